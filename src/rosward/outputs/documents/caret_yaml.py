# SPDX-License-Identifier: Apache-2.0
"""The flows of a system as an architecture file of CARET: which callback publishes what, and which reads what another one wrote.

The format is that of caret_analyze (main, June 2026: infra/yaml/architecture_reader_yaml.py, architecture/architecture_exporter.py). What
flows do not say is `UNDEFINED`: groups, executors, and outputs that no callback sends.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Final, NamedTuple

from rosward.outputs.documents.json_text import json_text
from rosward.ros.entities import EntityKind, Node
from rosward.ros.flows import STRENGTHS, End, NodeCallback, NodeFlows

__all__ = ["caret_yaml"]

_UNDEFINED: Final = "UNDEFINED"
_TF: Final = ("/tf", "/tf_static")
_NOTHING: Final = NodeFlows()


class _Callback(NamedTuple):
    """One callback as CARET tells them apart: `topic` is None for a timer. `passes`: topics that arrived, each with one that holds it."""

    name: str
    topic: str | None
    symbol: str
    period: int
    publishes: frozenset[str]
    passes: frozenset[tuple[str, str]]
    order: int


def caret_yaml(nodes: Sequence[Node]) -> str:
    """The text of the file. Nodes and topics of whose names a part is not known cannot be in it; a comment says how many."""
    known = sorted((n for n in nodes if "*" not in n.fqn), key=lambda n: n.fqn)
    by_name = {node.fqn: node for node in known}
    lines = ["# What each callback publishes and passes on, from the source by `rosward flow`."]
    left_out = len(nodes) - len(by_name)
    if left_out:
        lines.append(f"# Left out, since their names are not known or not their own: {left_out} of {len(nodes)} nodes.")
    lines += ["named_paths: []", "executors: []", "nodes:" if by_name else "nodes: []"]
    for node in by_name.values():
        lines += _node(node)
    return "\n".join(lines) + "\n"


def _node(node: Node) -> Iterator[str]:
    flows = node.flows or _NOTHING
    callbacks = _callbacks(node, flows)
    publishes, subscribes = _topics(node, EntityKind.PUBLISHER), _topics(node, EntityKind.SUBSCRIPTION)
    unsure = "" if node.flows is not None and flows.complete else "  # not wholly known: it may pass on more"
    yield f"- node_name: {_text(node.fqn)}{unsure}"
    if callbacks:
        yield "  callback_groups:"
        yield f"  - callback_group_type: {_UNDEFINED}"
        yield f"    callback_group_name: {_text(node.fqn + '/callback_group_0')}"
        yield "    callback_names:"
        yield from (f"    - {_text(each.name)}" for each in callbacks)
        yield "  callbacks:"
        for each in callbacks:
            yield from _callback(each)
    passings = sorted(set(_passings(callbacks)))
    if passings:
        yield "  variable_passings:"
        for write, read in passings:
            yield f"  - callback_name_write: {_text(write)}"
            yield f"    callback_name_read: {_text(read)}"
    if publishes:
        yield "  publishes:"
        for topic in publishes:
            yield f"  - topic_name: {_text(topic)}"
            yield "    callback_names:"
            names = [each.name for each in callbacks if topic in each.publishes]
            yield from (f"    - {_text(name)}" for name in names or [_UNDEFINED])
    if subscribes:
        yield "  subscribes:"
        for topic in subscribes:
            for each in callbacks:
                if each.topic == topic:
                    yield f"  - topic_name: {_text(topic)}"
                    yield f"    callback_name: {_text(each.name)}"
                    yield from _order(each)
    contexts = list(_contexts(flows, callbacks, subscribes, publishes))
    if contexts:
        yield "  message_contexts:"
        for how, subscribed, published in contexts:
            yield f"  - context_type: {how}"
            yield f"    subscription_topic_name: {_text(subscribed)}"
            yield f"    publisher_topic_name: {_text(published)}"


def _callback(callback: _Callback) -> Iterator[str]:
    yield f"  - callback_name: {_text(callback.name)}"
    if callback.topic is None:
        yield "    callback_type: timer_callback"
        yield f"    period_ns: {callback.period}" + ("" if callback.period else "  # not known")
    else:
        yield "    callback_type: subscription_callback"
        yield f"    topic_name: {_text(callback.topic)}"
    yield f"    symbol: {_text(callback.symbol or _UNDEFINED)}"
    yield from _order(callback)


def _order(callback: _Callback) -> Iterator[str]:
    if callback.order:
        yield f"    construction_order: {callback.order}"


def _callbacks(node: Node, flows: NodeFlows) -> list[_Callback]:
    """Those that a topic or a timer wakes; a subscription of which no callback is known has one all the same."""
    found: list[tuple[str | None, NodeCallback | None, str]] = []
    subscriptions = [e for e in node.of_kind(EntityKind.SUBSCRIPTION) if not e.system and "*" not in e.name]
    for each in flows.callbacks:
        if each.period is not None:
            found.append((None, each, each.function))
        topics = {end.name for end in each.events if end.kind == "topic"}
        found += [(topic, each, each.function) for topic in sorted(topics & {e.name for e in subscriptions})]
    woken = {topic for topic, _, _ in found}
    found += [(e.name, None, e.callback or "") for e in subscriptions if e.name not in woken]
    made: list[_Callback] = []
    seen: dict[tuple[str | None, int, str], int] = {}
    for number, (topic, callback, symbol) in enumerate(found):
        period = (callback.period or 0) if callback is not None else 0
        alike = (topic, period if topic is None else 0, symbol if topic is None else "")
        order = seen[alike] = seen.get(alike, -1) + 1
        sends = [
            (to, sources)
            for sink, sources in (callback.sends if callback is not None else ())
            for to in _published(sink)
        ]
        passes = frozenset((source.name, to) for to, sources in sends for source in sources if source.kind == "topic")
        publishes = frozenset(to for to, _ in sends)
        made.append(_Callback(f"{node.fqn}/callback_{number}", topic, symbol, period, publishes, passes, order))
    return made


def _topics(node: Node, kind: EntityKind) -> list[str]:
    return sorted({e.name for e in node.of_kind(kind) if not e.system and "*" not in e.name})


def _published(sent: End) -> tuple[str, ...]:
    """The topics on which an output goes."""
    return {"topic": (sent.name,), "tf": _TF}.get(sent.kind, ())


def _passings(callbacks: Sequence[_Callback]) -> Iterator[tuple[str, str]]:
    """The callback at which a message arrives writes what another one reads that sends it, or something that depends on it."""
    for reader in callbacks:
        topics = {topic for topic, _ in reader.passes if topic != reader.topic}
        yield from ((writer.name, reader.name) for writer in callbacks if writer.topic in topics)


def _contexts(
    flows: NodeFlows, callbacks: Sequence[_Callback], subscribes: Sequence[str], publishes: Sequence[str]
) -> Iterator[tuple[str, str, str]]:
    """How each topic that arrives comes to each that is published: along callbacks, or otherwise as the latest message."""
    chained = {pair for callback in callbacks for pair in callback.passes}
    made = {
        (end.name, topic)
        for sink in flows.sinks
        for topic in _published(sink.sink)
        for strength in STRENGTHS
        for end in sink.of(strength)
        if end.kind == "topic"
    }
    for subscribed, published in sorted(chained | made):
        if subscribed in subscribes and published in publishes:
            how = "callback_chain" if (subscribed, published) in chained else "use_latest_message"
            yield how, subscribed, published


def _text(text: str) -> str:
    """Quoted as JSON has it, which is YAML: names may hold anything."""
    return json_text(text).rstrip()
