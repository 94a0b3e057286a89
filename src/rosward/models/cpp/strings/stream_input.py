# SPDX-License-Identifier: Apache-2.0
"""What comes out of a stream?

std::istringstream is("a,b"); std::getline(is, word, ',')     word is 'a', then 'b', then nothing is left
is >> number                                                  by the type of what stands in the slot
"""

from __future__ import annotations

import re
from typing import Final

from rosward.domain.choice import options
from rosward.domain.text import make, parts_of
from rosward.domain.unknown import Cause
from rosward.domain.values import EMPTY, FALSE, Const, Ref, Unknown, Value
from rosward.models.cpp.strings.streams import (
    GOOD,
    LEFT,
    held_in,
    is_good,
    is_of_file,
    is_stream,
    name_of_library,
    put_in,
)
from rosward.models.cpp.values.copies import write
from rosward.models.cpp.values.slots import read
from rosward.models.native import Machine, NativeCall, NativeFunction
from rosward.models.python.plain import from_python, text_of, unknown_from
from rosward.models.python.strings import text_parts

__all__ = ["NATIVES", "extract"]

_WORD: Final = re.compile(r"\s*(\S+)")
_WHOLE: Final = re.compile(r"\s*([+-]?\d+)")
_FLOAT: Final = re.compile(r"\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)")


def extract(machine: Machine, stream: Value, slot: Value) -> Value:
    """stream >> slot; gives the stream."""
    held = read(machine, stream)
    for option in options(held):
        if name_of_library(slot) == "std.ws":
            continue
        old = read(machine, slot)
        kind = _kind(old)
        if not isinstance(option, Ref) or not is_stream(machine, option) or len(options(held)) > 1:
            write(machine, slot, machine.unknown(Cause.INPUT, "std.cin", kind))
            continue
        found = _taken(machine, option, kind)
        if found is not None:
            write(machine, slot, found)
    return held


def _kind(value: Value) -> str:
    if isinstance(value, Const) and value.value is not None:
        return type(value.value).__name__
    return value.hint if isinstance(value, Unknown) else "str" if parts_of(value) and not isinstance(value, Ref) else ""


def _taken(machine: Machine, ref: Ref, kind: str) -> Value | None:
    """The next word or number; None where there surely is none."""
    left = held_in(machine, ref, LEFT)
    text = text_of(left)
    pattern = {"str": _WORD, "int": _WHOLE, "float": _FLOAT, "bool": _WHOLE}.get(kind)
    if is_of_file(machine, ref) or text is None or pattern is None:
        unknown = _not_known(machine, ref, kind)
        put_in(machine, ref, LEFT, Unknown(unknown.reasons, "str"))
        put_in(machine, ref, GOOD, Unknown(unknown.reasons, "bool"))
        return unknown
    if is_good(machine, ref) is False:
        return None
    match = pattern.match(text)
    if match is None:
        put_in(machine, ref, GOOD, FALSE)
        return None if kind == "str" or not text.strip() else Const({"int": 0, "float": 0.0, "bool": False}[kind])
    put_in(machine, ref, LEFT, from_python(machine, text[match.end() :]))
    source = left.origins if isinstance(left, Const) else frozenset()
    return from_python(machine, _parsed(kind, match[1]), source)


def _parsed(kind: str, word: str) -> object:
    if kind == "str":
        return word
    return float(word) if kind == "float" else int(word) if kind == "int" else bool(int(word))


def _not_known(machine: Machine, ref: Ref, kind: str) -> Unknown:
    if is_of_file(machine, ref):
        return machine.unknown(Cause.FILE, text_of(held_in(machine, ref, "path")) or "", kind)
    return unknown_from(machine, ">>", kind, held_in(machine, ref, LEFT))


def _getline(call: NativeCall) -> Value:
    """std::getline(stream, slot, delimiter)."""
    machine, stream = call.machine, read(call.machine, call.args[0])
    slot = call.args[1]
    delimiter = text_of(read(machine, call.args[2])) if len(call.args) > 2 else "\n"
    if not isinstance(stream, Ref) or not is_stream(machine, stream):
        write(machine, slot, machine.unknown(Cause.INPUT, "std.getline", "str"))
        return machine.unknown(Cause.INPUT, "std.getline", "bool")
    left = held_in(machine, stream, LEFT)
    parts = parts_of(left)
    surely = is_good(machine, stream)
    if surely is False:
        return stream
    if left == EMPTY and not is_of_file(machine, stream):
        put_in(machine, stream, GOOD, FALSE)
        write(machine, slot, EMPTY)
        return stream
    known = surely and delimiter is not None and not is_of_file(machine, stream)
    cut = text_parts.cut_front(parts, delimiter) if known and delimiter else None
    if known and cut is None and delimiter and text_parts.split_all(parts, delimiter) == [parts]:
        cut = (parts, ())
    if cut is None:
        line: Value = _not_known(machine, stream, "str")
        rest: Value = Unknown(line.reasons, "str") if isinstance(line, Unknown) else line
        put_in(machine, stream, GOOD, unknown_from(machine, "getline", "bool", line))
    else:
        line, rest = make(cut[0]), make(cut[1])
    write(machine, slot, line)
    put_in(machine, stream, LEFT, rest)
    return stream


NATIVES: Final[dict[str, NativeFunction]] = {"std.getline": _getline}
