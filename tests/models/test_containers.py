# SPDX-License-Identifier: Apache-2.0
"""Promise: after any operations the abstract list, dict or set covers Python's own, and so does every result.

Arguments are known, one of several, or unknown: then the concrete run takes any value that the abstract one stands for.
"""

from __future__ import annotations

from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from models.fake import REASON, FakeMachine, abstract, covers
from rosward.domain.choice import join_all
from rosward.domain.compound import Slice, Tuple
from rosward.domain.text import make
from rosward.domain.unknown import Origin
from rosward.domain.values import NONE, UNBOUND, Const, Hole, Ref, Unknown, Value
from rosward.models.python.containers.tables import key_of

texts = st.sampled_from(["a", "b", "ab", "c"])


def _known(value: object) -> tuple[Value, object]:
    return (Const(value), value)  # type: ignore[arg-type]


@st.composite
def arguments(draw: st.DrawFn, strategy: st.SearchStrategy[Any]) -> tuple[Value, Any]:
    """An abstract value and one of those it stands for."""
    value = draw(strategy)
    way = draw(st.integers(0, 5))
    if way <= 2:
        return Const(value), value
    if way == 3:
        return join_all((Const(value), Const(draw(strategy)))), value
    if way == 4 and isinstance(value, str):
        return make((value[:1], Hole((REASON,)))), value
    return Unknown((REASON,)), value


elements = arguments(texts | st.integers(0, 2))
indices = arguments(st.integers(-3, 3))
keys = arguments(texts)
Step = tuple[str, tuple[tuple[Value, Any], ...]]


def steps(table: dict[str, tuple[st.SearchStrategy[tuple[Value, Any]], ...]]) -> st.SearchStrategy[list[Step]]:
    one = st.sampled_from(sorted(table)).flatmap(lambda n: st.tuples(st.just(n.split("(")[0]), st.tuples(*table[n])))
    return st.lists(one, max_size=8)


@st.composite
def listings(draw: st.DrawFn) -> tuple[Value, Any]:
    """A tuple of elements, to extend or update with."""
    members = draw(st.lists(elements, max_size=3))
    return Tuple(tuple(m[0] for m in members)), tuple(m[1] for m in members)


LIST = {
    "append": (elements,), "extend": (listings(),), "insert": (indices, elements), "pop()": (), "pop": (indices,),
    "remove": (elements,), "clear": (), "index": (elements,), "count": (elements,), "reverse": (), "copy": (),
    "sort": (),
    "__setitem__": (indices, elements), "__getitem__": (indices,), "__contains__": (elements,), "__len__": (),
}  # fmt: skip
DICT = {
    "get": (keys,), "get()": (keys, elements), "__setitem__": (keys, elements), "__getitem__": (keys,), "pop": (keys,),
    "pop()": (keys, elements), "setdefault": (keys, elements), "popitem": (), "clear": (), "copy": (), "keys": (),
    "values": (), "items": (), "__contains__": (keys,), "__len__": (),
}  # fmt: skip
SET = {
    "add": (elements,), "discard": (elements,), "remove": (elements,), "clear": (), "copy": (), "union": (listings(),),
    "intersection": (listings(),), "difference": (listings(),), "symmetric_difference": (listings(),),
    "update": (listings(),), "difference_update": (listings(),), "intersection_update": (listings(),),
    "symmetric_difference_update": (listings(),), "issubset": (listings(),), "issuperset": (listings(),),
    "isdisjoint": (listings(),), "__contains__": (elements,), "__len__": (),
}  # fmt: skip


def agree(kind: str, start: Any, sequence: list[Step]) -> None:
    """Run both, and compare after each step."""
    machine = FakeMachine()
    ref, concrete = abstract(machine, start), start
    for name, args in sequence:
        before = machine.heap[ref.address] if isinstance(ref, Ref) else None
        try:
            expected = getattr(concrete, name)(*(a[1] for a in args))
        except (IndexError, KeyError, ValueError, TypeError):
            return  # the path ends here
        result = machine.native(f"{kind}.{name}", ref, *(a[0] for a in args))
        if type(expected).__name__ in ("dict_keys", "dict_values", "dict_items"):
            expected = list(expected)
        note = (name, args, before, result, expected)
        assert result is not UNBOUND, note
        assert covers(machine, result, expected), note
        assert covers(machine, ref, concrete), (note, concrete)


@given(start=st.lists(texts, max_size=3), sequence=steps(LIST))
def test_lists(start: list[Any], sequence: list[Step]) -> None:
    agree("list", start, sequence)


@given(start=st.dictionaries(texts, st.integers(0, 2), max_size=3), sequence=steps(DICT))
def test_dicts(start: dict[Any, Any], sequence: list[Step]) -> None:
    agree("dict", start, sequence)


@given(start=st.sets(texts, max_size=3), sequence=steps(SET))
def test_sets(start: set[Any], sequence: list[Step]) -> None:
    agree("set", start, sequence)


tables = st.dictionaries(texts, st.integers(0, 2), max_size=3)


