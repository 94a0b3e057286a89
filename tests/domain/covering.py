# SPDX-License-Identifier: Apache-2.0
"""What it means that one abstract value, record or state covers another: every concrete one below is among those above.

Written apart from join, and as simply as can be, so that the laws say something; `test_covering.py` shows that it tells apart.
"""

from __future__ import annotations

from typing import Final

from rosward.domain.choice import join_all, options
from rosward.domain.compound import Tuple
from rosward.domain.heap import Alternatives, Obj
from rosward.domain.series import Series
from rosward.domain.state import State, element
from rosward.domain.suspended import ANY_TURN, EACH, KEPT, YIELD, Point, Suspension
from rosward.domain.text import matches
from rosward.domain.values import UNBOUND, Choice, Const, Hole, Text, Unknown, Value


def shape(value: Value) -> Value:
    """The value without what is only told of it: reasons, of which no more than a few are kept."""
    if isinstance(value, Unknown):
        return Unknown((), value.hint)
    if isinstance(value, Text):
        return Text(tuple(p if isinstance(p, str) else Hole((), p.shape) for p in value.parts), value.origins)
    if isinstance(value, Tuple):
        return Tuple(tuple(map(shape, value.items)))
    if isinstance(value, Choice):
        return join_all(map(shape, value.options))
    return value


def covers(above: Value, below: Value) -> bool:
    """Whether everything that `below` stands for is among what `above` stands for (complete enough for these tests)."""
    return all(any(_covers_one(a, b) for a in options(above)) for b in options(below))


def _covers_one(above: Value, below: Value) -> bool:
    if below is UNBOUND or above == below:
        return True
    if isinstance(above, Unknown):
        return above.hint in ("", kind(below))
    if isinstance(above, Const) and isinstance(below, Const):
        same = above.value.__class__ is below.value.__class__ and above.value == below.value
        return same and above.origins >= below.origins
    if isinstance(above, Text):
        return kind(below) == "str" and all(matches(above, text) for text in samples(below))
    if isinstance(above, Tuple) and isinstance(below, Tuple):
        return len(above.items) == len(below.items) and all(map(covers, above.items, below.items))
    return shape(above) == shape(below)


def kind(value: Value) -> str:
    """The name of the Python type of what a value stands for, '' where that is not one."""
    if isinstance(value, Const):
        return value.value.__class__.__name__
    if isinstance(value, Unknown):
        return value.hint
    return {Text: "str", Tuple: "tuple"}.get(type(value), "")


FILLINGS: Final = {"": ("", "x", "a/b", "/"), "word": ("x", "ab"), "digits": ("0", "-12")}


def fill(parts: list[str | Hole], choose: int) -> str:
    """The text with its holes filled, in one of several ways."""
    found = ""
    for number, part in enumerate(parts):
        if isinstance(part, str):
            found += part
        else:
            fillings = FILLINGS[part.shape]
            found += fillings[(choose >> number) % len(fillings)]
    return found


def samples(value: Value) -> list[str]:
    """Some of the texts that a value stands for."""
    if isinstance(value, Const):
        return [str(value.value)]
    if isinstance(value, Text):
        return [fill(list(value.parts), choose) for choose in range(8)]
    return ["", "x", "a/b"] if isinstance(value, Unknown) and value.hint == "str" else []


# Objects and states

_MARKED: Final = ("instance", "class", "module")
"""Of these it is told which attributes may be absent. A cell has one variable, and of variables it is not told."""


def object_covers(above: Obj, below: Obj) -> bool:
    """Whether every object that `below` stands for is among those that `above` stands for."""
    if above.kind != below.kind or above.cls != below.cls or (below.many and not above.many):
        return False
    return _attributes_cover(above, below) and _payload_covers(above, below) and _contents_cover(above, below)


def _attributes_cover(above: Obj, below: Obj) -> bool:
    if not all(name in above.attrs and covers(above.attrs[name], value) for name, value in below.attrs.items()):
        return False
    absent = (above.attrs.keys() - below.attrs.keys()) | below.partial
    return above.kind not in _MARKED or absent <= above.partial


def _payload_covers(above: Obj, below: Obj) -> bool:
    if isinstance(below.payload, Suspension):
        return isinstance(above.payload, Suspension) and suspension_covers(above.payload, below.payload)
    if isinstance(above.payload, Alternatives):
        return _alternatives_cover(above.payload, below)
    if isinstance(below.payload, Alternatives):  # above says less
        return above.payload is None
    if isinstance(below.payload, Value):
        return isinstance(above.payload, Value) and covers(above.payload, below.payload)
    return above.payload == below.payload


