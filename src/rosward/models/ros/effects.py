# SPDX-License-Identifier: Apache-2.0
"""The module `_rosward` that library models import: decorators that declare effects, and functions that perform them."""

from __future__ import annotations

from collections import ChainMap
from collections.abc import Mapping
from typing import TYPE_CHECKING, Final

from rosward.domain.certain import is_true, text_of
from rosward.domain.choice import join_all, lift, options
from rosward.domain.heap import Obj
from rosward.domain.series import Series
from rosward.domain.text import readable
from rosward.domain.unknown import Cause, Origin
from rosward.domain.values import (
    NONE,
    Class,
    Const,
    External,
    Function,
    Native,
    Partial,
    Ref,
    Text,
    Tuple,
    Unknown,
    Value,
)
from rosward.effects.log import EntityEffect, NodeEffect
from rosward.models.failures import fail
from rosward.models.native import NativeCall, NativeFunction
from rosward.models.python.contents import plain_data
from rosward.models.ros.given_words import context_lines, keep_line, lines_of, words_of_process
from rosward.models.ros.message_fields import arrived
from rosward.models.ros.parameter_table import new_table
from rosward.models.ros.qos import qos_of
from rosward.naming.options import callback_name, interface_type

if TYPE_CHECKING:
    from rosward.models.native import Machine


# Decorators


def _creates(call: NativeCall) -> Value:
    pairs = tuple(Tuple((Const(k), v)) for k, v in call.keywords.items())
    return Partial(Native("_rosward.mark"), (Tuple((Const("creates"), call.args[0], Tuple(pairs))),), ())


def _calls(call: NativeCall) -> Value:
    wanted = call.arg(2, "args", Tuple(()))
    known = call.machine.iterate(wanted).known if wanted is not None else ()
    spec = Tuple((Const("calls"), call.args[0], call.arg(1, "event", Const("callback")) or NONE, Tuple(known)))
    return Partial(Native("_rosward.mark"), (spec,), ())


def _mark(call: NativeCall) -> Value:
    spec, function = call.exactly(2)
    if isinstance(function, Function):
        effects = (*function.effects, spec)
        return Function(function.code, function.module, function.cells, function.defaults, function.kwdefaults, effects)
    return function


def _marker(kind: str) -> NativeFunction:
    return lambda call: _mark(call._replace(args=(Tuple((Const(kind),)), call.args[0])))


def _changes(call: NativeCall) -> Value:
    return Partial(Native("_rosward.mark"), (Tuple((Const("changes"), Tuple(call.args))),), ())


def _for_the_reader(call: NativeCall) -> Value:
    """A mark that changes nothing of what it stands on: `reads_only` (so does a declared function in any case), or what `models.facts` reads."""
    return call.args[0] if call.args else NONE


def _raises_nothing(call: NativeCall) -> Value:
    """A mark of a function; of a module `models.facts` reads it."""
    return _marker("raises_nothing")(call) if isinstance(call.args[0], Function) else NONE


def perform(machine: Machine, spec: Tuple, named: dict[str, Value]) -> None:
    """An effect that a decorator declares; `named` are the arguments of the call by parameter."""
    kind = text_of(spec.items[0])
    if kind == "spins":
        machine.spin()
    elif kind == "creates":
        pairs = (_items(pair) for pair in _items(spec.items[2]))
        wanted = {text_of(role): text_of(parameter) for role, parameter in pairs}
        given = {role: named.get(wanted.get(role, "")) for role in ("name", "type", "qos", "callback")}
        node = named.get(wanted.get("node", "self"))
        create(machine, text_of(spec.items[1]), node, given["name"], given["type"], given["callback"], given["qos"])
    elif kind == "calls":
        callback = named.get(text_of(spec.items[1]))
        if callback is not None and callback != NONE:
            args = tuple(_argument(machine, text_of(a), named) for a in _items(spec.items[3]))
            machine.schedule(callback, args, text_of(spec.items[2]))


def _items(value: Value) -> tuple[Value, ...]:
    return value.items if isinstance(value, Tuple) else ()


def _argument(machine: Machine, wanted: str, named: dict[str, Value]) -> Value:
    """What a callback is called with: see the notation of models."""
    kind, _, name = wanted.partition(":")
    if kind == "param":
        return named.get(name, NONE)
    if kind == "self":
        return named.get("self", NONE)
    if kind in ("message", "request", "response", "goal") and machine.truth(named.get("raw", NONE)) is False:
        return message_of(machine, named.get(name, NONE), kind)
    return machine.unknown(Cause.CALL, "argument of a callback")


