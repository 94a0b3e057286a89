# SPDX-License-Identifier: Apache-2.0
"""Promise: operators, comparisons, truth, iteration and builtin functions cover what Python computes."""

from __future__ import annotations

import operator
import time
from collections.abc import Callable
from typing import Any

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from sampling import sample

from models.fake import NATIVES, REASON, FakeMachine, abstract, covers, text
from models.test_strings import fillings, outcome
from rosward.domain.choice import join_all
from rosward.domain.compound import Descriptor, External, Native, Range, Slice, Tuple
from rosward.domain.unknown import Cause, Origin
from rosward.domain.values import FALSE, NONE, TRUE, UNBOUND, Const, Ref, Text, Unknown, Value
from rosward.models.native import Items
from rosward.models.python.operators.operators import unary

OPERATORS: dict[str, Any] = {
    "+": operator.add, "-": operator.sub, "*": operator.mul, "/": operator.truediv, "//": operator.floordiv,
    "%": operator.mod, "**": operator.pow, "<<": operator.lshift, ">>": operator.rshift, "&": operator.and_,
    "|": operator.or_, "^": operator.xor,
}  # fmt: skip
COMPARISONS: dict[str, Any] = {
    "==": operator.eq, "!=": operator.ne, "<": operator.lt, "<=": operator.le, ">": operator.gt, ">=": operator.ge,
    "in": lambda a, b: a in b, "not-in": lambda a, b: a not in b,
}  # fmt: skip
atoms = (
    st.none()
    | st.booleans()
    | st.integers(-5, 9)
    | st.sampled_from((0.5, 2.0))
    | st.text(alphabet="ab%s", max_size=3)
    | st.just(b"x")
)
objects = st.recursive(
    atoms,
    lambda inner: (
        st.lists(inner, max_size=3)
        | st.tuples(inner, inner)
        | st.dictionaries(st.sampled_from("ab"), inner, max_size=2)
        | st.sets(st.sampled_from("abc"), max_size=3)
    ),
    max_leaves=5,
)


@st.composite
def operands(draw: st.DrawFn) -> tuple[FakeMachine, Value, Any, Value, Any]:
    """Two abstract values on one machine, each with one of the objects that it stands for."""
    machine = FakeMachine()
    found: list[Any] = []
    for _ in range(2):
        way = draw(st.integers(0, 6))
        concrete: Any
        if way == 6:
            value, concrete = draw(fillings())
        else:
            concrete = draw(objects)
            value = abstract(machine, concrete)
            if way == 4:
                value = join_all((value, abstract(machine, draw(objects))))
            elif way == 5:
                value = Unknown((REASON,), concrete.__class__.__name__ if draw(st.booleans()) else "")
        found += [value, concrete]
    return (machine, *found)


@given(both=operands(), op=st.sampled_from(sorted(OPERATORS)))
def test_binary_covers(both: tuple[FakeMachine, Value, Any, Value, Any], op: str) -> None:
    machine, left, a, right, b = both
    assume(not (op in ("**", "<<") and isinstance(b, int) and b > 9))
    expected = outcome(OPERATORS[op], a, b)
    result = machine.binary(op, left, right)
    if result is UNBOUND:
        assert isinstance(expected, type), expected
    elif not isinstance(expected, type):
        assert covers(machine, result, expected), (result, expected)


@given(both=operands(), op=st.sampled_from(sorted(COMPARISONS)))
def test_compare_covers(both: tuple[FakeMachine, Value, Any, Value, Any], op: str) -> None:
    machine, left, a, right, b = both
    expected = outcome(COMPARISONS[op], a, b)
    result = machine.compare(op, left, right)
    if result is UNBOUND:
        assert isinstance(expected, type), expected
    elif not isinstance(expected, type):
        assert covers(machine, result, expected), (result, expected)


@given(both=operands())
def test_single_values_are_covered(both: tuple[FakeMachine, Value, Any, Value, Any]) -> None:
    machine, value, concrete, *_ = both
    truth = machine.truth(value)
    assert truth is None or truth is bool(concrete)
    for op, python in (("not", operator.not_), ("-", operator.neg), ("~", operator.invert), ("+", operator.pos)):
        expected = outcome(python, concrete)
        result = unary(machine, op, value)
        assert isinstance(expected, type) or covers(machine, result, expected)
    for name in ("len", "str", "bool", "int", "float", "list", "tuple", "set", "sorted", "repr", "abs", "type"):
        expected = outcome(getattr(__builtins__, name, None) or __builtins__[name], concrete)  # type: ignore[index]
        result = machine.native(f"builtins.{name}", value)
        if name == "type":
            known = Native(f"builtins.{concrete.__class__.__name__}")
            assert any(o == known or isinstance(o, Unknown) for o in options(result))
        elif isinstance(expected, type) or (
            isinstance(concrete, (set, dict)) and name in ("list", "tuple", "str", "repr")
        ):
            continue  # it raises, or gives the order of a set
        else:
            assert covers(machine, result, expected), (name, result, expected)


