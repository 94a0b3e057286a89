# SPDX-License-Identifier: Apache-2.0
"""Which values are made of other values, or stand for something by its name?"""

from __future__ import annotations

from typing import Final, NamedTuple, final

from rosward.domain.values import Choice, Reduced, Value


class Record(Value):
    """Compares the named tuple that it is mixed into with others of the same class only."""

    __slots__ = ()

    def __eq__(self, other: object) -> bool:
        return self.__class__ is other.__class__ and tuple.__eq__(self, other)  # type: ignore[operator]  # it is mixed into tuples

    def __ne__(self, other: object) -> bool:
        return not self == other

    def __hash__(self) -> int:
        return tuple.__hash__(self) ^ hash(self.__class__)  # type: ignore[arg-type]  # as above


MAX_PARTS: Final = 20_000


class TooManyPartsError(Exception):
    """A tuple would hold more than is kept."""


def parts_of(value: Value) -> int:
    """How many values are in a value, itself among them, each as often as it occurs."""
    if value.__class__ is Tuple:
        return value.parts
    if isinstance(value, Choice):
        return sum(parts_of(o) for o in value.options)
    if isinstance(value, Partial):
        return 1 + sum(parts_of(a) for a in value.arguments)
    if isinstance(value, BoundMethod):
        return 1 + parts_of(value.receiver)
    return 1


@final
class Tuple(Value):
    """A tuple of known length; `parts` counts all that is in it. One of too many parts is not made: `TooManyPartsError`.

    t = (t, t), forty times over, is small in memory and would take for ever to compare or to print.
    """

    __slots__ = ("_hash", "items", "parts")

    def __init__(self, items: tuple[Value, ...]) -> None:
        self.items = items
        self._hash = hash(items)
        self.parts = 1 + sum([parts_of(i) for i in items])
        if self.parts > MAX_PARTS:
            raise TooManyPartsError

    def __eq__(self, other: object) -> bool:
        return self is other or (other.__class__ is Tuple and self._hash == other._hash and self.items == other.items)

    def __hash__(self) -> int:
        return self._hash

    def __reduce__(self) -> Reduced:
        return Tuple, (self.items,)

    def __repr__(self) -> str:
        return f"Tuple{self.items!r}"


class External(Record, NamedTuple("_External", [("name", "str")])):
    """Something of a library that is neither among the sources nor modelled, by its dotted name: `std_msgs.msg.String`, `cv2.imread`."""

    __slots__ = ()


class Native(Record, NamedTuple("_Native", [("name", "str")])):
    """A builtin type or function, or one that a model implements in code, by its dotted name: `builtins.str`, `str.join`, `os.path.join`."""

    __slots__ = ()


class BoundMethod(Record, NamedTuple("_BoundMethod", [("receiver", "Value"), ("function", "Value")])):
    """`receiver.function`: a callable that passes receiver first."""

    __slots__ = ()


class Partial(
    Record,
    NamedTuple(
        "_Partial",
        [("function", "Value"), ("arguments", "tuple[Value, ...]"), ("keywords", "tuple[tuple[str, Value], ...]")],
    ),
):
    """`functools.partial`, or a native that needs arguments of its own."""

    __slots__ = ()


class Descriptor(
    Record,
    NamedTuple(
        "_Descriptor", [("kind", "str"), ("getter", "Value"), ("setter", "Value | None"), ("deleter", "Value | None")]
    ),
):
    """A wrapped function in a class: kind is 'property', 'cached_property', 'staticmethod' or 'classmethod'."""

    __slots__ = ()


class Super(Record, NamedTuple("_Super", [("after", "Value"), ("receiver", "Value")])):
    """`super()`: attributes of receiver, looked up behind class `after` in its mro."""

    __slots__ = ()


class Slice(Record, NamedTuple("_Slice", [("lower", "Value"), ("upper", "Value"), ("step", "Value")])):
    """`lower:upper:step`."""

    __slots__ = ()


class Range(Record, NamedTuple("_Range", [("start", "Value"), ("stop", "Value"), ("step", "Value")])):
    """`range(start, stop, step)`."""

    __slots__ = ()
