# SPDX-License-Identifier: Apache-2.0
"""Containers, iterators and algorithms: which elements are where?"""

from __future__ import annotations

from models.cpp.fake_cpp import INT, STRING, CppMachine
from models.fake import REASON, text
from rosward.domain.choice import join, options
from rosward.domain.compound import External, Tuple
from rosward.domain.slots import Pointer, Slot, TypeOf
from rosward.domain.values import FALSE, NONE, TRUE, Const, Ref, Unknown, Value
from rosward.models.cpp.iteration.elements import elements, parts
from rosward.models.cpp.values.copies import write
from rosward.models.cpp.values.slots import read

TEXTS = TypeOf("std.vector", (STRING,))
TABLE = TypeOf("std.map", (STRING, INT))
UNKNOWN = Unknown((REASON,), "str")


def vector(machine: CppMachine, *given: str | float, type_: Value = TEXTS) -> Ref:
    made = machine.call(type_, (Tuple(tuple(Const(each) for each in given)),))
    assert isinstance(made, Ref)
    return made


def table(machine: CppMachine, **given: int) -> Ref:
    made = machine.call(TABLE, (Tuple(tuple(Tuple((Const(k), Const(v))) for k, v in given.items())),))
    assert isinstance(made, Ref)
    return made


def plain(machine: CppMachine, value: Value) -> list[object]:
    """The constants that a container holds."""
    found = elements(machine, value, slots=False)
    assert isinstance(found, Tuple), found
    return [v.value if isinstance(v, Const) else v for v in found.items]


def ends(machine: CppMachine, container: Value) -> tuple[Value, Value]:
    return machine.method(container, "begin"), machine.method(container, "end")


def test_a_vector_keeps_copies() -> None:
    machine = CppMachine()
    lists = machine.call(TypeOf("std.vector", (TEXTS,)), ())
    inner = vector(machine, "a")
    machine.method(lists, "push_back", inner)
    machine.method(inner, "push_back", Const("b"))
    first = read(machine, machine.method(lists, "front"))
    assert plain(machine, first) == ["a"]
    assert first != inner


def test_elements_come_and_go() -> None:
    machine = CppMachine()
    v = vector(machine, "b", "c")
    machine.method(v, "insert", machine.method(v, "begin"), Const("a"))
    machine.method(v, "emplace_back", Const(2), Const("x"))
    assert plain(machine, v) == ["a", "b", "c", "xx"]
    where = machine.method(v, "erase", machine.binary("+", machine.method(v, "begin"), Const(1)))
    assert read(machine, where.target if isinstance(where, Pointer) else where) == Const("c")
    machine.method(v, "resize", Const(2))
    assert plain(machine, v) == ["a", "c"]


def test_at_is_checked_and_brackets_are_not() -> None:
    machine = CppMachine()
    v = vector(machine, "a")
    machine.method(v, "at", Const(1))
    assert machine.thrown == ["out_of_range"]
    assert isinstance(read(machine, machine.method(v, "operator[]", Const(1))), Unknown)
    assert machine.thrown == ["out_of_range"]


def test_an_index_that_is_not_known_is_any_element() -> None:
    machine = CppMachine()
    v = vector(machine, "a", "b")
    place = machine.method(v, "operator[]", Unknown((REASON,), "int"))
    assert read(machine, place) == join(Const("a"), Const("b"))
    write(machine, place, Const("c"))
    assert [set(options(read(machine, Slot(v, "item", Const(n))))) for n in (0, 1)] == [
        {Const("a"), Const("c")},
        {Const("b"), Const("c")},
    ]


def test_a_map_inserts_a_default() -> None:
    machine = CppMachine()
    m = table(machine)
    place = machine.method(m, "operator[]", Const("a"))
    assert read(machine, place) == Const(0)
    write(machine, place, Const(4))
    assert read(machine, machine.method(m, "at", Const("a"))) == Const(4)
    machine.method(m, "at", Const("z"))
    assert machine.thrown == ["out_of_range"]


def test_a_map_is_run_through_in_the_order_of_its_keys() -> None:
    machine = CppMachine()
    m = table(machine, b=2, a=1)
    here, stop = ends(machine, m)
    seen = []
    while machine.truth(machine.compare("!=", here, stop)):
        assert isinstance(here, Pointer)
        seen.append(parts(machine, here.target, 2, slots=False))
        here = machine.binary("+", here, Const(1))
    assert seen == [(Const("a"), Const(1)), (Const("b"), Const(2))]


def test_parts_of_an_entry_are_written_in_the_map() -> None:
    machine = CppMachine()
    m = table(machine, a=1)
    entry = elements(machine, m, slots=True)
    assert isinstance(entry, Tuple)
    _, value = parts(machine, entry.items[0], 2, slots=True)
    write(machine, value, Const(7))
    assert machine.obj(m).entries == {Const("a"): Const(7)}


def test_a_key_that_may_be_there() -> None:
    machine = CppMachine()
    m = table(machine, a=1)
    found = machine.method(m, "find", UNKNOWN)
    assert machine.truth(machine.compare("==", found, machine.method(m, "end"))) is None
    assert machine.method(m, "count", Const("a")) == Const(1)
    machine.method(m, "erase", UNKNOWN)
    assert machine.truth(machine.method(m, "count", Const("a"))) is None
    write(machine, machine.method(m, "operator[]", UNKNOWN), Const(5))
    assert set(options(read(machine, machine.method(m, "at", Const("a"))))) == {Const(0), Const(1), Const(5)}


