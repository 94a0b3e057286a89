# SPDX-License-Identifier: Apache-2.0
"""`rosward flow`: what each output is made of, where each input can go, and whether that keeps the rules of the project."""

from __future__ import annotations

import argparse
import sys
from typing import TYPE_CHECKING, Final

from rosward.cli.reviewing import add_review, findings_text, reviewed, write_baseline, write_file
from rosward.cli.shared import WrongUseError, add_deployment, add_enclaves, add_sources, extracted, refusing, request_of
from rosward.cli.status import COMPLETE, INCOMPLETE

if TYPE_CHECKING:
    from collections.abc import Sequence

    from rosward.findings import Finding
    from rosward.influence.graph import FlowGraph, Vertex
    from rosward.influence.policy import Policy
    from rosward.influence.search import Passing
    from rosward.ros.entities import Node
    from rosward.suppression.judge import Reviewed

_FORMATS: Final = ("text", "json", "dot", "caret", "sarif", "github", "junit")
_FILES: Final = {
    "json": "flow.json",
    "dot": "flow.dot",
    "caret": "architecture.yaml",
    "sarif": "flow.sarif",
    "junit": "flow.junit.xml",
}


def add(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.description = (
        "Show which inputs of each node flow into which of its outputs, and what reaches what across the system. "
        "Data: the content is in it. Decided by: the content decides what is sent, or whether. Triggered by: only its arrival counts."
    )
    parser.epilog = (
        "Exit status: 0 complete; 1 with --check, a rule is broken; 2 usage error or nothing to read; 3 internal error."
    )
    parser.set_defaults(run=refusing(_run))
    add_sources(parser)
    add_deployment(parser)
    add_enclaves(parser)
    question = parser.add_argument_group("question (default: all outputs of all nodes)")
    question.add_argument(
        "--to",
        action="append",
        default=[],
        metavar="NAME",
        help="what can influence this topic, service or action, or KIND:NAME, such as parameter:rate, network, node:/planner; may be repeated",
    )
    question.add_argument(
        "--from",
        action="append",
        default=[],
        dest="origin",
        metavar="NAME",
        help="what this can influence; may be repeated",
    )
    question.add_argument(
        "--check", action="store_true", help="check the rules of rosward.toml: [[flow.rule]], [[flow.release]]"
    )
    question.add_argument(
        "--suggest-private",
        action="store_true",
        help="list the topics whose content stays on the robot, and those whose content leaves it",
    )
    strength = parser.add_mutually_exclusive_group()
    strength.add_argument("--data-only", action="store_true", help="only where the content itself flows")
    strength.add_argument("-v", "--verbose", action="store_true", help="also what only triggers an output")
    parser.add_argument("--format", choices=_FORMATS, default="text", help="format to print or write (default: text)")
    parser.add_argument("-o", "--output", metavar="DIR", help="write to this folder instead of printing")
    add_review(parser)


def _run(options: argparse.Namespace) -> int:
    from rosward.influence.check import check
    from rosward.influence.graph import graph_of
    from rosward.influence.policy import Policy

    policy: Policy = options.flow or Policy()
    if options.check and not (policy.rules or policy.releases):
        raise WrongUseError("--check: there is no [[flow.rule]] in rosward.toml")
    if (options.check or options.suggest_private) and (options.to or options.origin):
        raise WrongUseError(
            "--check and --suggest-private look at everything: they cannot be combined with --from or --to"
        )
    request = request_of(options)
    result = extracted(options, options.paths, request, flow=True, watched=frozenset(policy.functions))
    nodes = result.network.nodes
    graph = graph_of(nodes)
    judged = _reviewed(options, check(nodes, graph, policy), result)
    text = _text(options, nodes, graph, judged)
    if options.output is None or options.format not in _FILES:
        sys.stdout.write(text)
    else:
        sys.stdout.write(f"wrote {write_file(text, f'{options.output}/{_FILES[options.format]}')}\n")
    if options.write_baseline is not None:
        write_baseline(judged.shown, options.write_baseline)
    broken = any(f.rule.severity.value == "error" for f in judged.new)
    return INCOMPLETE if options.check and broken else COMPLETE


def _reviewed(options: argparse.Namespace, found: Sequence[Finding], result: object) -> Reviewed:
    from rosward.suppression.judge import SourceTexts

    sources = SourceTexts(result.root, result.files)  # type: ignore[attr-defined]
    return reviewed(found, sources, options, unused=False)


def _text(options: argparse.Namespace, nodes: Sequence[Node], graph: FlowGraph, judged: Reviewed) -> str:
    """What is printed or written, in the format that was asked for."""
    if options.format == "json":
        from rosward.outputs.documents.flow_json import flow_json

        return flow_json(nodes, graph, [j.finding for j in judged.shown])
    if options.format == "dot":
        from rosward.outputs.graphs.flow_dot import flow_dot

        return flow_dot(graph, _passing(options))
    if options.format == "caret":
        from rosward.outputs.documents.caret_yaml import caret_yaml

        return caret_yaml(nodes)
    if options.format != "text":
        return findings_text(options.format, judged.shown, options)
    from rosward.outputs.terminal import flow_text

    if options.check:
        return flow_text.findings_text([j.finding for j in judged.shown])
    if options.suggest_private:
        from rosward.influence.private import privacy

        return flow_text.privacy_text(privacy(nodes, graph))
    passing = _passing(options)
    if options.to or options.origin:
        return _answer(options, nodes, graph, passing)
    return flow_text.nodes_text(nodes, data_only=options.data_only, triggers=options.verbose)


def _passing(options: argparse.Namespace) -> Passing:
    from rosward.influence.search import at_least

    return at_least("data" if options.data_only else "trigger" if options.verbose else "control")


def _answer(options: argparse.Namespace, nodes: Sequence[Node], graph: FlowGraph, passing: Passing) -> str:
    from rosward.influence.search import downstream, upstream
    from rosward.influence.select import beginnings
    from rosward.influence.senders import influencing
    from rosward.outputs.terminal import flow_text

    starts, targets = _meant(graph, options.origin, "--from"), _meant(graph, options.to, "--to")
    starts = beginnings(starts) or starts
    if options.origin and options.to:
        found = downstream(graph, starts, passing)
        text = flow_text.ways_text(found, [t for t in targets if t.side == "sent" and t not in starts])
        return text or f"{' '.join(options.origin)} does not reach {' '.join(options.to)}.\n"
    if options.origin:
        return flow_text.reaching_text(starts, downstream(graph, starts, passing))
    found = upstream(graph, targets, passing)
    enclaves = flow_text.enclaves_text(influencing(nodes, graph, found))
    return flow_text.tree_text(graph, targets, found, passing) + enclaves


def _meant(graph: FlowGraph, words: Sequence[str], option: str) -> list[Vertex]:
    """The vertices that words mean. Raises WrongUseError where one means nothing."""
    import difflib

    from rosward.influence.select import Selection, meant

    vertices = graph.vertices
    found: list[Vertex] = []
    for word in words:
        these = meant([Selection(word)], vertices)
        if not these:
            close = difflib.get_close_matches(word, sorted({v.end.name for v in vertices}), n=1)
            hint = f"; did you mean {close[0]}?" if close else ""
            raise WrongUseError(f"{option}: nothing is called {word!r}{hint}")
        found += these
    return list(dict.fromkeys(found))