def _alternatives_cover(above: Alternatives, below: Obj) -> bool:
    """Whether all that is in a list is told, and all that is told to be in it surely is."""
    told = dict(above.elements)
    if isinstance(below.payload, Alternatives):
        held = dict(below.payload.elements)
    elif below.items is not None:
        held = dict.fromkeys(below.items, True)
    else:
        return False
    return held.keys() <= told.keys() and all(held.get(value, False) for value, sure in told.items() if sure)


def _contents_cover(above: Obj, below: Obj) -> bool:
    if above.kind == "dict":
        return _entries_cover(above, below)
    return above.kind not in ("list", "set") or _elements_cover(above, below)


def _elements_cover(above: Obj, below: Obj) -> bool:
    if above.items is None:
        inner, outer = element(below), element(above)
        if inner is not None and (outer is None or not covers(outer, inner)):
            return False
        return above.ends is None or series_covers(above.ends, below.series())
    if below.items is None or len(above.items) != len(below.items):
        return False
    return all(map(covers, above.items, below.items))


def series_covers(above: Series, below: Series) -> bool:
    """Whether each sequence that begins and ends like `below` begins and ends like `above`, and has no other elements between."""
    if above.middle is None:
        return below.middle is None and len(above.head) == len(below.head) and all(map(covers, above.head, below.head))
    if below.least < above.least:
        return False
    first, last = len(above.head), len(above.tail)
    begins = all(_at_covers(value, below.at(n)) for n, value in enumerate(above.head))
    ends = all(_at_covers(value, below.at(-n - 1)) for n, value in enumerate(reversed(above.tail)))
    between = below.without(first).reversed().without(last).element()
    return begins and ends and (between is None or covers(above.middle, between))


def _at_covers(above: Value, below: Value | None) -> bool:
    return below is not None and covers(above, below)


def _entries_cover(above: Obj, below: Obj) -> bool:
    for key, value in below.entries.items():
        if not (key in above.entries and covers(above.entries[key], value)):
            return False
    absent = [key for key in above.entries if key not in below.entries or key in below.maybe]
    if any(key not in above.maybe for key in absent):
        return False
    sure = [key for key in above.entries if key not in above.maybe]
    if sure != [key for key in below.entries if key in sure]:  # in this order
        return False
    if below.rest is None:
        return True
    if above.rest is None or not covers(above.rest, below.rest):
        return False
    return above.rest_key is None or (below.rest_key is not None and covers(above.rest_key, below.rest_key))


def suspension_covers(above: Suspension, below: Suspension) -> bool:
    """Whether each point at which one may stand is one of the other, in the same turn or in any, with what it holds."""
    if (below.ended and not above.ended) or (below.shared and not above.shared):
        return False
    return all(_point_covered(above, point, held) for point, held in below.points.items())


def _point_covered(above: Suspension, point: Point, held: tuple[Value, ...]) -> bool:
    return any(
        _held_covers(place, above.points[place], held) for place in {point, point.syntactic} if place in above.points
    )


def _held_covers(place: Point, above: tuple[Value, ...], below: tuple[Value, ...]) -> bool:
    """Whether the values kept at a point are among others there: the registers, then what each loop on the way has ahead."""
    if len(above) != len(below):
        return False
    count = place.function.code.registers
    if not all(map(covers, above[:count], below[:count])):
        return False
    for step in place.path:
        if step.part in (EACH, YIELD):
            exact = step.turn != ANY_TURN
            if not _ahead_covers(above[count : count + KEPT], below[count : count + KEPT], exact=exact):
                return False
            count += KEPT
    return True


def _ahead_covers(above: tuple[Value, ...], below: tuple[Value, ...], *, exact: bool) -> bool:
    """Whether what a loop runs over and has ahead is among what another one has: in order, or in any."""
    source, ahead, rest = above
    runs_over, known, more = below
    if not covers(source, runs_over) or (more is not UNBOUND and not covers(rest, more)):
        return False
    if exact and covers(ahead, known):
        return True
    return all(covers(rest, i) for o in options(known) if isinstance(o, Tuple) for i in o.items)


def state_covers(above: State, below: State) -> bool:
    """Whether every execution that `below` stands for is among those that `above` stands for."""
    records = dict(above.heap.items())
    heap = all(a in records and object_covers(records[a], o) for a, o in below.heap.items())
    return heap and above.done <= below.done
