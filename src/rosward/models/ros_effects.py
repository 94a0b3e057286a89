# SPDX-License-Identifier: Apache-2.0
"""The module `_rosward` that library models import: decorators that declare effects, and functions that perform them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final, cast

from rosward.domain.choice import join_all, lift, options
from rosward.domain.heap import Obj
from rosward.domain.text import concat, make, parts_of
from rosward.domain.unknown import Cause, Origin
from rosward.domain.values import (
    NONE,
    UNBOUND,
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
from rosward.models.effects import EntityEffect, NodeEffect
from rosward.models.name_values import callback_name, interface_type, qos_of
from rosward.models.native import NativeCall, NativeFunction
from rosward.ros import arguments, names

if TYPE_CHECKING:
    from rosward.engine.interpreter import Interpreter


def host(call: NativeCall) -> Interpreter:
    """The interpreter behind a call: effects need its log and its frames."""
    return cast("Interpreter", call.machine)


def text_of(value: Value | None, default: str = "") -> str:
    """The str that a value surely is."""
    return value.value if isinstance(value, Const) and isinstance(value.value, str) else default


def is_true(value: Value | None) -> bool:
    """Whether a value is the constant True."""
    return isinstance(value, Const) and value.value is True


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
    spec, function = call.args
    if isinstance(function, Function):
        effects = (*function.effects, spec)
        return Function(function.code, function.module, function.cells, function.defaults, function.kwdefaults, effects)
    return function


def _marker(kind: str) -> NativeFunction:
    return lambda call: _mark(call._replace(args=(Tuple((Const(kind),)), call.args[0])))


def perform(machine: Interpreter, spec: Tuple, named: dict[str, Value]) -> None:
    """An effect that a decorator declares; `named` are the arguments of the call by parameter."""
    kind = text_of(spec.items[0])
    if kind == "spins":
        machine.spin()
    elif kind == "creates":
        wanted = {text_of(p.items[0]): text_of(p.items[1]) for p in spec.items[2].items}  # type: ignore[attr-defined]
        given = {role: named.get(wanted.get(role, "")) for role in ("name", "type", "qos", "callback")}
        node = named.get(wanted.get("node", "self"))
        create(machine, text_of(spec.items[1]), node, given["name"], given["type"], given["callback"], given["qos"])
    elif kind == "calls":
        callback = named.get(text_of(spec.items[1]))
        if callback is not None and callback != NONE:
            args = tuple(_argument(machine, text_of(a), named) for a in spec.items[3].items)  # type: ignore[attr-defined]
            machine.schedule(callback, args, text_of(spec.items[2]))


def _argument(machine: Interpreter, wanted: str, named: dict[str, Value]) -> Value:
    """What a callback is called with: see the notation of models."""
    kind, _, name = wanted.partition(":")
    if kind == "param":
        return named.get(name, NONE)
    if kind == "self":
        return named.get("self", NONE)
    if kind in ("message", "request", "response", "goal"):
        return message_of(machine, named.get(name, NONE), kind)
    return machine.unknown(Cause.CALL, "argument of a callback")


def message_of(machine: Interpreter, type_: Value, kind: str = "message") -> Value:
    """A message of a type (or the request, response, goal of one) that somebody sent."""
    found = interface_type(type_)
    subject = found.rpartition("/")[2] if found else "message"
    if kind == "response" and isinstance(type_, External):
        return machine.allocate(Obj("instance", External(f"{type_.name}.Response")), "response")
    part = {"request": "request", "goal": "goal"}.get(kind, "")
    return machine.unknown(Cause.MESSAGE, f"{subject} {part}".strip())


# Entities


def create(
    machine: Interpreter,
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


def _plain_text(machine: Interpreter, value: Value) -> Value:
    """A name as rclpy reads it: a member of a `str` enumeration is its text."""

    def one(option: Value) -> Value:
        payload = machine.obj(option).payload if isinstance(option, Ref) else None
        return payload if isinstance(payload, (Const, Text)) else option

    return lift(one, value)


def _why(value: Value) -> str:
    reasons = value.reasons if isinstance(value, Unknown) else ()
    return f": {reasons[0]}" if reasons else ""


def _used_as_node(machine: Interpreter, ref: Value) -> bool:
    """An instance of a class with a base that is not known may be a node; then it is taken to be one."""
    obj = machine.obj(ref)  # type: ignore[arg-type]
    cls = obj.cls
    outside = [b for b in cls.mro if isinstance(b, (External, Unknown))] if isinstance(cls, Class) else []
    if obj.kind == "instance" and outside:
        machine.log.assumed_node(machine, ref, outside[0])  # type: ignore[arg-type]
        return True
    return False


def _create(call: NativeCall) -> Value:
    machine = host(call)
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
)


def _words(machine: Interpreter, value: Value | None) -> tuple[Value, ...]:
    if value is None or value == NONE or isinstance(value, Unknown):
        return ()
    known, rest = machine.iterate(value)
    return known if rest is None else (*known, rest)


def _sim_time(machine: Interpreter, overrides: Value | None) -> tuple[tuple[str, Value], ...]:
    """`use_sim_time` among the parameter overrides of the code itself."""
    if overrides is None or overrides == NONE:
        return ()
    for item in machine.iterate(overrides).known:
        attrs = machine.obj(item).attrs if isinstance(item, Ref) else {}
        if text_of(attrs.get("_name")) == "use_sim_time":
            return (("use_sim_time", attrs.get("_value", NONE)),)
    return ()


def _create_node(call: NativeCall) -> Value:
    machine = host(call)
    keywords = call.keywords
    use_global = keywords.get("use_global_arguments")
    for node in options(call.args[0]):
        if not isinstance(node, Ref):
            continue
        overrides = keywords.get("parameter_overrides")
        table = machine.new_dict({})
        machine.update(node, machine.obj(node).with_attr("__parameters__", table))
        effect = NodeEffect(
            node.address,
            call.args[1] if len(call.args) > 1 else keywords.get("node_name", NONE),
            keywords.get("namespace", NONE),
            tuple((k, keywords[k]) for k in _NODE_OPTIONS if k in keywords) + _sim_time(machine, overrides),
            _words(machine, keywords.get("cli_args")),
            machine.log.global_words if use_global is None or machine.truth(use_global) is not False else (),
            machine.obj(node).cls,
            machine.place,
            machine.schedule_book.running,
        )
        machine.log.add_node(machine, effect)
        if overrides is not None and overrides != NONE:
            machine.update(node, machine.obj(node).with_attr("__overrides__", overrides))
    return NONE


def _init(call: NativeCall) -> Value:
    machine = host(call)
    machine.log.global_words = _words(machine, call.arg(0, "args"))
    return NONE


# Names


def _named(machine: Interpreter, node: Value, part: int) -> Value:
    """The node's final name (part 0) or namespace (part 1)."""
    found: list[Value] = []
    for option in options(node):
        if isinstance(option, Ref):
            found += [final_name(e)[part] for e in machine.log.nodes if e.address == option.address]
    return join_all(found) if found else machine.unknown(Cause.LIVE, "name of a node that is not known", "str")


