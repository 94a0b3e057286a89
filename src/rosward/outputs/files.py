# SPDX-License-Identifier: Apache-2.0
"""Which files does the output folder get? How each is written stands in `whole_files.py`."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from itertools import chain
from typing import Final, NamedTuple

from rosward.enclaves.grants import NOT_WIDENED
from rosward.enclaves.widened import Widenings
from rosward.findings import Finding
from rosward.guard import internal_error
from rosward.network.checks import UnknownNames
from rosward.network.connect import with_findings
from rosward.network.graph import Network
from rosward.outputs.documents.junit import junit_xml
from rosward.outputs.documents.network_json import network_json
from rosward.outputs.documents.sarif import sarif_json
from rosward.outputs.graphs.dot import graph_dot
from rosward.outputs.graphs.mermaid import fenced, graph_mermaid
from rosward.outputs.graphs.svg import graph_svg
from rosward.outputs.policies.permissions import permissions
from rosward.outputs.policies.policy import policies, policy_xml
from rosward.outputs.policies.starts import starts_text
from rosward.outputs.report.document import Background
from rosward.outputs.report.page import report_html
from rosward.outputs.whole_files import write_text
from rosward.source.location import Place
from rosward.suppression.judge import Judged, of_no_file

_LONGEST_PATH: Final = 250
_ORDER: Final = ("json", "policy", "permissions", "dot", "mermaid", "svg", "html", "sarif", "junit")
_SHOWING: Final = ("json", "html", "sarif", "junit")
"""The formats that show findings, and so tell of what went wrong with the others."""
_NO_BACKGROUND: Final = Background()


class Scan(NamedTuple):
    """The findings with their fingerprints, for the outputs that show findings alone."""

    findings: Sequence[Judged]
    baseline: bool = False
    documentation: str | None = None


class Written(NamedTuple):
    """The paths that were written, without those of single enclaves, and what is told of formats that were not."""

    paths: list[str]
    findings: tuple[Finding, ...] = ()


def write_outputs(
    network: Network,
    folder: str,
    formats: Iterable[str],
    *,
    unknown: UnknownNames = "deny",
    system: bool = False,
    types: bool = False,
    scan: Scan | None = None,
    widened: Widenings = NOT_WIDENED,
    background: Background = _NO_BACKGROUND,
    net: bool = True,
) -> Written:
    """Write the chosen formats below `folder`.

    The formats sarif and junit need a `scan`; the report shows sources and launch files where it has a `background`. Raises OSError where that is
    not possible. A format that cannot be made for a fault of rosward is a finding (RW299), which the others show; without `net` that is raised.
    """
    chosen = tuple(formats)
    written: dict[str, dict[str, None]] = {}
    failed: dict[str, Finding] = {}

    def write(one: str) -> None:
        told = with_findings(network, failed.values())
        texts = chain(
            _texts(told, (one,), unknown, system, types, widened),
            _report(told, (one,), unknown, background._replace(widened=widened)),
            _findings(_with_failures(scan, failed.values()), (one,)) if scan is not None else (),
        )
        paths = written.setdefault(one, {})
        for name, text in texts:
            path = write_text(folder, name, text)
            if "/" not in name:
                paths[path] = None

    def attempt(one: str) -> None:
        try:
            write(one)
        except OSError:
            raise
        except Exception as error:
            if not net:
                raise
            failed[one] = internal_error(error, Place("", 0), f"the format {one} was not written")

    for one in _ORDER:
        if one in chosen:
            attempt(one)
    if failed:  # those before it do not tell of it yet
        for one in _SHOWING:
            if one in chosen and one not in failed:
                attempt(one)
    return Written([path for paths in written.values() for path in paths], tuple(failed.values()))


def _with_failures(scan: Scan, failures: Collection[Finding]) -> Scan:
    return scan._replace(findings=(*scan.findings, *of_no_file(failures)))


def _texts(
    network: Network, formats: tuple[str, ...], unknown: UnknownNames, system: bool, types: bool, widened: Widenings
) -> Iterator[tuple[str, str]]:
    if "json" in formats:
        yield "network.json", network_json(network)
    if "policy" in formats and network.nodes:
        yield "policy.xml", policy_xml(network, unknown=unknown, widened=widened)
        for path, text in _placeable(policies(network, unknown=unknown, widened=widened)):
            yield f"policies{_below(path)}/policy.xml", text
        yield "enclaves.txt", starts_text(network)
    if "permissions" in formats and network.nodes:
        for path, text in _placeable(permissions(network, unknown=unknown, widened=widened)):
            yield f"permissions{_below(path)}/permissions.xml", text
    if "dot" in formats:
        yield "graph.dot", graph_dot(network, system=system, types=types)
    if "mermaid" in formats:
        flowchart = graph_mermaid(network, system=system)
        yield "graph.mmd", flowchart
        yield "graph.md", fenced(flowchart)
    if "svg" in formats:
        yield "graph.svg", graph_svg(network, system=system, types=types)


def _report(
    network: Network, formats: tuple[str, ...], unknown: UnknownNames, background: Background
) -> Iterator[tuple[str, str]]:
    if "html" in formats:
        yield "report.html", report_html(network, background, unknown)


def _findings(scan: Scan, formats: tuple[str, ...]) -> Iterator[tuple[str, str]]:
    if "sarif" in formats:
        yield (
            "findings.sarif",
            sarif_json(scan.findings, baseline=scan.baseline, documentation=scan.documentation),
        )
    if "junit" in formats:
        yield "findings.junit.xml", junit_xml(scan.findings)


def _placeable(documents: Mapping[str, str]) -> Iterator[tuple[str, str]]:
    """Without those of enclaves that no certificate can name (RW303 tells) and whose path is too long for a file system."""
    return ((path, text) for path, text in documents.items() if len(path) <= _LONGEST_PATH)


def _below(enclave: str) -> str:
    """An enclave path as a path below a folder; it holds letters, digits, `_` and `/` only."""
    return "" if enclave == "/" else enclave
