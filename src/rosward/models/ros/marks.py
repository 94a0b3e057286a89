# SPDX-License-Identifier: Apache-2.0
"""The marks of library models: decorators of `_rosward` that say what a function does, and what follows from each when it is called.

@creates("publisher", name="topic", type="msg_type")     a call creates an entity of that name and type
@calls("callback", event="message", args=(…))            what is given as `callback` may be called from now on
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.domain.certain import text_of
from rosward.domain.choice import lift
from rosward.domain.compound import External, Native, Partial, Tuple
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, Const, Function, Value
from rosward.models.native import NativeCall, NativeFunction
from rosward.models.ros.entities import create
from rosward.models.ros.messages import message_of, send

if TYPE_CHECKING:
    from rosward.models.native import Machine


def _creates(call: NativeCall) -> Value:
    pairs = tuple(Tuple((Const(k), v)) for k, v in call.keywords.items())
    return Partial(Native("_rosward.mark"), (Tuple((Const("creates"), call.args[0], Tuple(pairs))),), ())


def _calls(call: NativeCall) -> Value:
    wanted = call.arg(2, "args", Tuple(()))
    known = call.machine.iterate(wanted).known if wanted is not None else ()
    event, answers = call.arg(1, "event", Const("callback")), call.arg(3, "answers", NONE)
    spec = Tuple((Const("calls"), call.args[0], event or NONE, Tuple(known), answers or NONE))
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


def _with_words(call: NativeCall) -> Value:
    """A mark with words, which `models.marked_stubs` or `models.facts` reads: it changes nothing of what it stands on."""
    given = call.args[0] if call.args else NONE
    return given if isinstance(given, Function) else Partial(Native("_rosward.reads_only"), (), ())


def _raises_nothing(call: NativeCall) -> Value:
    """A mark of a function; of a module `models.facts` reads it."""
    return _marker("raises_nothing")(call) if isinstance(call.args[0], Function) else NONE


def perform(machine: Machine, spec: Tuple, named: dict[str, Value]) -> None:
    """An effect that a decorator declares; `named` are the arguments of the call by parameter."""
    kind = text_of(spec.items[0])
    if kind == "spins":
        machine.spin(serving=True)
    elif kind in ("waits", "suspends"):
        machine.waits(suspended=kind == "suspends")
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
            machine.schedule(callback, args, text_of(spec.items[2]), answered=_answered(spec.items[4], named))
    elif kind == "sends":
        owner = named["self"]
        node, name, type_ = (_attribute(machine, owner, text_of(path)) for path in spec.items[3:])
        send(machine, text_of(spec.items[1]), node, name, type_, named.get(text_of(spec.items[2]), NONE))


def _attribute(machine: Machine, value: Value, path: str) -> Value:
    """What stands at the end of `_action_server._action_type.Result`."""
    for name in path.split("."):
        value = machine.load_attr(value, name)
    return value


def _answered(spec: Value, named: dict[str, Value]) -> Value | None:
    """What is done with what a callback returns: `answers=("response", NAME, TYPE)` says that it is sent."""
    if not isinstance(spec, Tuple):
        return None
    kind, name, type_ = spec.items
    sent = (kind, *(named.get(n, NONE) for n in ("self", text_of(name))), _response(named.get(text_of(type_), NONE)))
    return Partial(Native("_rosward.send"), sent, ())


def _response(type_: Value) -> Value:
    return lift(lambda option: External(f"{option.name}.Response") if isinstance(option, External) else NONE, type_)


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


def _sends(call: NativeCall) -> Value:
    """`@sends(kind, parameter, node, name, type)`: the last three as attributes of `self`, with dots."""
    return Partial(Native("_rosward.mark"), (Tuple((Const("sends"), *call.exactly(5))),), ())


NATIVES: Final[dict[str, NativeFunction]] = {
    "_rosward.creates": _creates,
    "_rosward.calls": _calls,
    "_rosward.sends": _sends,
    "_rosward.mark": _mark,
    "_rosward.spins": _marker("spins"),
    "_rosward.suspends": _marker("suspends"),
    "_rosward.waits": _marker("waits"),
    "_rosward.native": _marker("native"),
    "_rosward.pure": _marker("pure"),
    "_rosward.changes": _changes,
    "_rosward.raises_nothing": _raises_nothing,
    **dict.fromkeys(
        (
            *("_rosward.sink", "_rosward.source", "_rosward.stops", "_rosward.releases", "_rosward.hands"),
            "_rosward.plugin_class",
        ),
        _with_words,
    ),
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
}