def remap_rules(effect: NodeEffect) -> tuple[names.RemapRule, ...]:
    """The remap rules that a node's own code gives it: its cli_args first, then those of rclpy.init."""
    local = arguments.parse_arguments([word_text(w) for w in effect.words]).remaps
    general = arguments.parse_arguments([word_text(w) for w in effect.global_words]).remaps
    return (*local, *general)


def word_text(value: Value) -> str:
    """A command-line word, with `*` for what is not known."""
    return "".join(p if isinstance(p, str) else names.HOLE for p in parts_of(value))


def final_name(effect: NodeEffect) -> tuple[Value, Value]:
    """The name and namespace of a node behind its remap rules."""
    namespace = Const("/") if effect.namespace in (NONE, UNBOUND) else lift(_full_namespace, effect.namespace)
    rules = remap_rules(effect)
    if not rules or not isinstance(effect.name, Const) or not isinstance(namespace, Const):
        return effect.name, namespace
    name, space = names.remap_node(text_of(effect.name), text_of(namespace), rules)
    return Const(name, effect.name.origins), Const(space, namespace.origins)


def _full_namespace(value: Value) -> Value:
    if isinstance(value, Const):
        if value.value is None:
            return Const("/")
        return Const(names.full_namespace(str(value.value)), value.origins)
    if isinstance(value, Text):
        first = value.parts[0]
        if isinstance(first, str) and not first.startswith("/"):
            return make(("/", *value.parts), value.origins)
    return value


