# SPDX-License-Identifier: Apache-2.0
"""Why a number of ours differs from the paper's: each difference as a sum of causes, computed from the source.

Three witnesses are compared: what rosward found, what the paper's table says, and the calls that stand in the source.
The paper's program counts one entity for each call, and for each node three system publishers, one system subscription
and seven services. What differs from that on its side, or on ours, is a cause of its own.
"""

from __future__ import annotations

import itertools
from collections import defaultdict
from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from facts import Entity, Graph
from sites import LIBRARIES, Scan, Site

COLUMNS = ("N", "T", "S", "A", "PUB", "SUB", "SS", "SC", "AS", "AC")
"""The columns of Table I: nodes, topics, services, actions, and the six kinds of entities."""

_KIND_OF = {
    "PUB": "publisher",
    "SUB": "subscription",
    "SS": "service",
    "SC": "client",
    "AS": "action_server",
    "AC": "action_client",
}
_NAMED_BY = {
    "T": ("publisher", "subscription"),
    "S": ("service", "client"),
    "A": ("action_server", "action_client"),
}
# What each node has by itself: (the paper's program, rosward)
_SYSTEM_PER_NODE = {"PUB": (3, 2), "SUB": (1, 0), "SS": (7, 7)}
_DISCOVERY = "ros_discovery_info: it belongs to the middleware's context, not to a node, and no policy can name it"


@dataclass(frozen=True, slots=True)
class Count:
    """A number of Table I and how much of it the client library creates."""

    total: int
    system: int = 0

    @property
    def user(self) -> int:
        """What the user's code creates."""
        return self.total - self.system

    def __str__(self) -> str:
        return f"{self.total}({self.system})" if self.system else str(self.total)


@dataclass(frozen=True, slots=True)
class Cause:
    """A part of the difference (ours minus the paper's) in one column; `right` is None where nothing explains it."""

    column: str
    delta: int
    text: str
    right: str | None
    where: tuple[str, ...] = ()


Row = dict[str, Count]


def count(graph: Graph) -> Row:
    """Our row of Table I."""
    row = {"N": Count(len(graph.nodes))}
    for column, names in (("T", graph.topics), ("S", graph.services), ("A", graph.actions)):
        row[column] = Count(len(names), sum(names.values()))
    for column, kind in _KIND_OF.items():
        ours = [entity for entity in graph.entities if entity.kind == kind]
        row[column] = Count(len(ours), sum(entity.system for entity in ours))
    return row


def explain(graph: Graph, scan: Scan, paper: Row) -> list[Cause]:
    """The causes of all differences; in each column they add up to ours minus the paper's."""
    ours = count(graph)
    causes = list(_nodes(graph, scan, paper))
    evidence = Evidence(graph, scan)
    for column, kind in _KIND_OF.items():
        causes += evidence.entities(column, kind)
        causes += evidence.lost_by_peer(column, kind, paper[column].user)
        causes += _system(graph, column, kind, ours, paper)
    for column in _NAMED_BY:
        causes += evidence.names(column, paper)
    for column in COLUMNS:
        rest = ours[column].total - paper[column].total - sum(c.delta for c in causes if c.column == column)
        if rest:
            causes.append(Cause(column, rest, "no cause was found", None))
    return causes


def source_text_names(scan: Scan) -> list[Site]:
    """The calls whose name the paper's program takes from the source text, f-string and all."""
    return [site for site in scan.entities if site.is_fstring]


