# SPDX-License-Identifier: Apache-2.0
"""How does a record become JSON, and how is it read from JSON that anybody may have written?

    PLACE = record(Place, TEXT, NUMBER, NUMBER)
    PLACE.write(Place("a.py", 3))    ->  ["a.py", 3, 1]
    PLACE.read(["a.py", "x", 1])     ->  MalformedError

Each record has a codec of its own, made of those of its fields, in their order. What is read has exactly the types that it says; nothing is
looked up by a name that stands in the text, and nothing of it is called.
"""

from __future__ import annotations

import enum
import json
from collections.abc import Callable
from dataclasses import dataclass
from operator import attrgetter
from typing import Any, Final, Generic, TypeVar

__all__ = [
    "FLAG", "LINES", "NUMBER", "OPTION", "PLAIN", "TEXT", "Codec", "MalformedError", "loaded", "mapping", "maybe", "one_of", "pair", "record",
    "sequence", "several", "text", "told_apart", "triple",
]  # fmt: skip

T = TypeVar("T")
U = TypeVar("U")
V = TypeVar("V")
E = TypeVar("E", bound=enum.Enum)

Json = Any
"""What `json` reads: None, bool, int, float, str, list, dict."""


class MalformedError(Exception):
    """A document is not of the form that it should be."""


@dataclass(frozen=True, slots=True)
class Codec(Generic[T]):
    """How values of one type are written and read. `read` raises MalformedError."""

    write: Callable[[T], Json]
    read: Callable[[Json], T]


def text(document: Json) -> bytes:
    """A document as bytes; each text in it comes back as it was, whatever it holds. Raises ValueError for a number that is too long."""
    return json.dumps(document, ensure_ascii=False, separators=(",", ":")).encode("utf-8", "surrogatepass")


def loaded(data: bytes) -> Json:
    """The document in these bytes. Raises MalformedError."""
    try:
        return json.loads(data.decode("utf-8", "surrogatepass"))
    except (ValueError, RecursionError) as error:
        raise MalformedError from error


def _same(value: T) -> T:
    return value


def _exactly(kind: type[T]) -> Codec[T]:
    def read(value: Json) -> T:
        if value.__class__ is not kind:
            raise MalformedError
        return value

    return Codec(_same, read)


TEXT: Final = _exactly(str)
NUMBER: Final = _exactly(int)
FLAG: Final = _exactly(bool)


def _read_plain(value: Json) -> object:
    if value.__class__ is list:
        return [_read_plain(each) for each in value]
    if value.__class__ is dict:
        raise MalformedError
    return value


_SIMPLE: Final = (bool, int, float, str)
PLAIN: Final[Codec[object]] = Codec(_same, _read_plain)
"""None, bool, int, float, str, and lists of them, as they are."""


def _read_option(value: Json) -> bool | float | str | tuple[str, ...] | None:
    if value is None or value.__class__ in _SIMPLE:
        return value
    return LINES.read(value)


def maybe(codec: Codec[T]) -> Codec[T | None]:
    """Such a value, or None."""
    write, read = codec.write, codec.read

    def write_maybe(value: T | None) -> Json:
        return None if value is None else write(value)

    def read_maybe(value: Json) -> T | None:
        return None if value is None else read(value)

    return Codec(write_maybe, read_maybe)


def sequence(codec: Codec[T]) -> Codec[tuple[T, ...]]:
    """Any number of such values."""
    write, read = codec.write, codec.read

    def write_all(values: tuple[T, ...]) -> Json:
        return [write(value) for value in values]

    def read_all(values: Json) -> tuple[T, ...]:
        if values.__class__ is not list:
            raise MalformedError
        return tuple([read(value) for value in values])

    return Codec(write_all, read_all)


LINES: Final = sequence(TEXT)
OPTION: Final[Codec[bool | float | str | tuple[str, ...] | None]] = Codec(_same, _read_option)
"""None, bool, int, float, str, or some texts."""


def several(codec: Codec[T]) -> Codec[frozenset[T]]:
    """A set of such values; what is written is sorted, so that equal sets are written alike."""
    ordered = sequence(codec)

    def write(values: frozenset[T]) -> Json:
        return ordered.write(tuple(sorted(values)))  # type: ignore[type-var]

    return Codec(write, lambda values: frozenset(ordered.read(values)))


def pair(first: Codec[T], second: Codec[U]) -> Codec[tuple[T, U]]:
    """Two values."""

    def write(value: tuple[T, U]) -> Json:
        return [first.write(value[0]), second.write(value[1])]

    def read(value: Json) -> tuple[T, U]:
        if value.__class__ is not list or len(value) != 2:
            raise MalformedError
        return first.read(value[0]), second.read(value[1])

    return Codec(write, read)


def triple(first: Codec[T], second: Codec[U], third: Codec[V]) -> Codec[tuple[T, U, V]]:
    """Three values."""

    def write(value: tuple[T, U, V]) -> Json:
        return [first.write(value[0]), second.write(value[1]), third.write(value[2])]

    def read(value: Json) -> tuple[T, U, V]:
        if value.__class__ is not list or len(value) != 3:
            raise MalformedError
        return first.read(value[0]), second.read(value[1]), third.read(value[2])

    return Codec(write, read)


def mapping(codec: Codec[T]) -> Codec[dict[str, T]]:
    """Values by texts, in their order."""

    def write(values: dict[str, T]) -> Json:
        return {key: codec.write(value) for key, value in values.items()}

    def read(values: Json) -> dict[str, T]:
        if values.__class__ is not dict:
            raise MalformedError
        return {key: codec.read(value) for key, value in values.items()}

    return Codec(write, read)


def one_of(kind: type[E]) -> Codec[E]:
    """A member of an enumeration, by its value."""
    known: dict[object, E] = {member.value: member for member in kind}

    def read(value: Json) -> E:
        found = known.get(value) if value.__class__ is str else None
        if found is None:
            raise MalformedError
        return found

    return Codec(lambda value: value.value, read)


def record(kind: type[T], /, *codecs: Codec[Any], **named: Codec[Any]) -> Codec[T]:
    """A record with these fields: those of a NamedTuple in its order, those of a dataclass by their names."""
    names = (*named,)
    writers = [codec.write for codec in (*codecs, *named.values())]
    readers = [codec.read for codec in (*codecs, *named.values())]
    count = len(readers)
    fields: Callable[[Any], Any] = attrgetter(*names) if len(names) > 1 else tuple

    def write(value: T) -> Json:
        return [each(field) for each, field in zip(writers, fields(value), strict=True)]

    def read(value: Json) -> T:
        if value.__class__ is not list or len(value) != count:
            raise MalformedError
        found = [each(field) for each, field in zip(readers, value, strict=True)]
        return kind(**dict(zip(names, found, strict=True))) if names else kind(*found)

    return Codec(write, read)


def told_apart(codec: Codec[T], known: Callable[[T], bool]) -> Codec[T]:
    """Such a value, but only one that is known; any other is malformed."""

    def read(value: Json) -> T:
        found = codec.read(value)
        if not known(found):
            raise MalformedError
        return found

    return Codec(codec.write, read)
