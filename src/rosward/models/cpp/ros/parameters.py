# SPDX-License-Identifier: Apache-2.0
"""Parameters of a node in C++: what the headers ask of the natives that the models of rclpy have, with what C++ knows beside: types.

declare_parameter<double>("rate", 10)           10.0: the default is of the type of the parameter
declare_parameter("rate", PARAMETER_DOUBLE)     no default; somebody has to give one of that type
get_parameter("rate", variable)                 written into the variable where there is one
"""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Final

from rosward.domain.certain import text_of
from rosward.domain.choice import join, join_all, options
from rosward.domain.compound import External, Tuple
from rosward.domain.text import origins_of, readable
from rosward.domain.unknown import Cause
from rosward.domain.values import FALSE, NONE, TRUE, UNBOUND, Class, Const, Ref, Unknown, Value
from rosward.models.cpp.ros.handed import NOTHING, given, node_of, types_of
from rosward.models.cpp.ros.parameter_types import BY_NUMBER, hint_of_word, word_of_type
from rosward.models.cpp.values.conversions import convert, new_map
from rosward.models.cpp.values.copies import copied, write
from rosward.models.cpp.values.slots import read, read_field
from rosward.models.native import NativeCall, NativeFunction
from rosward.models.python.containers import dicts
from rosward.models.ros import parameter_table as table
from rosward.models.ros import parameters
from rosward.models.ros.entities import create
from rosward.models.ros.parameter_given import override_of, overrides_of
from rosward.naming.command_line import type_word

if TYPE_CHECKING:
    from rosward.models.native import Machine

_DESCRIPTOR: Final = "rcl_interfaces.msg.ParameterDescriptor"
_VALUE: Final = "_value"
_NUMBER: Final = "_number"
_UNINITIALISED: Final = "UninitializedStaticallyTypedParameterException"
_CLOCK: Final = External("rosgraph_msgs.msg.Clock")


def _declare(call: NativeCall) -> Value:
    """`declare_parameter<T>(node, name, default, descriptor, ignore_override)`: the value."""
    machine = call.machine
    node, name = node_of(call, call.args[0]), given(call, 1)
    type_ = next(iter(types_of(call)), NONE)
    default, descriptor, ignored = given(call, 2), given(call, 3), given(call, 4, FALSE)
    if _is_descriptor(machine, default):
        default, descriptor = NONE, default
    default, word = _default(machine, default, type_)
    dynamic: Value = FALSE
    if _is_descriptor(machine, descriptor):
        parameters.NATIVES["_rosward.may_refuse"](call._replace(args=(node,), keywords={}))
        dynamic = machine.load_attr(descriptor, "dynamic_typing")
    args = (node, name, default, Const(word.upper()) if word else NONE, ignored, dynamic)
    declared = parameters.NATIVES["_rosward.declare_parameter"](call._replace(args=args, keywords={}))
    if declared is UNBOUND or default != NONE:
        return default if ignored == TRUE and declared is not UNBOUND else declared
    return declared if _is_of_rclcpp(machine, given(call, 2)) else _with_value(machine, node, name, declared)


def _is_of_rclcpp(machine: Machine, value: Value) -> bool:
    """Whether a default is a `ParameterValue` or a `ParameterType`: with these a parameter may be without a value."""
    attrs = machine.obj(value).attrs if isinstance(value, Ref) else {}
    return _NUMBER in attrs or _VALUE in attrs


def _with_value(machine: Machine, node: Value, name: Value, declared: Value) -> Value:
    """The value of a parameter that is declared by a type alone: an exception where nobody has given it one."""
    if override_of(machine, node, text_of(name, readable(name))) is not None:
        return declared
    if machine.log.configuration is not None:
        message = f"parameter {readable(name)!r} has no default, and nobody gives it a value"
        return table.raise_(machine, _UNINITIALISED, message, name)
    exceptions = machine.load_module("rclcpp.exceptions")
    machine.throw(machine.call(machine.load_attr(exceptions, _UNINITIALISED), (name,)))
    return declared


def _is_descriptor(machine: Machine, value: Value) -> bool:
    return isinstance(value, Ref) and machine.obj(value).cls == External(_DESCRIPTOR)


