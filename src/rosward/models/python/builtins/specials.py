# SPDX-License-Identifier: Apache-2.0
"""The special methods of builtin classes called by name: `super().__getitem__(key)`, `list.__eq__(a, b)`, an operator on a subclass."""

from __future__ import annotations

from typing import Final

from rosward.domain.values import NONE, Const, Ref, Text, Value
from rosward.models.native import NativeCall, NativeFunction
from rosward.models.python.contents import bare
from rosward.models.python.plain import native, unknown_from

_COMPARE: Final = {"__eq__": "==", "__ne__": "!=", "__lt__": "<", "__le__": "<=", "__gt__": ">", "__ge__": ">="}
_BINARY: Final = {"__add__": "+", "__mul__": "*", "__or__": "|", "__and__": "&", "__sub__": "-", "__xor__": "^"}
_IN_PLACE: Final = {
    ("list", "__iadd__"): "list.extend",
    ("dict", "__ior__"): "dict.update",
    ("set", "__ior__"): "set.update",
    ("set", "__iand__"): "set.intersection_update",
    ("set", "__isub__"): "set.difference_update",
    ("set", "__ixor__"): "set.symmetric_difference_update",
}
_HINTS: Final = {"__len__": "int", "__contains__": "bool", "__setitem__": "NoneType", "__delitem__": "NoneType"}
_LEAST: Final = {"__len__": 1, "__iter__": 1, "__reversed__": 1, "__setitem__": 3}
_ALL: Final = ("__len__", "__contains__", "__iter__", "__eq__", "__ne__")
_ORDER: Final = ("__lt__", "__le__", "__gt__", "__ge__")
_METHODS: Final = {
    "list": (
        *_ALL,
        *_ORDER,
        "__getitem__",
        "__setitem__",
        "__delitem__",
        "__reversed__",
        "__add__",
        "__mul__",
        "__iadd__",
    ),
    "tuple": (*_ALL, *_ORDER, "__getitem__", "__add__", "__mul__"),
    "dict": (*_ALL, "__getitem__", "__setitem__", "__delitem__", "__reversed__", "__or__", "__ior__"),
    "set": (*_ALL, *_ORDER, "__or__", "__and__", "__sub__", "__xor__", "__ior__", "__iand__", "__isub__", "__ixor__"),
    "str": ("__len__", "__contains__", "__getitem__"),
    "range": ("__len__", "__contains__", "__getitem__"),
}

_REFLECTED: Final = {"__radd__": "+", "__rsub__": "-", "__rmul__": "*"}
_ARITHMETIC: Final = {
    **{name: sign for name, sign in _BINARY.items() if name in ("__add__", "__sub__", "__mul__")},
    **_REFLECTED,
    "__floordiv__": "//",
    "__mod__": "%",
    "__truediv__": "/",
    "__pow__": "**",
}
_PLAIN: Final[dict[str, tuple[tuple[str, ...], dict[str, type], type | tuple[type, ...]]]] = {
    "str": (("__add__", "__mul__", "__rmul__", "__mod__"), {"__mod__": object, "__add__": str}, int),
    "int": (tuple(_ARITHMETIC), {}, int),
    "float": (tuple(_ARITHMETIC), {}, (int, float)),
}
"""Of what is no container: its methods, and which operands each takes; of others they give NotImplemented."""


def _special(call: NativeCall) -> Value:
    """What an object of a class derived from a builtin one holds, where it is not known what it is."""
    machine, (kind, _, name), receiver = call.machine, call.name.rpartition("."), call.args[0]
    if isinstance(receiver, Ref) and machine.obj(receiver).kind == "instance":
        return unknown_from(machine, call.name, _HINTS.get(name, ""), receiver)
    if name in _COMPARE:
        return machine.compare(_COMPARE[name], receiver, call.args[1])
    if name in _BINARY:
        return machine.binary(_BINARY[name], receiver, call.args[1])
    if (kind, name) in _IN_PLACE:
        machine.call_native(_IN_PLACE[kind, name], call.args[:2])
        return receiver
    match name:
        case "__len__" | "__iter__" | "__reversed__":
            return machine.call_native(f"builtins.{name.strip('_')}", (receiver,))
        case "__contains__":
            return machine.compare("in", call.args[1], receiver)
        case "__getitem__":
            return machine.load_item(receiver, call.args[1])
        case "__delitem__":
            machine.call_native(f"{kind}.pop", (receiver, call.args[1]))
        case _:
            machine.store_item(receiver, call.args[1], call.args[2])
    return NONE


def _plain(call: NativeCall) -> Value:
    """An operator of a text or number, called by name: `str.__add__(self, other)`."""
    machine, (kind, _, name) = call.machine, call.name.rpartition(".")
    receiver, other = (bare(machine, arg) for arg in call.args[:2])
    _, special, usual = _PLAIN[kind]
    taken = special.get(name, usual)
    fits = taken is object or isinstance(other, Text if taken is str else ())
    if not fits and not (isinstance(other, Const) and isinstance(other.value, taken)):
        return unknown_from(machine, call.name, "", *call.args)
    left, right = (other, receiver) if name in _REFLECTED else (receiver, other)
    return machine.binary(_ARITHMETIC[name], left, right)


def _fill(call: NativeCall) -> Value:
    """`__init__`: a list or set has these elements from now on; a dict gets entries."""
    kind = call.name.partition(".")[0]
    if kind != "dict":
        call.machine.call_native(f"{kind}.clear", call.args[:1])
    if len(call.args) > 1 or call.keywords:
        update = {"list": "list.extend", "set": "set.update", "dict": "dict.update"}[kind]
        call.machine.call_native(update, call.args[:2], call.keywords)
    return NONE


def _contents(call: NativeCall) -> Value:
    """`_rosward.contents(object)`: what an object of a subclass of a builtin type holds."""
    return bare(call.machine, call.args[0])


NATIVES: Final[dict[str, NativeFunction]] = {
    "_rosward.contents": native(_contents, 1),
    **{f"{k}.__init__": native(_fill, 1) for k in ("list", "dict", "set")},
    **{f"{k}.{n}": native(_special, _LEAST.get(n, 2)) for k, names in _METHODS.items() for n in names},
    **{f"{k}.{n}": native(_plain, 2) for k, (names, _, _) in _PLAIN.items() for n in names},
}
