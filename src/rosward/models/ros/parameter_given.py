# SPDX-License-Identifier: Apache-2.0
"""What is a parameter set to when it is declared: by the code's own `parameter_overrides`, the command line, a parameter file, else its default?

Node('n', parameter_overrides=[Parameter('topic', value='/a')])      '/a', whatever the default is
-p topic:=/b                                                         '/b', marked as given
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from rosward.domain.certain import text_of
from rosward.domain.choice import join, join_all, options
from rosward.domain.compound import Tuple
from rosward.domain.text import readable
from rosward.domain.unknown import OUTSIDE, Cause, Origin, Reason
from rosward.domain.values import FALSE, NONE, TRUE, UNBOUND, Const, Ref, Unknown, Value
from rosward.ir.program import PYTHON
from rosward.models.ros import parameter_table as table
from rosward.models.ros.effects import mark
from rosward.models.ros.names import nodes_at
from rosward.naming.command_line import ANY_NAME, type_word
from rosward.naming.final_name import command_lines
from rosward.naming.parameters import values_of
from rosward.records import NamedTuple

if TYPE_CHECKING:
    from rosward.models.native import Machine


def type_label(machine: Machine, type_: Value) -> str:
    """The name of a member of Parameter.Type, or that itself."""
    if isinstance(type_, Const):
        return text_of(type_)
    attrs = machine.obj(type_).attrs if isinstance(type_, Ref) else {}
    return text_of(attrs.get("name", attrs.get("_name_")))


def initial_value(machine: Machine, node: Value, name: Value, default: Value, hint: str, ignored: Value) -> Value:
    """The value of a parameter when it is declared: what the code or the command line sets, else its default.

    Of a process whose command line is known the default holds for sure; otherwise anybody may have set another.
    `ignored`: whether what is set from outside does not count (ignore_override).
    """
    label = text_of(name, readable(name))
    override = override_of(machine, node, label) if ignored != TRUE else None
    open_ = unread_files(machine, node)
    if override is not None and not open_:
        return override
    origin = Origin("parameter", label, settled=machine.log.configuration is not None and not open_)
    values = [
        machine.unknown(Cause.PARAMETER, label, hint)
        if option == NONE or option is UNBOUND
        else mark(machine, option, origin)
        for option in (options(default) if override is None else (override,))
    ]
    return join_all([*values, *(Unknown((r,), hint) for r in open_)])


def or_another_list(
    machine: Machine, node: Value, name: Value, value: Value, element: str, ignored: Value, *, typed: bool
) -> Value:
    """The first value of a parameter; where it is an empty list that anybody may have set, with one of elements of the type `element` beside.

    For rclpy an empty list is one of bytes, and declaring raises where another one is given: `typed`, it stays the only one.
    """
    if typed and machine.language_name == PYTHON:
        return value
    if machine.log.configuration is not None or not any(_is_empty(machine, option) for option in options(value)):
        return value
    label = text_of(name, readable(name))
    if ignored != TRUE and override_of(machine, node, label) is not None:
        return value
    return join(value, machine.new_list((), Unknown((Reason(Cause.ELEMENT, label, machine.place),), element)))


def _is_empty(machine: Machine, value: Value) -> bool:
    """Whether a default is a list without elements: none of them can tell what is made of each element."""
    if isinstance(value, Tuple):
        return not value.items
    return isinstance(value, Ref) and machine.obj(value).kind == "list" and machine.obj(value).items == ()


def given_wrongly(
    machine: Machine, node: Value, name: Value, default: Value, type_: Value, ignored: Value, typed: bool
) -> Value | None:
    """Declaring raises: what sets the parameter is of another type than the default. Without `typed` any type will do."""
    label = text_of(name)
    override = override_of(machine, node, label) if ignored == FALSE and typed and label else None
    if override is None:
        return None
    empty = machine.language_name == PYTHON and _is_empty(machine, default)
    declared = "byte_array" if empty else _type_of(machine, default) or type_label(machine, type_).lower()
    given = _type_of(machine, override)
    if not declared or not given or declared == given or "not_set" in (declared, given):
        return None
    message = f"parameter {label!r} is declared as {declared} but set to a value of type {given}"
    return table.raise_(machine, "InvalidParameterTypeException", message, name, Const(declared))


def _type_of(machine: Machine, value: Value) -> str | None:
    """rcl's word for the type of a value, None where it is not known."""
    if not isinstance(value, (Ref, Tuple)) or machine.language_name != PYTHON:
        return type_word(value)
    if isinstance(value, Ref) and machine.obj(value).kind != "list":
        return None
    items, rest = machine.iterate(value)
    return type_word(Tuple(tuple(items))) if rest is None else None


