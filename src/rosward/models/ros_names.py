# SPDX-License-Identifier: Apache-2.0
"""The final name of a node, and what its remap rules make of names, as values with their origins and reasons.

Node('talker') started with -r __node:=left -r chatter:=~/out     name 'left'; 'chatter' is /left/out
"""

from __future__ import annotations

from typing import Final

from rosward.domain.choice import join_all, lift, options
from rosward.domain.text import concat, make, pattern
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, UNBOUND, Const, Ref, Text, Value
from rosward.holes import Holed, literal, shown
from rosward.models.command_line import CommandLine, Rule, read_words
from rosward.models.effects import EffectLog, NodeEffect
from rosward.models.host import host, text_of
from rosward.models.native import Machine, NativeCall, NativeFunction
from rosward.ros import names


def command_lines(log: EffectLog, effect: NodeEffect) -> tuple[CommandLine, CommandLine]:
    """What the node's own arguments (cli_args) and those of its context say."""
    return read_words(effect.words, log.configuration), read_words(effect.global_words, log.configuration)


def remaps_of(log: EffectLog, effect: NodeEffect) -> tuple[Rule, ...]:
    """The remap rules that hold for a node: its own first."""
    own, general = command_lines(log, effect)
    return (*own.remaps, *general.remaps)


def final_name(log: EffectLog, effect: NodeEffect) -> tuple[Value, Value]:
    """The name and namespace of a node behind its remap rules."""
    name = effect.name
    namespace = Const("/") if effect.namespace in (NONE, UNBOUND) else lift(_full_namespace, effect.namespace)
    rules = remaps_of(log, effect)
    if rules:
        name = join_all(v for n in options(name) for v in _renamed(n, pattern(n), names.RemapKind.NODE, rules))
        namespace = join_all(
            v
            for s in options(namespace)
            for n in options(name)
            for v in _renamed(s, pattern(n), names.RemapKind.NAMESPACE, rules)
        )
    return name, namespace


def _renamed(old: Value, node_name: Holed, kind: names.RemapKind, rules: tuple[Rule, ...]) -> list[Value]:
    """What the rules of a kind make of a node's name or namespace: several where holes leave open which applies."""
    found: list[Value] = []
    for rule, target in rules:
        applies = names.is_for_node(rule, node_name) if rule.kind is kind else False
        if applies is not False:
            found.append(lift(_full_namespace, target) if kind is names.RemapKind.NAMESPACE else target)
        if applies:
            return found
    return [*found, old]


def _full_namespace(value: Value) -> Value:
    if isinstance(value, Const):
        if value.value is None:
            return Const("/")
        return _full(value)
    if isinstance(value, Text):
        first = value.parts[0]
        if isinstance(first, str) and not first.startswith("/"):
            return make(("/", *value.parts), value.origins)
    return value


def _full(value: Const) -> Const:
    return Const(shown(names.full_namespace(literal(str(value.value)))), value.origins)


def remapped_by(
    text: Holed, name: Holed, kind: names.RemapKind, rules: tuple[Rule, ...], node_name: Holed, namespace: Holed
) -> Value | None:
    """The target of the rule that made the full name `text` of `name`; None where no rule did."""
    if text in names.remap_topic(name, kind, (), node_name, namespace):
        return None
    for each in rules:
        if text in names.remap_topic(name, kind, (each.rule,), node_name, namespace):
            return each.target
    return None


# What programs ask


def _effects(machine: Machine, node: Value) -> list[NodeEffect]:
    log = host(machine).log
    found = [o.address for o in options(node) if isinstance(o, Ref)]
    return [e for e in log.nodes if e.address in found]


def _named(machine: Machine, node: Value, part: int) -> Value:
    """The node's final name (part 0) or namespace (part 1)."""
    log = host(machine).log
    found = [final_name(log, e)[part] for e in _effects(machine, node)]
    return join_all(found) if found else machine.unknown(Cause.LIVE, "name of a node that is not known", "str")


def _node_name(call: NativeCall) -> Value:
    return _named(call.machine, call.args[0], 0)


def _node_namespace(call: NativeCall) -> Value:
    return _named(call.machine, call.args[0], 1)


def _node_fqn(call: NativeCall) -> Value:
    name, namespace = (_named(call.machine, call.args[0], part) for part in (0, 1))
    return join_all(_qualified(n, s) for n in options(name) for s in options(namespace))


def _qualified(name: Value, namespace: Value) -> Value:
    if isinstance(namespace, Const) and namespace.value == "/":
        return concat((Const("/", namespace.origins), name))
    return concat((namespace, Const("/"), name))


def _resolve_name(call: NativeCall) -> Value:
    log = host(call.machine).log
    kind = names.RemapKind.SERVICE if text_of(call.arg(2, "kind")) == "service" else names.RemapKind.TOPIC
    found: list[Value] = []
    for effect in _effects(call.machine, call.args[0]):
        own, space = final_name(log, effect)
        rules = tuple(r.rule for r in remaps_of(log, effect))
        for name in options(call.args[1]):
            if isinstance(name, Const) and isinstance(own, Const) and isinstance(space, Const):
                try:
                    resolved = names.resolve(pattern(name), kind, rules, pattern(own), pattern(space))
                except names.InvalidName:
                    continue
                found += [Const(r, name.origins | own.origins | space.origins) for r in resolved]
            else:
                found.append(call.machine.unknown(Cause.OPERATION, "resolve name", "str"))
    return join_all(found) if found else call.machine.unknown(Cause.OPERATION, "resolve name", "str")


NATIVES: Final[dict[str, NativeFunction]] = {
    "_rosward.node_name": _node_name,
    "_rosward.node_namespace": _node_namespace,
    "_rosward.node_fqn": _node_fqn,
    "_rosward.resolve_name": _resolve_name,
}
