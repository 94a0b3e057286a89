# SPDX-License-Identifier: Apache-2.0
"""The final name of a node, and what its remap rules make of names, as values with their origins and reasons.

Node('talker') started with -r __node:=left -r chatter:=~/out     name 'left'; 'chatter' is /left/out
"""

from __future__ import annotations

from rosward.domain.certain import text_of
from rosward.domain.choice import join_all, lift, options
from rosward.domain.series import Series
from rosward.domain.text import concat, make, pattern
from rosward.domain.values import NONE, UNBOUND, Const, Text, Value
from rosward.effects.log import EffectLog, NodeEffect
from rosward.holes import Holed, literal, with_stars
from rosward.naming.command_line import CommandLine, ValueRule, read_words
from rosward.ros import names


def command_lines(log: EffectLog, effect: NodeEffect) -> tuple[CommandLine, CommandLine]:
    """What the node's own arguments (cli_args) and those of its context say."""
    return _read(log, effect.words), _read(log, effect.global_words)


def _read(log: EffectLog, words: Series) -> CommandLine:
    """Each name of a node asks for the same words again."""
    found = log.remembered.get(words)
    if not isinstance(found, CommandLine):
        found = log.remembered[words] = read_words(words, log.configuration)
    return found


def remaps_of(log: EffectLog, effect: NodeEffect) -> tuple[ValueRule, ...]:
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


def full_name(namespace: Value, name: Value) -> Value:
    """The full name of a node, for one alternative of its namespace and of its name."""
    return concat((namespace, name) if text_of(namespace) == "/" else (namespace, Const("/"), name))


def _renamed(old: Value, node_name: Holed, kind: names.RemapKind, rules: tuple[ValueRule, ...]) -> list[Value]:
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
    return Const(with_stars(names.full_namespace(literal(str(value.value)))), value.origins)


def remapped_by(
    text: Holed, name: Holed, kind: names.RemapKind, rules: tuple[ValueRule, ...], node_name: Holed, namespace: Holed
) -> Value | None:
    """The target of the rule that made the full name `text` of `name`; None where no rule did."""
    if text in names.remap_topic(name, kind, (), node_name, namespace):
        return None
    for each in rules:
        if text in names.remap_topic(name, kind, (each.rule,), node_name, namespace):
            return each.target
    return None
