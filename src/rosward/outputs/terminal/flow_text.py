# SPDX-License-Identifier: Apache-2.0
"""Flows for a person: per node, what each output is made of; as a tree, what reaches something; as a way, how one thing reaches another.

/controller
  /cmd_vel      data  /odom, /plan, parameter:max_speed     decided by  /e_stop          controller.py:88
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from itertools import islice
from typing import Final

from rosward.findings import Finding
from rosward.influence.declared import flows_of
from rosward.influence.graph import FlowGraph, Vertex
from rosward.influence.private import Leaving, Privacy
from rosward.influence.search import Passing, Reached, in_order, way_to
from rosward.influence.senders import Influencing
from rosward.influence.tree import Step, Tree
from rosward.location import Place
from rosward.network.counts import several
from rosward.ros.entities import Interface, Node
from rosward.ros.flows import End, NodeCall, NodeSink
from rosward.safe import printable

__all__ = [
    "enclaves_text",
    "findings_text",
    "nodes_text",
    "path_text",
    "privacy_text",
    "reaching_text",
    "shown",
    "tree_text",
    "ways_text",
]

_MOST_LINES: Final = 2_000
_MORE: Final = "…  (use --format json for everything)"
_MOST_NODES: Final = 6
"""So many nodes of a way are named in a line."""


_CONSTANT: Final = "constant"
_TALK: Final = ("log", "stdout")
"""Outputs that are not worth a line where they are constant."""


def nodes_text(nodes: Sequence[Node], *, data_only: bool = False, triggers: bool = False) -> str:
    """What each output of each node is made of."""
    lines: list[str] = []
    for node in nodes:
        rows = [
            (shown(sink.sink), *columns, where)
            for sink in flows_of(node).sinks
            for columns, where in _by_calls(sink, lambda s: _columns(s, data_only, triggers))
            if triggers or sink.sink.kind not in _TALK or columns[0] != _CONSTANT
        ]
        if rows:
            lines += [f"{node.display_name}  {node.defined_at.file}{_doubt(node)}", *_aligned(rows), ""]
    if not lines:
        return "No node sends anything.\n"
    return "\n".join(printable(line) for line in lines)


def _doubt(node: Node) -> str:
    flows = node.flows
    if flows is None or (node.interface is Interface.DECLARED and not flows.complete):
        known = "declared" if node.interface is Interface.DECLARED else "unknown"
        return f"  ({known}: each output may hold each input)"
    if not flows.complete:
        return "  (not wholly known: outputs may hold every input)"
    assumed = ", ".join(shown(sink.sink) for sink in flows_of(node).sinks if sink.assumed)
    told = f"; each input is assumed for {assumed}" if assumed else ""
    if node.interface is Interface.DECLARED:
        return f"  (declared{told})"
    return f"  (partially known{told})" if told and node.interface is Interface.PARTIAL else ""


def _by_calls(
    sink: NodeSink, columns: Callable[[NodeSink | NodeCall], tuple[str, ...]]
) -> Iterator[tuple[tuple[str, ...], str]]:
    """One row, with its place; several where a function sends something else for each of its callers."""
    groups: dict[tuple[str, ...], list[tuple[Place, ...]]] = {}
    for call in sink.calls:
        groups.setdefault(columns(call), []).append(call.through)
    if len(groups) < 2:
        yield columns(sink), _short(sink.at)
        return
    for row, places in zip(groups, _telling(list(groups.values())), strict=True):
        callers = path_text(places, ", ")
        yield row, f"{_short(sink.at)}{' called at ' if callers else ''}{callers}"


def _telling(groups: Sequence[Sequence[tuple[Place, ...]]]) -> list[list[Place]]:
    """The callers that tell groups of calls apart: the next ones, where these do, else those that call them."""
    farthest = max(len(through) for calls in groups for through in calls)
    for near in range(1, farthest + 1):
        heads = [list(dict.fromkeys(place for through in calls for place in through[-near:][:1])) for calls in groups]
        if near == farthest or sum(map(len, heads)) == len({place for each in heads for place in each}):
            break
    return heads


def _columns(sent: NodeSink | NodeCall, data_only: bool, triggers: bool) -> tuple[str, ...]:
    made = ", ".join(map(shown, sent.data))
    decided = "" if data_only else ", ".join(map(shown, sent.control))
    woken = ", ".join(map(shown, sent.trigger)) if triggers else ""
    constant = "" if made or decided or woken else _CONSTANT
    return (
        f"data  {made}" if made else constant,
        f"decided by  {decided}" if decided else "",
        f"triggered by  {woken}" if woken else "",
    )


def _short(place: Place) -> str:
    return f"{place.file.rpartition('/')[2]}:{place.line}"


def _aligned(rows: Sequence[tuple[str, ...]]) -> list[str]:
    widths = [max(len(row[column]) for row in rows) for column in range(len(rows[0]) - 1)]
    return [
        "  " + "  ".join([*(c.ljust(min(w, _WIDE)) for c, w in zip(row, widths, strict=False) if w), row[-1]])
        for row in rows
    ]


_WIDE: Final = 60


def shown(end: End) -> str:
    """A source or sink as people name it: topics by their names alone."""
    if end.kind == "topic":
        return end.name
    return f"{end.kind} {end.name}" if end.name else end.kind


def _vertex(vertex: Vertex) -> str:
    return shown(vertex.end) + (f" of {vertex.node}" if vertex.node else "")


def tree_text(graph: FlowGraph, targets: Sequence[Vertex], found: dict[Vertex, Reached], passing: Passing) -> str:
    """What reaches these, each source once, below what it is part of."""
    tree = Tree(graph, passing)
    lines: list[str] = []
    for target in tree.roots(targets):
        lines.append(_vertex(target))
        lines += islice(_branches(tree.steps(target)), _MOST_LINES - len(lines) + 1)
        if len(lines) > _MOST_LINES:
            lines[_MOST_LINES:] = [_MORE]
            break
    outside = sorted({_vertex(v) for v in found if v.side == "in" and v.node and v.end.kind != "parameter"})
    if outside:
        lines.append(f"from outside: {', '.join(outside)}")
    return "\n".join(printable(line) for line in lines) + "\n"


def enclaves_text(found: Iterable[Influencing]) -> str:
    """The enclaves that can influence something, those that put data into it first."""
    known = list(found)
    parts = []
    for word, strength in (("", "data"), ("by deciding alone: ", "control"), ("by triggering alone: ", "trigger")):
        named = [f"{e.enclave}{' (assumed)' * e.assumed}" for e in known if e.strength == strength]
        if named:
            parts.append(f"{word}{', '.join(named)}")
    return printable(f"enclaves that can influence it: {'; '.join(parts)}") + "\n" if parts else ""


def _branches(steps: Iterable[Step]) -> Iterator[str]:
    indents: list[str] = []
    for edge, depth, last, above in steps:
        del indents[depth - 1 :]
        branch, marks = "└─ " if last else "├─ ", "  (assumed)" * edge.assumed + "  (above)" * above
        yield f"{''.join(indents)}{branch}{edge.strength:8}{shown(edge.source.end)}  {edge.node}  {path_text(edge.path)}{marks}"
        indents.append("   " if last else "│  ")


def path_text(path: Iterable[Place], between: str = " → ") -> str:
    """Lines, each file named once."""
    parts: list[str] = []
    file = ""
    for place in path:
        parts.append(str(place.line) if place.file == file else _short(place))
        file = place.file
    return between.join(parts)


def reaching_text(starts: Sequence[Vertex], found: dict[Vertex, Reached]) -> str:
    """What these reach, the strongest first."""
    lines = [", ".join(dict.fromkeys(_vertex(v) for v in starts))]
    rows = []
    seen: set[str] = {lines[0]}
    for vertex, reached in in_order(found):
        name = _vertex(vertex)
        if reached.by is None or name in seen or vertex.side != "sent":
            continue
        seen.add(name)
        via = list(dict.fromkeys(edge.node for edge in way_to(found, vertex) if edge.node))
        rows.append((reached.strength, name, f"through {_few(via)}", "assumed" if reached.assumed else ""))
    if not rows:
        return f"{lines[0]} reaches nothing.\n"
    return "\n".join(printable(line).rstrip() for line in [*lines, *_aligned(rows)]) + "\n"


def _few(names: Sequence[str]) -> str:
    if len(names) <= _MOST_NODES:
        return ", ".join(names)
    return f"{', '.join(names[: _MOST_NODES - 1])} and {len(names) - _MOST_NODES + 1} more nodes"


def ways_text(found: dict[Vertex, Reached], targets: Sequence[Vertex]) -> str:
    """How each of the targets is reached, line by line."""
    lines: list[str] = []
    for target in targets:
        if target not in found or found[target].by is None:
            continue
        way = way_to(found, target)
        nodes = list(dict.fromkeys(edge.node for edge in way if edge.node))
        reached = found[target]
        unsure = ", assumed" if reached.assumed else ""
        title = f"{_vertex(way[0].source)} → {_vertex(target)}: {reached.strength}{unsure}"
        lines.append(f"{title}, {several(len(nodes), 'node', 'nodes')}")
        for edge in way:
            if edge.node:
                lines.append(f"  {edge.node}: {edge.strength}, {_vertex(edge.source)} to {_vertex(edge.target)}")
                lines += [f"    {place}" for place in edge.path if place.file]
        if len(lines) > _MOST_LINES:
            lines[_MOST_LINES:] = [_MORE]
            break
        lines.append("")
    return "\n".join(printable(line) for line in lines)


def findings_text(findings: Sequence[Finding]) -> str:
    """What breaks the rules, each with the lines that lead there."""
    lines: list[str] = []
    for finding in findings:
        lines.append(f"{finding.rule.severity.value:7} {finding.code} {finding.message}")
        lines += [f"    {place}" for place in finding.path or ((finding.place,) if finding.place.file else ())]
    errors = sum(f.rule.severity.value == "error" for f in findings)
    broken = several(errors, "forbidden flow", "forbidden flows")
    lines.append(f"{broken} found." if errors else "No forbidden flow found.")
    return "\n".join(printable(line) for line in lines) + "\n"


def privacy_text(found: Privacy) -> str:
    """Topics by whether their content stays."""
    lines: list[str] = []
    groups: dict[str, list[Leaving]] = {}
    for one in found.leaving:
        groups.setdefault(one.topic, []).append(one)
    if groups:
        lines.append("content leaves the robot")
        for topic, several_ in groups.items():
            lines.append(f"  {topic}")
            for one in several_:
                place = one.way[-1].path[-1] if one.way and one.way[-1].path else ""
                unsure = "  (assumed)" if one.reached.assumed else ""
                lines.append(f"    to {_vertex(one.target)}  {place}  in enclave {one.enclave}{unsure}")
        lines.append("")
    if found.unread:
        lines += ["no node of the system subscribes", *(f"  {topic}" for topic in found.unread), ""]
    if found.private:
        lines.append("content stays in the system (enclaves that publish → that subscribe)")
        for kept in found.private:
            senders, receivers = (", ".join(paths) or "none" for paths in (kept.senders, kept.receivers))
            lines.append(f"  {kept.topic}  {senders} → {receivers}")
        lines.append("")
    return "\n".join(printable(line) for line in lines) or "There are no topics.\n"
