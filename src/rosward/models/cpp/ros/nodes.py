# SPDX-License-Identifier: Apache-2.0
"""Nodes and what is created on them, as the headers of the models say it.

rosward::create("publisher", this, topic, rosward::type<M>(), qos)      an entity, as `_rosward.create` of the models of rclpy
rosward::interface_of(node)                                             a pointer to the node behind a node, pointer or interface
"""

from __future__ import annotations

from typing import Final

from rosward.domain.certain import text_of
from rosward.domain.choice import join_all, lift, options
from rosward.domain.compound import External
from rosward.domain.slots import Pointer
from rosward.domain.text import pattern
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, UNBOUND, Class, Const, Ref, Text, Unknown, Value
from rosward.models.cpp.ros.handed import NODE, given, node_of, target_of
from rosward.models.cpp.values.callables import function_behind
from rosward.models.cpp.values.slots import read, read_field
from rosward.models.native import NativeCall, NativeFunction
from rosward.models.ros import entities, names
from rosward.models.ros.parameter_table import raise_
from rosward.models.ros.qos import qos_of
from rosward.ros import names as rules
from rosward.ros.validation import validate_node_name

_QOS: Final = "rmw_qos_profile_"
_CLIENT_LIBRARY: Final = Const("rclcpp")
_OPTIONS: Final = (
    "enable_rosout",
    "enable_topic_statistics",
    "start_parameter_services",
    "start_parameter_event_publisher",
    "enable_logger_service",
    "use_global_arguments",
    "parameter_overrides",
    "allow_undeclared_parameters",
    "automatically_declare_parameters_from_overrides",
)
"""The fields of `rclcpp::NodeOptions` that decide what a node has, each with `_` behind its name."""

_REFUSALS: Final = {
    "publisher": ("InvalidTopicNameError", rules.RemapKind.TOPIC),
    "subscription": ("InvalidTopicNameError", rules.RemapKind.TOPIC),
    "service_server": ("InvalidServiceNameError", rules.RemapKind.SERVICE),
    "service_client": ("InvalidServiceNameError", rules.RemapKind.SERVICE),
}
"""What is thrown for a name that rcl refuses; for actions the error of rcl itself."""


def _create(call: NativeCall) -> Value:
    """`create(kind, node, name, type, qos, callback)`."""
    callback = function_behind(call.machine, given(call, 5))
    entities.create(
        call.machine,
        text_of(given(call, 0)),
        node_of(call, call.args[1]),
        given(call, 2),
        given(call, 3),
        None if callback == NONE else callback,
        _profile(call, given(call, 4)),
    )
    return _named(call)


def _named(call: NativeCall) -> Value:
    """A name that rcl refuses: the call throws. Where nothing catches that, the name itself is what is told."""
    machine, kind, name = call.machine, text_of(given(call, 0)), given(call, 2)
    if not machine.is_tried:
        return NONE
    exception, scope = _REFUSALS.get(kind, ("RCLError", rules.RemapKind.TOPIC))
    refused = names.refused(machine, node_of(call, call.args[1]), name, scope)
    if refused is False:
        return NONE
    if refused:
        return raise_(machine, exception, f"a name that rcl refuses: {exception} is thrown", name)
    machine.throw(machine.call(machine.load_attr(machine.load_module("rclcpp.exceptions"), exception), (name,)))
    return NONE  # it may throw, of which nobody is told: the name is told of where it is not known


def _introspect(call: NativeCall) -> Value:
    """`introspect(kind, node, name, type, qos)`: the publisher of the events of a service."""
    kind = text_of(given(call, 0))
    node, name, type_ = node_of(call, call.args[1]), given(call, 2), given(call, 3)
    entities.create(call.machine, kind, node, name, type_, qos=_profile(call, given(call, 4)), introspection=True)
    return NONE


def _profile(call: NativeCall, value: Value) -> Value | None:
    """The profile of a QoS, as rmw has it."""
    target = target_of(call, value)
    if target == NONE:
        return None
    profiles = [p for option in options(target) for p in options(_inner(call, option))]
    known = {qos_of(call.machine, profile) for profile in profiles}
    return profiles[0] if len(known) == 1 else None


def _inner(call: NativeCall, value: Value) -> Value:
    held = call.machine.obj(value).attrs.get(_QOS) if isinstance(value, Ref) else None
    return value if held is None else read(call.machine, held)