def message_of(machine: Machine, type_: Value, kind: str = "message") -> Value:
    """A message of a type (or the request, response, goal of one) that somebody sent."""
    found = interface_type(type_)
    subject = found.rpartition("/")[2] if found else "message"
    if kind == "response" and isinstance(type_, External):
        return machine.allocate(Obj("instance", External(f"{type_.name}.Response")), "response")
    part = {"request": "request", "goal": "goal"}.get(kind, "")
    unknown = machine.unknown(Cause.MESSAGE, f"{subject} {part}".strip())
    if not isinstance(type_, External):
        return unknown
    return arrived(machine, External(f"{type_.name}.{part.capitalize()}") if part else type_, unknown, kind)


# Entities


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
            f"the type of this {kind.replace('_', ' ')} stands where its name belongs, which fails; it is taken as it is meant",
        )
        name, type_ = type_, name
    for option in options(node if node is not None else NONE):
        address = option.address if isinstance(option, Ref) else None
        if address is not None and not machine.log.is_node(address):
            if not _used_as_node(machine, option):
                address = None
        if isinstance(option, Const) and option.value is None and len(options(node or NONE)) > 1:
            continue
        if address is None and isinstance(type_, Const) and type_.value is not None:
            continue  # no interface type: a method of that name that has nothing to do with ROS
        if address is None:
            machine.report("RW208", f"{kind.replace('_', ' ')} on a node that is not known{_why(option)}")
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
    """A name as rclpy reads it: a member of a `str` enumeration is its text."""

    def one(option: Value) -> Value:
        payload = machine.obj(option).payload if isinstance(option, Ref) else None
        return payload if isinstance(payload, (Const, Text)) else option

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
    "enable_rosout",
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


def _init(call: NativeCall) -> Value:
    """`init(context, args)`: the context keeps its command line."""
    keep_line(call.machine, call.args[0], call.arg(1, "args"))
    return NONE


def _remove_ros_args(call: NativeCall) -> Value:
    """`rclpy.utilities.remove_ros_args(args)`: the words that are not between --ros-args and --."""
    machine = call.machine
    args = call.arg(0, "args")
    words = machine.series(words_of_process(machine) if args is None or args == NONE else args)
    kept: list[list[Value]] = []
    for_ros = False
    for part in (words.head, words.tail):
        kept.append([])
        for word in part:
            text = text_of(word)
            if text == "--ros-args":
                for_ros = True
            elif for_ros and text == "--":
                for_ros = False
            elif not for_ros:
                kept[-1].append(word)
    return machine.new_list(kept[0], words.middle, tuple(kept[1]))


def _environment(call: NativeCall) -> Value:
    """`_rosward.environment(name)`: a variable that the deployment sets, or that is known of the shell; None where nothing is known."""
    machine = call.machine
    name = text_of(call.args[0])
    return _own_variables(machine, name).get(name) or NONE


def _is_unset(call: NativeCall) -> Value:
    """`_rosward.unset(name)`: whether the deployment has removed a variable."""
    name = text_of(call.args[0])
    variables = _own_variables(call.machine, name)
    return Const(name in variables and variables[name] is None)


def _own_variables(machine: Machine, name: str) -> Mapping[str, Value | None]:
    """What is known of the environment of the process, before the program changes it; `name` is what is asked of it."""
    machine.log.variables.read[name] = None
    configuration = machine.log.configuration
    shell: Mapping[str, Value | None] = machine.environment
    return shell if configuration is None else ChainMap(dict(configuration.environment), dict(shell))


# Plain functions


def _schedule(call: NativeCall) -> Value:
    event = text_of(call.keywords.get("event"), "callback")
    if call.args[0] != NONE:
        call.machine.schedule(call.args[0], call.args[1:], event)
    return NONE


def _spun(call: NativeCall) -> Value:
    """`_rosward.spun(node)`: the program lets a node work; which one may not be known."""
    machine = call.machine
    for option in options(call.args[0]):
        if isinstance(option, (Unknown, External)):
            machine.log.spun.setdefault(machine.place, _why(option))
    return NONE


def _spin(call: NativeCall) -> Value:
    call.machine.spin()
    return NONE


def _message(call: NativeCall) -> Value:
    return message_of(call.machine, call.args[0])


