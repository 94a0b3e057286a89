# SPDX-License-Identifier: Apache-2.0
"""Does a system keep the rules of its project about flows?

A rule with `not-to` asks what the sources reach. One with `only-from` asks what the target is made of in the end: a name that nothing in the
system makes of something else, and that is none of those allowed. The clock and random numbers count as nobody's.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import groupby
from typing import Final

from rosward.findings import Finding
from rosward.influence.executed import executed
from rosward.influence.graph import Edge, FlowGraph, Vertex
from rosward.influence.policy import Policy, Release, Rule, is_function
from rosward.influence.search import Passing, Reached, at_least, downstream, upstream, way_from, way_to
from rosward.influence.select import Selection, beginnings, meant
from rosward.location import Place
from rosward.ros.entities import Node
from rosward.ros.flows import STRENGTHS

_NOBODYS: Final = ("clock", "random")
_NOWHERE: Final = Place("", 0)


def check(nodes: Iterable[Node], graph: FlowGraph, policy: Policy) -> list[Finding]:
    """What is found in the flows of a system: content that is executed, and what breaks the rules."""
    return [*executed(nodes), *against(graph, policy)]


def against(graph: FlowGraph, policy: Policy) -> list[Finding]:
    """Findings of all rules and releases."""
    found: list[Finding] = []
    for rule in policy.rules:
        found += _names_nothing(graph, rule)
        found += _forbidden(graph, rule, policy) if rule.sources else _others(graph, rule, policy)
        found += _decided(graph, rule, policy)
    for release in policy.releases:
        found += _releases(graph, release)
    found += _contradictions(policy)
    return found


def _passing(by: str, releases: Iterable[Release]) -> Passing:
    """Edges of that strength that no release stops."""
    strong = at_least(by)
    through = [s for release in releases for s in release.through]

    def passing(edge: Edge) -> bool:
        return strong(edge) and not any(_goes_through(edge, s) for s in through)

    return passing


def _goes_through(edge: Edge, through: Selection) -> bool:
    if is_function(through.word):
        return edge.target.end.kind == "released" and edge.target.end.name == through.word
    if through.node:
        return edge.node != "" and through.fits(edge.node)
    return edge.node == "" and (through.means(edge.source) or through.means(edge.target))


def _by_releases(starts: Iterable[Vertex], policy: Policy) -> Iterator[tuple[tuple[Release, ...], list[Vertex]]]:
    """The sources in groups to which the same releases apply."""

    def of(vertex: Vertex) -> tuple[int, ...]:
        return tuple(n for n, r in enumerate(policy.releases) if any(s.means(vertex) for s in r.of))

    for numbers, group in groupby(sorted(starts, key=lambda v: (of(v), v)), key=of):
        yield tuple(policy.releases[n] for n in numbers), list(group)


def _forbidden(graph: FlowGraph, rule: Rule, policy: Policy) -> Iterator[Finding]:
    vertices = graph.vertices
    starts = beginnings(meant(rule.sources, vertices))
    targets = [v for v in meant(rule.not_to, vertices) if v.side == "sent"]
    best: dict[Vertex, tuple[Reached, list[Edge]]] = {}
    for releases, group in _by_releases(starts, policy):
        passing = _passing(rule.by, releases)
        found = downstream(graph, group, passing)
        for target in targets:
            reached = found.get(target)
            if reached is None:
                continue
            way = way_to(found, target)
            if not way:  # it is one of the sources itself
                reached, way = _from_another(graph, target, group, found, passing)
            known = best.get(target)
            if way and (known is None or _order(reached) < _order(known[0])):
                best[target] = reached, way
    for target, (reached, way) in sorted(best.items()):
        yield _broken(rule, way, target, reached)


def _from_another(
    graph: FlowGraph, target: Vertex, starts: Iterable[Vertex], found: dict[Vertex, Reached], passing: Passing
) -> tuple[Reached, list[Edge]]:
    """How one of the sources is reached from those of other names; no way where it is not."""
    direct = [e for e in graph.into.get(target, ()) if e.source.end != target.end and passing(e)]
    direct = [e for e in direct if (source := found.get(e.source)) is not None and source.by is None]
    if direct:  # mostly
        edge = min(direct, key=lambda e: (STRENGTHS.index(e.strength), e.assumed))
        return Reached(edge.strength, edge.assumed, edge, 1), [edge]
    behind = upstream(graph, [target], passing)
    others = [s for s in starts if s in behind and s.end != target.end]
    if not others:
        return Reached("data", False, None, 0), []
    first = min(others, key=lambda s: (_order(behind[s]), s))
    return behind[first], way_from(behind, first)


def _order(reached: Reached) -> tuple[int, bool, int]:
    return STRENGTHS.index(reached.strength), reached.assumed, reached.steps


def _others(graph: FlowGraph, rule: Rule, policy: Policy) -> Iterator[Finding]:
    vertices = graph.vertices
    targets = [v for v in meant(rule.to, vertices) if v.side == "sent"]
    allowed = set(meant(rule.only_from, vertices))
    groups = list(_by_releases([v for v in vertices if v.side == "in" and v not in allowed], policy))
    for releases, group in groups:
        passing = _passing(rule.by, releases)
        found = upstream(graph, targets, lambda e, p=passing: p(e) and e.target not in allowed)  # type: ignore[misc]  # bound at once
        for origin in group:
            reached = found.get(origin)
            if reached is None or reached.by is None or origin.end.kind in _NOBODYS:
                continue
            if not any(edge.source in found for edge in graph.into.get(origin, ())):
                way = way_from(found, origin)
                yield _broken(rule, way, way[-1].target, reached)


def _broken(rule: Rule, way: list[Edge], target: Vertex, reached: Reached) -> Finding:
    source = way[0].source
    path = tuple({(p.file, p.line): p for edge in way for p in edge.path if p.file}.values())
    via = [edge.node for edge in way if edge.node]
    how = {"data": "reaches", "control": "decides", "trigger": "triggers"}[reached.strength]
    message = f"{source} {how} {target} through {', '.join(dict.fromkeys(via))}, which {rule.name!r} forbids"
    place = path[-1] if path else _NOWHERE
    if reached.assumed:
        unsure = next(edge.node for edge in way if edge.assumed)
        message = f"{source} may reach {target}, which {rule.name!r} forbids: not all is known of {unsure}"
        return Finding("RW604", message, place, nodes=tuple(dict.fromkeys(via)), path=path)
    return Finding("RW601", message, place, nodes=tuple(dict.fromkeys(via)), path=path)


def _names_nothing(graph: FlowGraph, rule: Rule) -> Iterator[Finding]:
    vertices = graph.vertices
    nodes = {e.node for edges in graph.out.values() for e in edges}
    protected = rule.sources or rule.to
    if protected and not meant(protected, vertices) and not any(s.node and any(map(s.fits, nodes)) for s in protected):
        words = ", ".join(s.word for s in protected)
        yield Finding("RW603", f"nothing is called {words}: the flow rule {rule.name!r} protects nothing", _NOWHERE)
        return
    for selection in (*rule.sources, *rule.not_to, *rule.to, *rule.only_from):
        if selection.word.endswith("*") or selection.kind in ("network", "file", "log", "process", "stdout"):
            continue
        known = any(map(selection.fits, nodes)) if selection.node else any(map(selection.means, vertices))
        if not known:
            yield Finding("RW603", f"{selection.word!r} in the flow rule {rule.name!r} names nothing", _NOWHERE)


def _releases(graph: FlowGraph, release: Release) -> Iterator[Finding]:
    """Whether something is released, and whether what is secret decides that."""
    words = ", ".join(s.word for s in release.through)
    vertices = graph.vertices
    starts = beginnings(meant(release.of, vertices))
    found = downstream(graph, starts, at_least("control"))
    passing = [
        edge
        for vertex in found
        for edge in graph.out.get(vertex, ())
        if any(_goes_through(edge, s) for s in release.through)
    ]
    if not passing:
        yield Finding("RW602", f"the flow release through {words} releases nothing", _NOWHERE)
    deciding = [edge for edge in _inside(graph, passing) if edge.strength == "control" and edge.source in found]
    yield from (_deciding(edge, words) for edge in deciding[:1])


def _decided(graph: FlowGraph, rule: Rule, policy: Policy) -> Iterator[Finding]:
    """What a rule protects decides what a function of a library releases, of which a model says that it does."""
    marked = [v for v in graph.vertices if v.end.kind == "released" and v.end.name not in policy.functions]
    if not marked or not rule.sources:
        return
    found = downstream(graph, beginnings(meant(rule.sources, graph.vertices)), at_least("control"))
    for vertex in marked:
        for edge in graph.into.get(vertex, ()):
            if edge.strength == "control" and edge.source in found:
                yield _deciding(edge, vertex.end.name)
                break


def _deciding(edge: Edge, words: str) -> Finding:
    message = f"{edge.source} decides what {words} releases"
    return Finding("RW606", message, edge.path[-1] if edge.path else _NOWHERE, nodes=(edge.node,))


def _inside(graph: FlowGraph, passing: list[Edge]) -> Iterator[Edge]:
    """The flows in nodes at which a release takes place: those that pass it, or make the topic that does."""
    for edge in passing:
        if edge.node:
            yield edge
        else:
            yield from (e for e in graph.into.get(edge.source, ()) if e.node)


def _contradictions(policy: Policy) -> Iterator[Finding]:
    """One rule allows by name what another one forbids."""
    allowed = [(r, s, t) for r in policy.rules for s in r.only_from for t in r.to]
    forbidden = {(s.word, t.word): r for r in policy.rules for s in r.sources for t in r.not_to}
    for rule, source, target in allowed:
        other = forbidden.get((source.word, target.word))
        if other is not None:
            message = f"{rule.name!r} lets {source.word} reach {target.word}, which {other.name!r} forbids"
            yield Finding("RW607", message, _NOWHERE)
