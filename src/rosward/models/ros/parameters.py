# SPDX-License-Identifier: Apache-2.0
"""Parameters of a node: what `declare_parameter` and `get_parameter` give, from where, and when they raise.

self.declare_parameter('topic', '/scan')    '/scan', marked as the default of parameter topic
self.declare_parameter('topic')             unknown, because parameter topic has no value
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Final

from rosward.domain.certain import is_true, text_of
from rosward.domain.choice import join, join_all, options
from rosward.domain.compound import Native, Tuple
from rosward.domain.text import pattern, readable
from rosward.domain.unknown import Cause, Origin, Origins
from rosward.domain.values import FALSE, NONE, TRUE, UNBOUND, Const, Ref, Text, Unknown, Value
from rosward.effects.log import ParameterEffect
from rosward.models.failures import fail
from rosward.models.native import NativeCall, NativeFunction
from rosward.models.python.containers import dicts
from rosward.models.python.contents import plain_data
from rosward.models.ros import parameter_table as table
from rosward.models.ros.parameter_given import (
    given_wrongly,
    initial_value,
    or_another_list,
    overrides_of,
    own_overrides,
    type_label,
)
from rosward.naming.command_line import type_word

if TYPE_CHECKING:
    from rosward.models.native import Machine


def _declare(call: NativeCall) -> Value:
    machine = call.machine
    nodes, names = options(call.args[0]), options(plain_data(machine, call.args[1]))
    default = plain_data(machine, call.arg(2, "default", NONE) or NONE)
    type_ = call.arg(3, "type", NONE) or NONE
    ignored = call.arg(4, "ignore_override", FALSE) or FALSE
    typed = call.arg(5, "dynamic", FALSE) in (FALSE, NONE)
    alone = len(nodes) == len(names) == 1
    found: list[Value] = []
    for node in nodes:
        for name in names:
            failed = _refused(machine, node, name) or given_wrongly(machine, node, name, default, type_, ignored, typed)
            if failed is not None:
                machine.raised += 1
                if alone:
                    return failed
                continue
            if table.is_declared(machine, node, name) is None:
                table.may_raise(machine, text_of(name, readable(name)))
            value = initial_value(machine, node, name, default, _hint(machine, type_), ignored)
            _record(machine, node, name, value, default, type_)
            element = _HINTS.get(type_label(machine, type_).removesuffix("_ARRAY"), "")
            value = or_another_list(machine, node, name, value, element, ignored, typed=typed)
            table.put(machine, node, name, value, sure=alone)
            found.append(value)
    return join_all(found) if found else UNBOUND


def _refused(machine: Machine, node: Value, name: Value) -> Value | None:
    """Declaring raises: the name is empty or no str, or the parameter is there already."""
    if isinstance(name, Const) and not isinstance(name.value, str):
        return fail(machine, Native("builtins.TypeError"), f"the parameter name {name.value!r} is not a str", ())
    if name == Const(""):
        return table.raise_(machine, "InvalidParameterException", "the parameter name is empty", name)
    if isinstance(name, Const) and table.is_declared(machine, node, name):
        message = f"parameter {name.value!r} is already declared: ParameterAlreadyDeclaredException is raised"
        return table.raise_(machine, "ParameterAlreadyDeclaredException", message, name)
    return None


_HINTS: Final = {"BOOL": "bool", "INTEGER": "int", "DOUBLE": "float", "STRING": "str"}


def _hint(machine: Machine, type_: Value) -> str:
    """The Python type of a parameter of a declared type; '' where it is not known."""
    word = type_label(machine, type_)
    return "list" if word.endswith("_ARRAY") else _HINTS.get(word, "")


def _now(machine: Machine, value: Value, label: str) -> Value:
    """The value of a parameter when a callback reads it: by then `ros2 param set` may have given it another."""
    if not machine.in_callback:
        return value
    if isinstance(value, Const):
        return Const(value.value, _reopened(value.origins, label))
    return Text(value.parts, _reopened(value.origins, label)) if isinstance(value, Text) else value


def _reopened(origins: Origins, label: str) -> Origins:
    """Of what the node itself has set, too, somebody may give the parameter another value."""
    found = frozenset(o._replace(settled=False) if o[:2] == ("parameter", label) else o for o in origins)
    return found if any(o[:2] == ("parameter", label) for o in found) else found | {Origin("parameter", label)}


def _parameter(call: NativeCall) -> Value:
    """The value that `get_parameter` gives; it raises for what is not declared, unless the node takes such parameters."""
    machine = call.machine
    nodes, names = options(call.args[0]), options(call.args[1])
    found: list[Value] = []
    for node in nodes:
        undeclared = table.flag(machine, node, table.UNDECLARED)
        for name in names:
            label = text_of(name, readable(name))
            declared = table.is_declared(machine, node, name)
            if declared is False and not undeclared:
                failed = table.not_declared(machine, name, "get_parameter")
                if len(nodes) == len(names) == 1:
                    return failed
                continue
            if declared is None and not undeclared:
                table.may_raise(machine, label)
            value = table.value_of(machine, node, name)
            if value is not None:
                table.may_lack_value(machine, value, label)
                found += [_now(machine, v, label) for v in options(value)]
            elif declared is not False:
                found.append(machine.unknown(Cause.PARAMETER, label))
            if declared is not True and undeclared and table.table_of(machine, node) is not None:
                found.append(NONE)
    return join_all(found) if found else UNBOUND


def _set(call: NativeCall) -> Value:
    """A new value, as a node of rclpy takes it: where it begins to follow simulated time it subscribes to that."""
    machine = call.machine
    node, name, value = call.exactly(3)

    def follow(each: Value) -> None:
        clock = machine.load_attr(machine.load_module("rosgraph_msgs.msg"), "Clock")
        machine.call(machine.load_attr(each, "create_subscription"), (clock, Const("/clock"), NONE, Const(1)))

    return set_value(machine, node, name, value, follow)


def set_value(machine: Machine, node: Value, name: Value, value: Value, follow: Callable[[Value], None]) -> Value:
    """A new value; where it may be refused (by a callback, by its type) the old one stays possible.

    `follow` is what a node does that begins to follow simulated time.
    """
    nodes, names = options(node), options(name)
    alone = len(nodes) == len(names) == 1
    for each in nodes:
        undeclared = table.flag(machine, each, table.UNDECLARED)
        for key in names:
            declared = table.is_declared(machine, each, key)
            if declared is False and not undeclared:
                failed = table.not_declared(machine, key, "set_parameters")
                if alone:
                    return failed
                continue
            if declared is None and not undeclared:
                table.may_raise(machine, text_of(key, readable(key)))
            old = table.value_of(machine, each, key)
            same = old is None or (type_word(old) is not None and type_word(old) == type_word(value))
            if value == NONE:
                table.take(machine, each, key, sure=False)
                continue
            sure = alone and same and not table.flag(machine, each, table.REFUSES)
            table.put(machine, each, key, value, sure=sure)
            if text_of(key) == "use_sim_time" and any(is_true(v) for v in options(value)):
                follow(each)
    return NONE


def _has(call: NativeCall) -> Value:
    """Whether a parameter is declared."""
    machine = call.machine
    answers = {table.is_declared(machine, n, k) for n in options(call.args[0]) for k in options(call.args[1])}
    if len(answers) == 1 and None not in answers:
        return TRUE if answers.pop() else FALSE
    label = text_of(call.args[1])
    if label and len(options(call.args[0])) == 1:
        return table.may_have(machine, call.args[0], label)
    return machine.unknown(Cause.PARAMETER, "whether it is declared", "bool")


def _is_given(call: NativeCall) -> Value:
    """`_rosward.is_given(node, name)`: whether it is declared, as far as code and configuration say.

    What nobody here knows to be set is for `get_parameter_or` as for a parameter with a default: the default stands for all that may be.
    """
    machine = call.machine
    node, name = call.exactly(2)
    if machine.log.configuration is None and not own_overrides(machine, node)[1]:
        if all(
            table.is_declared(machine, node, n) is None and not table.may_name(machine, node, n) for n in options(name)
        ):
            return FALSE
    return _has(call)


def _undeclare(call: NativeCall) -> Value:
    machine = call.machine
    nodes, names = options(call.args[0]), options(call.args[1])
    alone = len(nodes) == len(names) == 1
    for node in nodes:
        for name in names:
            declared = table.is_declared(machine, node, name)
            if declared is False:
                failed = table.not_declared(machine, name, "undeclare_parameter")
                if alone:
                    return failed
                continue
            refuses = table.flag(machine, node, table.REFUSES)  # one that is read only stays
            if declared is None or refuses:
                table.may_raise(machine, text_of(name, readable(name)))
            table.take(machine, node, name, sure=alone and not refuses)
    return NONE


def _needs(call: NativeCall) -> Value:
    """`_rosward.needs_parameter(node, name, method)`: the method raises where the parameter is not declared."""
    machine = call.machine
    node, name = call.args[0], call.args[1]
    declared = table.is_declared(machine, node, name)
    if declared is True or table.flag(machine, node, table.UNDECLARED):
        return NONE
    if declared is False:
        return table.not_declared(machine, name, text_of(call.args[2]))
    table.may_raise(machine, text_of(name, readable(name)))
    return NONE


def _by_prefix(call: NativeCall) -> Value:
    """The declared parameters below a prefix, by the rest of their names."""
    machine = call.machine
    prefix = call.args[1]
    parts = options(prefix)
    cls = machine.load_attr(machine.load_module("rclpy.parameter"), "Parameter")
    result = machine.new_dict({})
    for node in options(call.args[0]):
        any_ = table.has_others(machine, node) or (
            table.flag(machine, node, table.UNDECLARED) and table.may_be_set(machine)
        )
        for part in parts:
            text = text_of(part)
            if not isinstance(part, Const):
                any_ = True
                continue
            for key in table.labels(machine, node):
                name = text_of(key)
                if not text or name.startswith(f"{text}."):
                    short = Const(name.removeprefix(f"{text}.") if text else name)
                    value = table.value_of(machine, node, key)
                    sure = len(parts) == 1 and table.is_declared(machine, node, key) is True
                    each = machine.call(cls, (key, NONE, NONE if value is None else value))
                    dicts.store(machine, result, short, each, weak=not sure)
        if any_:
            any_name = machine.unknown(Cause.PARAMETER, "*" if text_of(prefix) == "" else f"{pattern(prefix)}.*", "str")
            each = machine.call(cls, (any_name, NONE, Unknown(any_name.reasons)))
            dicts.store(machine, result, any_name, each, weak=True)
    return result


def _declare_given(call: NativeCall) -> Value:
    """Every parameter that somebody sets becomes one of the node (automatically_declare_parameters_from_overrides).

    That is what the code gives by parameter_overrides, and what command line and parameter files give. Where it is not known who starts
    the process, it may be any.
    """
    machine = call.machine
    for node in options(call.args[0]):
        given = overrides_of(machine, node)
        for why in given.others:
            table.put_any(machine, node, why)
        for label, (value, sure) in given.values.items():
            _keep(machine, node, Const(label), value, sure=sure)
    return NONE


def _as_declared(machine: Machine, value: Value) -> Value:
    """The value as it stands at the declaration: of a list its elements, since what is recorded must not change with the list."""
    if isinstance(value, Ref):
        record = machine.obj(value)
        if record.kind == "list" and record.items is not None and not record.many:
            return Tuple(record.items)
    return value


def _keep(machine: Machine, node: Value, name: Value, value: Value, *, sure: bool) -> None:
    """Record a parameter that is declared here; not `sure`: it may be."""
    _record(machine, node, name, value, NONE, NONE)
    table.put(machine, node, name, value, sure=sure)


def _record(machine: Machine, node: Value, name: Value, value: Value, default: Value, type_: Value) -> None:
    address = node.address if isinstance(node, Ref) else None
    written, given = _as_declared(machine, default), _as_declared(machine, value)
    machine.log.add_parameter(machine, ParameterEffect(address, name, written, given, type_, machine.place))


def _declare_own(call: NativeCall) -> Value:
    """What the client library declares for every node: use_sim_time, and in most distros start_type_description_service."""
    machine = call.machine
    for node in options(call.args[0]):
        for label, default, sure in (("use_sim_time", FALSE, True), ("start_type_description_service", TRUE, False)):
            if table.is_declared(machine, node, Const(label)) is not True:
                value = initial_value(machine, node, Const(label), default, "bool", FALSE)
                old = table.value_of(machine, node, Const(label))
                table.put(machine, node, Const(label), value if old is None else join(value, old), sure=sure)
    return NONE


def _unset(call: NativeCall) -> Value:
    """`_rosward.is_unset(value)`: whether a parameter has no value."""
    machine = call.machine
    answer = table.is_unset(call.args[0])
    if answer is None:
        return machine.unknown(Cause.PARAMETER, "whether it has a value", "bool")
    return TRUE if answer else FALSE


def _lacks(call: NativeCall) -> Value:
    """`_rosward.may_lack(node)`: each parameter that is there may be declared anew by an override."""
    machine = call.machine
    for node in options(call.args[0]):
        for label in table.labels(machine, node):
            table.take(machine, node, label, sure=False)
    return NONE


def _refuses(call: NativeCall) -> Value:
    """`_rosward.may_refuse(node)`: from here on something may refuse a new value of a parameter."""
    machine = call.machine
    for node in options(call.args[0]):
        if isinstance(node, Ref):
            machine.update(node, machine.obj(node).with_attr(table.REFUSES, TRUE))
    return NONE


NATIVES: Final[dict[str, NativeFunction]] = {
    "_rosward.declare_given": _declare_given,
    "_rosward.declare_own": _declare_own,
    "_rosward.declare_parameter": _declare,
    "_rosward.is_given": _is_given,
    "_rosward.is_unset": _unset,
    "_rosward.may_lack": _lacks,
    "_rosward.may_refuse": _refuses,
    "_rosward.needs_parameter": _needs,
    "_rosward.parameter": _parameter,
    "_rosward.set_parameter": _set,
    "_rosward.undeclare_parameter": _undeclare,
    "rclpy.node.Node.get_parameters_by_prefix": _by_prefix,
    "rclpy.node.Node.has_parameter": _has,
}
