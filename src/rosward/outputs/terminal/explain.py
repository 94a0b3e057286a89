# SPDX-License-Identifier: Apache-2.0
"""The answer of `rosward explain` for a person, and as JSON.

topic /porter/battery  sensor_msgs/msg/BatteryState
  1 publisher, 1 subscription

publisher of /porter/base_driver
  created   delivery_base/delivery_base/base_driver.py:31
              30 │         self._odometry = self.create_publisher(Odometry, 'odom', SENSOR)
            > 31 │         self._battery = self.create_publisher(BatteryState, 'battery', SENSOR)
  …

Ends that differ in their node alone, such as those of the robots of a fleet, are told once.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from typing import Final

from rosward.explanation.answers import Answer, DoubtTold, EnclaveTold, EndTold, MeetingTold, NodeTold, RuleTold
from rosward.explanation.content import ContentTold, StepTold
from rosward.explanation.excerpts import Excerpt
from rosward.explanation.provenance import NameSource, PolicyLine, Start
from rosward.outputs.terminal.flow_text import path_text, shown
from rosward.ros.entities import KIND_ORDER, EntityKind
from rosward.safe import encodable, printable

__all__ = ["explain_text"]

_WHOLE: Final = 3
"""Subjects that are told in full; of more, each gets one line."""

_GROUPS: Final = 8
"""Kinds of ends that are told in full; of more, each end gets one line."""

_SHOWN: Final = 12
"""Lines of a list that are shown."""

_STEPS: Final = 60
"""Steps that lead to a content, of which so many are shown."""
_NAMED: Final = 6
_RESOLUTIONS: Final = {
    "exact": "exact: determined by the code alone",
    "default": "default: holds unless it is set from outside",
    "bound": "bound: set from outside",
}
_INTERFACES: Final = {
    "analysed": "analysed: derived from its source",
    "declared": "declared: described in a file",
    "partial": "partially known: it may have more than this",
    "unknown": "unknown: only what every node has",
}
_IGNORING: Final = {"error": ", and its code in `accepted` of the configuration"}


def explain_text(answer: Answer) -> str:
    """The answer for a terminal."""
    if answer.empty:
        lines = [f"{answer.query}: no name in the result matches or ends with this, and nothing is at this place"]
        lines += ["did you mean", *(f"  {name}" for name in answer.close)] if answer.close else []
    else:
        lines = list(_sections(answer))
        while lines and not lines[-1]:
            lines.pop()
    return "\n".join(encodable(printable(line)) for line in lines) + "\n"


def _sections(answer: Answer) -> Iterator[str]:
    if answer.rule is not None:
        yield from _rule_of_findings(answer.rule, len(answer.doubts))
    brief = len(answer.meetings) + len(answer.nodes) + len(answer.enclaves) > _WHOLE
    if brief:
        yield f"{answer.query} matches the end of several names; pass a longer name to see all details"
        yield from (f"  {m.word:<8} {m.name}  {_numbers(m)}" for m in answer.meetings)
        yield from (f"  node     {n.name}  {_started(n.start)}" for n in answer.nodes)
        yield from (f"  enclave  {e.path}  {', '.join(e.nodes)}" for e in answer.enclaves)
        yield ""
    else:
        for meeting in answer.meetings:
            yield from _meeting(meeting)
        for node in answer.nodes:
            yield from _node(node)
        for enclave in answer.enclaves:
            yield from _enclave(enclave)
    yield from _ends(answer.ends, named=True)
    if answer.through:
        yield "through a call on this line"
        yield from _cut(f"  {e.kind} {e.name} of {e.node}  {_at(e)}" for e in answer.through)
        yield ""
    yield from _doubts(answer.doubts, helped=answer.rule is not None)


def _rule_of_findings(rule: RuleTold, found: int) -> Iterator[str]:
    yield f"{rule.code} {rule.title}"
    yield _row(rule.severity, rule.meaning)
    yield _row("do", rule.help)
    yield _row("ignore", f"# rosward: ignore[{rule.code}] on its line{_IGNORING.get(rule.severity, '')}")
    if not rule.searched:
        yield _row("find", f"rosward explain {rule.code} PATH lists where it applies")
    else:
        yield _row("found", f"{found}" if found else "nowhere in the sources")
    yield ""


def _meeting(meeting: MeetingTold) -> Iterator[str]:
    yield f"{meeting.word} {meeting.name}  {', '.join(meeting.types) or 'of unknown type'}"
    yield from _overview(meeting)
    yield ""
    yield from _ends(meeting.ends, named=False)
    if meeting.content is not None:
        yield from _contents(meeting, meeting.content)


def _contents(meeting: MeetingTold, content: Sequence[ContentTold]) -> Iterator[str]:
    """What it is made of: directly with the source, and what that is made of by the lines alone."""
    if not content:
        yield f"{meeting.word} {meeting.name}: no statement of the sources sends it"
        yield ""
    for each in content:
        yield f"{shown(each.of)} is made of"
        for told in each.constant:
            yield f"  constant  by {told.node}"
            yield from _code([told.at])
        for step in each.steps[:_STEPS]:
            yield from _step(step)
        if len(each.steps) > _STEPS:
            yield f"  … and {len(each.steps) - _STEPS} more (--json has all)"
        yield from (f"  not all is known of {node}: what it sends may hold more" for node in each.unsure)
        yield ""


def _step(step: StepTold) -> Iterator[str]:
    marks = "  (assumed)" * step.assumed + "  (made of what is above)" * step.above
    head = f"{'  ' * step.depth}{step.strength:<9} {shown(step.source)}  by {step.node}"
    if step.depth == 1:
        yield head + marks
        yield from _code(step.lines)
    else:
        yield f"{head}  {path_text(e.place for e in step.lines)}{marks}"


def _code(excerpts: Iterable[Excerpt]) -> Iterator[str]:
    """Each line, behind the file where that is another one than before."""
    file = ""
    for place, lines in excerpts:
        if place.file != file:
            yield f"            {place.file}"
            file = place.file
        yield from (f"              {number:>4} │ {text}".rstrip() for number, text in lines)


def _overview(meeting: MeetingTold) -> Iterator[str]:
    """Who has an end of it, those that give before those that take."""
    nodes: dict[str, dict[str, None]] = {}
    for end in sorted(meeting.ends, key=lambda e: KIND_ORDER[EntityKind(e.kind)]):
        nodes.setdefault(end.kind, {})[end.node] = None
    counts = Counter(end.kind for end in meeting.ends)
    heads = {kind: f"{counts[kind]} {kind}{'' if counts[kind] == 1 else 's'}" for kind in nodes}
    wide = max(map(len, heads.values()), default=0)
    for kind, names in nodes.items():
        ordered = sorted(names)
        more = f", and {len(ordered) - _NAMED} more" if len(ordered) > _NAMED else ""
        yield f"  {heads[kind]:<{wide}}  {', '.join(ordered[:_NAMED])}{more}"


def _numbers(meeting: MeetingTold) -> str:
    counts = Counter(end.kind for end in meeting.ends)
    return ", ".join(f"{n} {kind}{'' if n == 1 else 's'}" for kind, n in counts.items())


def _ends(ends: Sequence[EndTold], *, named: bool) -> Iterator[str]:
    groups: dict[tuple[object, ...], list[EndTold]] = {}
    for end in ends:
        groups.setdefault(_alike(end, named=named), []).append(end)
    if len(groups) > _GROUPS:
        yield from _cut(f"  {e.kind} {e.name} of {e.node}  {_at(e)}{_marks(e)}" for e in ends)
        yield ""
        return
    for members in groups.values():
        yield from _group(members, named=named)
        yield ""


def _alike(end: EndTold, *, named: bool) -> tuple[object, ...]:
    places = tuple(excerpt.place for excerpt in end.created) if not end.system else ()
    made_of = tuple((s.name, repr(s.value), s.origin) for s in end.made_of)
    return (
        *(end.kind, end.type, end.qos, end.via, end.conditional, end.resolution, end.callback),
        *(places, made_of, end.remaps, end.missing, end.name if named else "", end.system),
        _rule(end.policy),
    )


def _group(members: list[EndTold], *, named: bool) -> Iterator[str]:
    first = members[0]
    what = f"{first.kind} {first.name}  {first.type or 'of unknown type'}," if named else first.kind
    whose = first.node if len(members) == 1 else f"{len(members)} nodes"
    yield f"{what} of {whose}{', only in some executions' if first.conditional else ''}"
    if first.system:
        yield _row("created", "by the client library")
    else:
        for excerpt in first.created:
            yield from _excerpt("created", excerpt)
        if first.via:
            yield _row("by", first.via)
        if first.calls:
            more = "" if len({m.calls for m in members}) == 1 else "  (of the first node)"
            yield _row("calls", " → ".join(str(place) for place in first.calls) + more)
    yield from (_row("QoS", first.qos),) if first.qos else ()
    yield from (_row("callback", first.callback),) if first.callback else ()
    yield from _name(first)
    if len(members) == 1:
        yield _row("node", f"{first.node}, created at {first.node_at}")
        yield _row("started", _started(first.start))
        yield _row("policy", _policy(first.policy))
    else:
        wide = min(max(len(m.node) for m in members), 40)
        yield from _cut(_row("node" if m is first else "", f"{m.node:<{wide}}  {_started(m.start)}") for m in members)
        yield _row("policy", f"{_rule(first.policy)} in the enclave of each")


def _name(end: EndTold) -> Iterator[str]:
    if end.missing:
        yield _row(
            "name", f"{end.resolution}: {'partially known' if end.resolution == 'pattern' else 'cannot be determined'}"
        )
        yield from (_row("missing", reason) for reason in end.missing[:_SHOWN])
        yield from (_row("supply", remedy) for remedy in end.remedies)
    else:
        yield _row("name", _RESOLUTIONS.get(end.resolution, end.resolution))
    yield from (_row("" if at else "made of", _source(source)) for at, source in enumerate(end.made_of))
    yield from (_row("remap", f"{rule}  (remap rule of the launch file)") for rule in end.remaps)


def _source(source: NameSource) -> str:
    value = f" = {_value(source.value)}" if source.value is not None else ""
    places = ", ".join(str(place) for place in source.places[:3])
    origin = f": {source.origin}" if source.origin else ""
    return f"{source.what} {source.name}{value}{origin}" + (f" ({places})" if places else "")


def _value(value: object) -> str:
    text = repr(value)
    return text if len(text) <= 60 else text[:60] + "…"


def _started(start: Start) -> str:
    if start.assumed:
        return f"not by the sources: {start.process} is assumed to be created elsewhere"
    if start.launched_by is None:
        if start.package and start.executable:
            return f"ros2 run {start.package} {start.executable}"
        return f"process {start.process}"
    chain = "".join(f", included at {place}" for place in reversed(start.includes))
    return f"{start.process}, launched at {start.launched_by}{chain}"


def _policy(line: PolicyLine | None) -> str:
    return f"enclave {line.enclave}: {_rule(line)}" if line is not None else "none"


def _rule(line: PolicyLine | None) -> str:
    if line is None:
        return "no rule"
    return f"no rule: {line.why_not}" if line.why_not else f"{line.element} {line.rule}"


def _node(node: NodeTold) -> Iterator[str]:
    yield f"node {node.name}"
    yield from _excerpt("created", node.created)
    yield _row("started", _started(node.start))
    yield _row("enclave", node.enclave)
    yield _row("interface", _INTERFACES.get(node.interface, node.interface))
    yield from (_row("missing", reason) for reason in node.lacks[:_SHOWN])
    if node.missing:
        yield _row("name", node.resolution)
        yield from (_row("missing", reason) for reason in node.missing)
        yield from (_row("supply", remedy) for remedy in node.remedies)
    own = [end for end in node.ends if not end.system]
    for kind in dict.fromkeys(end.kind for end in own):
        rows = [end for end in own if end.kind == kind]
        yield ""
        yield f"  {kind}{'' if len(rows) == 1 else 's'}"
        wide = min(max(len(end.name) for end in rows), 44)
        yield from (f"    {end.name:<{wide}}  {end.type or '?'}  {_at(end)}{_marks(end)}" for end in rows)
    if len(own) < len(node.ends):
        yield ""
        yield f"  and {len(node.ends) - len(own)} entities that the client library creates"
    if node.parameters:
        yield ""
        yield f"  parameter{'' if len(node.parameters) == 1 else 's'}"
        for p in node.parameters:
            value = _value(p.value) if p.value is not None else "(unknown or not a plain value)"
            set_ = (
                f"  (default {_value(p.default)})" if repr(p.value) != repr(p.default) and p.default is not None else ""
            )
            yield f"    {p.name} = {value}{set_}  {p.declared_at or ''}".rstrip()
    yield ""
    yield from _doubts(node.doubts)


def _at(end: EndTold) -> str:
    return str(end.created[0].place) if end.created else ""


def _marks(end: EndTold) -> str:
    marks = [end.resolution] if end.resolution != "exact" else []
    marks += ["conditional"] if end.conditional else []
    return f"  [{', '.join(marks)}]" if marks else ""


def _enclave(enclave: EnclaveTold) -> Iterator[str]:
    yield f"enclave {enclave.path}"
    yield _row("nodes" if len(enclave.nodes) > 1 else "node", ", ".join(enclave.nodes))
    lines = dict.fromkeys(f"    {_rule(rule)}" for rule in enclave.rules if not rule.why_not)
    yield "  rules"
    yield from lines
    omitted = [rule for rule in enclave.rules if rule.why_not]
    if omitted:
        yield "  omitted"
        yield from _cut(f"    {rule.rule}: {rule.why_not}" for rule in omitted)
    yield ""


def _doubts(doubts: Sequence[DoubtTold], *, helped: bool = False) -> Iterator[str]:
    for doubt in doubts[:_SHOWN]:
        yield f"{doubt.severity} {doubt.code} {doubt.title}"
        yield _row("what", doubt.message)
        yield from _excerpt("where", doubt.excerpt)
        if not helped:
            yield _row("do", doubt.help)
        yield ""
    if len(doubts) > _SHOWN:
        yield f"… and {len(doubts) - _SHOWN} more (--json has all)"


def _excerpt(word: str, excerpt: Excerpt) -> Iterator[str]:
    yield _row(word, str(excerpt.place))
    wide = len(str(excerpt.lines[-1].line)) if excerpt.lines else 0
    for number, text in excerpt.lines:
        mark = ">" if number == excerpt.place.line else " "
        yield f"            {mark} {number:>{wide}} │ {text}".rstrip()


def _row(word: str, text: str) -> str:
    return f"  {word:<9} {text}".rstrip()


def _cut(lines: Iterable[str]) -> Iterator[str]:
    every = list(lines)
    yield from every[:_SHOWN]
    if len(every) > _SHOWN:
        yield f"    … and {len(every) - _SHOWN} more (--json has all)"
