# SPDX-License-Identifier: Apache-2.0
"""Where does a stream read and write next?

stream.seekg(0);            all of the text is still to be read
stream.seekp(1);            what stands behind the first character is written over
stream.ignore(9, ',');      what is to be read begins behind the comma
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

from rosward.domain.choice import options
from rosward.domain.values import Ref, Value
from rosward.models.cpp.arity import with_least
from rosward.models.cpp.strings.streams import LEFT, OVER, TEXT, WRITTEN, held_in, put_in
from rosward.models.cpp.values.slots import read
from rosward.models.native import NativeCall, NativeFunction
from rosward.models.python.plain import from_python, int_of, text_of, unknown_from

__all__ = ["NATIVES"]


def _sought(call: NativeCall) -> Iterator[tuple[Ref, Value, str | None, int]]:
    """Each stream with its text, that text where it is known, and the place in it that is asked for; -1 where that is not known."""
    machine = call.machine
    place = int_of(read(machine, call.args[1])) if len(call.args) == 2 else None
    for option in options(read(machine, call.args[0])):
        if isinstance(option, Ref):
            whole = held_in(machine, option, TEXT)
            yield option, whole, text_of(whole), -1 if place is None else place


def _seek_to_read(call: NativeCall) -> Value:
    """stream.seekg(n): what is still to be read begins elsewhere."""
    machine = call.machine
    for stream, whole, text, place in _sought(call):
        if text is not None and place >= 0:
            left = from_python(machine, text[place:])
        else:
            left = unknown_from(machine, "seekg", "str", whole)
        put_in(machine, stream, LEFT, left)
    return read(machine, call.args[0])


def _seek_to_write(call: NativeCall) -> Value:
    """stream.seekp(n): what stands behind that place is written over."""
    machine = call.machine
    for stream, whole, text, place in _sought(call):
        if text is not None and 0 <= place <= len(text):
            put_in(machine, stream, OVER, whole)
            put_in(machine, stream, WRITTEN, from_python(machine, text[:place]))
        else:
            put_in(machine, stream, OVER, unknown_from(machine, "seekp", "str", whole))
    return read(machine, call.args[0])


def _skip(call: NativeCall) -> Value:
    """stream.ignore(count, delimiter): so many characters are read, or up to the delimiter."""
    machine, stream = call.machine, read(call.machine, call.args[0])
    count = 1 if len(call.args) == 1 else int_of(read(machine, call.args[1]))
    until = "" if len(call.args) < 3 else text_of(read(machine, call.args[2]))
    for option in options(stream):
        if isinstance(option, Ref):
            left = held_in(machine, option, LEFT)
            text = text_of(left)
            if text is None or until is None or count is None or count < 0:
                put_in(machine, option, LEFT, unknown_from(machine, "ignore", "str", left))
                continue
            found = text.find(until, 0, count) if until else -1
            put_in(machine, option, LEFT, from_python(machine, text[count if found < 0 else found + 1 :]))
    return stream


_METHODS: Final[dict[str, NativeFunction]] = {"ignore": _skip, "seekg": _seek_to_read, "seekp": _seek_to_write}
NATIVES: Final[dict[str, NativeFunction]] = {
    f"std.stringstream.{name}": function for name, function in with_least(_METHODS, 1).items()
}