def _default(machine: Machine, value: Value, type_: Value) -> tuple[Value, str]:
    """A default as it stands in the table of parameters, and the word for its type where that is said."""
    if value == External(NOTHING) or (value == NONE and not isinstance(type_, Class)):
        return NONE, word_of_type(type_)
    if isinstance(value, Ref):
        attrs = machine.obj(value).attrs
        if _NUMBER in attrs:
            return NONE, _numbered(attrs[_NUMBER])
        if _VALUE in attrs:
            return attrs[_VALUE], ""
    word = word_of_type(type_)
    return (convert(machine, value, type_) if word else raw(machine, value)), word


def _numbered(number: Value) -> str:
    """The word for the number of a type; '' where that is not known."""
    return BY_NUMBER.get(number.value, "") if isinstance(number, Const) and isinstance(number.value, int) else ""


def raw(machine: Machine, value: Value) -> Value:
    """A value of a parameter as the tables hold it: what is in a `ParameterValue`, a list of what stands in braces."""
    if isinstance(value, Ref):
        obj = machine.obj(value)
        if _VALUE in obj.attrs:
            return read(machine, obj.attrs[_VALUE])
        if isinstance(obj.cls, External):
            return machine.unknown(Cause.MESSAGE, "value of a parameter")
        return copied(machine, value)
    if isinstance(value, Tuple):
        return machine.new_list(tuple(read(machine, item) for item in value.items))
    return NONE if value == External(NOTHING) else value


def _raw(call: NativeCall) -> Value:
    """`parameter_value(x)`: what a `ParameterValue` of x holds."""
    return join_all(raw(call.machine, option) for option in options(given(call, 0)))


def _is_plain(call: NativeCall) -> Value:
    """`is_plain<T>()`: whether a parameter of type T is declared with the value itself, not with a `ParameterValue` or `ParameterType`."""
    type_ = next(iter(types_of(call)), NONE)
    return FALSE if isinstance(type_, Class) and type_.module == "rclcpp" else TRUE


def _get(call: NativeCall) -> Value:
    """`get_parameter(node, name, variable)`: whether there is one; then its value is in the variable."""
    machine = call.machine
    node, name, slot = node_of(call, call.args[0]), given(call, 1), call.args[2]
    declared = [table.is_declared(machine, n, k) for n in options(node) for k in options(name)]
    if all(d is False for d in declared):
        return FALSE
    found = [v for n in options(node) for k in options(name) if (v := table.value_of(machine, n, k)) is not None]
    label = text_of(name, readable(name))
    value = join_all(found) if found else machine.unknown(Cause.PARAMETER, label, _hint_at(machine, slot))
    if all(d is True for d in declared) and found and table.is_unset(value) is False:
        write(machine, slot, _fitting(machine, value, slot))
        return TRUE
    known = [v for v in options(value) if v != NONE]
    if known:
        write(machine, slot, join(_fitting(machine, join_all(known), slot), read(machine, slot)))
    return machine.unknown(Cause.PARAMETER, f"whether {label} is there", "bool") if known else FALSE


def _fitting(machine: Machine, value: Value, slot: Value) -> Value:
    """A value as a variable takes it: a whole number of a parameter may be asked for as another number."""
    old = read(machine, slot)
    if isinstance(old, Ref):
        return copied(machine, value)
    if isinstance(value, Const) and isinstance(old, Const) and isinstance(old.value, float):
        return convert(machine, value, External("double")) if type(value.value) is int else value
    return value


def _hint_at(machine: Machine, slot: Value) -> str:
    old = read(machine, slot)
    return type(old.value).__name__ if isinstance(old, Const) and old.value is not None else ""


