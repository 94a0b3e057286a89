# SPDX-License-Identifier: Apache-2.0
"""Which arithmetic types of C++ are the same, and which one has what is computed of two?"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

__all__ = ["INT", "LONG", "SMALL", "UNSIGNED", "WIDE", "WRAPPING", "common", "same_type"]

INT: Final = "int"
LONG: Final = "long"
UNSIGNED: Final = "unsigned int"
WIDE: Final = "unsigned long"
WRAPPING: Final = frozenset({"bool", "short", "unsigned short", UNSIGNED, WIDE})
"""Types of whole numbers that begin again where they end, of those that `auto` may stand for."""
_SAME: Final[Mapping[str, str]] = {
    **dict.fromkeys(("unsigned", "uint32_t"), UNSIGNED),
    **dict.fromkeys(("size_t", "uint64_t", "unsigned long int", "unsigned long long", "uintptr_t"), WIDE),
    **dict.fromkeys(("long int", "long long", "int64_t", "ssize_t", "ptrdiff_t"), LONG),
    "int32_t": INT,
    "short int": "short",
    "int16_t": "short",
    "uint16_t": "unsigned short",
}
SMALL: Final = frozenset(
    {"bool", "char", "short", "unsigned short", "int8_t", "uint8_t", "signed char", "unsigned char", INT}
)


def same_type(name: str) -> str:
    """An arithmetic type by the one of its names that stands for all."""
    short = _shorter(name)
    return _SAME.get(name) or _SAME.get(short, short)


def _shorter(name: str) -> str:
    """`long` for `signed long int`, `unsigned long long` for `long long unsigned int`: the words that need not be there."""
    words = name.split()
    if (len(words) < 2 and words != ["signed"]) or "double" in words or "char" in words:
        return name
    sizes = [word for word in words if word in ("long", "short")]
    sign = ["unsigned"] if "unsigned" in words else []
    return " ".join(sign + sizes) or INT


def common(one: str, other: str) -> str:
    """The type of what is computed of two."""
    types = {INT if each in SMALL else each for each in (one, other)}
    if "" in types:
        return WIDE if WIDE in types else ""
    for wide in ("double", "float", WIDE, LONG, UNSIGNED):
        if wide in types:
            return wide
    return INT
