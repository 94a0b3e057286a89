# SPDX-License-Identifier: Apache-2.0
"""How are values and operations written down, for another run of the same rosward to read?

    Const("x")                         "x"
    Native("builtins.str")             [15, "builtins.str"]        the number of its class, and what it is made of
    a class, the code of a function    [8, 120], [9, 121, KEY]     the line that tells it: it is read once, where somebody needs it

A line is JSON. Reading makes objects of the classes of `_CLASSES` and nothing else; nothing that is read is executed. What a program leads to is
a small part of what is written, so each line waits until it is asked for, and the body of a function until it is called.
"""

from __future__ import annotations

import json
from collections.abc import Container, Mapping, Sequence
from sys import intern
from types import MappingProxyType
from typing import Any, Final, final

from rosward.domain.compound import (
    BoundMethod,
    Descriptor,
    External,
    Native,
    Partial,
    Range,
    Record,
    Slice,
    Super,
    Tuple,
)
from rosward.domain.heap import Alternatives, Obj, Shuffled
from rosward.domain.series import Series
from rosward.domain.unknown import Cause, Origin, Reason
from rosward.domain.values import (
    UNBOUND,
    Choice,
    Class,
    Const,
    Function,
    Hole,
    ModuleValue,
    Ref,
    Text,
    Unknown,
)
from rosward.effects.configuration import Given
from rosward.ir import ops
from rosward.ir.program import Code, CodeKind, Parameters
from rosward.location import Place
from rosward.models.native import Arguments
from rosward.records import NamedTuple

__all__ = ["Lines", "NotWrittenError", "Reader", "Writer"]

_TUPLE, _LIST, _DICT, _SET, _BYTES, _COMPLEX, _CAUSE, _KIND, _CLASS, _CODE, _ARGUMENTS, _UNBOUND, _CONST = range(13)
_FIRST: Final = 13
_CLASSES: Final[tuple[Any, ...]] = (
    *(External, Native, BoundMethod, Partial, Descriptor, Super, Slice, Range, Tuple, Alternatives, Shuffled, Series),
    *(Origin, Reason, Choice, Function, Hole, ModuleValue, Ref, Text, Unknown, Place, Parameters, Obj, Given),
    *(ops.Argument, ops.Assume, ops.Await, ops.Binary, ops.Break, ops.Build, ops.Call, ops.Compare, ops.Const),
    *(ops.Continue, ops.Delete, ops.ForEach, ops.Format, ops.Handler, ops.If, ops.Import, ops.ImportFrom),
    *(ops.ImportStar, ops.Intrinsic, ops.LoadAttr, ops.LoadCell, ops.LoadGlobal, ops.LoadItem, ops.LoadName),
    *(ops.MakeClass, ops.MakeFunction, ops.Move, ops.NewCell, ops.Raise, ops.Return, ops.StoreAttr, ops.StoreCell),
    *(ops.StoreGlobal, ops.StoreItem, ops.StoreName, ops.Try, ops.Unary, ops.Unpack, ops.While, ops.With, ops.Yield),
)
_NUMBERS: Final = {each: number for number, each in enumerate(_CLASSES, _FIRST)}

_PLAIN: Final = (str, int, float, bool, type(None))
_ENUMS: Final = {_CAUSE: Cause, _KIND: CodeKind}
_OF_CODE: Final = (
    *("kind", "name", "qualname", "file", "line", "parameters", "ops", "registers", "variables", "cells", "free"),
    *("is_generator", "is_coroutine", "is_stub", "annotations", "returns", "doc", "language"),
)
_OF_CLASS: Final = ("address", "name", "qualname", "module", "bases", "mro", "place", "stub")
_OF_OBJECT: Final = (
    *("attrs", "cls", "ends", "entries", "items", "kind", "many", "maybe", "partial", "payload", "rest", "rest_key"),
)
_OF_VALUES: Final[Mapping[type, tuple[str, ...]]] = MappingProxyType(
    {
        Tuple: ("items",),
        Choice: ("options",),
        Function: ("code", "module", "cells", "defaults", "kwdefaults", "effects"),
        ModuleValue: ("address", "name", "file"),
        Ref: ("address",),
        Text: ("parts", "origins"),
        Unknown: ("reasons", "hint", "variable"),
    }
)
"""The arguments of the classes that may be compiled: those do not say which they are."""

Lines = Sequence[bytes]


class NotWrittenError(Exception):
    """Something is of a class that is not written."""


class _Fields(NamedTuple):
    """The arguments by which an object of a class is made: those by position, and those by name alone."""

    position: tuple[str, ...]
    name: tuple[str, ...]


def _fields(of: Any) -> _Fields:
    if of in _OF_VALUES:
        return _Fields(_OF_VALUES[of], ())
    code = of.__init__.__code__
    last = code.co_argcount + code.co_kwonlyargcount
    return _Fields(code.co_varnames[1 : code.co_argcount], code.co_varnames[code.co_argcount : last])


