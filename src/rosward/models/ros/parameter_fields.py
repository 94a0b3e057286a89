# SPDX-License-Identifier: Apache-2.0
"""Which field of a ParameterValue holds the value of a parameter, and of which type is an array?

Parameter('rate', value=10).get_parameter_value()    integer_value 10, string_value ''
declare_parameter('gains', [1, 2.5])                 of no type: TypeError
"""

from __future__ import annotations

from typing import Final

from rosward.domain.certain import text_of
from rosward.domain.choice import join_all, options
from rosward.domain.compound import Tuple
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, Const, Ref, Text, Unknown, Value
from rosward.models.native import Machine, NativeCall, NativeFunction
from rosward.naming.command_line import type_word

_KINDS: Final = {"bool": "bool", "integer": "int", "double": "float", "string": "str"}
"""The Python type of what a field holds; all other fields hold arrays."""


def _field(call: NativeCall) -> Value:
    """`_rosward.field_of(value, type, empty)`: the value, where it is of that type or of one that is not known."""
    value, word, empty = call.exactly(3)
    return join_all([_one(call.machine, option, text_of(word), empty) for option in options(value)])


def _one(machine: Machine, value: Value, word: str, empty: Value) -> Value:
    kind = _KINDS.get(word, "list")
    if isinstance(value, Unknown):
        if value.hint and value.hint not in (kind, "tuple"):
            return empty
        return value if value.hint else Unknown(value.reasons, "" if kind == "list" else kind)
    if value == NONE:
        return empty
    given = type_word(_plain(machine, value))
    return value if given is None or given == word else empty


def _plain(machine: Machine, value: Value) -> Value:
    """A list as a tuple, where its elements are known."""
    if not isinstance(value, Ref):
        return value
    items = machine.obj(value).items
    return Const(None) if items is None else Tuple(items)


_TYPES: Final = (
    (bytes, "BYTE_ARRAY"),
    (bool, "BOOL_ARRAY"),
    (int, "INTEGER_ARRAY"),
    (float, "DOUBLE_ARRAY"),
    (str, "STRING_ARRAY"),
)


def _array_type(call: NativeCall) -> Value:
    """`_rosward.array_type(values)`: the name of the type whose values all elements are; '' where they are of several."""

    def one(value: Value) -> Value:
        if not isinstance(value, (Ref, Tuple)):
            return call.machine.unknown(Cause.PARAMETER, "type of an array", "str")
        series = call.machine.series(value)
        elements = [o for element in (*series.head, *series.tail) for o in options(element)]
        kinds = {kind for o in elements if (kind := _element(o)) is not None}
        if not kinds and (elements or not series.exact):
            return call.machine.unknown(Cause.PARAMETER, "type of an array", "str")
        return Const(next((word for kind, word in _TYPES if all(issubclass(k, kind) for k in kinds)), ""))

    return join_all([one(option) for option in options(call.args[0])])


def _element(value: Value) -> type | None:
    """The Python type of an element; None where it is not known."""
    if isinstance(value, Const):
        return type(value.value)
    return str if isinstance(value, Text) else None


NATIVES: Final[dict[str, NativeFunction]] = {
    "_rosward.array_type": _array_type,
    "_rosward.field_of": _field,
}
