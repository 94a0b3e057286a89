# SPDX-License-Identifier: Apache-2.0
"""`rosward extract`: the graph, the policies and a report of the sources, or of the system that a launch file starts."""

from __future__ import annotations

import argparse
import sys
from functools import partial
from typing import TYPE_CHECKING, Final

from rosward.cli.kept import store_of
from rosward.cli.reviewing import add_review, findings_text, reviewed_result, scan_of, write_baseline
from rosward.cli.shared import (
    WrongUseError,
    add_deployment,
    add_enclaves,
    add_sources,
    add_unknown,
    extracted,
    note_failures,
    refusing,
    request_of,
)
from rosward.cli.status import COMPLETE, INCOMPLETE
from rosward.guard import Steps
from rosward.outputs.formats import BY_NAME, DEFAULT_FORMATS, FORMATS, OF_FINDINGS
from rosward.records import replace

if TYPE_CHECKING:
    from rosward.enclaves.widened import Widenings
    from rosward.influence.policy import Policy
    from rosward.outputs.background import Background
    from rosward.result import Result
    from rosward.suppression.judge import Reviewed

FORMAT_NAMES: Final = (*BY_NAME, "none")
_WORDS: Final = "; ".join((*(f"{each.name}: {each.what}" for each in FORMATS), "none: no file"))


