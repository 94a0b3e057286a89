# SPDX-License-Identifier: Apache-2.0
"""Abstract values at random, and what it means that one covers another."""

from __future__ import annotations

from typing import Final

from hypothesis import strategies as st

from rosward.domain.choice import join_all, options
from rosward.domain.heap import Obj
from rosward.domain.memory import Heap
from rosward.domain.text import make, matches
from rosward.domain.unknown import Cause, Origin, Reason
from rosward.domain.values import (
    UNBOUND,
    Choice,
    Const,
    External,
    Hole,
    Native,
    Partial,
    Ref,
    Text,
    Tuple,
    Unknown,
    Value,
)
from rosward.engine.state import NOTHING_DONE, State, element
from rosward.source.location import Place

HERE: Final = Place("a.py", 1)
REASONS: Final = tuple(Reason(cause, subject, HERE) for cause in (Cause.PARAMETER, Cause.MESSAGE) for subject in "abc")
LOOP: Final = Reason(Cause.LOOP, "", HERE)
ORIGINS: Final = (Origin("parameter", "p"), Origin("argument", "q"), Origin("launch argument", "r", settled=True))

words = st.text("ab/_", max_size=4)
reasons = st.lists(st.sampled_from(REASONS), min_size=1, max_size=3, unique=True).map(tuple)
origins = st.frozensets(st.sampled_from(ORIGINS), max_size=2)
holes = st.builds(Hole, reasons, st.sampled_from(("", "word", "digits")))
text_parts = st.lists(st.one_of(words, holes), max_size=5)

strings = st.builds(Const, words, origins)
plain = st.one_of(st.none(), st.booleans(), st.integers(0, 3), st.sampled_from((0.0, 1.5)), st.just(b"x"))
constants = st.one_of(strings, st.builds(Const, plain, origins))
texts = st.builds(make, text_parts, origins)
unknowns = st.builds(Unknown, reasons, st.sampled_from(("", "str", "int", "list")))
references = st.builds(Ref, st.integers(1, 4))
names = st.sampled_from(("std_msgs.msg.String", "cv2", "lib.make"))
leaves: st.SearchStrategy[Value] = st.one_of(
    constants, texts, unknowns, references, st.builds(External, names), st.builds(Native, names)
)
singles: st.SearchStrategy[Value] = st.one_of(
    leaves,
    st.lists(leaves, max_size=2).map(lambda items: Tuple(tuple(items))),
    st.builds(Partial, leaves, st.lists(leaves, max_size=1).map(tuple), st.just(())),
)
values: st.SearchStrategy[Value] = st.one_of(singles, st.lists(singles, min_size=1, max_size=5).map(join_all))
string_values: st.SearchStrategy[Value] = st.lists(st.one_of(strings, texts), min_size=1, max_size=4).map(join_all)


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

attributes = st.dictionaries(st.sampled_from("xyz"), values, max_size=3)
CLASS: Final = Native("builtins.object")


@st.composite
def instances(draw: st.DrawFn) -> Obj:
    return Obj("instance", CLASS, attrs=draw(attributes), many=draw(st.booleans()))


@st.composite
def lists(draw: st.DrawFn, kind: str = "list") -> Obj:
    many = draw(st.booleans())
    if draw(st.booleans()):
        return Obj(kind, CLASS, items=tuple(draw(st.lists(values, max_size=3))), many=many)
    return Obj(kind, CLASS, items=None, rest=draw(st.one_of(st.none(), values)), many=many)


@st.composite
def dicts(draw: st.DrawFn) -> Obj:
    keys: st.SearchStrategy[Value] = words.map(Const)
    entries = draw(st.dictionaries(keys, values, max_size=3))
    maybe = frozenset(k for k in entries if draw(st.booleans()))
    rest = draw(st.one_of(st.none(), values))
    key = draw(unknowns) if rest is not None else None
    return Obj("dict", CLASS, entries=entries, maybe=maybe, rest=rest, rest_key=key, many=draw(st.booleans()))


def objects(kind: str) -> st.SearchStrategy[Obj]:
    """Records of one kind."""
    if kind == "dict":
        return dicts()
    return instances() if kind == "instance" else lists(kind)


KINDS: Final = ("instance", "list", "set", "dict")
triples = st.sampled_from(KINDS).flatmap(lambda kind: st.tuples(objects(kind), objects(kind), objects(kind)))


@st.composite
def states(draw: st.DrawFn, version: int = 1) -> State:
    """A state whose address n holds an object of kind n: as in a run, an address never changes its kind."""
    heap = {address: draw(objects(kind)) for address, kind in enumerate(KINDS) if draw(st.booleans())}
    done = draw(st.frozensets(st.sampled_from((("node", 1), ("node", 2), ("entity", 3))), max_size=2))
    return State(Heap(heap.items()), version, done or NOTHING_DONE)


two_states = st.tuples(states(version=1), states(version=2))
"""Of different versions: equal ones mean equal heaps."""


def object_covers(above: Obj, below: Obj) -> bool:
    """Whether every object that `below` stands for is among those that `above` stands for."""
    if below.many and not above.many:
        return False
    attrs = all(name in above.attrs and covers(above.attrs[name], value) for name, value in below.attrs.items())
    if above.kind in ("list", "set"):
        return attrs and _elements_cover(above, below)
    return attrs and (above.kind != "dict" or _entries_cover(above, below))


def _elements_cover(above: Obj, below: Obj) -> bool:
    if above.items is None:
        inner, outer = element(below), element(above)
        return inner is None or (outer is not None and covers(outer, inner))
    if below.items is None or len(above.items) != len(below.items):
        return False
    return all(map(covers, above.items, below.items))


def _entries_cover(above: Obj, below: Obj) -> bool:
    for key, value in below.entries.items():
        if not (key in above.entries and covers(above.entries[key], value)):
            return False
    absent = [key for key in above.entries if key not in below.entries or key in below.maybe]
    if any(key not in above.maybe for key in absent):
        return False
    if below.rest is None:
        return True
    if above.rest is None or above.rest_key is None or below.rest_key is None:
        return False
    return covers(above.rest, below.rest) and covers(above.rest_key, below.rest_key)


def state_covers(above: State, below: State) -> bool:
    """Whether every execution that `below` stands for is among those that `above` stands for."""
    records = dict(above.heap.items())
    heap = all(a in records and object_covers(records[a], o) for a, o in below.heap.items())
    return heap and above.done <= below.done