@given(start=tables, other=st.lists(st.tuples(keys, elements), max_size=3))
def test_update_merges_pairs_and_dicts(start: dict[Any, Any], other: list[Any]) -> None:
    machine = FakeMachine()
    ref, concrete = abstract(machine, start), dict(start)
    pairs = Tuple(tuple(Tuple((k[0], v[0])) for k, v in other))
    machine.native("dict.update", ref, pairs)
    concrete.update((k[1], v[1]) for k, v in other)
    assert covers(machine, ref, concrete)
    made = machine.native("builtins.dict", pairs, x=Const(1))
    assert covers(machine, made, {**{k[1]: v[1] for k, v in other}, "x": 1})
    merged = machine.binary("|", made, ref)
    assert covers(machine, merged, {**{k[1]: v[1] for k, v in other}, "x": 1, **concrete})


slices = st.tuples(*(st.none() | st.integers(-3, 3),) * 2)


@given(start=st.lists(texts, max_size=4), bounds=slices, step=st.sampled_from((None, 1, 2, -1)), new=listings())
def test_slices_of_lists(start: list[Any], bounds: tuple[Any, Any], step: int | None, new: tuple[Value, Any]) -> None:
    machine = FakeMachine()
    ref, index = abstract(machine, start), Slice(Const(bounds[0]), Const(bounds[1]), Const(step))
    assert covers(machine, machine.load_item(ref, index), start[bounds[0] : bounds[1] : step])
    assert covers(
        machine, machine.load_item(Tuple(tuple(map(Const, start))), index), tuple(start[bounds[0] : bounds[1] : step])
    )
    assert covers(machine, machine.load_item(ref, Slice(Unknown((REASON,)), NONE, NONE)), start[bounds[0] :])
    changed = list(start)
    changed[bounds[0] : bounds[1]] = new[1]
    machine.store_item(ref, Slice(Const(bounds[0]), Const(bounds[1]), NONE), new[0])
    assert covers(machine, ref, changed)
    del changed[bounds[0] : bounds[1]]
    machine.native("list.pop", ref, Slice(Const(bounds[0]), Const(bounds[1]), NONE))
    assert covers(machine, ref, changed)


# By example


def test_get_with_an_unknown_key_joins_all() -> None:
    machine = FakeMachine()
    table = abstract(machine, {"a": 1, "b": 2})
    found = machine.native("dict.get", table, Unknown((REASON,)))
    assert found == join_all((Const(1), Const(2), NONE))
    narrowed = machine.native("dict.get", table, make(("a", Hole((REASON,)))))
    assert narrowed == join_all((Const(1), NONE))


def test_a_default_key_leaves_its_origin_on_the_value() -> None:
    machine = FakeMachine()
    origin = frozenset({Origin("parameter", "mode")})
    table = abstract(machine, {"sim": "/sim/scan", "real": "/scan"})
    assert machine.load_item(table, Const("sim", origin)) == Const("/sim/scan", origin)
    machine.store_item(table, Const("sim", origin), Const("/x"))
    assert machine.load_item(table, Const("sim")) == Const("/x")


def test_weak_writes_keep_the_old_value() -> None:
    machine = FakeMachine()
    one, two = abstract(machine, {"a": 1}), abstract(machine, ["x"])
    machine.store_item(join_all((one, two)), join_all((Const("a"), Const("z"))), Const(9))
    assert machine.load_item(one, Const("a")) == join_all((Const(1), Const(9)))
    assert covers(machine, one, {"a": 1, "z": 9})
    assert covers(machine, one, {"a": 9})


def test_a_missing_key_ends_the_path() -> None:
    machine = FakeMachine()
    assert machine.load_item(abstract(machine, {"a": 1}), Const("b")) is UNBOUND
    assert machine.native("list.pop", abstract(machine, [])) is UNBOUND
    assert machine.native("dict.pop", abstract(machine, {}), Const("k")) is UNBOUND
    assert machine.native("set.remove", abstract(machine, set()), Const("k")) is UNBOUND
    assert machine.deaths == ["KeyError", "IndexError", "KeyError", "KeyError"]


def test_sort_by_key() -> None:
    machine = FakeMachine()
    names = abstract(machine, ["bb", "a", "ccc"])
    by_length = machine.function("key", lambda v: Const(len(str(v.value))))
    machine.native("list.sort", names, key=by_length, reverse=Const(True))
    assert covers(machine, names, ["ccc", "bb", "a"])
    mixed = machine.new_list([Unknown((REASON,), "str"), Const("a")])
    machine.native("list.sort", mixed)
    assert covers(machine, mixed, ["a", "q"])
    machine.native("list.sort", abstract(machine, ["a", 1]))
    assert machine.deaths == ["TypeError"]


@pytest.mark.parametrize(
    ("value", "key"),
    [
        (Const("a", frozenset({Origin("parameter", "p")})), Const("a")),
        (Tuple((Const("a"), Const(1))), Tuple((Const("a"), Const(1)))),
        (Ref(3), Ref(3)),
        (Unknown(()), None),
        (Tuple((Unknown(()),)), None),
        (join_all((Const(1), Const(2))), None),
    ],
)
def test_key_of(value: Value, key: Value | None) -> None:
    assert key_of(value) == key


def test_from_keys_and_frozen_sets() -> None:
    machine = FakeMachine()
    made = machine.native("dict.fromkeys", Tuple((Const("a"), Const("b"))), Const(0))
    assert covers(machine, made, {"a": 0, "b": 0})
    frozen = machine.native("builtins.frozenset", Tuple((Const("a"), Const("a"))))
    assert covers(machine, machine.binary("|", frozen, abstract(machine, {"b"})), {"a", "b"})
    assert machine.native("builtins.len", frozen) == Const(1)