class Evidence:
    """Which calls in the source each of our entities comes from, and back."""

    def __init__(self, graph: Graph, scan: Scan) -> None:
        self._graph = graph
        self._scan = scan
        self._user = [entity for entity in graph.entities if not entity.system]
        self._sites = {entity: self._sites_of(entity) for entity in self._user}
        self._entities: dict[Site, list[Entity]] = defaultdict(list)
        for entity, sites in self._sites.items():
            for site in sites:
                self._entities[site].append(entity)

    def _sites_of(self, entity: Entity) -> list[Site]:
        sites = [site for site in self._scan.entities if site.kind == entity.kind]
        return [site for site in sites if any(site.covers(spot) for spot in entity.spots)]

    def _library(self, entity: Entity) -> Site | None:
        covering = (site for site in self._scan.libraries if any(site.covers(spot) for spot in entity.spots))
        return next(covering, None)

    def _components(self, kind: str) -> Iterator[tuple[list[Site], list[Entity]]]:
        """The calls and entities of a kind, put together where they belong to each other."""
        waiting: list[Site | Entity] = [site for site in self._scan.entities if site.kind == kind]
        waiting += [entity for entity in self._user if entity.kind == kind]
        done: set[Site | Entity] = set()
        for start in waiting:
            if start in done:
                continue
            reached, edge = {start}, [start]
            while edge:
                item = edge.pop()
                near: Iterable[Site | Entity] = self._entities[item] if isinstance(item, Site) else self._sites[item]
                new = [other for other in near if other not in reached]
                reached.update(new)
                edge += new
            done |= reached
            sites = [item for item in reached if isinstance(item, Site)]
            yield sites, [item for item in reached if isinstance(item, Entity)]

    def entities(self, column: str, kind: str) -> Iterator[Cause]:
        """Why our entities of a kind are not one for each call."""
        for sites, entities in self._components(kind):
            delta = len(entities) - len(sites)
            where = tuple(sorted(map(str, sites))) or tuple(f"{f}:{n}" for f, n in entities[0].spots)
            if not sites:
                yield self._without_site(column, entities, where)
            elif not entities:
                yield self._without_entity(column, sites[0], where)
            elif delta < 0:
                text = "calls that create one name in one node again: one entity to us, one for each call to the peer"
                yield Cause(column, delta, text, "both", where)
            elif delta > 0:
                yield _repeated(column, delta, sites, entities, where)

    def _without_site(self, column: str, entities: list[Entity], where: tuple[str, ...]) -> Cause:
        library = self._library(entities[0])
        if library is None:
            return Cause(column, len(entities), f"{entities[0].name} of ours comes from no call", None, where)
        text = f"{LIBRARIES[library.kind]} entities, which the peer does not see"
        return Cause(column, len(entities), text, "rosward", where)

    def _without_entity(self, column: str, site: Site, where: tuple[str, ...]) -> Cause:
        codes = {finding.code for finding in self._graph.findings if site.covers(finding.spot)}
        if "RW205" in codes:
            return Cause(column, -1, "a call that nothing reaches: no permission is needed for it", "rosward", where)
        if codes & {"RW103", "RW209"}:
            return Cause(column, -1, "a call that fails when it runs", "rosward", where)
        said = f"we say {', '.join(sorted(codes))}" if codes else "we say nothing of it"
        return Cause(column, -1, f"a call of which we know no entity ({said})", None, where)

    def lost_by_peer(self, column: str, kind: str, paper: int) -> Iterator[Cause]:
        """Why the paper's number is not that of the calls."""
        sites = [site for site in self._scan.entities if site.kind == kind]
        lost = len(sites) - paper
        suspects = [site for site in sites if site.name is None]
        if lost < 0:
            yield Cause(column, lost, "the peer counts more than there are calls", None)
        elif lost and len(suspects) >= lost:
            fstrings = [site for site in suspects if site.is_fstring]
            shown = fstrings if len(fstrings) >= lost else suspects
            text = "calls that the peer loses: it counts fewer than there are, all others have plain names"
            yield Cause(column, lost, text, "rosward", tuple(map(str, shown)))
        elif lost:
            yield Cause(column, lost, "the peer counts fewer than there are calls, though their names are plain", None)

    def names(self, column: str, paper: Row) -> Iterator[Cause]:
        """Why the sets of names differ in size, from the names that the paper's program must have seen."""
        table = {"T": self._graph.topics, "S": self._graph.services, "A": self._graph.actions}[column]
        ours = {name for name, system in table.items() if not system}
        theirs = self._names_of_peer(column, paper)
        if theirs is None:
            text = "the paper's number is not that of the names in the source"
            yield Cause(column, len(ours) - paper[column].user, text, None)
        else:
            for name in sorted(ours - theirs.keys()):
                yield self._name_of_ours(column, name)
            for name in sorted(theirs.keys() - ours):
                yield self._name_of_theirs(column, name, theirs[name])
        system = sum(table.values()) - paper[column].system
        yield from _system_names(column, system, self._graph, paper)

    def _names_of_peer(self, column: str, paper: Row) -> dict[str, Site] | None:
        """The names that the paper's program sees, with a call for each; None where their number is not the paper's."""
        kinds = _NAMED_BY[column]
        sites = [site for site in self._scan.entities if site.kind in kinds]
        counted = sum(paper[column].user for column, kind in _KIND_OF.items() if kind in kinds)
        lost = max(len(sites) - counted, 0)
        suspects = [site for site in sites if site.is_fstring] or [site for site in sites if site.name is None]
        for without in itertools.islice(itertools.combinations(suspects, lost), 10_000):
            names = {self._name_to_peer(site): site for site in reversed(sites) if site not in without}
            if len(names) == paper[column].user:
                return names
        return None

    def _name_to_peer(self, site: Site) -> str:
        found = {entity.name for entity in self._entities[site]}
        if site.is_fstring:
            return site.written
        if len(found) == 1:
            return found.pop()
        if site.name is not None:
            return site.name if site.name.startswith("/") else f"/{site.name}"
        return "TOP"

    def _name_of_ours(self, column: str, name: str) -> Cause:
        having = [e for e in self._user if e.name == name and e.kind in _NAMED_BY[column]]
        libraries = {LIBRARIES[site.kind] for site in map(self._library, having) if site is not None}
        if libraries:
            return Cause(
                column, 1, f"{' and '.join(sorted(libraries))} names, which the peer does not see", "rosward", (name,)
            )
        sites = [site for entity in having for site in self._sites[entity]]
        if any(site.name is None for site in sites):
            text = "names that the source computes: the peer writes source text or TOP"
            return Cause(column, 1, text, "rosward", (f"{name} ({sites[0]})",))
        return Cause(column, 1, "a name of ours that no call in the source explains", None, (name,))

    def _name_of_theirs(self, column: str, name: str, site: Site) -> Cause:
        where = (f"{name} ({site})",)
        if site.is_fstring or name == "TOP":
            return Cause(column, -1, "names of the peer that are source text or TOP", "rosward", where)
        cause = self._without_entity(column, site, where)
        if self._entities[site]:
            return Cause(column, -1, "a name of the peer that we do not have", None, where)
        return cause