def _create_node(call: NativeCall) -> Value:
    """`create_node(this, name, namespace, options, context, lifecycle, lifecycle_services)`."""
    machine = call.machine
    options_ = target_of(call, given(call, 3))
    keywords: dict[str, Value] = {"namespace": given(call, 2), "client_library": _CLIENT_LIBRARY}
    for name in _OPTIONS:
        keywords[name] = _option(call, options_, name)
    keywords["cli_args"] = _option(call, options_, "arguments")
    keywords["context"] = target_of(call, given(call, 4))
    keywords["lifecycle"], keywords["lifecycle_services"] = given(call, 5), given(call, 6)
    inner = NativeCall(machine, "_rosward.create_node", (target_of(call, call.args[0]), given(call, 1)), keywords)
    entities.NATIVES["_rosward.create_node"](inner)
    own = given(call, 1)
    if machine.is_tried and isinstance(own, Const) and validate_node_name(pattern(own)) is not None:
        return raise_(machine, "InvalidNodeNameError", "a name that rcl refuses: InvalidNodeNameError is thrown", own)
    return NONE


def _option(call: NativeCall, node_options: Value, name: str) -> Value:
    machine = call.machine
    if isinstance(node_options, Ref):
        return read_field(machine, node_options, f"{name}_")
    if isinstance(node_options, Unknown):
        return Unknown(node_options.reasons)
    return machine.unknown(Cause.CALL, f"NodeOptions::{name}")


def _interface_of(call: NativeCall) -> Value:
    """`interface_of(node)`: a pointer to the node; of a class that has nodes inside, what its `get_node_base_interface` gives."""
    machine = call.machine

    def one(option: Value) -> Value:
        if not isinstance(option, Ref):
            return option
        held = machine.obj(option).attrs.get(NODE, UNBOUND)
        if held is not UNBOUND:
            found = node_of(call, option)
            return Pointer(found) if isinstance(found, Ref) else found
        asked = machine.load_attr(option, "get_node_base_interface")
        if isinstance(asked, Unknown):
            return Pointer(option)
        inner = target_of(call, machine.call(asked, ()))
        return Pointer(inner) if isinstance(inner, Ref) else inner

    return lift(one, target_of(call, call.args[0]))


def _node_behind(call: NativeCall) -> Value:
    """`node_behind(node)`: a pointer to what is handed over as a node, a sub-node as it is."""
    return lift(lambda o: Pointer(o) if isinstance(o, Ref) else o, target_of(call, call.args[0]))


def _spun(call: NativeCall) -> Value:
    def seen(option: Value) -> Value:
        """What is spun as one of a base that nobody knows may be a node by that."""
        cls = call.machine.obj(option).cls if isinstance(option, Ref) else NONE
        bases = cls.mro if isinstance(cls, Class) else ()
        return next((b for b in bases if isinstance(b, External) and not b.name.startswith("std.")), option)

    return entities.NATIVES["_rosward.spun"](call._replace(args=(lift(seen, node_of(call, call.args[0])),)))


def _spin(call: NativeCall) -> Value:
    call.machine.spin()
    return NONE


def _of_name(name: str) -> NativeFunction:
    """The native of the same name of the models of rclpy, with the node in the first place."""
    native = names.NATIVES[f"_rosward.{name}"]

    def asked(call: NativeCall) -> Value:
        others = tuple(read(call.machine, a) for a in call.args[1:])
        return native(call._replace(args=(node_of(call, call.args[0]), *others), keywords={}))

    return asked


def _expand_name(call: NativeCall) -> Value:
    """`expand_name(name, node_name, namespace)`."""
    machine = call.machine
    name, node, space = (given(call, n) for n in range(3))
    found: list[Value] = []
    for each in options(name):
        if not all(isinstance(v, (Const, Text)) for v in (each, node, space)):
            return machine.unknown(Cause.OPERATION, "expand name", "str")
        try:
            resolved = rules.resolve(pattern(each), rules.RemapKind.TOPIC, (), pattern(node), pattern(space))
        except rules.InvalidName:
            continue
        found += [Const(r) for r in resolved]
    return join_all(found) if found else machine.unknown(Cause.OPERATION, "expand name", "str")


NATIVES: Final[dict[str, NativeFunction]] = {
    "rosward.create": _create,
    "rosward.create_node": _create_node,
    "rosward.expand_name": _expand_name,
    "rosward.interface_of": _interface_of,
    "rosward.introspect": _introspect,
    "rosward.node_behind": _node_behind,
    "rosward.node_fqn": _of_name("node_fqn"),
    "rosward.node_name": _of_name("node_name"),
    "rosward.node_namespace": _of_name("node_namespace"),
    "rosward.resolve_name": _of_name("resolve_name"),
    "rosward.spin": _spin,
    "rosward.spun": _spun,
}
