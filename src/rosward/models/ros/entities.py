# SPDX-License-Identifier: Apache-2.0
"""What creates nodes and their entities: each is recorded, with all that the call says of it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.domain.certain import is_true, text_of
from rosward.domain.choice import lift, options
from rosward.domain.compound import External
from rosward.domain.series import Series
from rosward.domain.values import NONE, Class, Const, Ref, Text, Unknown, Value
from rosward.effects.log import EntityEffect, NodeEffect
from rosward.models.native import NativeCall, NativeFunction
from rosward.models.python.contents import plain_data
from rosward.models.ros.callbacks import callback_name
from rosward.models.ros.given_words import context_lines, lines_of
from rosward.models.ros.parameter_table import new_table
from rosward.models.ros.parameter_tests import in_place
from rosward.models.ros.qos import qos_of

if TYPE_CHECKING:
    from rosward.models.native import Machine


def create(
    machine: Machine,
    kind: str,
    node: Value | None,
    name: Value | None,
    type_: Value | None,
    callback: Value | None = None,
    qos: Value | None = None,
    *,
    ros_prefix: bool = True,
    introspection: bool = False,
) -> None:
    """Record an entity on every node that `node` may be."""
    profile, prefix = qos_of(machine, qos)
    name = None if name is None else plain_data(machine, name)
    if isinstance(name, (External, Class)) and isinstance(type_, (Const, Text)):
        machine.report(
            "RW209",
            f"the type of this {kind.replace('_', ' ')} is in place of its name, which fails; the arguments were swapped for the analysis",
        )
        name, type_ = type_, name
    for option in options(node if node is not None else NONE):
        address = option.address if isinstance(option, Ref) else None
        if address is not None and not machine.is_node(address):
            if not _used_as_node(machine, option):
                address = None
        if isinstance(option, Const) and option.value is None and len(options(node or NONE)) > 1:
            continue
        if address is None and isinstance(type_, Const) and type_.value is not None:
            continue  # no interface type: a method of that name that has nothing to do with ROS
        if address is None:
            machine.report("RW208", f"{kind.replace('_', ' ')} on an unknown node{_why(option)}")
        effect = EntityEffect(
            kind,
            address,
            _plain_text(machine, name) if name is not None else NONE,
            type_ if type_ is not None else NONE,
            callback_name(callback),
            profile,
            ros_prefix and prefix,
            introspection,
            machine.place,
            machine.via,
        )
        machine.log.add_entity(machine, effect)


def _plain_text(machine: Machine, value: Value) -> Value:
    """A name as rclpy reads it: a member of a `str` enumeration is its text. What is surely not given is not what it is."""

    def one(option: Value) -> Value:
        payload = machine.obj(option).payload if isinstance(option, Ref) else None
        return in_place(machine, payload if isinstance(payload, (Const, Text)) else option)

    return lift(one, value)


def _why(value: Value) -> str:
    reasons = value.reasons if isinstance(value, Unknown) else ()
    return f": {reasons[0]}" if reasons else ""


def _used_as_node(machine: Machine, ref: Value) -> bool:
    """An instance of a class with a base that is not known may be a node; then it is taken to be one."""
    if not isinstance(ref, Ref):
        return False
    obj = machine.obj(ref)
    cls = obj.cls
    outside = [b for b in cls.mro if isinstance(b, (External, Unknown))] if isinstance(cls, Class) else []
    if obj.kind == "instance" and outside:
        machine.log.assumed_node(machine, ref, outside[0])
        return True
    return False


def _create(call: NativeCall) -> Value:
    machine = call.machine
    introspection = call.keywords.get("introspection")
    prefix = call.keywords.get("ros_prefix")
    create(
        machine,
        text_of(call.args[0]),
        call.arg(1, "node"),
        call.arg(2, "name"),
        call.arg(3, "type"),
        call.keywords.get("callback"),
        call.keywords.get("qos"),
        ros_prefix=prefix is None or is_true(prefix),
        introspection=is_true(introspection),
    )
    return NONE


_NODE_OPTIONS: Final = (
    "client_library",
    "enable_rosout",
    "enable_topic_statistics",
    "start_parameter_event_publisher",
    "start_parameter_services",
    "enable_logger_service",
    "lifecycle",
    "lifecycle_services",
    "allow_undeclared_parameters",
    "automatically_declare_parameters_from_overrides",
    "asked",
)


_READ_BY_LIBRARY: Final = ("use_sim_time", "start_type_description_service")
"""Parameters that decide what the client library itself creates."""


def _own_overrides(machine: Machine, overrides: Value | None) -> tuple[tuple[str, Value], ...]:
    """Those among the parameter overrides of the code itself that the client library reads."""
    if overrides is None or overrides == NONE:
        return ()
    found: list[tuple[str, Value]] = []
    for item in machine.iterate(overrides).known:
        attrs = machine.obj(item).attrs if isinstance(item, Ref) else {}
        name = text_of(attrs.get("_name"))
        if name in _READ_BY_LIBRARY:
            found.append((name, attrs.get("_value", NONE)))
    return tuple(found)


def _create_node(call: NativeCall) -> Value:
    machine = call.machine
    keywords = call.keywords
    use_global = keywords.get("use_global_arguments")
    for node in options(call.args[0]):
        if not isinstance(node, Ref):
            continue
        overrides = keywords.get("parameter_overrides")
        new_table(machine, node, keywords.get("allow_undeclared_parameters"))
        takes_global = use_global is None or machine.truth(use_global) is not False
        general = context_lines(machine, keywords.get("context")) if takes_global else (Series(),)
        lines = [(own, words) for own in lines_of(machine, keywords.get("cli_args")) for words in general]
        for own, words in lines:
            effect = NodeEffect(
                node.address,
                plain_data(machine, call.args[1] if len(call.args) > 1 else keywords.get("node_name", NONE)),
                plain_data(machine, keywords.get("namespace", NONE)),
                tuple((k, keywords[k]) for k in _NODE_OPTIONS if k in keywords) + _own_overrides(machine, overrides),
                own,
                words,
                machine.obj(node).cls,
                machine.place,
                machine.in_callback or len(lines) > 1,
            )
            machine.log.add_node(machine, effect)
        if overrides is not None and overrides != NONE:
            machine.update(node, machine.obj(node).with_attr("__overrides__", overrides))
    return NONE


def _spun(call: NativeCall) -> Value:
    """`_rosward.spun(node)`: the program lets a node work; which one may not be known."""
    machine = call.machine
    for option in options(call.args[0]):
        if isinstance(option, (Unknown, External)):
            machine.log.spun.setdefault(machine.place, _why(option))
    return NONE


NATIVES: Final[dict[str, NativeFunction]] = {
    "_rosward.create": _create,
    "_rosward.spun": _spun,
    "_rosward.create_node": _create_node,
}
