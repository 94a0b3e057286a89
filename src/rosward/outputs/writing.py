# SPDX-License-Identifier: Apache-2.0
"""What does a writer of a format get, and what does it give?

    for name, text in files(BY_NAME["dot"], Material(network)):      graph.dot, digraph rosward { …
    text(BY_NAME["junit"], Scan(findings))                           <?xml …

Writers are imported when they are called: what draws and renders is slow to import, and often not asked for.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from importlib import import_module
from typing import TYPE_CHECKING, Final, Protocol, cast

from rosward.enclaves.grants import NOT_WIDENED
from rosward.enclaves.widened import Widenings
from rosward.network.checks import UnknownNames
from rosward.network.graph import Network
from rosward.outputs.pictures import Pictures
from rosward.records import NamedTuple

if TYPE_CHECKING:
    from rosward.outputs.background import Background
    from rosward.outputs.formats import Format
    from rosward.suppression.judge import Judged

__all__ = ["File", "FindingsWriter", "Material", "NetworkWriter", "Scan", "files", "of_enclave", "of_enclaves", "text"]

_LONGEST_PATH: Final = 250

File = tuple[str, str]
"""A path below the output folder, and the text."""


class Scan(NamedTuple):
    """The findings with their fingerprints. `documentation` is the address of the page that docs/findings.md became."""

    findings: Sequence[Judged]
    baseline: bool = False
    documentation: str | None = None


class Material(NamedTuple):
    """What there is to write. `background` is what the report shows beside the network; `pictures`, what was drawn of it so far."""

    network: Network
    unknown: UnknownNames = "deny"
    system: bool = False
    types: bool = False
    widened: Widenings = NOT_WIDENED
    background: Background | None = None
    pictures: Pictures | None = None


class NetworkWriter(Protocol):
    """`files` of a writer."""

    def __call__(self, material: Material, /) -> Iterator[File]:
        """The files of the format."""


class FindingsWriter(Protocol):
    """`text` of a writer of findings."""

    def __call__(self, scan: Scan, /) -> str:
        """The one document of the format."""


def files(chosen: Format, material: Material) -> Iterator[File]:
    """The files of a format that is made of a network."""
    if chosen.needs == "network" or material.network.nodes:
        yield from cast("NetworkWriter", _writer(chosen, "files"))(material)


def text(chosen: Format, scan: Scan) -> str:
    """The document of a format that is made of findings alone."""
    return cast("FindingsWriter", _writer(chosen, "text"))(scan)


def _writer(chosen: Format, name: str) -> object:
    return getattr(import_module(f"rosward.outputs.{chosen.writer}"), name)


def of_enclaves(folder: str, documents: Mapping[str, str], name: str) -> Iterator[File]:
    """A document of each enclave, without those that no certificate can name (RW303 tells) and whose path is too long for a file system."""
    for path, document in documents.items():
        if len(path) <= _LONGEST_PATH:
            yield of_enclave(folder, path, name), document


def of_enclave(folder: str, enclave: str, name: str) -> str:
    """Where a document of an enclave lies; the path of an enclave holds letters, digits, `_` and `/` only."""
    return f"{folder}{'' if enclave == '/' else enclave}/{name}"
