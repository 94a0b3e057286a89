# SPDX-License-Identifier: Apache-2.0
"""The builtin types called: `str(5)`, `int('3')`, `list(names)`, `dict(a=1)`, `property(f)`, `slice(1)`, `type(x)`."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from rosward.domain.choice import options
from rosward.domain.compound import BoundMethod, Descriptor, External, Native, Partial, Slice, Tuple
from rosward.domain.heap import CLASSES, Obj
from rosward.domain.series import Series
from rosward.domain.values import (
    EMPTY,
    FALSE,
    NONE,
    Choice,
    Class,
    Const,
    Function,
    ModuleValue,
    Ref,
    Text,
    Unknown,
    Value,
)
from rosward.models.interfaces import is_known_interface
from rosward.models.native import Items, Machine, NativeCall, NativeFunction
from rosward.models.python.builtins.attributes import has_attribute
from rosward.models.python.comparing.compare import kind_of
from rosward.models.python.comparing.equal_objects import member_value
from rosward.models.python.containers import dicts
from rosward.models.python.containers.any_order import keep_unordered
from rosward.models.python.containers.list_alternatives import elements_apart, keep_told
from rosward.models.python.containers.lists import ITERATOR, VIEW, new_tuple
from rosward.models.python.containers.sets import new_set
from rosward.models.python.plain import (
    NOT_PLAIN,
    Raised,
    affordable,
    evaluate,
    from_python,
    listed,
    native,
    origins,
    plain,
    run,
    spread,
    truth_const,
    unknown_from,
)
from rosward.models.python.strings.formatting import to_str

_NUMBERS: Final[dict[str, Callable[..., object]]] = {"int": int, "float": float, "complex": complex}


def _str(call: NativeCall) -> Value:
    if not call.args:
        return EMPTY
    if len(call.args) > 1 or call.keywords:
        return call.machine.call_native("bytes.decode", call.args, call.keywords)
    return to_str(call.machine, call.args[0])


def _number(call: NativeCall) -> Value:
    """int, float and complex."""
    name = call.name.rpartition(".")[2]
    if call.keywords:
        return unknown_from(call.machine, name, name, *call.args, *call.keywords.values())

    def one(*values: Value) -> Value:
        if isinstance(values[0], Ref):
            values = (member_value(call.machine, values[0], f"__{name}__") or values[0], *values[1:])
        known = evaluate(call.machine, name, _NUMBERS[name], values, name)
        if known is not None:
            return known
        if isinstance(values[0], Tuple) or (
            isinstance(values[0], Ref) and kind_of(call.machine, values[0]) in ("list", "dict", "set")
        ):
            raise Raised("TypeError", f"{name}() argument must be a string or a real number")
        return unknown_from(call.machine, name, name, *values)

    return spread(one, *call.args) if call.args else from_python(call.machine, _NUMBERS[name]())


def _bool(call: NativeCall) -> Value:
    return spread(lambda v: truth_const(call.machine, v), call.args[0]) if call.args else FALSE


def _byte_array(call: NativeCall) -> Value:
    """bytearray(…): what it holds can be changed at any time, so it is not known."""
    return unknown_from(call.machine, call.name, "bytearray", *call.args)


def _bytes(call: NativeCall) -> Value:
    operands = [plain(v) for v in call.args]
    if NOT_PLAIN in operands or call.keywords or not affordable(call.machine, "bytes", operands):
        return unknown_from(call.machine, call.name, "bytes", *call.args)
    return from_python(call.machine, run(bytes, *operands), origins(*call.args), "bytes")


def _items(call: NativeCall) -> Items:
    return call.machine.iterate(call.args[0]) if call.args else Items(())


def _series(call: NativeCall) -> Series:
    return call.machine.series(call.args[0]) if call.args else Series()


def _list(call: NativeCall) -> Value:
    made = listed(call.machine, call.name, *_series(call))
    keep_told(call.machine, made, (elements_apart(call.machine, a) for a in call.args[:1]))
    for source in call.args[:1]:
        keep_unordered(call.machine, made, source)
    return made


def _tuple(call: NativeCall) -> Value:
    return new_tuple(call.machine, _series(call))


def _set(call: NativeCall) -> Value:
    return new_set(call.machine, _items(call), frozen=call.name.endswith("frozenset"))


def _dict(call: NativeCall) -> Value:
    made = call.machine.allocate(Obj("dict", Native("builtins.dict")), call.name)
    for source in call.args[:1]:
        for option in options(source):
            dicts.merge(call.machine, made, option, weak=isinstance(source, Choice))
    for name, value in call.keywords.items():
        dicts.store(call.machine, made, Const(name), value, weak=name in call.unsure)
    if call.loose is not None:  # `dict(**unknown)`
        key = unknown_from(call.machine, "dict", "str", call.loose)
        dicts.store(call.machine, made, key, call.loose, weak=True)
    return made


def _object(call: NativeCall) -> Value:
    return call.machine.allocate(Obj("instance", Native("builtins.object")))


def _slice(call: NativeCall) -> Value:
    args = call.args
    return Slice(NONE, args[0], NONE) if len(args) == 1 else Slice(args[0], args[1], args[2] if len(args) > 2 else NONE)


def _property(call: NativeCall) -> Value:
    getter, setter = call.arg(0, "fget", NONE) or NONE, call.arg(1, "fset")
    deleter = call.arg(2, "fdel")
    return Descriptor("property", getter, None if setter == NONE else setter, None if deleter == NONE else deleter)


def _wrapped(call: NativeCall) -> Value:
    """staticmethod and classmethod."""
    return Descriptor(call.name.rpartition(".")[2], call.args[0], None, None)


def _type(call: NativeCall) -> Value:
    """type(x); `type(name, bases, names)` is followed by the engine where its arguments are plain."""
    if len(call.args) != 1 and call.args:
        call.machine.report("RW203", "a class is made by type()")
        return unknown_from(call.machine, "type", "", *call.args)
    return spread(lambda v: type_of(call.machine, v), call.args[0])


def type_of(machine: Machine, value: Value) -> Value:
    """The class of a value."""
    if isinstance(value, Ref):
        obj = machine.obj(value)
        if obj.payload in (ITERATOR, VIEW):
            return unknown_from(machine, "type", "", value)
        return Native("builtins.generator") if obj.kind == "generator" else obj.attrs.get(CLASSES, obj.cls)
    if isinstance(value, BoundMethod) and isinstance(value.function, Function):
        return Native("builtins.method")
    if isinstance(value, Class):
        found = machine.obj(Ref(value.address)).cls
        return found if isinstance(found, Class) else Native("builtins.type")
    if isinstance(value, (Native, External, BoundMethod, Partial)):
        return unknown_from(machine, "type", "", value)
    if isinstance(value, (Function, ModuleValue)):
        return Native("builtins.module" if isinstance(value, ModuleValue) else "builtins.function")
    kind = kind_of(machine, value)
    return Native(f"builtins.{kind}") if kind else unknown_from(machine, "type", "", value)


_METHODS: Final[dict[str, tuple[Callable[..., object], str]]] = {
    "int.bit_length": (int.bit_length, "int"),
    "int.bit_count": (int.bit_count, "int"),
    "int.conjugate": (int.conjugate, "int"),
    "float.is_integer": (float.is_integer, "bool"),
    "float.hex": (float.hex, "str"),
    "float.as_integer_ratio": (float.as_integer_ratio, "tuple"),
    "bytes.fromhex": (bytes.fromhex, "bytes"),
}


def _numeric(call: NativeCall) -> Value:
    """Methods of numbers."""
    function, hint = _METHODS[call.name]

    def one(*values: Value) -> Value:
        known = evaluate(call.machine, call.name, function, values)
        return unknown_from(call.machine, call.name, hint, *values) if known is None else known

    return spread(one, *call.args)


def is_callable(machine: Machine, value: Value) -> bool | None:
    """callable(value)."""
    if isinstance(value, (Function, Class, Native, BoundMethod, Partial)) or is_known_interface(machine, value):
        return True
    if isinstance(value, (Const, Text, Tuple, ModuleValue)):
        return False
    if isinstance(value, Ref) and machine.obj(value).kind != "instance":
        return False
    if isinstance(value, Ref):
        return has_attribute(machine, value, "__call__")
    return False if isinstance(value, Unknown) and value.hint else None


NATIVES: Final[dict[str, NativeFunction]] = {
    "builtins.str": native(_str, 0, "object encoding errors"),
    "builtins.int": native(_number, 0, "_ base"),
    "builtins.float": native(_number),
    "builtins.complex": native(_number, 0, "real imag"),
    "builtins.bool": native(_bool),
    "builtins.bytes": native(_bytes, 0, "source encoding errors"),
    "builtins.bytearray": native(_byte_array, 0, "source encoding errors"),
    "builtins.list": native(_list),
    "builtins.tuple": native(_tuple),
    "builtins.set": native(_set),
    "builtins.frozenset": native(_set),
    "builtins.dict": native(_dict),
    "builtins.object": native(_object),
    "builtins.slice": native(_slice, 1),
    "builtins.property": native(_property, 0, "fget fset fdel doc"),
    "builtins.staticmethod": native(_wrapped, 1),
    "builtins.classmethod": native(_wrapped, 1),
    "builtins.type": native(_type),
    **{name: native(_numeric, 1) for name in _METHODS},
}