def options(value: Value) -> tuple[Value, ...]:
    return tuple(getattr(value, "options", (value,)))


@given(both=operands())
def test_iteration_covers(both: tuple[FakeMachine, Value, Any, Value, Any]) -> None:
    machine, value, concrete, *_ = both
    expected = outcome(list, concrete)
    items = machine.iterate(value)
    if isinstance(expected, type) or isinstance(concrete, set):
        return
    assert covers(machine, machine.new_list(*items), expected)


columns = st.lists(st.lists(st.integers(0, 5), max_size=4), min_size=1, max_size=3)


@given(lists=columns, cut=st.integers(0, 4))
def test_functions_over_iterables_cover(lists: list[list[int]], cut: int) -> None:
    machine = FakeMachine()
    double = machine.function("double", lambda v: machine.binary("*", v, Const(2)))
    odd = machine.function("odd", lambda v: machine.binary("%", v, Const(2)))
    for rest in (False, True):
        values = []
        for numbers in lists:
            tail = [Const(n) for n in numbers[cut:]]
            loose = rest and tail
            values.append(
                machine.new_list(map(Const, numbers[:cut] if loose else numbers), join_all(tail) if loose else None)
            )
        first, numbers = values[0], lists[0]
        cases = {
            "zip": (tuple(values), list(zip(*lists, strict=False))),
            "enumerate": ((first, Const(1)), list(enumerate(numbers, 1))),
            "map": ((double, first), [n * 2 for n in numbers]),
            "filter": ((odd, first), [n for n in numbers if n % 2]),
            "sorted": ((first,), sorted(numbers)),
            "reversed": ((first,), numbers[::-1]),
            "sum": ((first,), sum(numbers)),
            "any": ((first,), any(numbers)),
            "all": ((first,), all(numbers)),
            "min": ((first,), min(numbers, default=None)),
            "max": ((first,), max(numbers, default=None)),
            "len": ((first,), len(numbers)),
            "tuple": ((first,), tuple(numbers)),
        }
        for name, (args, expected) in cases.items():
            keywords = {"default": NONE} if name in ("min", "max") else {}
            result = machine.native(f"builtins.{name}", *args, **keywords)
            assert covers(machine, result, expected), (name, result, expected)


def test_iterators_are_used_up() -> None:
    machine = FakeMachine()
    it = machine.native("builtins.iter", abstract(machine, ["a", "b"]))
    assert machine.native("builtins.iter", it) == it
    assert [machine.native("builtins.next", it) for _ in "ab"] == [Const("a"), Const("b")]
    assert machine.native("builtins.next", it, NONE) == NONE
    assert machine.native("builtins.next", it) is UNBOUND
    assert machine.deaths == ["StopIteration"]


@pytest.mark.parametrize(
    ("op", "left", "right"),
    [
        ("**", 10, 10**8),
        ("**", 10**100, 10**3),
        ("*", "a", 10**9),
        ("*", b"a", 10**9),
        ("<<", 1, 10**9),
        ("*", 10**9, "ab"),
    ],
)
def test_nothing_huge_is_computed(op: str, left: Any, right: Any) -> None:
    machine, start = FakeMachine(), time.process_time()
    result = machine.binary(op, Const(left), Const(right))
    assert isinstance(result, Unknown)
    assert result.reasons[0].cause is Cause.LIMIT
    machine.binary("*", abstract(machine, ["a"]), Const(10**12))
    machine.iterate(Range(Const(0), Const(10**15), Const(1)))
    machine.native("builtins.pow", Const(10), Const(10**9))
    machine.native("builtins.eval", Const("(" * 5000))
    machine.native("builtins.bytes", Const(10**10))
    machine.native("builtins.int", Const("9" * 100_000))
    assert time.process_time() - start < 5


def test_growth_is_bounded() -> None:
    machine = FakeMachine()
    value: Value = Const("ab")
    number: Value = Const(3)
    for _ in range(40):
        value = machine.binary("+", value, value)
        number = machine.binary("*", number, number)
    assert isinstance(value, (Text, Unknown))
    assert isinstance(number, Unknown)


