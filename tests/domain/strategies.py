# SPDX-License-Identifier: Apache-2.0
"""Abstract values, records and states at random."""

from __future__ import annotations

from typing import Final

from hypothesis import strategies as st

from rosward.domain.choice import join_all
from rosward.domain.compound import External, Native, Partial, Tuple
from rosward.domain.heap import Alternatives, Obj, ObjKind, fields_of
from rosward.domain.memory import Heap
from rosward.domain.series import Series
from rosward.domain.state import NOTHING_DONE, State
from rosward.domain.suspended import ANY_TURN, EACH, YIELD, PathStep, Point, Suspension, add_points
from rosward.domain.text import make
from rosward.domain.unknown import Cause, Origin, Reason
from rosward.domain.values import NONE, UNBOUND, Const, Function, Hole, ModuleValue, Ref, Unknown, Value
from rosward.ir.program import Code, CodeKind, Parameters
from rosward.location import Place

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


# Objects and states

attributes = st.dictionaries(st.sampled_from("xyz"), values, max_size=3)
CLASS: Final = Native("builtins.object")


@st.composite
def instances(draw: st.DrawFn, kind: ObjKind = "instance") -> Obj:
    attrs = draw(attributes)
    partial = frozenset(name for name in attrs if draw(st.booleans()))
    return Obj(kind, CLASS, attrs=attrs, many=draw(st.booleans()), partial=partial)


@st.composite
def members(draw: st.DrawFn) -> Obj:
    """Members of an enum that are numbers or texts too."""
    return draw(instances()).replace(payload=draw(values))


@st.composite
def exceptions(draw: st.DrawFn) -> Obj:
    arguments = Tuple(tuple(draw(st.lists(singles, max_size=2))))
    chained = draw(st.dictionaries(st.sampled_from(("__cause__", "__context__")), references, max_size=2))
    absent = frozenset(name for name in chained if draw(st.booleans()))
    return Obj("instance", CLASS, attrs={"args": arguments, **chained}, many=draw(st.booleans()), partial=absent)


@st.composite
def cells(draw: st.DrawFn) -> Obj:
    return Obj("cell", NONE, attrs=draw(st.one_of(st.just({}), values.map(lambda v: {"value": v}))))


@st.composite
def lists(draw: st.DrawFn, kind: ObjKind = "list", payload: object = None) -> Obj:
    elements = draw(st.sampled_from((values, references)))
    record = Obj(kind, CLASS, many=draw(st.booleans()), payload=payload)
    several = st.lists(elements, max_size=3)
    how = draw(st.sampled_from(("exact", "bag", "ends") if kind == "list" else ("exact", "bag")))
    if how == "exact":
        return record.replace(items=tuple(draw(several)))
    if how == "bag":
        return record.replace(items=None, rest=draw(st.one_of(st.none(), elements)))
    return record.replace(**fields_of(Series(tuple(draw(several)), draw(elements), tuple(draw(several))), kind))


@st.composite
def told_lists(draw: st.DrawFn) -> Obj:
    """Lists of objects, of which it is told which are in it, and which may be."""
    held = draw(st.lists(references, max_size=3, unique=True))
    if draw(st.booleans()):
        return Obj("list", CLASS, items=tuple(held))
    elements = tuple((value, draw(st.booleans())) for value in held)
    return Obj("list", CLASS, items=None, rest=join_all(held) if held else None, payload=Alternatives(elements))


@st.composite
def dicts(draw: st.DrawFn, variables: bool = False) -> Obj:
    keys: st.SearchStrategy[Value] = words.map(Const)
    entries = draw(st.dictionaries(keys, values, max_size=3))
    maybe = frozenset(k for k in entries if draw(st.booleans()))
    rest = draw(st.one_of(st.none(), values))
    key = draw(st.one_of(st.none(), unknowns)) if rest is not None else None
    record = Obj("dict", CLASS, entries=entries, maybe=maybe, rest=rest, rest_key=key, many=draw(st.booleans()))
    return record.replace(payload=draw(references)) if variables else record


REGISTERS: Final = 2
_NOTHING: Final = Parameters((), 0, None, (), None)
CODES: Final = tuple(
    Code(CodeKind.FUNCTION, name, name, "a.py", 1, _NOTHING, [], REGISTERS, (), (), (), is_generator=True, index=number)
    for number, name in enumerate(("one", "two"))
)
FUNCTIONS: Final = tuple(Function(code, ModuleValue(0, "m", "a.py"), (), (), ()) for code in CODES)


@st.composite
def _points(draw: st.DrawFn) -> tuple[Point, tuple[Value, ...]]:
    """A point, and what it holds: outside of loops, or in a turn of one, behind a `yield` or a `yield from`."""
    function = draw(st.sampled_from(FUNCTIONS))
    held = tuple(draw(st.lists(values, min_size=REGISTERS, max_size=REGISTERS)))
    where = draw(st.sampled_from(("start", "plain", "loop", "from")))
    if where == "start":
        return Point(function, 0, (), ()), held
    if where == "plain":
        return Point(function, 0, (), (PathStep(draw(st.integers(0, 2)), ""),)), held
    turn = draw(st.sampled_from((0, 1, ANY_TURN)))
    ahead = () if turn == ANY_TURN else tuple(draw(st.lists(values, max_size=2)))
    rest = draw(st.one_of(st.just(UNBOUND), values))
    path = (PathStep(0, EACH, turn), PathStep(0, "")) if where == "loop" else (PathStep(1, YIELD, turn),)
    return Point(function, 0, (), path), (*held, draw(references), Tuple(ahead), rest)


@st.composite
def suspensions(draw: st.DrawFn) -> Suspension:
    """As a run makes them: where a yield may be in any turn, that is the only one of its points."""
    points = add_points({}, dict(draw(st.lists(_points(), max_size=4))))
    return Suspension(points, ended=draw(st.booleans()), shared=draw(st.booleans()))


@st.composite
def generators(draw: st.DrawFn) -> Obj:
    return Obj("generator", NONE, payload=draw(suspensions()), many=draw(st.booleans()))


ROLES: Final[dict[str, st.SearchStrategy[Obj]]] = {
    "instance": instances(),
    "class": instances("class"),
    "module": instances("module"),
    "member": members(),
    "exception": exceptions(),
    "cell": cells(),
    "list": lists(),
    "told list": told_lists(),
    "lists of both kinds": st.one_of(lists(), told_lists()),
    "iterator": lists(payload="iterator"),
    "set": lists("set"),
    "dict": dicts(),
    "variables": dicts(variables=True),
    "generator": generators(),
}
"""All that a record may be. What is at one address keeps its role: the address belongs to a place, a context, a kind and a class."""

triples = st.sampled_from(sorted(ROLES)).flatmap(lambda role: st.tuples(*[ROLES[role]] * 3))


@st.composite
def states(draw: st.DrawFn, version: int = 1) -> State:
    """A state whose address n holds an object of one role: as in a run, an address never changes it."""
    heap = {address: draw(role) for address, role in enumerate(ROLES.values()) if draw(st.booleans())}
    done = draw(st.frozensets(st.sampled_from((("node", 1), ("node", 2), ("entity", 3))), max_size=2))
    return State(Heap(heap.items()), version, done or NOTHING_DONE)


two_states = st.tuples(states(version=1), states(version=2))
"""Of different versions: equal ones mean equal heaps."""