def _node_name(call: NativeCall) -> Value:
    return _named(host(call), call.args[0], 0)


def _node_namespace(call: NativeCall) -> Value:
    return _named(host(call), call.args[0], 1)


def _node_fqn(call: NativeCall) -> Value:
    machine = host(call)
    name, namespace = _named(machine, call.args[0], 0), _named(machine, call.args[0], 1)
    return join_all(_qualified(n, s) for n in options(name) for s in options(namespace))


def _qualified(name: Value, namespace: Value) -> Value:
    if isinstance(namespace, Const) and namespace.value == "/":
        return concat((Const("/", namespace.origins), name))
    return concat((namespace, Const("/"), name))


def _resolve_name(call: NativeCall) -> Value:
    machine = host(call)
    node = call.args[0]
    kind = names.RemapKind.SERVICE if text_of(call.arg(2, "kind")) == "service" else names.RemapKind.TOPIC
    effects = [e for e in machine.log.nodes if isinstance(node, Ref) and e.address == node.address]
    found: list[Value] = []
    for effect in effects:
        own, space = final_name(effect)
        for name in options(call.args[1]):
            if isinstance(name, Const) and isinstance(own, Const) and isinstance(space, Const):
                try:
                    resolved = names.resolve(text_of(name), kind, remap_rules(effect), text_of(own), text_of(space))
                except names.InvalidName:
                    continue
                found += [Const(r, name.origins | own.origins | space.origins) for r in resolved]
            else:
                found.append(machine.unknown(Cause.OPERATION, "resolve name", "str"))
    return join_all(found) if found else machine.unknown(Cause.OPERATION, "resolve name", "str")


# Plain functions


def _schedule(call: NativeCall) -> Value:
    event = text_of(call.keywords.get("event"), "callback")
    if call.args[0] != NONE:
        call.machine.schedule(call.args[0], call.args[1:], event)
    return NONE


def _spin(call: NativeCall) -> Value:
    call.machine.spin()
    return NONE


def _message(call: NativeCall) -> Value:
    return message_of(host(call), call.args[0])


def _unknown(call: NativeCall) -> Value:
    label = text_of(call.args[0]).upper().replace(" ", "_")
    cause = Cause[label] if label in Cause.__members__ else Cause.CALL
    subject = call.arg(1, "subject")
    return call.machine.unknown(
        cause, text_of(subject, "" if subject is None else word_text(subject)), text_of(call.arg(2, "hint"))
    )


def mark(machine: Interpreter, value: Value, origin: Origin) -> Value:
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
    kind, name, value = call.args
    return mark(host(call), value, Origin(text_of(kind), text_of(name, word_text(name))))


def _either(call: NativeCall) -> Value:
    return join_all(call.args)


def _opaque(call: NativeCall) -> Value:
    return join_all(call.machine.allocate(Obj("instance", c)) for c in options(call.args[0]))


def _escape(call: NativeCall) -> Value:
    call.machine.escape(call.args, "a library")
    return NONE


def _report(call: NativeCall) -> Value:
    call.machine.report(text_of(call.args[0]), word_text(call.args[1]))
    return NONE


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
    "_rosward.create": _create,
    "_rosward.create_node": _create_node,
    "_rosward.init": _init,
    "_rosward.node_name": _node_name,
    "_rosward.node_namespace": _node_namespace,
    "_rosward.node_fqn": _node_fqn,
    "_rosward.resolve_name": _resolve_name,
    "_rosward.schedule": _schedule,
    "_rosward.spin": _spin,
    "_rosward.message": _message,
    "_rosward.unknown": _unknown,
    "_rosward.default": _default,
    "_rosward.either": _either,
    "_rosward.opaque": _opaque,
    "_rosward.escape": _escape,
    "_rosward.report": _report,
    "rosidl_runtime_py.utilities.get_message": _get_message,
    "rosidl_runtime_py.utilities.get_service": _get_message,
    "rosidl_runtime_py.utilities.get_action": _get_message,
}

__all__ = ["NATIVES", "create", "final_name", "host", "mark", "message_of", "perform", "remap_rules", "text_of"]