def add(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.description = (
        "Analyse files, packages or workspaces and write the computation graph, the SROS2 policies and a report."
    )
    parser.epilog = (
        "Exit status: 0 complete; 1 written but incomplete (an unknown name, an unreadable file, a limit), or as set by --fail-on; "
        "2 usage error or nothing to read; 3 written, but an internal error affected a part of it (RW299)."
    )
    parser.set_defaults(run=refusing(run))
    add_sources(parser)
    add_deployment(parser)
    add_enclaves(parser)
    parser.add_argument(
        "-o", "--output", metavar="DIR", default="rosward-out", help="output folder (default: rosward-out)"
    )
    parser.add_argument(
        "--format",
        type=_formats,
        metavar="LIST",
        default=DEFAULT_FORMATS,
        help=f"comma-separated outputs (default: {', '.join(DEFAULT_FORMATS)}); {_WORDS}",
    )
    add_unknown(parser)
    add_compact(parser)
    parser.add_argument("--system", action="store_true", help="show the entities of the client library in the graph")
    parser.add_argument("--types", action="store_true", help="show interface types in the graph")
    parser.add_argument(
        "--flows",
        action="store_true",
        help="show in report.html what each output is made of, and what reaches what; on by itself if rosward.toml has flow rules",
    )
    parser.add_argument(
        "--loose-ends",
        action="store_true",
        help="report topics without a publisher or subscription, and services and actions without a server (report.html always has them)",
    )
    add_review(parser)
    parser.add_argument(
        "--fail-on",
        choices=("error", "warning", "note"),
        default="error",
        help="exit with 1 if there are new findings of this severity or higher (default: error)",
    )
    volume = parser.add_mutually_exclusive_group()
    volume.add_argument("-q", "--quiet", action="store_true", help="print only errors")
    volume.add_argument("-v", "--verbose", action="store_true", help="print every finding")


def add_compact(parser: argparse.ArgumentParser) -> None:
    """What happens to permissions that are too large."""
    parser.add_argument(
        "--compact",
        action="store_true",
        help="if the permissions of an enclave are too large for DDS, replace names by patterns and report what else they allow",
    )


def _formats(text: str) -> tuple[str, ...]:
    wanted = tuple(dict.fromkeys(part.strip() for part in text.split(",") if part.strip()))
    wrong = [w for w in wanted if w not in FORMAT_NAMES]
    if wrong or not wanted:
        raise argparse.ArgumentTypeError(
            f"choose from {', '.join(FORMAT_NAMES)}: {', '.join(wrong) or 'nothing given'}"
        )
    return wanted


def run(options: argparse.Namespace) -> int:
    """Extract once. Raises WrongUseError."""
    from rosward.outputs.background import Background
    from rosward.rules import Severity
    from rosward.suppression.judge import SourceTexts

    request = request_of(options)
    policy: Policy | None = options.flow or None
    watched = frozenset(policy.functions if policy else ())
    flowing = bool(options.flows or (policy and (policy.rules or policy.releases)))
    result = extracted(options, options.paths, request, shown=not options.quiet, flow=flowing, watched=watched)
    if flowing:
        result = with_flows_checked(result, policy)
    widened: Widenings = {}
    if options.compact:
        result, widened = compacted(result, options)
    sources = SourceTexts(result.root, result.files)
    found, loose = reviewed_result(result, sources, options, unused=not request.deploys)
    background = Background(result.root, result.systems, loose, flow=flowing)
    written, found = _write(result, found, options, widened, background)
    steps = Steps()
    if not options.quiet:
        steps(lambda: summarise(result, found, written, options), None, "the rest of the summary is missing")
    for name in options.format:
        if name in OF_FINDINGS and not BY_NAME[name].files:
            printed = partial(findings_text, name, found.shown, options)
            sys.stdout.write(steps(printed, "", f"the format {name} was not written"))
    note_failures(options, steps.findings)
    enough = Severity(options.fail_on).rank
    return INCOMPLETE if any(f.rule.severity.rank <= enough for f in found.new) else COMPLETE


def with_flows_checked(result: Result, policy: Policy | None) -> Result:
    """The same network, with what its flows break of the rules of the project among its findings."""
    from rosward.influence.check import check
    from rosward.influence.graph import graph_of
    from rosward.influence.policy import Policy
    from rosward.network.connect import with_findings

    nodes = result.network.nodes
    return replace(result, network=with_findings(result.network, check(nodes, graph_of(nodes), policy or Policy())))


def compacted(result: Result, options: argparse.Namespace) -> tuple[Result, Widenings]:
    """The same network, with what patterns do to the size of permissions among its findings."""
    from rosward.enclaves.compact import compact
    from rosward.network.connect import with_findings

    network = result.network
    steps = Steps()
    compaction = steps(lambda: compact(network.nodes, options.unknown), None, "the permissions were not compacted")
    if compaction is None:
        note_failures(options, steps.findings)
        return replace(result, network=with_findings(network, steps.findings)), {}
    kept = tuple(f for f in network.findings if f.code != "RW304")
    network = with_findings(replace(network, findings=kept), compaction.findings)
    return replace(result, network=network), compaction.widened


def _write(
    result: Result,
    found: Reviewed,
    options: argparse.Namespace,
    widened: Widenings,
    background: Background,
) -> tuple[list[str], Reviewed]:
    """What was written, and the findings with those of writing."""
    from rosward.outputs.files import write_outputs
    from rosward.outputs.pictures import Pictures
    from rosward.outputs.writing import Material
    from rosward.suppression.judge import of_no_file

    store = store_of(options)
    try:
        written = write_outputs(
            Material(
                replace(result.network, findings=found.findings),
                options.unknown,
                options.system,
                options.types,
                widened,
                background,
                Pictures(store),
            ),
            options.output,
            options.format,
            scan_of(found.shown, options) if any(name in OF_FINDINGS for name in options.format) else None,
        )
    except OSError as error:
        raise WrongUseError(f"cannot write to {options.output}: {error.strerror or error}") from error
    if store is not None:
        store.close()
    note_failures(options, written.findings)
    paths = written.paths
    if options.write_baseline is not None:
        paths.append(write_baseline(found.shown, options.write_baseline))
    return paths, found._replace(shown=(*found.shown, *of_no_file(written.findings)))


def summarise(result: Result, found: Reviewed, written: list[str], options: argparse.Namespace) -> None:
    """Print what was found, and what was written."""
    from rosward.outputs.terminal.paper import standard_output
    from rosward.outputs.terminal.summary import Unread, summary

    network = replace(result.network, findings=found.new)
    unasked = 0 if result.systems else result.launch_files
    summary(
        network,
        standard_output(),
        options.verbose,
        written,
        found,
        options.configuration,
        Unread(result.excluded, result.ignored, unasked),
    )
