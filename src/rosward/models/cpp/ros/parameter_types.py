# SPDX-License-Identifier: Apache-2.0
"""Which type has a parameter that is declared with a type of C++?

std::string     string          float           double
uint8_t         integer         std::vector<T>  the array of the type of T; of uint8_t it is one of bytes
"""

from __future__ import annotations

from types import MappingProxyType
from typing import Final

from rosward.domain.values import Value
from rosward.models.cpp.values.types import Shape, argument, name_of, shape_of

__all__ = ["BY_NUMBER", "hint_of_word", "word_of_type"]

BY_NUMBER: Final = MappingProxyType(
    {
        0: "not_set",
        1: "bool",
        2: "integer",
        3: "double",
        4: "string",
        5: "byte_array",
        6: "bool_array",
        7: "integer_array",
        8: "double_array",
        9: "string_array",
    }
)
"""rcl's words for the types of parameters, by their numbers in rcl_interfaces/msg/ParameterType."""
_WORDS: Final = {
    Shape.BOOL: "bool",
    Shape.INT: "integer",
    Shape.FLOAT: "double",
    Shape.TEXT: "string",
    Shape.CHAR: "integer",
}
_HINTS: Final = {"bool": "bool", "integer": "int", "double": "float", "string": "str"}
_BYTES: Final = frozenset({"uint8_t", "std.uint8_t", "unsigned char"})


def word_of_type(type_: Value) -> str:
    """rcl's word for the parameters of a type of C++; '' for a type that no parameter has."""
    shape = shape_of(type_)
    if shape is Shape.POINTER:
        return "string" if name_of(argument(type_, 0)) == "char" else ""
    if shape in (Shape.LIST, Shape.ARRAY):
        inner = argument(type_, 0)
        word = "byte" if name_of(inner) in _BYTES else _WORDS.get(shape_of(inner), "")
        return f"{word}_array" if word else ""
    return _WORDS.get(shape, "")


def hint_of_word(word: str) -> str:
    """The name of the Python type by which the values of a parameter are kept."""
    return "list" if word.endswith("_array") else _HINTS.get(word, "")