@final
class Writer:
    """Writes values into `lines`; `only`: objects of no other classes, where that is said."""

    def __init__(self, only: Container[type] | None = None) -> None:
        self.lines: list[bytes] = []
        self._only = only
        self._known: dict[int, tuple[int, object]] = {}  # by id: classes and code, and the line of each

    def line(self, value: object) -> int:
        """The number of a new line with a value."""
        number = len(self.lines)
        self.lines.append(b"")
        self.lines[number] = json.dumps(self._written(value), separators=(",", ":")).encode("ascii")
        return number

    def _once(self, value: object, told: object) -> int:
        known = self._known.get(id(value))
        if known is None:
            known = self._known[id(value)] = (
                len(self.lines),
                value,
            )  # the object is kept, so that no other takes its id
            self.line(told)
        return known[0]

    def _written(self, value: Any) -> object:
        made = value.__class__
        if made in _PLAIN:
            return value
        if made is tuple or made is list:
            return [_TUPLE if made is tuple else _LIST, *map(self._written, value)]
        if made is Const:
            return [_CONST, self._written(value.value), *([self._written(value.origins)] if value.origins else [])]
        if self._only is not None and made not in self._only:
            return self._rare(value)
        if made is Code:
            return [_CODE, self._once(value, [getattr(value, name) for name in _OF_CODE]), value.key]
        if made is Class:
            told = [getattr(value, name) if name != "mro" else value.mro[1:] for name in _OF_CLASS]
            return [_CLASS, self._once(value, told)]
        if made is Obj:
            plain = Obj("instance", UNBOUND)
            told = [getattr(value, name) for name in _OF_OBJECT]
            kept = [(n, v) for n, v in enumerate(told) if v is None or v != getattr(plain, _OF_OBJECT[n])]
            return [_NUMBERS[Obj], *(part for n, v in kept for part in (n, self._written(v)))]
        if made in _NUMBERS:
            return [_NUMBERS[made], *map(self._written, self._parts(value))]
        return self._rare(value)

    def _parts(self, value: Any) -> list[object]:
        if isinstance(value, tuple):
            return list(value)
        if isinstance(value, Record):
            return list(value.fields())
        fields = _fields(value.__class__)
        return [getattr(value, name.removesuffix("_")) for name in (*fields.position, *fields.name)]

    def _rare(self, value: Any) -> object:
        if isinstance(value, Mapping):
            return [_DICT, *(self._written(part) for item in value.items() for part in item)]
        if isinstance(value, (set, frozenset)):
            return [_SET, *sorted(map(self._written, value), key=json.dumps)]
        if value is UNBOUND:
            return [_UNBOUND]
        for number, each in _ENUMS.items():
            if isinstance(value, each):
                return [number, value.name]
        if isinstance(value, Arguments):
            return [_ARGUMENTS, *map(self._written, value)]
        if isinstance(value, bytes):
            return [_BYTES, value.hex()]
        if isinstance(value, complex):
            return [_COMPLEX, value.real, value.imag]
        raise NotWrittenError(type(value).__name__)


@final
class Reader:
    """Reads what stands in lines; each class and each code is made once."""

    def __init__(self, lines: Lines) -> None:
        self._lines = lines
        self._known: dict[int, Class | Code] = {}

    def line(self, number: int) -> Any:
        """What a line holds."""
        return self._read(json.loads(self._lines[number]))

    def _read(self, told: Any) -> Any:
        if told.__class__ is not list:
            return told
        number = told[0]
        if number == _CONST:
            return Const(self._read(told[1]), *map(self._read, told[2:]))
        if number == _TUPLE:
            return tuple([self._read(each) for each in told[1:]])
        if number == _CODE:
            return self._code(told[1], told[2])
        if number < _FIRST:
            return self._special(number, told)
        made = _CLASSES[number - _FIRST]
        if made is Obj:
            return self._object(told)
        parts = [self._read(each) for each in told[1:]]
        if issubclass(made, (tuple, Record)):
            return made(*parts)
        names = _fields(made)
        count = len(names.position)
        return made(*parts[:count], **dict(zip(names.name, parts[count:], strict=True)))

    def _special(self, number: int, told: list[Any]) -> object:
        if number == _CLASS:
            return self._class(told[1])
        if number in _ENUMS:
            return _ENUMS[number][told[1]]
        if number == _BYTES:
            return bytes.fromhex(told[1])
        if number == _UNBOUND:
            return UNBOUND
        parts = [self._read(each) for each in told[1:]]
        if number == _DICT:
            return {k if k.__class__ is not str else intern(k): v for k, v in zip(parts[::2], parts[1::2], strict=True)}
        if number == _SET:
            return frozenset(parts)
        if number == _ARGUMENTS:
            return Arguments(parts)
        return complex(*parts) if number == _COMPLEX else parts

    def _object(self, told: list[Any]) -> Obj:
        made = Obj("instance", UNBOUND)
        for number, value in zip(told[1::2], told[2::2], strict=True):
            setattr(made, _OF_OBJECT[number], self._read(value))
        return made

    def _class(self, line: int) -> Class:
        made = self._known.get(line)
        if made is None:
            made = self._known[line] = Class(*self.line(line))
        assert isinstance(made, Class)
        return made

    def _code(self, line: int, key: str) -> Code:
        made = self._known.get(line)
        if made is None:
            lines = self._lines  # and not this reader, which holds the code
            made = self._known[line] = Code.waiting(key, lambda: _code(lines, line, key))
        assert isinstance(made, Code)
        return made


def _code(lines: Lines, line: int, key: str) -> Code:
    """A code body that somebody needs."""
    told = dict(zip(_OF_CODE, Reader(lines).line(line), strict=True))
    unit, _, index = key.rpartition("#")
    return Code(**told, unit=unit, index=int(index))