def _repeated(column: str, delta: int, sites: list[Site], entities: list[Entity], where: tuple[str, ...]) -> Cause:
    nodes = {entity.node for entity in entities}
    if len(nodes) > 1:
        return Cause(column, delta, "calls that run for several nodes: the peer counts them once", "rosward", where)
    if all(site.name is not None for site in sites):
        return Cause(column, delta, "several entities of ours from a call with a plain name", None, where)
    if all(entity.conditional for entity in entities):
        return Cause(
            column, delta, "calls whose name is one of several constants: the peer counts one", "rosward", where
        )
    return Cause(column, delta, "calls that run with several names: the peer counts one", "rosward", where)


def _nodes(graph: Graph, scan: Scan, paper: Row) -> Iterator[Cause]:
    """The paper has one node for each file of a project."""
    by_file: dict[str, list[str]] = {file: [] for file in scan.files}
    for node in graph.nodes:
        by_file.setdefault(node.spot[0], []).append(f"{node.name} ({node.spot[0]}:{node.spot[1]})")
    if len(scan.files) != paper["N"].total:
        yield Cause("N", len(scan.files) - paper["N"].total, "the paper does not have one node for each file", None)
    for file, nodes in by_file.items():
        calls = [site for site in scan.nodes if site.file == file]
        if len(nodes) > 1 and len(calls) >= len(nodes):
            yield Cause("N", len(nodes) - 1, "files that create several nodes", "rosward", tuple(nodes))
        elif len(nodes) != 1:
            yield Cause("N", len(nodes) - 1, "not one node in a file that creates one", None, (*nodes,) or (file,))


def _system(graph: Graph, column: str, kind: str, ours: Row, paper: Row) -> Iterator[Cause]:
    """What each node has by itself."""
    theirs, mine = _SYSTEM_PER_NODE.get(column, (0, 0))
    nodes = paper["N"].total
    if theirs != mine:
        yield Cause(column, (mine - theirs) * nodes, _DISCOVERY, "rosward")
    if paper[column].system != theirs * nodes:
        yield Cause(
            column, theirs * nodes - paper[column].system, "the paper's system entities are not the usual ones", None
        )
    if ours["N"].total != nodes and mine:
        text = "what the client library creates in the further nodes"
        yield Cause(column, mine * (ours["N"].total - nodes), text, "rosward")
    by_node: dict[str, list[str]] = {node.name: [] for node in graph.nodes}
    for entity in graph.entities:
        if entity.system and entity.kind == kind:
            by_node[entity.node].append(entity.name)
    for node, names in by_node.items():
        if len(names) != mine:
            yield _unusual(column, len(names) - mine, node, names)


def _unusual(column: str, delta: int, node: str, names: list[str]) -> Cause:
    """A node whose system entities are not the usual ones."""
    if any(name == "/clock" for name in names) and delta == 1:
        return Cause(column, delta, "/clock, which use_sim_time subscribes to", "rosward", (node,))
    return Cause(column, delta, f"unusual system entities: {', '.join(names) or 'none'}", None, (node,))


def _system_names(column: str, delta: int, graph: Graph, paper: Row) -> Iterator[Cause]:
    if column == "T" and delta:
        yield Cause(column, -1, _DISCOVERY, "rosward")
        if graph.topics.get("/clock"):
            yield Cause(column, 1, "/clock, which use_sim_time subscribes to", "rosward")
    elif column == "S" and delta:
        further = len(graph.nodes) - paper["N"].total
        if further and delta == 7 * further:
            yield Cause(column, delta, "what the client library creates in the further nodes", "rosward")
