# SPDX-License-Identifier: Apache-2.0
"""Whatever a program passes, and however much of it, a native gives a value: what makes no sense is not known."""

from __future__ import annotations

import random

import pytest

from models.cpp.fake_cpp import INT, NATIVES, STRING, CppMachine
from models.fake import REASON, text
from rosward.domain.choice import join
from rosward.domain.compound import External, TooManyPartsError, Tuple
from rosward.domain.heap import Obj
from rosward.domain.slots import Pointer, Slot, TypeOf
from rosward.domain.values import NONE, Const, Unknown, Value
from rosward.models.cpp import operators
from rosward.models.cpp.iteration import elements
from rosward.models.cpp.values import conversions, copies
from rosward.models.native import NativeCall, perform

OWN = sorted(name for name in NATIVES if name.startswith(("std.", "boost.", "absl.", "fmt.", "rcpputils.")))
TYPES = (
    INT,
    STRING,
    TypeOf("double", ()),
    TypeOf("char", ()),
    TypeOf("pointer", (INT,)),
    TypeOf("std.vector", (STRING,)),
    TypeOf("std.map", (STRING, INT)),
    TypeOf("std.set", (INT,)),
    TypeOf("std.pair", (INT, STRING)),
    TypeOf("std.optional", (INT,)),
    TypeOf("std.array", (INT, Const(2))),
    TypeOf("std.chrono.duration", (INT,)),
)
OPERATORS = ("+", "-", "*", "/", "%", "<<", ">>", "&", "==", "!=", "<", ">=", "<=>", "&&")


def pool(machine: CppMachine) -> list[Value]:
    """Values of every kind."""
    texts, table = TypeOf("std.vector", (STRING,)), TypeOf("std.map", (STRING, INT))
    containers = [
        machine.call(texts, (Tuple((Const("a"), Const("b"))),)),
        machine.call(table, (Tuple((Tuple((Const("a"), Const(1))),)),)),
        machine.call(TypeOf("std.set", (INT,)), (Tuple((Const(1),)),)),
        machine.call(TypeOf("std.multimap", (STRING, INT)), ()),
        machine.call(TypeOf("std.optional", (STRING,)), (Const("o"),)),
        machine.function_of("make_pair", Const("a"), Const(1)),
        machine.new_list((), join(Const("a"), Const("b"))),
        machine.call(External("std.stringstream"), (Const("a 1"),)),
        machine.call(External("std.ifstream"), (Const("/a"),)),
        machine.call(External("std.chrono.milliseconds"), (Const(5),)),
        machine.allocate(Obj("instance", External("demo.X"), {"a": Const(1)}), "x"),
    ]
    iterators = [
        machine.method(c, name) for c in (*containers[:3], containers[6]) for name in ("begin", "end", "rbegin")
    ]
    plain: list[Value] = [
        Const(v) for v in (0, 1, -1, 2**64 - 1, 2.5, float("nan"), True, None, "a", "", "/a/b.c", "%d", "{}")
    ]
    variables = [machine.variable(v) for v in (Const("abc"), Const(3), containers[0], Unknown((REASON,), "str"), NONE)]
    unknown: list[Value] = [text("a", "*"), *(Unknown((REASON,), hint) for hint in ("", "str", "int", "list"))]
    others: list[Value] = [
        Tuple(()),
        Tuple((Const("a"), Const(1))),
        External("std.nullopt"),
        External("std.hex"),
        External("std.tolower"),
        Pointer(containers[0]),
        Slot(containers[0], "item", Const(9)),
        Slot(containers[1], "entry", Const("a")),
        join(Const("a"), NONE),
        machine.function("first", lambda *args: args[0] if args else Const(0)),
        machine.function_of("ref", variables[0]),
    ]
    return [*containers, *iterators, *plain, *variables, *unknown, *others, *TYPES]


@pytest.mark.parametrize("seed", range(4))
def test_natives(seed: int) -> None:
    source, machine = random.Random(seed), CppMachine()
    values = pool(machine)
    for _ in range(2_500):
        name = source.choice(OWN)
        args = tuple(source.choices(values, k=source.choice((0, 1, 2, 2, 3, 3, 4, 5))))
        if name.endswith(".new"):
            args = (TypeOf(name.removesuffix(".new"), tuple(source.choices(TYPES, k=2))), *args)
        types: dict[str, Value] = {"types": Tuple(tuple(source.choices(TYPES, k=1)))} if source.random() < 0.4 else {}
        given = perform(NATIVES[name], NativeCall(machine, name, args, types))
        assert isinstance(given, Value), (name, args)


@pytest.mark.parametrize("seed", range(2))
def test_operators_and_conversions(seed: int) -> None:
    source, machine = random.Random(seed), CppMachine()
    values = pool(machine)
    for _ in range(1_500):
        left, right, type_ = source.choice(values), source.choice(values), source.choice(TYPES)
        try:
            operators.binary(machine, source.choice(OPERATORS), left, right)
        except TooManyPartsError:
            continue  # the engine knows what to do
        operators.unary(machine, source.choice("-+!~"), left)
        operators.truth(machine, left)
        conversions.convert(machine, left, type_)
        elements.elements(machine, left, slots=bool(seed))
        elements.parts(machine, left, 2, slots=bool(seed))
        copies.write(machine, left, copies.copied(machine, right))
