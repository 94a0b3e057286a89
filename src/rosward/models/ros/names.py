# SPDX-License-Identifier: Apache-2.0
"""What a node answers of names: its own, and those that its remap rules make of others."""

from __future__ import annotations

from typing import Final

from rosward.domain.certain import text_of
from rosward.domain.choice import join, join_all, lift, options
from rosward.domain.text import pattern
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, Const, Ref, Value
from rosward.effects.log import NodeEffect
from rosward.models.native import Machine, NativeCall, NativeFunction
from rosward.naming.final_name import final_name, full_name, remaps_of
from rosward.ros import names, validation


def nodes_at(machine: Machine, node: Value) -> list[NodeEffect]:
    """The nodes that an object is, or may be."""
    return machine.nodes_at({o.address for o in options(node) if isinstance(o, Ref)})


def _named(machine: Machine, node: Value, part: int) -> Value:
    """The node's final name (part 0) or namespace (part 1)."""
    log = machine.log
    found = [final_name(log, e)[part] for e in nodes_at(machine, node)]
    return join_all(found) if found else machine.unknown(Cause.LIVE, "name of an unknown node", "str")


def _node_name(call: NativeCall) -> Value:
    return _named(call.machine, call.args[0], 0)


def _node_namespace(call: NativeCall) -> Value:
    return _named(call.machine, call.args[0], 1)


def _node_fqn(call: NativeCall) -> Value:
    name, namespace = (_named(call.machine, call.args[0], part) for part in (0, 1))
    return join_all(full_name(s, n) for n in options(name) for s in options(namespace))


def _resolve_name(call: NativeCall) -> Value:
    log = call.machine.log
    kind = names.RemapKind.SERVICE if text_of(call.arg(2, "kind")) == "service" else names.RemapKind.TOPIC
    found: list[Value] = []
    for effect in nodes_at(call.machine, call.args[0]):
        own, space = final_name(log, effect)
        rules = tuple(r.rule for r in remaps_of(log, effect))
        for name in options(call.args[1]):
            node, above = _asked_for(name, own, space)
            if isinstance(name, Const) and isinstance(node, Const) and isinstance(above, Const):
                try:
                    resolved = names.resolve(pattern(name), kind, rules, pattern(node), pattern(above))
                except names.InvalidName:
                    continue
                found += [Const(r, name.origins | node.origins | above.origins) for r in resolved]
            else:
                found.append(call.machine.unknown(Cause.OPERATION, "resolve name", "str"))
    return join_all(found) if found else call.machine.unknown(Cause.OPERATION, "resolve name", "str")


def _asked_for(name: Value, own: Value, space: Value) -> tuple[Value, Value]:
    """The name and namespace of a node; what a name does not ask for may be any: an absolute one asks for nothing."""
    text = str(name.value) if isinstance(name, Const) else "~"
    private = text.startswith("~") or "{" in text
    return own if private else Const("node"), space if private or not text.startswith("/") else Const("/")


def refused(machine: Machine, node: Value, name: Value, kind: names.RemapKind) -> bool | None:
    """Whether no node that this may be takes one of these names; None where one of them may be such a name."""
    doubt = False
    for option in options(name):
        if not isinstance(option, Const):
            doubt = True
            continue
        for effect in nodes_at(machine, node):
            own, space = final_name(machine.log, effect)
            if isinstance(own, Const) and isinstance(space, Const):
                try:
                    names.resolve(pattern(option), kind, (), pattern(own), pattern(space))
                except names.InvalidName:
                    if len(options(name)) == 1:
                        return True
                    doubt = True
    return None if doubt else False


_VALIDATED: Final = {
    "name": validation.validate_name,
    "full": validation.validate_full,
    "node": validation.validate_node_name,
    "namespace": validation.validate_namespace,
}


def _refused(call: NativeCall) -> Value:
    """`_rosward.refused(name, kind, sure)`: why rcl refuses a name; None where it takes it, or no `try` is around: what follows is analysed then.

    With `sure`, what may be refused or not is taken.
    """
    machine = call.machine
    name, kind = call.args[:2]
    validate = _VALIDATED[text_of(kind) or "name"]
    sure = len(call.args) > 2
    doubt = NONE if sure else machine.unknown(Cause.OPERATION, "name", "str")

    def why(option: Value) -> Value:
        if not isinstance(option, Const) or not isinstance(option.value, str):
            return join(NONE, doubt)
        found = validate(pattern(option))
        told = NONE if found is None else Const(found)
        return join(told, doubt) if option.origins and not sure else told

    return NONE if not machine.is_tried or (sure and len(options(name)) > 1) else lift(why, name)


NATIVES: Final[dict[str, NativeFunction]] = {
    "_rosward.node_name": _node_name,
    "_rosward.node_namespace": _node_namespace,
    "_rosward.node_fqn": _node_fqn,
    "_rosward.resolve_name": _resolve_name,
    "_rosward.refused": _refused,
    "_rosward.tried": lambda call: Const(call.machine.is_tried),
}
