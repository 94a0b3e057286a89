# SPDX-License-Identifier: Apache-2.0
"""The output folder: which files it gets, each written whole or not at all."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Iterable, Iterator
from pathlib import Path

from rosward.network.checks import UnknownNames
from rosward.network.graph import Network
from rosward.outputs.dot import graph_dot
from rosward.outputs.network_json import network_json
from rosward.outputs.permissions import permissions
from rosward.outputs.policy import policies, policy_xml
from rosward.outputs.report import report_html
from rosward.outputs.starts import starts_text
from rosward.outputs.svg import graph_svg


def write_outputs(
    network: Network,
    folder: str,
    formats: Iterable[str],
    *,
    unknown: UnknownNames = "deny",
    system: bool = False,
    types: bool = False,
) -> list[str]:
    """Write the chosen formats below `folder`; returns the paths written, without those of single enclaves.

    Raises OSError where that is not possible.
    """
    written: list[str] = []
    for name, text in _texts(network, tuple(formats), unknown, system, types):
        path = write_text(folder, name, text)
        if "/" not in name:
            written.append(path)
    return written


def _texts(
    network: Network, formats: tuple[str, ...], unknown: UnknownNames, system: bool, types: bool
) -> Iterator[tuple[str, str]]:
    if "json" in formats:
        yield "network.json", network_json(network)
    if "policy" in formats and network.nodes:
        yield "policy.xml", policy_xml(network, unknown=unknown)
        for path, text in policies(network, unknown=unknown).items():
            yield f"policies{_below(path)}/policy.xml", text
        yield "enclaves.txt", starts_text(network)
    if "permissions" in formats and network.nodes:
        for path, text in permissions(network, unknown=unknown).items():
            yield f"permissions{_below(path)}/permissions.xml", text
    if "dot" in formats:
        yield "graph.dot", graph_dot(network, system=system, types=types)
    if "svg" in formats:
        yield "graph.svg", graph_svg(network, system=system, types=types)
    if "html" in formats:
        yield "report.html", report_html(network, system=system, unknown=unknown)


def _below(enclave: str) -> str:
    """An enclave path as a path below a folder; it holds letters, digits, `_` and `/` only."""
    return "" if enclave == "/" else enclave


def write_text(folder: str, name: str, text: str) -> str:
    """Write one file below a folder, whole or not at all; returns its path."""
    path = Path(folder) / name
    path.parent.mkdir(parents=True, exist_ok=True)
    _replace(path, text)
    return str(path)


def _replace(path: Path, text: str) -> None:
    """Write a file whole: readers see the old content or the new."""
    handle, temporary = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name}.")
    try:
        with os.fdopen(handle, "w", encoding="utf-8", newline="\n") as file:
            file.write(text)
        os.chmod(temporary, 0o644)  # noqa: PTH101
        os.replace(temporary, path)  # noqa: PTH105
    except BaseException:
        os.unlink(temporary)  # noqa: PTH108
        raise
