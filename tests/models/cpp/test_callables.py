# SPDX-License-Identifier: Apache-2.0
"""Smart pointers, what can be called, threads, durations, type traits."""

from __future__ import annotations

import pytest

from models.cpp.fake_cpp import INT, STRING, CppMachine
from models.fake import REASON
from rosward.domain.choice import options
from rosward.domain.compound import External, Partial
from rosward.domain.slots import Pointer, TypeOf
from rosward.domain.values import FALSE, NONE, TRUE, Const, Unknown, Value
from rosward.models.cpp.constants import known_member, known_name
from rosward.models.cpp.values.copies import write
from rosward.models.cpp.values.slots import read
from rosward.models.cpp.values.traits import NO_TYPE

DOUBLE = TypeOf("double", ())
FIRST, SECOND = External("std.placeholders._1"), External("std.placeholders._2")


def joined(machine: CppMachine) -> Value:
    """A function that joins its arguments."""

    def join(*args: Value) -> Value:
        total: Value = Const("")
        for arg in args:
            total = machine.binary("+", total, arg)
        return total

    return machine.function("join", join)


def test_a_shared_value_has_one_place() -> None:
    machine = CppMachine()
    pointer = machine.function_of("make_shared", Const(5), types=(INT,))
    assert isinstance(pointer, Pointer)
    write(machine, pointer.target, Const(6))
    held = machine.variable(pointer)
    assert machine.method(held, "get") == Pointer(pointer.target)  # which owns nothing
    assert read(machine, pointer.target) == Const(6)
    machine.method(held, "reset")
    assert read(machine, held) == NONE


def test_a_weak_pointer_may_lead_nowhere() -> None:
    machine = CppMachine()
    pointer = machine.function_of("make_shared", Const(5), types=(INT,))
    assert set(options(machine.method(machine.variable(pointer), "lock"))) == {pointer, NONE}


def test_bind_puts_arguments_in_their_places() -> None:
    machine = CppMachine()
    function = joined(machine)
    in_order = machine.function_of("bind", function, Const("a"), FIRST)
    assert in_order == Partial(function, (Const("a"),), ())
    turned = machine.function_of("bind", function, SECOND, Const("-"), FIRST)
    assert machine.call(turned, (Const("x"), Const("y"), Const("z"))) == Const("y-x")


def test_bind_copies_what_is_not_referred_to() -> None:
    machine = CppMachine()
    name = machine.variable(Const("old"))
    copied = machine.function_of("bind", joined(machine), name)
    referred = machine.function_of("bind", joined(machine), machine.function_of("ref", name))
    write(machine, name, Const("new"))
    assert machine.call(copied, ()) == Const("old")
    assert machine.call(referred, ()) == Const("new")


def test_a_thread_is_scheduled_with_its_arguments() -> None:
    machine = CppMachine()
    function = joined(machine)
    machine.function_of("thread", function, Const("a"))
    future = machine.function_of("async", External("std.launch.async"), function, Const("b"))
    assert machine.scheduled == [Partial(function, (Const("a"),), ()), Partial(function, (Const("b"),), ())]
    assert machine.method(future, "get") == Const("b")


def test_an_atomic_is_its_value() -> None:
    machine = CppMachine()
    flag = machine.variable(machine.call(TypeOf("std.atomic", (INT,)), (Const(1),)))
    assert machine.method(flag, "fetch_add", Const(2)) == Const(1)
    machine.method(flag, "store", machine.binary("*", machine.method(flag, "load"), Const(2)))
    assert read(machine, flag) == Const(6)


def test_durations() -> None:
    machine = CppMachine()
    half = machine.call(External('std.operator""ms'), (Const(500),))
    total = machine.binary("+", machine.function_of("chrono.seconds", Const(1)), half)
    cast = machine.function_of("chrono.duration_cast", total, types=(External("std.chrono.milliseconds"),))
    assert machine.method(cast, "count") == Const(1500)
    assert machine.compare("<", half, total) == TRUE
    whole = machine.function_of("chrono.duration_cast", total, types=(External("std.chrono.seconds"),))
    assert machine.method(whole, "count") == Const(1)
    assert isinstance(machine.function_of("chrono.steady_clock.now"), Unknown)


@pytest.mark.parametrize(
    ("trait", "types", "expected"),
    [
        ("is_same_v", (STRING, STRING), True),
        ("is_same_v", (STRING, INT), False),
        ("is_integral_v", (TypeOf("unsigned long", ()),), True),
        ("is_floating_point_v", (INT,), False),
        ("is_base_of_v", (INT, STRING), False),
        ("conjunction_v", (External("std.true_type"), External("std.false_type")), False),
    ],
)
def test_questions_about_types(trait: str, types: tuple[Value, ...], *, expected: bool) -> None:
    assert known_name(f"std.{trait}", types) == Const(expected)


def test_types_that_were_deduced_may_be_others() -> None:
    assert isinstance(known_name("std.is_same_v", (INT, TypeOf("long", ()))), Unknown)
    assert isinstance(known_name("std.is_same_v", (Unknown((REASON,)), INT)), Unknown)


def test_types_made_of_types() -> None:
    assert known_name("std.decay_t", (TypeOf("reference", (STRING,)),)) == STRING
    assert known_name("std.conditional_t", (TRUE, INT, DOUBLE)) == INT
    assert known_name("std.enable_if_t", (FALSE, INT)) == NO_TYPE
    assert known_member(TypeOf("std.is_same", (INT, INT)), "value") == TRUE
    assert known_member(TypeOf("std.vector", (STRING,)), "value_type") == STRING


def test_limits_of_numbers() -> None:
    machine = CppMachine()

    def limit(type_: Value, name: str) -> Value:
        found = known_member(TypeOf("std.numeric_limits", (type_,)), name)
        assert found is not None
        return machine.call(found, ())

    assert limit(INT, "max") == Const(2**31 - 1)
    assert limit(External("uint8_t"), "max") == Const(255)
    assert limit(DOUBLE, "infinity") == Const(float("inf"))


def test_what_is_thrown_only_perhaps_goes_on() -> None:
    machine = CppMachine()
    machine.is_tried = True
    value = machine.function_of("stoi", Unknown((REASON,), "str"))
    assert machine.thrown == ["invalid_argument", "out_of_range"]
    assert isinstance(value, Unknown)
