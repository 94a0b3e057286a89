# SPDX-License-Identifier: Apache-2.0
"""Which formats are there, which files has each, and which module writes it?

    Format("dot", "the graph for Graphviz, in full", "network", "graphs.dot", ("graph.dot",), usual=True)

A new format is an entry here, a writer, and tests; the command line, the server and what checks the documentation read this table. The
writer is a module below `outputs` that is imported only where its format is asked for, and has one function (`outputs/writing.py`):

    def files(material: Material) -> Iterator[tuple[str, str]]      of the network: names below the output folder, and texts
    def text(scan: Scan) -> str                                     of findings alone, which other commands write, too
"""

from __future__ import annotations

from typing import Final, Literal

from rosward.records import NamedTuple

__all__ = ["BY_NAME", "DEFAULT_FORMATS", "FORMATS", "OF_FINDINGS", "Format", "Needs"]

Needs = Literal["network", "nodes", "findings"]
"""What a format is made of: the network, a network that has nodes (else nothing is written), or findings alone."""


class Format(NamedTuple):
    """One format of outputs.

    `files` are below the output folder; `ENCLAVE` stands for the path of each enclave, and a format without files is printed. `usual`: it is
    written where no format is named. `tells`: it shows findings, and so what went wrong with the others.
    """

    name: str
    what: str
    needs: Needs
    writer: str
    files: tuple[str, ...] = ()
    usual: bool = False
    tells: bool = False


FORMATS: Final = (
    Format(
        "json", "all that was found", "network", "documents.network_json", ("network.json",), usual=True, tells=True
    ),
    Format(
        "policy",
        "SROS2 policies",
        "nodes",
        "policies.policy_files",
        ("policy.xml", "policies/ENCLAVE/policy.xml", "enclaves.txt"),
        usual=True,
    ),
    Format(
        "permissions",
        "DDS permissions, unsigned",
        "nodes",
        "policies.permissions",
        ("permissions/ENCLAVE/permissions.xml",),
    ),
    Format("dot", "the graph for Graphviz", "network", "graphs.dot", ("graph.dot",), usual=True),
    Format("mermaid", "the graph for Mermaid", "network", "graphs.mermaid", ("graph.mmd", "graph.md")),
    Format("svg", "the graph as a picture", "network", "graphs.svg", ("graph.svg",), usual=True),
    Format("html", "a report for the browser", "network", "report.page", ("report.html",), usual=True, tells=True),
    Format("sarif", "findings for code scanning", "findings", "documents.sarif", ("findings.sarif",), tells=True),
    Format("junit", "findings as test results", "findings", "documents.junit", ("findings.junit.xml",), tells=True),
    Format("github", "findings as annotations, printed", "findings", "documents.github", tells=True),
)
"""In the order in which they are written."""

BY_NAME: Final = {each.name: each for each in FORMATS}
DEFAULT_FORMATS: Final = tuple(each.name for each in FORMATS if each.usual)
OF_FINDINGS: Final = tuple(each.name for each in FORMATS if each.needs == "findings")
"""What each command that shows findings can write."""