def unread_files(machine: Machine, node: Value) -> tuple[Reason, ...]:
    """The parameter files of the node's command lines that are not known: they may set anything."""
    return tuple(
        dict.fromkeys(
            r for e in nodes_at(machine, node) for line in command_lines(machine.log, e) for r in line.missing
        )
    )


def override_of(machine: Machine, node: Value, name: str) -> Value | None:
    """What the node's own code sets by parameter_overrides, or its command line."""
    if not isinstance(node, Ref):
        return None
    own, others = own_overrides(machine, node)
    if name in own:
        return own[name]
    found: list[Value] = []
    for effect in nodes_at(machine, node):
        values = values_of(machine.log, effect)
        value = values.get(name, values.get(ANY_NAME))
        if value is not None:
            found.append(on_heap(machine, name, value))
    if others:
        found.append(machine.unknown(Cause.PARAMETER, f"{name}, which parameter_overrides may set"))
    return join_all(found) if found else None


class Overrides(NamedTuple):
    """What code and configuration set of a node: values by name, each with whether it surely is set; `others`: why there may be more."""

    values: dict[str, tuple[Value, bool]]
    others: tuple[str, ...]


def overrides_of(machine: Machine, node: Value) -> Overrides:
    """All parameters that somebody sets. Where it is not known who starts the process, there may be any."""
    own, unknown = own_overrides(machine, node)
    open_ = unread_files(machine, node)
    effects = nodes_at(machine, node)
    given: dict[str, list[Value]] = {}
    for effect in effects:
        for label, value in values_of(machine.log, effect).items():
            given.setdefault(label, []).append(on_heap(machine, label, value))
    outside = given.pop(ANY_NAME, None) is not None or machine.log.configuration is None or open_
    found = {
        label: (join_all([*values, *(Unknown((r,)) for r in open_)]), len(values) == len(effects))
        for label, values in given.items()
    }
    found.update({label: (value, True) for label, value in own.items()})
    others = ((OUTSIDE,) if outside else ()) + (("set by parameter_overrides",) if unknown else ())
    return Overrides(found, others)


def own_overrides(machine: Machine, node: Value) -> tuple[dict[str, Value], bool]:
    """What the code itself sets by parameter_overrides, by name; and whether it may set others."""
    given = machine.obj(node).attrs.get("__overrides__") if isinstance(node, Ref) else None
    if given is None:
        return {}, False
    known, rest = machine.iterate(given)
    found: dict[str, Value] = {}
    others = rest is not None
    for item in known:
        attrs = machine.obj(item).attrs if isinstance(item, Ref) else {}
        name = text_of(attrs.get("_name", attrs.get("name")))
        value = attrs.get("_value", attrs.get("value"))
        if name and value is not None:
            found[name] = value
        else:
            others = True
    return found, others


def on_heap(machine: Machine, name: str, value: Value) -> Value:
    """A given value as the program holds it, marked as set from outside."""
    if isinstance(value, Tuple):
        value = machine.new_list(value.items)
    return mark(machine, value, Origin("parameter", name, settled=True, given=True))
