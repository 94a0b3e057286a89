# SPDX-License-Identifier: Apache-2.0
"""What does the report hold? One JSON document, version 1, schema in `outputs/schemas/report.schema.json`.

    network, its launched systems, the folder of its sources
      ->  {"version": 1, "summary": {…}, "nodes": […], "endpoints": […], "entities": […], "enclaves": […], "rules": […], "findings": […], "code": {…}}

Parts speak of each other by ids that are counted in the order of the network. Nothing depends on machine or time.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Final

from rosward._version import __version__
from rosward.explanation.provenance import Start, Starts
from rosward.findings import Finding
from rosward.location import Place
from rosward.network.checks import UnknownNames
from rosward.network.connect import with_findings
from rosward.network.counts import Count, counts_of
from rosward.network.graph import Network
from rosward.network.launch_tree import LaunchEntry
from rosward.network.loose_ends import loose_ends
from rosward.one_cause import alike
from rosward.outputs.background import Background
from rosward.outputs.documents.rows import place_row
from rosward.outputs.report.belongs import Belongings
from rosward.outputs.report.endpoints import endpoint_rows
from rosward.outputs.report.flows import NO_FLOWS, flows
from rosward.outputs.report.members import entity_rows, node_row
from rosward.outputs.report.numbered import Member, Numbered, numbered
from rosward.outputs.report.plain import harmless, place_rows
from rosward.outputs.report.rights import rights
from rosward.outputs.report.source_lines import SourceLines, source_lines
from rosward.records import NamedTuple
from rosward.rules import Severity

__all__ = ["VERSION", "report_document"]

VERSION: Final = 1


_NOTHING: Final = Background()


def report_document(
    network: Network, background: Background = _NOTHING, unknown: UnknownNames = "deny"
) -> dict[str, object]:
    """The document. `unknown` is what the policies in it say for a name that is not known."""
    loose = loose_ends(network) if background.loose is None else background.loose
    network = with_findings(network, loose)
    numbers = numbered(network)
    launched = _launched(numbers, background)
    granted = rights(network, numbers, unknown, background.widened)
    belongings = Belongings(numbers)
    subjects = [belongings.of(finding) for finding in network.findings]
    findings_of: dict[str, list[str]] = {}
    for number, ids in enumerate(subjects):
        for id_ in ids:
            findings_of.setdefault(id_, []).append(f"f{number}")
    flowing = flows(numbers) if background.flow else NO_FLOWS
    code = SourceLines({}, 0)
    if background.root is not None:
        code = source_lines(background.root, _places(network, numbers, launched), alone=flowing.places)
    return {
        "version": VERSION,
        "summary": _summary(network, code.left_out),
        "nodes": harmless([node_row(m, launched[m.id].start, granted, findings_of) for m in numbers.members]),
        "endpoints": harmless(endpoint_rows(numbers.endpoints, findings_of)),
        "entities": harmless(
            [row for m in numbers.members for row in entity_rows(m, launched[m.id].entries, granted, findings_of)]
        ),
        "enclaves": granted.enclaves,
        "rules": granted.rules,
        "findings": harmless(_findings(network.findings, subjects, ways=background.flow)),
        "code": harmless(code.lines),
        **({"flows": harmless(flowing.rows)} if background.flow else {}),
    }


class _Launched(NamedTuple):
    """What launch files say of a node."""

    start: Start
    entries: Sequence[LaunchEntry]


def _launched(numbers: Numbered, background: Background) -> dict[str, _Launched]:
    starts = Starts(background.systems)
    return {m.id: _Launched(starts.of(m.node), starts.entries(m.node)) for m in numbers.members}


def _summary(network: Network, places_left_out: int) -> dict[str, object]:
    counts = counts_of(network)
    return {
        "rosward": __version__,
        "distro": network.distro,
        "files": network.files,
        "lines": network.lines,
        "processes": network.processes,
        "complete": not counts.severities[Severity.ERROR],
        "counts": {
            "nodes": counts.nodes,
            "topics": _count(counts.topics),
            "services": _count(counts.services),
            "actions": _count(counts.actions),
            "names": {resolution.value: number for resolution, number in counts.names.items()},
            "findings": {severity.value: number for severity, number in counts.severities.items()},
        },
        "places_without_code": places_left_out,
    }


def _count(count: Count) -> dict[str, object]:
    return {"total": count.total, "system": count.system}


def _findings(findings: Sequence[Finding], subjects: Sequence[list[str]], *, ways: bool) -> list[dict[str, object]]:
    """`ways`: with the lines by which something flows, for those that are about that."""
    groups = alike(range(len(findings)), findings.__getitem__)
    first = {number: f"f{leader}" for leader, *others in groups for number in others}
    rows = [_finding(f"f{n}", finding, subjects[n], first.get(n)) for n, finding in enumerate(findings)]
    for row, finding in zip(rows, findings, strict=True):
        if ways and finding.path:
            row["way"] = place_rows(finding.path)
    return rows


def _finding(id_: str, finding: Finding, subjects: list[str], first: str | None) -> dict[str, object]:
    rule = finding.rule
    return {
        "id": id_,
        "code": finding.code,
        "severity": rule.severity.value,
        "title": rule.title,
        "help": rule.help,
        "message": finding.message,
        "place": place_row(finding.place),
        "subjects": subjects,
        "first": first,
    }


def _places(network: Network, numbers: Numbered, launched: Mapping[str, _Launched]) -> Iterator[Place]:
    """Every place of the document: what is doubted first, then what is made, then how one gets there."""
    members = numbers.members
    yield from (finding.place for finding in network.findings)
    yield from (place for member in members for place in _places_of(member))
    for member in members:
        for end in member.ends:
            yield from end.entity.path
        yield from _declared(member)
        yield from launched[member.id].start.includes
        for entry in launched[member.id].entries:
            yield entry.place
            yield from (parameter.place for parameter in entry.parameters if parameter.place is not None)


def _places_of(member: Member) -> Iterable[Place]:
    node = member.node
    yield node.defined_at
    if node.launched_by is not None:
        yield node.launched_by
    for end in member.ends:
        yield from end.entity.created_at


def _declared(member: Member) -> Iterable[Place]:
    return (p.declared_at for p in member.node.parameters if p.declared_at is not None)
