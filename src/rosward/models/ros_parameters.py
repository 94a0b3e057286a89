# SPDX-License-Identifier: Apache-2.0
"""Parameters of a node: what `declare_parameter` and `get_parameter` give, and from where.

self.declare_parameter('topic', '/scan')    '/scan', marked as the default of parameter topic
self.declare_parameter('topic')             unknown, because parameter topic has no value
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.domain.choice import join_all, options
from rosward.domain.text import pattern
from rosward.domain.unknown import Cause, Origin, Origins, Reason
from rosward.domain.values import FALSE, NONE, TRUE, UNBOUND, Const, Ref, Text, Tuple, Unknown, Value
from rosward.models.command_line import ANY_NAME, given_to, type_word
from rosward.models.effects import EffectLog, NodeEffect, ParameterEffect
from rosward.models.host import host, is_true, text_of
from rosward.models.native import NativeCall, NativeFunction
from rosward.models.ros_effects import mark
from rosward.models.ros_names import command_lines, final_name
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
    machine = host(call.machine)
    node, name = call.args[0], call.args[1]
    default = call.arg(2, "default", NONE) or NONE
    type_ = call.arg(3, "type", NONE) or NONE
    ignored = call.arg(4, "ignore_override", FALSE) or FALSE
    typed = call.arg(5, "dynamic", FALSE) in (FALSE, NONE)
    found: list[Value] = []
    for each in options(node):
        for key in options(name):
            value = _initial(machine, each, key, default, _hint(machine, type_), ignored, typed=typed)
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


def _initial(
    machine: Interpreter, node: Value, name: Value, default: Value, hint: str, ignored: Value, *, typed: bool
) -> Value:
    """The value of a parameter when it is declared: what the code or the command line sets, else its default.

    Of a process whose command line is known the default holds for sure; otherwise anybody may have set another.
    `ignored`: whether what is set from outside does not count (ignore_override). A parameter that is not `typed` takes a value of any type.
    """
    label = text_of(name, pattern(name))
    override = _override(machine, node, label) if ignored != TRUE else None
    if override is not None and typed:
        _check_type(machine, label, default, override)
    open_ = _open(machine, node)
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


def _check_type(machine: Interpreter, label: str, default: Value, override: Value) -> None:
    """rclpy refuses a value of another type than that of the default."""
    declared, given = type_word(default), type_word(override)
    if declared and given and declared != given and "not_set" not in (declared, given):
        machine.report("RW209", f"parameter {label!r} is declared as {declared} but set to a value of type {given}")


def _open(machine: Interpreter, node: Value) -> tuple[Reason, ...]:
    """The parameter files of the node's command lines that are not known: they may set anything."""
    return tuple(
        dict.fromkeys(
            r for e in _effects(machine, node) for line in command_lines(machine.log, e) for r in line.missing
        )
    )


def _effects(machine: Interpreter, node: Value) -> list[NodeEffect]:
    return [e for e in machine.log.nodes if isinstance(node, Ref) and e.address == node.address]


def _override(machine: Interpreter, node: Value, name: str) -> Value | None:
    """What the node's own code sets by parameter_overrides, or its command line."""
    if not isinstance(node, Ref):
        return None
    given = machine.obj(node).attrs.get("__overrides__")
    if given is not None:
        for item in machine.iterate(given).known:
            if isinstance(item, Ref):
                attrs = machine.obj(item).attrs
                if name in (text_of(attrs.get("_name")), text_of(attrs.get("name"))):
                    return attrs.get("_value", attrs.get("value"))
    found: list[Value] = []
    for effect in _effects(machine, node):
        values = values_of(machine.log, effect)
        value = values.get(name, values.get(ANY_NAME))
        if value is not None:
            found.append(_on_heap(machine, name, value))
    return join_all(found) if found else None


def values_of(log: EffectLog, effect: NodeEffect) -> dict[str, Value]:
    """The parameters that the command lines of a node set, by name."""
    own, general = command_lines(log, effect)
    if not own.parameters and not general.parameters:
        return {}
    name, space = final_name(log, effect)
    found: dict[str, list[Value]] = {}
    for fqn in {fully_qualified(pattern(s), pattern(n)): None for n in options(name) for s in options(space)}:
        for label, value in {**given_to(fqn, general.parameters), **given_to(fqn, own.parameters)}.items():
            found.setdefault(label, []).append(value)
    return {label: join_all(values) for label, values in found.items()}


