# SPDX-License-Identifier: Apache-2.0
"""Slots, copies, conversions and operators: what values of C++ are."""

from __future__ import annotations

import pytest

from models.cpp.fake_cpp import INT, STRING, CppMachine
from models.fake import REASON, text
from rosward.domain.choice import join
from rosward.domain.compound import External, Tuple
from rosward.domain.heap import Obj
from rosward.domain.slots import Pointer, Slot, TypeOf
from rosward.domain.values import FALSE, NONE, TRUE, Const, Ref, Unknown, Value
from rosward.models.cpp.values.conversions import convert, default_value
from rosward.models.cpp.values.copies import assigned, copied, write
from rosward.models.cpp.values.slots import read

DOUBLE = TypeOf("double", ())
CHAR = TypeOf("char", ())
TEXTS = TypeOf("std.vector", (STRING,))


def items(machine: CppMachine, value: Value) -> list[object]:
    """What constants a list holds."""
    held = read(machine, value)
    assert isinstance(held, Ref)
    return [v.value for v in machine.obj(held).items or () if isinstance(v, Const)]


def lamp(machine: CppMachine, **fields: Value) -> Ref:
    """An object that is neither a pair nor a message."""
    return machine.allocate(Obj("instance", TypeOf("demo.Lamp", ()), fields), tuple(fields.values()))


def test_a_variable_is_written_and_read() -> None:
    machine = CppMachine()
    place = machine.variable(Const(1))
    write(machine, place, Const(2))
    assert read(machine, place) == Const(2)
    write(machine, place, Const(3), weak=True)
    assert read(machine, place) == join(Const(2), Const(3))


def test_a_copy_has_parts_of_its_own_and_shares_what_pointers_lead_to() -> None:
    machine = CppMachine()
    shared = lamp(machine, on=TRUE)
    inner = machine.new_list((Const(1),))
    original = lamp(machine, list=inner, other=Pointer(shared))
    copy = copied(machine, original)
    assert isinstance(copy, Ref)
    assert copy != original
    assert machine.obj(copy).attrs["list"] != inner
    assert machine.obj(copy).attrs["other"] == Pointer(shared)
    write(machine, Slot(copy, "field", "list"), Const(None))
    assert machine.obj(original).attrs["list"] == inner


def test_an_object_stays_where_it_is_when_another_is_assigned() -> None:
    machine = CppMachine()
    left, right = lamp(machine, on=FALSE), lamp(machine, on=TRUE)
    assigned(machine, left, right)
    assert machine.obj(left).attrs["on"] == TRUE
    assigned(machine, left, Unknown((REASON,)))
    assert isinstance(machine.obj(left).attrs["on"], Unknown)


def test_a_character_of_a_string_is_written_in_its_slot() -> None:
    machine = CppMachine()
    name = machine.variable(Const("a/b"))
    write(machine, Slot(name, "item", Const(1)), Const("_"))
    assert read(machine, name) == Const("a_b")
    write(machine, Slot(name, "item", Unknown((REASON,), "int")), Const("x"))
    assert isinstance(read(machine, name), Unknown)


@pytest.mark.parametrize(
    ("type_", "value", "expected"),
    [
        (INT, Const(2.9), 2),
        (INT, Const("a"), 97),
        (INT, Const(2**64 - 1), -1),
        (DOUBLE, Const(1), 1.0),
        (TypeOf("float", ()), Const(0.1), 0.10000000149011612),
        (CHAR, Const(97), "a"),
        (TypeOf("bool", ()), Const(3), True),
        (STRING, Tuple((Const("a"), Const("b"))), "ab"),
        (TypeOf("array", (CHAR, Const(8))), Const("abc"), "abc"),
    ],
)
def test_numbers_and_texts_are_converted(type_: Value, value: Value, expected: object) -> None:
    assert convert(CppMachine(), value, type_) == Const(expected)  # type: ignore[arg-type]  # one of the plain ones


def test_braces_become_containers() -> None:
    machine = CppMachine()
    assert items(machine, convert(machine, Tuple((Const("a"), Const("b"))), TEXTS)) == ["a", "b"]
    nested = TypeOf("std.array", (INT, Const(3)))
    assert items(machine, convert(machine, Tuple((Tuple((Const(1), Const(2))),)), nested)) == [1, 2, 0]
    unique = TypeOf("std.set", (STRING,))
    assert items(machine, convert(machine, Tuple((Const("b"), Const("a"), Const("b"))), unique)) == ["a", "b"]
    table = convert(machine, Tuple((Tuple((Const("k"), Const(1))),)), TypeOf("std.map", (STRING, DOUBLE)))
    assert isinstance(table, Ref)
    assert machine.obj(table).entries == {Const("k"): Const(1.0)}


def test_defaults() -> None:
    machine = CppMachine()
    assert default_value(machine, INT) == Const(0)
    assert default_value(machine, STRING) == Const("")
    assert default_value(machine, TypeOf("std.shared_ptr", (INT,))) == NONE
    assert items(machine, default_value(machine, TypeOf("std.array", (INT, Const(2))))) == [0, 0]


@pytest.mark.parametrize(
    ("left", "operator", "right", "expected"),
    [
        (7, "/", 2, 3),
        (-7, "/", 2, -3),
        (-7, "%", 3, -1),
        (7.0, "/", 2, 3.5),
        (1, "<<", 4, 16),
        (2**64 - 1, "+", 1, 0),
        ("c", "-", "0", 51),
        ("a", "+", 1, 98),
        ("ab", "+", "c", "abc"),
        ("abc", "+", 1, "bc"),
        ("/a", "/", "b", "/a/b"),
        (-1, "==", 2**64 - 1, True),
        ("a", "<", "b", True),
        ("a", "==", 97, True),
    ],
)
def test_operators(left: str | float, operator: str, right: str | float, expected: object) -> None:
    machine = CppMachine()
    assert machine.binary(operator, Const(left), Const(right)) == Const(expected)  # type: ignore[arg-type]  # as above


def test_what_is_not_known_keeps_its_type_and_what_is_known_of_it() -> None:
    machine = CppMachine()
    number = Unknown((REASON,), "int")
    assert machine.binary("+", number, Const(1)) == Unknown((REASON,), "int")
    assert machine.binary("+", Const("/a"), text("*")) == text("/a", "*")
    assert isinstance(machine.binary("/", Const(1), Const(0)), Unknown)


def test_pointers_are_compared_by_where_they_lead() -> None:
    machine = CppMachine()
    one, other = Pointer(lamp(machine, a=TRUE)), Pointer(lamp(machine, b=TRUE))
    assert machine.compare("==", one, one) == TRUE
    assert machine.compare("==", one, other) == FALSE
    assert machine.compare("!=", one, NONE) == TRUE
    assert machine.truth(one) is True
    assert machine.truth(NONE) is False


def test_an_optional_counts_as_whether_it_holds_something() -> None:
    machine = CppMachine()
    type_ = TypeOf("std.optional", (STRING,))
    empty, full = (convert(machine, v, type_) for v in (External("std.nullopt"), Const("a")))
    assert machine.truth(empty) is False
    assert machine.truth(full) is True
    assert machine.compare("==", full, Const("a")) == TRUE
    assert machine.compare("==", empty, External("std.nullopt")) == TRUE
