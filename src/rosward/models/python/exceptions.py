# SPDX-License-Identifier: Apache-2.0
"""Exceptions as objects: what Python's own classes of exceptions keep, and what their methods say.

error = ValueError('bad', 3)      error.args ('bad', 3), str(error) "('bad', 3)", repr(error) "ValueError('bad', 3)"
KeyError('k')                     str "'k'", with the quotes
OSError(2, 'gone', 'a.txt')       a FileNotFoundError: errno 2, strerror 'gone', str "[Errno 2] gone: 'a.txt'"

All of it is computed from `args`, as in Python. What raises and catches them is `engine/python/exceptions.py`.
"""

from __future__ import annotations

import builtins
from typing import TYPE_CHECKING, Final

from rosward.domain.choice import join_all, options
from rosward.domain.compound import External, Native, Tuple
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, UNBOUND, Class, Const, Ref, Value
from rosward.models.native import NativeCall, NativeFunction

if TYPE_CHECKING:
    from rosward.domain.heap import Obj
    from rosward.models.native import Machine

FALSE: Final = Const(False)
GROUP: Final[type[BaseException] | tuple[()]] = getattr(builtins, "BaseExceptionGroup", ())  # Python 3.10 has none
EMPTY: Final = Const("")
MEMBERS: Final = frozenset(
    [
        "args",
        "__cause__",
        "__context__",
        "__suppress_context__",
        "__traceback__",
        "value",
        "code",
        "errno",
        "strerror",
        "filename",
        "filename2",
        "name",
        "path",
        "msg",
        "obj",
        "message",
        "exceptions",
    ]
)
"""Attributes that Python's own exceptions have without an assignment."""
_NOTHING: Final = {"__cause__": NONE, "__context__": NONE, "__suppress_context__": FALSE}
_OWNERS: Final[dict[str, tuple[type[BaseException], int]]] = {
    "value": (StopIteration, 0),
    "code": (SystemExit, 0),
    "errno": (OSError, 0),
    "strerror": (OSError, 1),
    "filename": (OSError, 2),
    "filename2": (OSError, 4),
}
_KEYWORDS: Final[dict[str, tuple[type[BaseException], ...]]] = {
    "name": (ImportError, AttributeError, NameError),
    "path": (ImportError,),
    "obj": (AttributeError,),
}


def is_exception(name: str) -> bool:
    """Whether a name of `builtins` is an exception class."""
    found = getattr(builtins, name.removeprefix("builtins."), None)
    return isinstance(found, type) and issubclass(found, BaseException)


def builtin_base(cls: Value) -> type[BaseException] | None:
    """The class of Python's own from which a class of exceptions derives (itself, where it is one)."""
    for base in cls.mro if isinstance(cls, Class) else (cls,):
        if isinstance(base, Native) and is_exception(base.name):
            found: type[BaseException] = getattr(builtins, base.name.removeprefix("builtins."))
            return found
    return None


def own_class(cls: Native, args: tuple[Value, ...]) -> Native:
    """The class of which a builtin exception really is: `OSError(2, …)` is a FileNotFoundError, IOError another name of OSError."""
    found = builtin_base(cls)
    if found is None:
        return cls
    if found is OSError and len(args) >= 2 and isinstance(args[0], Const) and isinstance(args[0].value, int):
        found = type(OSError(args[0].value, ""))
    return Native(f"builtins.{found.__name__}")


def is_exception_object(machine: Machine, value: Value) -> bool:
    """Whether a value is surely an exception."""
    if not isinstance(value, Ref):
        return False
    obj = machine.obj(value)
    return obj.kind == "instance" and builtin_base(obj.cls) is not None


def arguments(machine: Machine, obj: Obj) -> tuple[Value, ...] | None:
    """The `args` of an exception; None where they are not known."""
    found = obj.attrs.get("args")
    if found is None:
        return () if builtin_base(obj.cls) is not None else None
    if isinstance(found, Tuple):
        return found.items
    del machine
    return None


def member_of(machine: Machine, obj: Obj, name: str) -> Value | None:
    """What an exception has in an attribute that nobody assigned; None where it is no exception, or has no such attribute."""
    base = builtin_base(obj.cls)
    if base is None:
        return None
    if name in _NOTHING:
        return _NOTHING[name]
    if name == "__traceback__":
        return machine.unknown(Cause.LIVE, "traceback")
    args = arguments(machine, obj)
    if name == "args":
        return Tuple(args) if args is not None else machine.unknown(Cause.LIVE, "exception.args", "tuple")
    if any(issubclass(base, cls) for cls in _KEYWORDS.get(name, ())):
        return NONE
    if name == "msg" and issubclass(base, (ImportError, SyntaxError)):
        return _at(machine, args, 0, name)
    if name in ("message", "exceptions") and issubclass(base, GROUP):
        return _group_part(machine, args, name)
    owner, index = _OWNERS.get(name, (None, 0))
    if owner is None or not issubclass(base, owner):
        return None
    if owner is OSError and args is not None and len(args) < 2:
        return NONE
    if owner is SystemExit and args is not None and len(args) > 1:
        return Tuple(args)
    return _at(machine, args, index, name)