def _on_heap(machine: Interpreter, name: str, value: Value) -> Value:
    """A given value as the program holds it, marked as set from outside."""
    if isinstance(value, Tuple):
        value = machine.new_list(value.items)
    return mark(machine, value, Origin("parameter", name, settled=True, given=True))


def _now(machine: Interpreter, value: Value, label: str) -> Value:
    """The value of a parameter when a callback reads it: by then `ros2 param set` may have given it another."""
    if not machine.schedule_book.running:
        return value
    if isinstance(value, Const):
        return Const(value.value, _reopened(value.origins, label))
    return Text(value.parts, _reopened(value.origins, label)) if isinstance(value, Text) else value


def _reopened(origins: Origins, label: str) -> Origins:
    return frozenset(o._replace(settled=False) if o[:2] == ("parameter", label) else o for o in origins)


def _parameter(call: NativeCall) -> Value:
    machine = host(call.machine)
    found: list[Value] = []
    for node in options(call.args[0]):
        table = _table(machine, node)
        for name in options(call.args[1]):
            label = text_of(name, pattern(name))
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
            if value is None:
                value = machine.unknown(Cause.PARAMETER, label)
            found.append(join_all(_now(machine, v, label) for v in options(value)))
    return join_all(found)


def _set(call: NativeCall) -> Value:
    machine = host(call.machine)
    node, name, value = call.args
    for each in options(node):
        table = _table(machine, each)
        for key in options(name):
            if table is not None:
                machine.store_item(table, key, value)
            if text_of(key) == "use_sim_time" and any(is_true(v) for v in options(value)):
                clock = machine.load_attr(machine.load_module("rosgraph_msgs.msg"), "Clock")
                machine.call(machine.load_attr(each, "create_subscription"), (clock, Const("/clock"), NONE, Const(1)))
    return NONE


def _undeclare(call: NativeCall) -> Value:
    """A parameter that is no longer declared; perhaps, where the node or the name is one of several."""
    machine = host(call.machine)
    nodes, names = options(call.args[0]), options(call.args[1])
    sure = len(nodes) == len(names) == 1
    for table in (t for t in (_table(machine, n) for n in nodes) if t is not None):
        record = machine.obj(table)
        label = names[0] if sure and isinstance(names[0], Const) else None
        gone = {k for k in record.entries if k == label or (label is None and _may_be_named(k, names))}
        entries = {k: v for k, v in record.entries.items() if k != label}
        changed = record.replace(entries=entries, maybe=(record.maybe | gone) & frozenset(entries))
        machine.update(table, changed)
    return NONE


def _may_be_named(key: Value, names: tuple[Value, ...]) -> bool:
    return any(not isinstance(n, Const) or n.value == text_of(key) for n in names)


def _has(call: NativeCall) -> Value:
    """Whether a parameter is declared."""
    machine = host(call.machine)
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
    machine = host(call.machine)
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


def _declare_given(call: NativeCall) -> Value:
    """Every parameter that the command line sets becomes one of the node (automatically_declare_parameters_from_overrides)."""
    machine = host(call.machine)
    for node in options(call.args[0]):
        table = _table(machine, node)
        for effect in _effects(machine, node):
            for label, value in values_of(machine.log, effect).items():
                if table is not None:
                    machine.store_item(table, Const(label), _on_heap(machine, label, value))
    return NONE


NATIVES: Final[dict[str, NativeFunction]] = {
    "_rosward.declare_given": _declare_given,
    "_rosward.declare_parameter": _declare,
    "_rosward.parameter": _parameter,
    "rclpy.node.Node.has_parameter": _has,
    "rclpy.node.Node.get_parameters_by_prefix": _by_prefix,
    "_rosward.set_parameter": _set,
    "rclpy.node.Node.undeclare_parameter": _undeclare,
}