def test_alternatives_of_lists_make_one_list() -> None:
    """Else `x = x + [y]` would make one list more in each turn of a loop."""
    machine = FakeMachine()
    one, two, three = (abstract(machine, v) for v in (["a"], ["b"], ["c", "d"]))
    before = len(machine.heap)
    same = machine.binary("+", join_all((one, two)), three)
    assert isinstance(same, Ref)
    assert machine.obj(same).items == (join_all((Const("a"), Const("b"))), Const("c"), Const("d"))
    longer = machine.load_item(join_all((one, three)), Slice(NONE, NONE, NONE))
    assert covers(machine, longer, ["a"])
    assert covers(machine, longer, ["c", "d"])
    assert len(machine.heap) == before + 2


def test_defaults_go_both_ways_but_keep_their_origin() -> None:
    machine = FakeMachine()
    origin = frozenset({Origin("parameter", "mode")})
    mode = Const("sim", origin)
    result = machine.compare("==", mode, Const("sim"))
    assert result == Const(True, origin)
    assert machine.truth(result) is None
    assert machine.truth(mode) is None
    assert machine.truth(Const("sim", frozenset({Origin("parameter", "mode", settled=True)}))) is True
    assert machine.compare("in", mode, abstract(machine, ["sim", "real"])) == Const(True, origin)
    numbers = machine.iterate(Range(Const(0), Const(2, origin), Const(1)))
    assert numbers == Items((Const(0, origin), Const(1, origin)))
    assert machine.native("builtins.bool", mode) == Const(True, origin)


@pytest.mark.parametrize(
    ("op", "left", "right", "result"),
    [
        ("==", text("/robot_", "*"), Const("/base"), FALSE),
        ("==", text("*", "/cmd"), Const("/base/odom"), FALSE),
        ("!=", text("/robot_", "*"), Const("/base"), TRUE),
        ("==", text("/a", "*"), text("/b", "*"), FALSE),
        ("==", text("/a", "*"), NONE, FALSE),
        ("in", Const("robot"), text("/robot_", "*"), TRUE),
        ("in", Const(5), Range(Const(0), Const(9), Const(1)), TRUE),
        ("not-in", Const("a"), Tuple((Const("b"), text("c", "*"))), TRUE),
        ("==", Unknown((), "int"), Const("a"), FALSE),
    ],
)
def test_decided_comparisons(op: str, left: Value, right: Value, result: Value) -> None:
    assert FakeMachine().compare(op, left, right) == result


@pytest.mark.parametrize(
    ("op", "left", "right", "error"),
    [
        ("+", Const("a"), Const(1), "TypeError"),
        ("+", Const(1), text("a", "*"), "TypeError"),
        ("/", Const(1), Const(0), "ZeroDivisionError"),
        ("%", Const("%d"), Tuple((Const("a"),)), "TypeError"),
        ("%", Const("%d%d"), Tuple((Unknown((REASON,)),)), "TypeError"),
        ("-", Tuple(()), Const(1), "TypeError"),
    ],
)
def test_certain_errors_end_the_path(op: str, left: Value, right: Value, error: str) -> None:
    machine = FakeMachine()
    assert machine.binary(op, left, right) is UNBOUND
    assert machine.deaths == [error]
    either = join_all((left, Const(7)))
    if op != "%":
        assert machine.binary(op, either, join_all((right, Const(7)))) is not UNBOUND
        assert machine.deaths == [error]


def test_reasons_travel() -> None:
    machine = FakeMachine()
    unknown = Unknown((REASON,), "int")
    for value in (
        machine.binary("+", unknown, Const(1)),
        machine.compare("<", unknown, Const(1)),
        machine.native("builtins.abs", unknown),
    ):
        assert isinstance(value, Unknown)
        assert value.reasons == (REASON,)
    assert machine.binary("+", Const("a"), unknown) != UNBOUND


def test_attributes_by_name() -> None:
    machine = FakeMachine()
    robot = machine.native("builtins.object")
    machine.native("builtins.setattr", robot, Const("on_a"), Const(1))
    machine.native("builtins.setattr", robot, Const("on_b"), Const(2))
    machine.native("builtins.setattr", robot, Const("off"), Const(3))
    assert machine.native("builtins.getattr", robot, Const("on_a")) == Const(1)
    some = machine.native("builtins.getattr", robot, text("on_", "*"))
    assert {Const(1), Const(2)} < set(options(some))
    assert Const(3) not in options(some)
    machine.native("builtins.setattr", robot, join_all((Const("on_a"), Const("on_b"))), Const(9))
    assert machine.load_attr(robot, "on_b") == join_all((Const(2), Const(9)))
    machine.native("builtins.setattr", robot, Unknown(()), Const(9))
    assert machine.findings == ["RW203"]
    assert machine.native("builtins.hasattr", Const("x"), Const("upper")) == TRUE
    assert machine.native("builtins.hasattr", Const("x"), Const("nope")) == FALSE
    assert machine.native("builtins.getattr", NONE, Const("x"), Const(5)) == Const(5)
    machine.native("builtins.delattr", robot, Const("off"))
    assert isinstance(robot, Ref)
    assert machine.obj(robot).attrs["off"] is UNBOUND


