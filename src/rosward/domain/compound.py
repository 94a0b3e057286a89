# SPDX-License-Identifier: Apache-2.0
"""Which values are made of other values, or stand for something by its name?"""

from __future__ import annotations

from typing import Final, final

from rosward.domain.values import Choice, Function, Reduced, Value


class Record(Value):
    """Compared by its class and its fields."""

    __slots__ = ()

    def fields(self) -> tuple[object, ...]:
        """What it is made of, in the order of the constructor."""
        raise NotImplementedError

    def __eq__(self, other: object) -> bool:
        return self is other or (
            isinstance(other, Record) and self.__class__ is other.__class__ and self.fields() == other.fields()
        )

    def __hash__(self) -> int:
        return hash((self.__class__, self.fields()))

    def __reduce__(self) -> Reduced:
        return self.__class__, self.fields()

    def __repr__(self) -> str:
        return f"{self.__class__.__name__}{self.fields()!r}"


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


@final
class External(Record):
    """Something of a library that is neither among the sources nor modelled, by its dotted name: `std_msgs.msg.String`, `cv2.imread`."""

    __slots__ = ("name",)

    def __init__(self, name: str) -> None:
        self.name = name

    def fields(self) -> tuple[str]:
        """In the order of the constructor."""
        return (self.name,)


@final
class Native(Record):
    """A builtin type or function, or one that a model implements in code, by its dotted name: `builtins.str`, `str.join`, `os.path.join`."""

    __slots__ = ("name",)

    def __init__(self, name: str) -> None:
        self.name = name

    def fields(self) -> tuple[str]:
        """In the order of the constructor."""
        return (self.name,)


@final
class BoundMethod(Record):
    """`receiver.function`: a callable that passes receiver first."""

    __slots__ = ("function", "receiver")

    def __init__(self, receiver: Value, function: Value) -> None:
        self.receiver = receiver
        self.function = function

    def fields(self) -> tuple[Value, Value]:
        """In the order of the constructor."""
        return self.receiver, self.function


@final
class Partial(Record):
    """`functools.partial`, or a native that needs arguments of its own."""

    __slots__ = ("arguments", "function", "keywords")

    def __init__(self, function: Value, arguments: tuple[Value, ...], keywords: tuple[tuple[str, Value], ...]) -> None:
        self.function = function
        self.arguments = arguments
        self.keywords = keywords

    def fields(self) -> tuple[Value, tuple[Value, ...], tuple[tuple[str, Value], ...]]:
        """In the order of the constructor."""
        return self.function, self.arguments, self.keywords


def function_behind(value: Value) -> Function | None:
    """The function that a method or partial leads to, or a function itself."""
    while isinstance(value, (BoundMethod, Partial)):
        value = value.function
    return value if isinstance(value, Function) else None


@final
class Descriptor(Record):
    """A wrapped function in a class: kind is 'property', 'cached_property', 'staticmethod' or 'classmethod'."""

    __slots__ = ("deleter", "getter", "kind", "setter")

    def __init__(self, kind: str, getter: Value, setter: Value | None, deleter: Value | None) -> None:
        self.kind = kind
        self.getter = getter
        self.setter = setter
        self.deleter = deleter

    def fields(self) -> tuple[str, Value, Value | None, Value | None]:
        """In the order of the constructor."""
        return self.kind, self.getter, self.setter, self.deleter


@final
class Super(Record):
    """`super()`: attributes of receiver, looked up behind class `after` in its mro."""

    __slots__ = ("after", "receiver")

    def __init__(self, after: Value, receiver: Value) -> None:
        self.after = after
        self.receiver = receiver

    def fields(self) -> tuple[Value, Value]:
        """In the order of the constructor."""
        return self.after, self.receiver


@final
class Slice(Record):
    """`lower:upper:step`."""

    __slots__ = ("lower", "step", "upper")

    def __init__(self, lower: Value, upper: Value, step: Value) -> None:
        self.lower = lower
        self.upper = upper
        self.step = step

    def fields(self) -> tuple[Value, Value, Value]:
        """In the order of the constructor."""
        return self.lower, self.upper, self.step


@final
class Range(Record):
    """`range(start, stop, step)`."""

    __slots__ = ("start", "step", "stop")

    def __init__(self, start: Value, stop: Value, step: Value) -> None:
        self.start = start
        self.stop = stop
        self.step = step

    def fields(self) -> tuple[Value, Value, Value]:
        """In the order of the constructor."""
        return self.start, self.stop, self.step