def _unknown(call: NativeCall) -> Value:
    label = text_of(call.args[0]).upper().replace(" ", "_")
    cause = Cause[label] if label in Cause.__members__ else Cause.CALL
    subject = call.arg(1, "subject")
    name = text_of(subject, "" if subject is None else readable(subject))
    value = call.machine.unknown(cause, name, text_of(call.arg(2, "hint")))
    whole = cause is Cause.ENVIRONMENT and value.hint == "str" and isinstance(subject, Const)
    return Unknown(value.reasons, value.hint, name) if whole else value


def mark(machine: Machine, value: Value, origin: Origin) -> Value:
    """The value, and all that it holds, as computed from an origin."""
    if isinstance(value, Const):
        return value if value.value is None else Const(value.value, value.origins | {origin})
    if isinstance(value, Text):
        return Text(value.parts, value.origins | {origin})
    if isinstance(value, Tuple):
        return Tuple(tuple(mark(machine, v, origin) for v in value.items))
    if isinstance(value, Ref) and machine.obj(value).kind in ("list", "set"):
        obj = machine.obj(value)
        items = None if obj.items is None else [mark(machine, v, origin) for v in obj.items]
        rest = None if obj.rest is None else mark(machine, obj.rest, origin)
        return machine.new_list(items or (), rest)
    if len(options(value)) > 1:
        return join_all(mark(machine, v, origin) for v in options(value))
    return value


def _default(call: NativeCall) -> Value:
    kind, name, value = call.exactly(3)
    return mark(call.machine, value, Origin(text_of(kind), text_of(name, readable(name))))


def _either(call: NativeCall) -> Value:
    return join_all(call.args)


def _opaque(call: NativeCall) -> Value:
    return join_all(call.machine.allocate(Obj("instance", c)) for c in options(call.args[0]))


def _escape(call: NativeCall) -> Value:
    call.machine.escape(call.args, "a library")
    return NONE


def _report(call: NativeCall) -> Value:
    call.machine.report(text_of(call.args[0]), readable(call.args[1]))
    return NONE


def _fail_unless(call: NativeCall) -> Value:
    """`_rosward.fail_unless(condition, exception, message)`: the library raises where the condition surely does not hold."""
    machine = call.machine
    condition, exception, message = call.exactly(3)
    if machine.truth(condition) is not False:
        return NONE
    return fail(machine, exception, readable(message), (message,))


def _get_message(call: NativeCall) -> Value:
    """`rosidl_runtime_py.utilities.get_message('pkg/msg/Name')`: the type of a constant text."""

    def one(value: Value) -> Value:
        parts = text_of(value).split("/")
        if len(parts) == 2:
            parts.insert(1, call.name.rpartition("_")[2].replace("message", "msg").replace("service", "srv"))
        return External(".".join(parts)) if len(parts) == 3 else call.machine.unknown(Cause.CALL, "interface type")

    return lift(one, call.args[0])


NATIVES: Final[dict[str, NativeFunction]] = {
    "_rosward.creates": _creates,
    "_rosward.calls": _calls,
    "_rosward.mark": _mark,
    "_rosward.spins": _marker("spins"),
    "_rosward.native": _marker("native"),
    "_rosward.pure": _marker("pure"),
    "_rosward.changes": _changes,
    "_rosward.raises_nothing": _raises_nothing,
    **dict.fromkeys(
        (
            "_rosward.reads_only",
            "_rosward.node_class",
            "_rosward.node_method",
            "_rosward.creator",
            "_rosward.asks_all",
            "_rosward.before_sources",
            "_rosward.precise",
            "_rosward.exact_calls",
        ),
        _for_the_reader,
    ),
    "_rosward.create": _create,
    "_rosward.create_node": _create_node,
    "_rosward.init": _init,
    "_rosward.environment": _environment,
    "_rosward.unset": _is_unset,
    "rclpy.utilities.remove_ros_args": _remove_ros_args,
    "_rosward.schedule": _schedule,
    "_rosward.spin": _spin,
    "_rosward.spun": _spun,
    "_rosward.message": _message,
    "_rosward.unknown": _unknown,
    "_rosward.default": _default,
    "_rosward.either": _either,
    "_rosward.opaque": _opaque,
    "_rosward.escape": _escape,
    "_rosward.fail_unless": _fail_unless,
    "_rosward.report": _report,
    "rosidl_runtime_py.utilities.get_message": _get_message,
    "rosidl_runtime_py.utilities.get_service": _get_message,
    "rosidl_runtime_py.utilities.get_action": _get_message,
}

__all__ = ["NATIVES", "create", "mark", "message_of", "perform"]