def test_code_at_run_time() -> None:
    machine = FakeMachine()
    assert covers(machine, machine.native("builtins.eval", Const("['a', 1]")), ["a", 1])
    assert machine.findings == []
    for name in ("exec", "compile", "eval"):
        machine.native(f"builtins.{name}", Const("f()"))
    assert machine.findings == ["RW203"] * 3


@pytest.mark.parametrize(
    ("name", "args", "cause"),
    [
        ("input", (), Cause.INPUT),
        ("open", (Const("/etc/robot.yaml"),), Cause.FILE),
        ("id", (NONE,), Cause.RANDOM),
        ("locals", (), Cause.LIVE),
    ],
)
def test_unknown_sources(name: str, args: tuple[Value, ...], cause: Cause) -> None:
    found = FakeMachine().native(f"builtins.{name}", *args)
    assert isinstance(found, Unknown)
    assert found.reasons[0].cause is cause
    assert name != "open" or found.reasons[0].subject == "/etc/robot.yaml"


def test_types() -> None:
    machine = FakeMachine()
    assert machine.native("builtins.type", Const("a")) == Native("builtins.str")
    assert machine.native("builtins.isinstance", Const(True), Native("builtins.int")) == TRUE
    assert (
        machine.native("builtins.isinstance", Const("a"), Tuple((Native("builtins.int"), Native("builtins.float"))))
        == FALSE
    )
    assert machine.native("builtins.issubclass", Native("builtins.bool"), Native("builtins.int")) == TRUE
    assert machine.native("builtins.callable", Native("builtins.len")) == TRUE
    assert machine.native("builtins.callable", Const(1)) == FALSE
    assert machine.native("builtins.property", Native("f")) == Descriptor("property", Native("f"), None, None)
    assert machine.native("builtins.staticmethod", Native("f")) == Descriptor("staticmethod", Native("f"), None, None)
    assert machine.native("builtins.slice", Const(1)) == Slice(NONE, Const(1), NONE)
    assert machine.native("builtins.range", Const(3)) == Range(Const(0), Const(3), Const(1))
    assert machine.native("builtins.print", Const(3)) == NONE


KINDS: tuple[Callable[[FakeMachine], Value], ...] = (
    lambda _: Unknown((REASON,)),
    lambda _: Unknown((REASON,), "int"),
    lambda _: NONE,
    lambda _: Const(2),
    lambda _: Const("ab"),
    lambda _: Const("%s{}{0[a]}"),
    lambda _: Const(b"ab"),
    lambda _: Const(1.5),
    lambda _: text("a", "*"),
    lambda _: Tuple((Const("a"), Const(1))),
    lambda m: abstract(m, ["a", 1]),
    lambda m: abstract(m, {"a": 1}),
    lambda m: abstract(m, {"a"}),
    lambda m: m.new_list((), Unknown((REASON,))),
    lambda m: m.new_dict({}, Unknown((REASON,))),
    lambda m: m.native("builtins.object"),
    lambda m: m.native("builtins.iter", abstract(m, ["a"])),
    lambda _: External("lib.thing"),
    lambda _: Native("builtins.str"),
    lambda _: Range(Const(0), Unknown((REASON,), "int"), Const(1)),
    lambda _: Slice(NONE, Const(1), NONE),
    lambda m: join_all((NONE, Const("a"), abstract(m, ["a"]))),
)  # fmt: skip


@pytest.mark.parametrize("name", sample(sorted(NATIVES), 4))
@given(data=st.data())
def test_no_argument_makes_a_native_fail(name: str, data: st.DataObject) -> None:
    machine = FakeMachine()
    args = [make(machine) for make in data.draw(st.lists(st.sampled_from(KINDS), max_size=4))]
    assert isinstance(machine.native(name, *args), Value)


@given(
    data=st.data(), op=st.sampled_from([*OPERATORS, "@"]), comparison=st.sampled_from([*COMPARISONS, "is", "is-not"])
)
def test_no_operand_makes_an_operator_fail(data: st.DataObject, op: str, comparison: str) -> None:
    machine = FakeMachine()
    left, right, third = (data.draw(st.sampled_from(KINDS))(machine) for _ in range(3))
    assert isinstance(machine.binary(op, left, right), Value)
    assert isinstance(machine.compare(comparison, left, right), Value)
    assert isinstance(unary(machine, "-", left), Value)
    assert isinstance(machine.load_item(left, right), Value)
    machine.store_item(left, right, third)
    machine.iterate(left)
    machine.truth(left)
