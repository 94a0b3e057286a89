# SPDX-License-Identifier: Apache-2.0
"""What takes long is refused before it is called, and known for what it is."""

from __future__ import annotations

import sys

import pytest

from models.fake import FakeMachine
from rosward.domain.compound import MAX_PARTS, TooManyPartsError, Tuple
from rosward.domain.unknown import Cause
from rosward.domain.values import Const, Unknown
from rosward.models.python.cost import MAX_WORK, work
from rosward.models.python.operators import operators

_HUGE = 10**9
_BIG = 10**400


@pytest.mark.parametrize(
    ("name", "operands"),
    [
        ("round", (_BIG, -_HUGE)),
        ("pow", (10, _HUGE)),
        ("**", (10, 10**10)),
        ("<<", (1, _HUGE)),
        ("*", ("a", 10**12)),
        ("*", (10**12, b"a")),
        ("bytes", (10**10,)),
        ("int", ("9" * 1_000_000,)),
        ("str.ljust", ("a", _HUGE)),
        ("str.zfill", ("a", _HUGE)),
        ("bytes.center", (b"a", _HUGE)),
        ("str.expandtabs", ("\t", _HUGE)),
        ("str.replace", ("a" * 4_000, "a", "b" * 4_000)),
        ("str.find", ("a" * 500_000, "a" * 500)),
        ("math.factorial", (_HUGE,)),
        ("math.comb", (_HUGE, _HUGE // 2)),
        ("math.perm", (_HUGE,)),
    ],
)
def test_what_takes_long_is_known_beforehand(name: str, operands: tuple[object, ...]) -> None:
    assert work(name, operands) > MAX_WORK


@pytest.mark.parametrize(
    ("name", "operands"),
    [
        ("round", (3.14159, 2)),
        ("pow", (2, 64)),
        ("pow", (3, 5**100, 7**100)),
        ("**", (1, _HUGE)),
        ("**", (2.0, _HUGE)),
        ("*", ("=", 80)),
        ("int", ("12345",)),
        ("str.zfill", ("7", 3)),
        ("str.replace", ("front_left", "_", "/")),
        ("math.factorial", (20,)),
        ("math.comb", (30, 15)),
    ],
)
def test_what_programs_compute_is_computed(name: str, operands: tuple[object, ...]) -> None:
    assert work(name, operands) < MAX_WORK


def test_the_reason_is_the_limit() -> None:
    machine = FakeMachine()
    found = machine.native("builtins.round", Const(_BIG), Const(-_HUGE))
    assert isinstance(found, Unknown)
    assert found.reasons[0].cause is Cause.LIMIT
    assert machine.native("builtins.pow", Const(3), Const(5), Const(7)) == Const(pow(3, 5, 7))
    assert isinstance(operators.binary(machine, "<<", Const(1), Const(_HUGE)), Unknown)


def test_what_takes_longer_than_a_step_is_counted() -> None:
    machine = FakeMachine()
    machine.native("str.upper", Const("a" * 500_000))
    assert machine.spent > 50


def test_numbers_with_one_hash_have_many() -> None:
    """A dict of them would compare each with each."""
    prime = sys.hash_info.modulus
    numbers: list[complex] = [n * prime for n in range(1, 200)]
    assert len({hash(n) for n in numbers}) == 1
    assert len({hash(Const(n)) for n in numbers}) > 190
    pairs = [complex(-1_000_003 * n, n) for n in range(1, 200)]
    assert len({hash(Const(n)) for n in pairs}) > 190


def test_equal_constants_have_one_hash() -> None:
    for value in (2**61, -(2**70), 1e30, float("inf"), 0.0, 3 + 4j, True, "a", b"a", None):
        assert hash(Const(value)) == hash(Const(value))


def test_a_tuple_that_doubles_is_not_made_for_ever() -> None:
    made = Tuple((Const(1),))
    while made.parts <= MAX_PARTS // 2 - 1:
        made = Tuple((made, made))
    with pytest.raises(TooManyPartsError):
        Tuple((made, made))