def test_sets_are_in_order_and_have_each_key_once() -> None:
    machine = CppMachine()
    s = vector(machine, "b", "a", type_=TypeOf("std.set", (STRING,)))
    machine.method(s, "insert", Const("a"))
    machine.method(s, "insert", Const("c"))
    assert plain(machine, s) == ["a", "b", "c"]
    assert machine.method(s, "erase", Const("b")) == Const(1)
    machine.method(s, "insert", text("x", "*"))
    found = elements(machine, s, slots=False)
    assert isinstance(found, (Ref, Tuple))


def test_several_values_under_a_key() -> None:
    machine = CppMachine()
    many = machine.call(TypeOf("std.multimap", (STRING, INT)), ())
    for value in (1, 2):
        machine.method(many, "emplace", Const("k"), Const(value))
    machine.method(many, "emplace", Const("a"), Const(0))
    both = parts(machine, machine.method(many, "equal_range", Const("k")), 2, slots=False)
    assert machine.function_of("distance", *both) == Const(2)
    assert machine.method(many, "count", Const("a")) == Const(1)


def test_algorithms_on_constants() -> None:
    machine = CppMachine()
    v = vector(machine, "b", "a", "b")
    machine.function_of("sort", *ends(machine, v))
    assert plain(machine, v) == ["a", "b", "b"]
    assert machine.function_of("count", *ends(machine, v), Const("b")) == Const(2)
    last = machine.function_of("unique", *ends(machine, v))
    machine.method(v, "erase", last, machine.method(v, "end"))
    machine.function_of("reverse", *ends(machine, v))
    assert plain(machine, v) == ["b", "a"]
    assert machine.function_of("accumulate", *ends(machine, v), Const("")) == Const("ba")
    out = vector(machine)
    machine.function_of("copy", *ends(machine, v), machine.function_of("back_inserter", out))
    assert plain(machine, out) == ["b", "a"]


def test_algorithms_ask_what_they_are_given() -> None:
    machine = CppMachine()
    v = vector(machine, 1, 2, 3, type_=TypeOf("std.vector", (INT,)))
    even = machine.function("even", lambda x: machine.compare("==", machine.binary("%", x, Const(2)), Const(0)))
    assert machine.function_of("any_of", *ends(machine, v), even) == TRUE
    assert machine.function_of("all_of", *ends(machine, v), even) == FALSE
    where = machine.function_of("find_if", *ends(machine, v), even)
    assert machine.function_of("distance", machine.method(v, "begin"), where) == Const(1)
    last = machine.function_of("remove_if", *ends(machine, v), even)
    machine.method(v, "erase", last, machine.method(v, "end"))
    assert plain(machine, v) == [1, 3]


def test_algorithms_on_whole_containers() -> None:
    machine = CppMachine()
    v = vector(machine, "c", "a", "b")
    machine.function_of("ranges.sort", v)
    machine.function_of("erase", v, Const("b"))
    assert plain(machine, v) == ["a", "c"]
    m = table(machine, a=1, b=2)
    second = machine.function("second", lambda e: machine.compare("==", parts(machine, e, 2, slots=False)[1], Const(2)))
    machine.function_of("erase_if", m, second)
    assert machine.obj(m).entries == {Const("a"): Const(1)}


def test_what_is_not_known_is_asked_once_and_may_be_so() -> None:
    machine = CppMachine()
    names = machine.new_list((), join(Const("a"), Const("b")))
    asked: list[Value] = []

    def note(value: Value) -> Value:
        asked.append(read(machine, value))
        return Unknown((REASON,), "bool")

    found = machine.function_of("find_if", *ends(machine, names), machine.function("note", note))
    assert len(asked) == 1
    assert machine.truth(machine.compare("==", found, machine.method(names, "end"))) is None
    assert isinstance(machine.method(names, "size"), Unknown)


def test_iterators_step_to_the_end_and_back() -> None:
    machine = CppMachine()
    v = vector(machine, "a", "b")
    start, stop = ends(machine, v)
    assert machine.binary("+", start, Const(2)) == stop
    back = machine.function_of("prev", stop)
    assert isinstance(back, Pointer)
    assert read(machine, back.target) == Const("b")
    assert machine.binary("-", stop, start) == Const(2)
    reverse = machine.method(v, "rbegin")
    assert isinstance(reverse, Pointer)
    assert read(machine, reverse.target) == Const("b")
    assert machine.binary("+", reverse, Const(2)) == machine.method(v, "rend")


def test_pairs_tuples_and_optionals() -> None:
    machine = CppMachine()
    pair = machine.function_of("make_pair", Const("a"), Const(1))
    assert parts(machine, pair, 2, slots=False) == (Const("a"), Const(1))
    triple = machine.function_of("make_tuple", Const("a"), Const(1), Const(2))
    assert read(machine, machine.function_of("get", triple, types=(Const(1),))) == Const(1)
    name = machine.call(TypeOf("std.optional", (STRING,)), ())
    assert machine.method(name, "value_or", Const("x")) == Const("x")
    machine.method(name, "emplace", Const("y"))
    assert read(machine, machine.method(name, "value")) == Const("y")
    machine.method(name, "reset")
    machine.method(name, "value")
    assert machine.thrown == ["bad_optional_access"]


def test_a_variant_is_what_it_holds() -> None:
    machine = CppMachine()
    held = machine.variable(Const("a"))
    assert machine.function_of("holds_alternative", held, types=(STRING,)) == TRUE
    assert machine.function_of("holds_alternative", held, types=(INT,)) == FALSE
    assert machine.function_of("get_if", Pointer(held), types=(INT,)) == NONE
    assert read(machine, machine.function_of("get", held, types=(STRING,))) == Const("a")
    assert machine.call(External("std.any_cast"), (held,)) == Const("a")
