# SPDX-License-Identifier: Apache-2.0
"""How is a model in code called? With what the call surely gives; what else may be given is told apart.

len()                     TypeError of the program: the model is not entered, or ends where it reads what is not there
max(*unknown)             the model sees the unknown number of arguments as `loose`
sorted(x, **options)      keywords that may be missing are `unsure`
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.domain.choice import join, options
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, UNBOUND, Choice, Ref, Value
from rosward.engine.arguments import ANY, LOOSE, MAYBE, ORDER
from rosward.engine.calls.alternatives import each_apart
from rosward.engine.python import contents
from rosward.engine.python.specials import one_has
from rosward.models.native import Arguments, NativeCall, NativeFunction, perform
from rosward.models.python.containers.lists import exhaust
from rosward.models.python.contents import KINDS, text_data
from rosward.models.python.contents import contents as held_by

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

_NOTHING: Final[frozenset[str]] = frozenset()
_HELD: Final = frozenset(KINDS.values())
_TAKE_LOOSE: Final = frozenset({"builtins.dict", "builtins.print", "builtins.zip"})
"""Natives that look at `loose` themselves. Others see it as one more argument, and may give something else than what they give for that."""

_OF_TEXTS: Final = frozenset({"str", "bytes", "re"})
_ASK_OBJECTS: Final = frozenset({"format", "format_map", "__mod__"})
"""Methods of texts that ask an object how it is written."""

_RUN_THROUGH: Final = frozenset(
    {
        *(f"builtins.{name}" for name in ("list", "tuple", "set", "frozenset", "dict", "sorted", "sum", "min", "max")),
        *("str.join", "bytes.join", "list.extend", "set.update", "dict.update"),
    }
)
"""What takes all that an iterator has: nothing is left of it."""


def invoke(
    machine: Engine, native: NativeFunction, name: str, args: tuple[Value, ...], keywords: dict[str, Value]
) -> Value:
    """What the native gives for the arguments."""
    loose, unsure, anything = keywords.get(LOOSE), _NOTHING, ANY in keywords
    is_open = loose is not None or anything
    if is_open or (keywords and any(k[:1] == MAYBE for k in keywords)):
        unsure = frozenset(k[1:] for k in keywords if k[:1] == MAYBE)
        keywords = flattened((), keywords)[1]
    frame = machine.frames[-1] if machine.frames else None
    op = frame.op if frame is not None else None
    given = args if loose is None or name in _TAKE_LOOSE else (*args, loose)
    if anything and loose is None:
        loose = machine.unknown(Cause.CALLER, name)
    value = _on_contents(machine, native, NativeCall(machine, name, Arguments(given), keywords, loose, unsure))
    if name in _RUN_THROUGH:
        for arg in args:
            exhaust(machine, arg)
    if frame is not None and op is not None:
        frame.op = op
    if is_open and value is not UNBOUND and name not in _TAKE_LOOSE and not name.startswith("_rosward."):
        return join(value, machine.unknown(Cause.CALL, name.removeprefix("builtins.")))
    return value


_ASKED: Final = {
    **{
        f"builtins.{n}": f"__{n}__"
        for n in (
            "len",
            "abs",
            "int",
            "float",
            "round",
            "hash",
            "str",
            "repr",
            "bool",
            "format",
            "reversed",
            "complex",
            "bytes",
            "divmod",
            "pow",
            "dir",
            "iter",
        )
    },
    **dict.fromkeys(("builtins.bin", "builtins.hex", "builtins.oct", "builtins.chr", "operator.index"), "__index__"),
    **{f"math.{n}": f"__{n}__" for n in ("trunc", "floor", "ceil")},
    "operator.neg": "__neg__",
}
"""Builtins that ask an object by a method of its own."""
_OF_TWO: Final = {"builtins.pow": "__rpow__", "builtins.divmod": "__rdivmod__"}
"""Those that ask the second one by another method, where the first has none."""


def _of_each(machine: Engine, native: NativeFunction, call: NativeCall) -> Value:
    """What a builtin does that asks an object: of several, it asks one."""
    method, asked = _ASKED.get(call.name), call.args[0] if call.args else NONE
    if method is None or not one_has(machine, asked, method):
        if call.name in _OF_TWO and len(call.args) == 2 and one_has(machine, call.args[1], _OF_TWO[call.name]):
            return each_apart(machine, options(call.args[1]), lambda o: perform(native, _with(call, (asked, o))))
        return perform(native, call)
    return each_apart(machine, options(asked), lambda o: perform(native, _to(call, o)))


def _on_contents(machine: Engine, native: NativeFunction, call: NativeCall) -> Value:
    """A method of a builtin type, on an object of a subclass, acts on what the object holds. Methods of texts take their arguments so, too."""
    kind, _, method = call.name.rpartition(".")
    if kind in _OF_TEXTS and method not in _ASK_OBJECTS and any(a.__class__ in (Ref, Choice) for a in call.args):
        call = _with(call, tuple(text_data(machine, arg) for arg in call.args))
    if kind not in _HELD or not call.args:
        return _of_each(machine, native, call)

    def one(receiver: Value) -> Value:
        held = held_by(machine, receiver)
        if held is None:
            return perform(native, call if receiver is call.args[0] else _to(call, receiver))
        if call.name == "dict.__getitem__" and len(call.args) == 2:
            value = contents.missing(machine, receiver, held, call.args[1])
            if value is not None:
                return value
        value = perform(native, _to(call, held))
        return receiver if method in contents.IN_PLACE else value

    receiver = call.args[0]
    if receiver.__class__ is Choice and any(held_by(machine, o) is not None for o in receiver.options):
        return each_apart(machine, options(receiver), one)
    return one(receiver)


def _to(call: NativeCall, receiver: Value) -> NativeCall:
    """The call of the same method, of another object."""
    return _with(call, (receiver, *call.args[1:]))


def _with(call: NativeCall, args: tuple[Value, ...]) -> NativeCall:
    return NativeCall(call.machine, call.name, Arguments(args), call.keywords, call.loose, call.unsure)


def flattened(args: tuple[Value, ...], keywords: dict[str, Value]) -> tuple[tuple[Value, ...], dict[str, Value]]:
    """All arguments in plain form, for what does not care how many there are."""
    loose = keywords.get(LOOSE)
    args = args if loose is None else (*args, loose)
    return args, {k.removeprefix(MAYBE): v for k, v in keywords.items() if k not in (LOOSE, ORDER, ANY)}