def _at(machine: Machine, args: tuple[Value, ...] | None, index: int, name: str) -> Value:
    if args is None:
        return machine.unknown(Cause.LIVE, f"exception.{name}")
    return args[index] if index < len(args) else NONE


def _group_part(machine: Machine, args: tuple[Value, ...] | None, name: str) -> Value:
    """`message` or `exceptions` of an exception group."""
    if args is None or len(args) != 2:
        return machine.unknown(Cause.LIVE, f"exception.{name}")
    if name == "message":
        return args[0]
    known, rest = machine.iterate(args[1])
    return Tuple(known) if rest is None else machine.unknown(Cause.LIVE, "exception.exceptions", "tuple")


def message(machine: Machine, ref: Ref) -> Value:
    """str(exception), where no class of the program says it otherwise."""
    obj = machine.obj(ref)
    base = builtin_base(obj.cls)
    args = arguments(machine, obj)
    if args is None or base is None:
        return machine.unknown(Cause.LIVE, "text of an exception", "str")
    if issubclass(base, GROUP):
        return _group_text(machine, args)
    if issubclass(base, OSError) and len(args) >= 2:
        return _system_text(machine, args)
    if issubclass(base, (UnicodeError, SyntaxError)) and len(args) > 1:
        return machine.unknown(Cause.LIVE, "text of an exception", "str")
    if not args:
        return EMPTY
    if len(args) > 1:
        return machine.call_native("builtins.repr", (Tuple(args),))
    return machine.call_native("builtins.repr" if issubclass(base, KeyError) else "builtins.str", (args[0],))


def _system_text(machine: Machine, args: tuple[Value, ...]) -> Value:
    """`[Errno 2] No such file or directory: 'a.txt'`."""
    text = _joined(machine, Const("[Errno "), _text(machine, args[0]), Const("] "), _text(machine, args[1]))
    if len(args) < 3:
        return text
    shown = machine.call_native("builtins.repr", (args[2],))
    return _joined(machine, text, Const(": "), shown)


def _group_text(machine: Machine, args: tuple[Value, ...]) -> Value:
    """`message (2 sub-exceptions)`."""
    inner = _group_part(machine, args, "exceptions")
    if not isinstance(inner, Tuple):
        return machine.unknown(Cause.LIVE, "text of an exception", "str")
    count = len(inner.items)
    return _joined(machine, args[0], Const(f" ({count} sub-exception{'' if count == 1 else 's'})"))


def _text(machine: Machine, value: Value) -> Value:
    return machine.call_native("builtins.str", (value,))


def _joined(machine: Machine, *parts: Value) -> Value:
    text: Value = EMPTY
    for part in parts:
        text = machine.binary("+", text, part)
    return text


def described(machine: Machine, ref: Ref) -> Value:
    """repr(exception)."""
    obj = machine.obj(ref)
    args = arguments(machine, obj)
    name = obj.cls.name.rpartition(".")[2] if isinstance(obj.cls, (Class, Native, External)) else ""
    if args is None or not name:
        return machine.unknown(Cause.LIVE, "text of an exception", "str")
    shown: list[Value] = []
    for arg in args:
        shown += [Const(", "), machine.call_native("builtins.repr", (arg,))]
    return _joined(machine, Const(f"{name}("), *shown[1:], Const(")"))


# Methods


def _each(call: NativeCall) -> list[Ref]:
    return [o for o in options(call.args[0]) if isinstance(o, Ref)] if call.args else []


def _init(call: NativeCall) -> Value:
    """BaseException.__init__: what it is given becomes `args`."""
    for ref in _each(call):
        call.machine.update(ref, call.machine.obj(ref).with_attr("args", Tuple(call.args[1:])))
        for name, value in call.keywords.items():
            call.machine.update(ref, call.machine.obj(ref).with_attr(name, value))
    return NONE


def _str(call: NativeCall) -> Value:
    found = [message(call.machine, ref) for ref in _each(call)]
    return join_all(found) if found else call.machine.unknown(Cause.LIVE, "text of an exception", "str")


def _repr(call: NativeCall) -> Value:
    found = [described(call.machine, ref) for ref in _each(call)]
    return join_all(found) if found else call.machine.unknown(Cause.LIVE, "text of an exception", "str")


def _with_traceback(call: NativeCall) -> Value:
    return call.args[0] if call.args else UNBOUND


def _add_note(call: NativeCall) -> Value:
    machine = call.machine
    for ref in _each(call):
        notes = machine.obj(ref).attrs.get("__notes__")
        if notes is None:
            notes = machine.new_list(())
            machine.update(ref, machine.obj(ref).with_attr("__notes__", notes))
        machine.call_native("list.append", (notes, *call.args[1:2]))
    return NONE


NATIVES: Final[dict[str, NativeFunction]] = {
    "BaseException.__init__": _init,
    "BaseException.__str__": _str,
    "BaseException.__repr__": _repr,
    "BaseException.with_traceback": _with_traceback,
    "BaseException.add_note": _add_note,
}
