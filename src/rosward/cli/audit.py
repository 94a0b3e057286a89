# SPDX-License-Identifier: Apache-2.0
"""`rosward audit`: does the source explain what runs, and does all run that it says?"""

from __future__ import annotations

import argparse
import sys
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from rosward.cli.reviewing import add_output_file, add_review, deliver, findings_text, reviewed, write_baseline
from rosward.cli.shared import WrongUseError, add_deployment, add_format, add_sources, extracted, refusing, request_of
from rosward.cli.snapshot import add_looks
from rosward.cli.status import COMPLETE, INCOMPLETE
from rosward.outputs.formats import OF_FINDINGS
from rosward.records import NamedTuple
from rosward.ros.distro import DEFAULT_DISTRO, DISTROS

if TYPE_CHECKING:
    from rosward.audit.accepted import Accepted
    from rosward.audit.graph import LiveGraph
    from rosward.audit.result import Audit
    from rosward.findings import Finding
    from rosward.ros.entities import Node
    from rosward.suppression.judge import Judged, SourceTexts


def add(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.description = (
        "Report which running nodes and entities the sources do not explain, and which expected ones are not running. "
        "The running system is described by a snapshot or by output of `ros2 node info`. "
        "Without either, rosward inspects the live graph, which needs rclpy."
    )
    parser.epilog = (
        "Exit status: 0 everything that runs is explained, and everything expected runs; 1 differences found; "
        "2 usage error or nothing to read; 3 internal error."
    )
    parser.set_defaults(run=refusing(_run))
    running = parser.add_argument_group("running system (default: the live graph)")
    which = running.add_mutually_exclusive_group()
    which.add_argument("--snapshot", metavar="FILE", help="file written by `rosward snapshot`")
    which.add_argument(
        "--node-info",
        action="append",
        metavar="FILE",
        help="output of `ros2 node info` for one or more nodes; - reads standard input; may be repeated",
    )
    add_looks(running)
    running.add_argument(
        "--allow",
        action="append",
        default=[],
        metavar="NAME",
        help="accept this node, or 'NODE NAME' for one name of a node; * matches any text; may be repeated",
    )
    running.add_argument("--accept", metavar="FILE", help="file with one such name per line")
    add_sources(parser)
    parser.set_defaults(distro=None)
    parser.add_argument(
        "--network", metavar="FILE", help="network.json of an earlier `extract`, used instead of sources"
    )
    add_deployment(parser)
    add_format(parser, "text", "json", *OF_FINDINGS)
    add_output_file(parser)
    add_review(parser)


class _Said(NamedTuple):
    """What the source says: its nodes, what is in doubt, and where its texts are."""

    nodes: tuple[Node, ...]
    findings: tuple[Finding, ...]
    sources: SourceTexts


def _run(options: argparse.Namespace) -> int:
    from rosward.audit.compare import audit
    from rosward.source.json_fields import UnreadableError

    try:
        accepted = _accepted(options)
        graph = _graph(options)
        if options.distro is None:
            options.distro = graph.distro if graph.distro in DISTROS else DEFAULT_DISTRO
        said = _earlier(options) if options.network is not None else _extracted(options)
        found = audit(said.nodes, said.findings, graph, accepted)
    except UnreadableError as error:
        raise WrongUseError(str(error)) from error
    return _tell(found, said, options)


def _accepted(options: argparse.Namespace) -> Accepted:
    from rosward.audit.accepted import Accepted, read_accepted

    lines = read_accepted(options.accept) if options.accept is not None else []
    return Accepted([*lines, *options.allow])


def _graph(options: argparse.Namespace) -> LiveGraph:
    from rosward.audit.document import read_snapshot, snapshot_of
    from rosward.audit.node_info import read_node_info

    if options.snapshot is not None:
        return read_snapshot(options.snapshot)
    if options.node_info:
        return read_node_info({file: _text(file) for file in options.node_info})
    from rosward.audit.snapshot import take

    try:
        return snapshot_of(take(options.seconds, options.domain_id, options.enclave))
    except RuntimeError as error:
        raise WrongUseError(
            f"the live graph cannot be inspected: {error}; use --snapshot or --node-info instead"
        ) from error


def _text(file: str) -> str:
    from rosward.findings import Finding
    from rosward.source import limits
    from rosward.source.text import read_bytes

    if file == "-":
        return sys.stdin.read(limits.NODE_INFO_TEXT + 1)
    data = read_bytes(file, file, limits.NODE_INFO_TEXT)
    if isinstance(data, Finding):
        raise WrongUseError(f"--node-info: {file}: {data.message}")
    return data.decode("utf-8", "replace")


def _earlier(options: argparse.Namespace) -> _Said:
    from rosward.network.network_file import read_network
    from rosward.suppression.judge import SourceTexts

    request = request_of(options)
    if options.paths or request.deploys or request.params:
        raise WrongUseError(
            "--network replaces the sources: it cannot be combined with PATH or with options that start something"
        )
    read = read_network(options.network)
    return _Said(read.nodes, read.findings, SourceTexts(Path.cwd(), ()))


def _extracted(options: argparse.Namespace) -> _Said:
    from rosward.suppression.judge import SourceTexts

    result = extracted(options, options.paths, request_of(options))
    return _Said(result.network.nodes, result.findings, SourceTexts(result.root, result.files))


def _tell(found: Audit, said: _Said, options: argparse.Namespace) -> int:
    """Findings at places of the source and of the snapshot are reviewed apart: they are relative to different folders."""
    from rosward.suppression.judge import SourceTexts

    differences = {d.finding: None for d in found.differences}
    in_code = [f for f in differences if f.place.file != found.source]
    in_snapshot = [*(f for f in differences if f.place.file == found.source), *found.findings]
    code = reviewed(in_code, said.sources, options, unused=False)
    paper = reviewed(in_snapshot, SourceTexts(Path.cwd(), ()), options, unused=False)
    shown = (*code.shown, *paper.shown)
    if options.write_baseline is not None:
        write_baseline(shown, options.write_baseline)
    left = {j.finding for j in shown}
    known = {j.finding for j in shown if j.known}
    found = replace(
        found,
        differences=tuple(d for d in found.differences if d.finding in left),
        findings=tuple(f for f in found.findings if f in left and f not in known),
    )
    deliver(_output(found, known, shown, said, options), options.output)
    return COMPLETE if left <= known else INCOMPLETE


def _output(
    found: Audit, known: set[Finding], shown: tuple[Judged, ...], said: _Said, options: argparse.Namespace
) -> str:
    from rosward.outputs.documents.audit_json import audit_json
    from rosward.outputs.terminal.audit_text import audit_text

    if options.format in OF_FINDINGS:
        return findings_text(options.format, shown, options)
    return (
        audit_json(found, known, said.findings) if options.format == "json" else audit_text(found, known, said.findings)
    )