def _get_below(call: NativeCall, *, whole: bool = False) -> Value:
    """`get_parameters(node, prefix, map)`: those whose names begin so, by the rest of their names (`whole`: by their names)."""
    machine = call.machine
    node, begin, found = node_of(call, call.args[0]), given(call, 1), read(machine, call.args[2])
    prefix = text_of(begin)
    any_ = False
    for each in options(node):
        for key in table.labels(machine, each):
            label = text_of(key)
            if isinstance(found, Ref) and (not prefix or label.startswith(f"{prefix}.")):
                value = table.value_of(machine, each, key)
                short = Const(label.removeprefix(f"{prefix}.") if prefix and not whole else label)
                sure = isinstance(begin, Const) and table.is_declared(machine, each, key) is True
                dicts.store(machine, found, short, NONE if value is None else value, weak=not sure)
                any_ = True
        if table.has_others(machine, each) and isinstance(found, Ref):
            others = machine.unknown(Cause.PARAMETER, f"{prefix}.*", "str")
            dicts.store(machine, found, others, Unknown(others.reasons), weak=True)
            any_ = True
    return TRUE if any_ else FALSE


def _set(call: NativeCall) -> Value:
    """`set_parameter(node, name, value)`."""
    machine = call.machine
    node, name, value = node_of(call, call.args[0]), given(call, 1), given(call, 2)

    def follow(each: Value) -> None:
        create(machine, "subscription", each, Const("/clock"), _CLOCK)

    if all(_refused(machine, each, name, value) for each in options(node)):
        return FALSE
    parameters.set_value(machine, node, name, value, follow)
    sure = not any(table.flag(machine, each, table.REFUSES) for each in options(node))
    return TRUE if sure else machine.unknown(Cause.PARAMETER, "whether it is accepted", "bool")


def _refused(machine: Machine, node: Value, name: Value, value: Value) -> bool:
    """Whether a value surely is of another type than the parameter that it is for."""
    old = table.value_of(machine, node, name)
    words = {_word_of(machine, v) for v in options(old)} if old is not None else {""}
    new = {_word_of(machine, v) for v in options(value)}
    return "" not in words | new and not words & new


def _lacks(call: NativeCall) -> Value:
    """`lacks_parameter(node, name)`: whether a node surely has no parameter of that name."""
    machine, name = call.machine, given(call, 1)
    nodes = options(node_of(call, call.args[0]))
    return TRUE if all(table.is_declared(machine, n, k) is False for n in nodes for k in options(name)) else FALSE


def _default_in(call: NativeCall) -> Value:
    """`default_in(entry)`: the default, of a pair of it and a descriptor as well."""
    value = given(call, 0)
    if isinstance(value, Ref) and "first" in call.machine.obj(value).attrs:
        return read_field(call.machine, value, "first")
    return value


def _as(call: NativeCall) -> Value:
    """`parameter_as<T>(value, name)`: the value, where it is of that type; else an exception."""
    machine = call.machine
    value, name = given(call, 0), given(call, 1)
    type_ = next(iter(types_of(call)), NONE)
    if isinstance(type_, Class) and type_.module == "rclcpp" and type_.name != "ParameterType":
        return machine.call(type_, (value,) if type_.name == "ParameterValue" else (name, value))
    word = _word(machine, type_)
    if not word:
        return value
    fitting = [_hinted(v, word) for v in options(value) if v != NONE and _word_of(machine, v) in (word, "")]
    if not fitting:
        message = f"{_which(name, value)} is no {word}: InvalidParameterTypeException is thrown"
        return table.raise_(machine, "InvalidParameterTypeException", message, name, Const(word))
    return join_all(fitting)


def _which(name: Value, value: Value) -> str:
    """The parameter that is asked, for a message: by its name, or by what its value is the default of."""
    labels = {o.name for option in options(value) for o in origins_of(option) if o.kind == "parameter"}
    known = text_of(name) or (labels.pop() if len(labels) == 1 else "")
    return f"parameter {known!r}" if known else "the value of this parameter"


def _word(machine: Machine, type_: Value) -> str:
    """The word for a type: of C++, or a `ParameterType`."""
    if isinstance(type_, Ref):
        return _numbered(machine.obj(type_).attrs.get(_NUMBER, NONE))
    return word_of_type(type_)


def _hinted(value: Value, word: str) -> Value:
    return Unknown(value.reasons, hint_of_word(word)) if isinstance(value, Unknown) and not value.hint else value


