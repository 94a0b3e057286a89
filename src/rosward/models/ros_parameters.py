# SPDX-License-Identifier: Apache-2.0
"""Parameters of a node: what `declare_parameter` and `get_parameter` give, and from where.

self.declare_parameter('topic', '/scan')    '/scan', marked as the default of parameter topic
self.declare_parameter('topic')             unknown, because parameter topic has no value
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.domain.choice import join_all, options
from rosward.domain.unknown import Cause, Origin
from rosward.domain.values import FALSE, NONE, TRUE, UNBOUND, Const, Ref, Value
from rosward.models.effects import NodeEffect, ParameterEffect
from rosward.models.native import NativeCall, NativeFunction
from rosward.models.ros_effects import create, final_name, host, is_true, mark, text_of, word_text
from rosward.ros import arguments
from rosward.ros.names import fully_qualified

if TYPE_CHECKING:
    from rosward.engine.interpreter import Interpreter

_TABLE: Final = "__parameters__"


def _table(machine: Interpreter, node: Value) -> Ref | None:
    if not isinstance(node, Ref):
        return None
    found = machine.obj(node).attrs.get(_TABLE)
    return found if isinstance(found, Ref) else None


def _declare(call: NativeCall) -> Value:
    machine = host(call)
    node, name = call.args[0], call.args[1]
    default = call.arg(2, "default", NONE) or NONE
    type_ = call.arg(3, "type", NONE) or NONE
    found: list[Value] = []
    for each in options(node):
        for key in options(name):
            value = _initial(machine, each, key, default, _hint(machine, type_))
            address = each.address if isinstance(each, Ref) else None
            machine.log.parameters[ParameterEffect(address, key, default, value, type_, machine.place)] = None
            table = _table(machine, each)
            if table is not None:
                machine.store_item(table, key, value)
            found.append(value)
    return join_all(found)


_HINTS: Final = {"BOOL": "bool", "INTEGER": "int", "DOUBLE": "float", "STRING": "str"}


def _hint(machine: Interpreter, type_: Value) -> str:
    """The Python type of a parameter of a declared type; '' where it is not known."""
    if not isinstance(type_, Ref):
        return ""
    label = machine.obj(type_).attrs.get("name", machine.obj(type_).attrs.get("_name_"))
    word = text_of(label)
    return "list" if word.endswith("_ARRAY") else _HINTS.get(word, "")


def _initial(machine: Interpreter, node: Value, name: Value, default: Value, hint: str) -> Value:
    """The value of a parameter when it is declared: an override of the code itself, else its default, which anybody may change."""
    label = text_of(name, word_text(name))
    override = _override(machine, node, label)
    if override is not None:
        return override
    values = [
        machine.unknown(Cause.PARAMETER, label, hint)
        if option == NONE or option is UNBOUND
        else mark(machine, option, Origin("parameter", label))
        for option in options(default)
    ]
    return join_all(values)


def _override(machine: Interpreter, node: Value, name: str) -> Value | None:
    """What the node's own code sets by parameter_overrides or by its arguments."""
    if not isinstance(node, Ref):
        return None
    given = machine.obj(node).attrs.get("__overrides__")
    if given is not None:
        for item in machine.iterate(given).known:
            if isinstance(item, Ref):
                attrs = machine.obj(item).attrs
                if name in (text_of(attrs.get("_name")), text_of(attrs.get("name"))):
                    return attrs.get("_value", attrs.get("value"))
    for effect in machine.log.nodes:
        if effect.address == node.address and (effect.words or effect.global_words):
            value = _from_words(machine, effect, name)
            if value is not None:
                return value
    return None


def _from_words(machine: Interpreter, effect: NodeEffect, name: str) -> Value | None:
    own, space = final_name(effect)
    fqn = fully_qualified(word_text(space), word_text(own))
    for words in (effect.words, effect.global_words):
        parsed = arguments.parse_arguments([word_text(w) for w in words])
        value = arguments.parameters_of_node(parsed.parameters, fqn).get(name)
        if value is not None:
            return _plain(machine, value.value)
    return None


def _plain(machine: Interpreter, value: object) -> Value:
    if isinstance(value, tuple):
        return machine.new_list([_plain(machine, v) for v in value])
    if value is None or isinstance(value, (bool, int, float, str, bytes)):
        return Const(value) if value is not None else machine.unknown(Cause.PARAMETER, "override")
    return machine.unknown(Cause.PARAMETER, "override")


def _parameter(call: NativeCall) -> Value:
    machine = host(call)
    found: list[Value] = []
    for node in options(call.args[0]):
        table = _table(machine, node)
        for name in options(call.args[1]):
            label = text_of(name, word_text(name))
            record = machine.obj(table) if table is not None else None
            value = record.entries.get(Const(label)) if record is not None and isinstance(name, Const) else None
            if value is None and record is not None:
                value = record.rest
                if not isinstance(name, Const):
                    value = join_all([*record.entries.values(), *(() if value is None else (value,))])
            if value is None or value is UNBOUND:
                value = _override(machine, node, label)
            if value is None and label == "use_sim_time":
                value = mark(machine, Const(False), Origin("parameter", label))
            found.append(value if value is not None else machine.unknown(Cause.PARAMETER, label))
    return join_all(found)


def _set(call: NativeCall) -> Value:
    machine = host(call)
    node, name, value = call.args
    for each in options(node):
        table = _table(machine, each)
        for key in options(name):
            if table is not None:
                machine.store_item(table, key, value)
            if text_of(key) == "use_sim_time" and any(is_true(v) for v in options(value)):
                create(
                    machine,
                    "subscription",
                    each,
                    Const("/clock"),
                    machine.load_attr(machine.load_module("rosgraph_msgs.msg"), "Clock"),
                )
    return NONE


def _has(call: NativeCall) -> Value:
    """Whether a parameter is declared."""
    machine = host(call)
    answers: set[bool | None] = set()
    for node in options(call.args[0]):
        table = _table(machine, node)
        for name in options(call.args[1]):
            record = machine.obj(table) if table is not None else None
            if (
                record is None
                or not isinstance(name, Const)
                or record.rest is not None
                or Const(name.value) in record.maybe
            ):
                answers.add(None)
            else:
                answers.add(Const(name.value) in record.entries)
    if len(answers) == 1 and None not in answers:
        return TRUE if answers.pop() else FALSE
    return machine.unknown(Cause.PARAMETER, "whether it is declared", "bool")


def _by_prefix(call: NativeCall) -> Value:
    """The declared parameters below a prefix, by the rest of their names."""
    machine = host(call)
    prefix = text_of(call.args[1])
    entries: dict[Value, Value] = {}
    rest: Value | None = None
    for node in options(call.args[0]):
        table = _table(machine, node)
        if table is None:
            rest = machine.unknown(Cause.PARAMETER, prefix)
            continue
        for key, value in machine.obj(table).entries.items():
            name = text_of(key)
            if not prefix or name.startswith(f"{prefix}."):
                short = name.removeprefix(f"{prefix}.") if prefix else name
                cls = machine.load_attr(machine.load_module("rclpy.parameter"), "Parameter")
                entries[Const(short)] = machine.call(cls, (key, NONE, value))
        rest = rest or machine.obj(table).rest
    return machine.new_dict(entries, rest)


NATIVES: Final[dict[str, NativeFunction]] = {
    "_rosward.declare_parameter": _declare,
    "_rosward.parameter": _parameter,
    "rclpy.node.Node.has_parameter": _has,
    "rclpy.node.Node.get_parameters_by_prefix": _by_prefix,
    "_rosward.set_parameter": _set,
}