def _word_of(machine: Machine, value: Value) -> str:
    """rcl's word for the type of a value; '' where it may be of several."""
    if isinstance(value, Ref):
        series = machine.obj(value).series() if machine.obj(value).kind == "list" else None
        items = tuple(o for i in (*series.head, *series.tail) for o in options(i)) if series is not None else ()
        word = type_word(Tuple(items)) if items else None
    else:
        word = type_word(value)
    return "" if word in (None, "not_set") else word


def _type(call: NativeCall) -> Value:
    """`parameter_type(value)`: the number of its type."""
    machine = call.machine
    numbers = {word: number for number, word in BY_NUMBER.items()}
    found: list[Value] = []
    for option in options(given(call, 0)):
        number = 0 if option == NONE else numbers.get(_word_of(machine, option))
        found.append(machine.unknown(Cause.PARAMETER, "type of a value", "int") if number is None else Const(number))
    return join_all(found)


def _type_name(call: NativeCall) -> Value:
    """`parameter_word(number)`: `to_string` of a type."""
    word = _numbered(given(call, 0))
    return Const(word) if word else call.machine.unknown(Cause.PARAMETER, "type of a value", "str")


def _text(call: NativeCall) -> Value:
    """`parameter_text(value)`: `to_string` of a value."""
    value = given(call, 0)
    if isinstance(value, Const) and isinstance(value.value, bool):
        return Const("true" if value.value else "false", value.origins)
    if isinstance(value, Const) and isinstance(value.value, (str, int)):
        return Const(str(value.value), value.origins)
    return call.machine.unknown(Cause.PARAMETER, "text of a value", "str")


def _of_node(name: str) -> NativeFunction:
    """The native of the models of rclpy, with the node in the first place."""
    native = parameters.NATIVES[name]

    def asked(call: NativeCall) -> Value:
        others = tuple(read(call.machine, a) for a in call.args[1:])
        return native(call._replace(args=(node_of(call, call.args[0]), *others), keywords={}))

    return asked


def _copy_all(call: NativeCall) -> Value:
    """`copy_parameters(source, destination)`."""
    for node in options(node_of(call, call.args[1])):
        table.put_any(call.machine, node, "copied from another node")
    return NONE


def _given_overrides(call: NativeCall) -> Value:
    """`given_parameters<Map, ParameterValue>(node)`: what is set from outside, by name; unknown where that may be anything."""
    machine = call.machine
    map_type, value_type = types_of(call)
    found: list[Value] = []
    for node in options(node_of(call, call.args[0])):
        given = overrides_of(machine, node)
        if given.others:
            found.append(machine.unknown(Cause.PARAMETER, given.others[0], "dict"))
            continue
        made = new_map(machine, map_type)
        for label, (value, sure) in given.values.items():
            dicts.store(machine, made, Const(label), machine.call(value_type, (value,)), weak=not sure)
        found.append(made)
    return join_all(found)


NATIVES: Final[dict[str, NativeFunction]] = {
    "rosward.copy_parameters": _copy_all,
    "rosward.declare_given": _of_node("_rosward.declare_given"),
    "rosward.declare_own": _of_node("_rosward.declare_own"),
    "rosward.declare_parameter": _declare,
    "rosward.default_in": _default_in,
    "rosward.get_parameter": _get,
    "rosward.get_parameters": _get_below,
    "rosward.get_whole_parameters": partial(_get_below, whole=True),
    "rosward.given_parameters": _given_overrides,
    "rosward.has_parameter": _of_node("rclpy.node.Node.has_parameter"),
    "rosward.is_given": _of_node("_rosward.is_given"),
    "rosward.is_plain": _is_plain,
    "rosward.lacks_parameter": _lacks,
    "rosward.may_refuse": _of_node("_rosward.may_refuse"),
    "rosward.needs_parameter": _of_node("_rosward.needs_parameter"),
    "rosward.parameter": _of_node("_rosward.parameter"),
    "rosward.parameter_as": _as,
    "rosward.parameter_text": _text,
    "rosward.parameter_type": _type,
    "rosward.parameter_value": _raw,
    "rosward.parameter_word": _type_name,
    "rosward.set_parameter": _set,
    "rosward.undeclare_parameter": _of_node("_rosward.undeclare_parameter"),
}
