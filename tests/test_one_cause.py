# SPDX-License-Identifier: Apache-2.0
"""One cause, one finding: what is put together, what leads it, and that nothing gets lost."""

from __future__ import annotations

import random

import pytest

from rosward.findings import Finding, doubtful, each_once
from rosward.location import Place
from rosward.one_cause import OneCause, by_cause, more_of
from rosward.rules import RULES, Severity

ARGUMENT = ("launch argument without a value: ns",)


def at(line: int, code: str, causes: tuple[str, ...] = (), message: str = "m") -> Finding:
    return Finding(code, message, Place("a.py", line), causes)


def test_what_tells_of_the_cause_itself_leads() -> None:
    names = [at(line, "RW101", ARGUMENT) for line in range(1, 4)]
    unset, wide = at(9, "RW312", ARGUMENT), at(2, "RW302", ARGUMENT)
    (one,) = by_cause([*names, wide, unset])
    assert one == OneCause(unset, (*names, wide))
    assert more_of(one) == "3 more with this cause: 3 RW101"


def test_the_heaviest_leads() -> None:
    (one,) = by_cause([at(1, "RW205", ("c",)), at(2, "RW302", ("c",)), at(3, "RW101", ("c",))])
    assert [f.code for f in (one.finding, *one.also)] == ["RW101", "RW302", "RW205"]


def test_without_a_cause_each_is_alone() -> None:
    found = by_cause(
        [at(1, "RW101"), at(1, "RW101", message="other"), at(2, "RW101", ("a",)), at(3, "RW101", ("a", "b"))]
    )
    assert [len(one.also) for one in found] == [0, 0, 0, 0]
    assert more_of(found[0]) == ""


def test_a_wildcard_is_no_news_beside_the_name_that_makes_it() -> None:
    (one,) = by_cause([at(2, "RW102", ("c",)), at(2, "RW302", ("c",))])
    assert more_of(one) == ""
    (one,) = by_cause([at(2, "RW102", ("c",)), at(2, "RW302", ("c",)), at(3, "RW302", ("c",))])
    assert more_of(one) == "1 more with this cause: 1 RW302"


def test_of_one_code_the_number_is_enough() -> None:
    (one,) = by_cause([at(line, "RW318", ("container /c",)) for line in range(1, 15)])
    assert more_of(one) == "13 more with this cause"


@pytest.mark.parametrize("seed", range(20))
def test_nothing_gets_lost(seed: int) -> None:
    """Each finding is in one group, an error leads where there is one: whoever counts the groups never counts no error where there is one."""
    dice = random.Random(seed)
    codes = sorted(RULES)
    causes = [(), ("a",), ("b",), ("a", "b")]
    findings = [at(n, dice.choice(codes), dice.choice(causes)) for n in range(40)]
    groups = by_cause(findings)
    assert sorted(f for one in groups for f in (one.finding, *one.also)) == sorted(findings)
    weights = list(Severity)
    for one in groups:
        assert all(weights.index(one.finding.rule.severity) <= weights.index(f.rule.severity) for f in one.also)
    assert {one.finding for one in by_cause(findings[::-1])} == {one.finding for one in groups}


def test_what_is_said_twice_is_said_once_of_all_that_it_is_about() -> None:
    place = Place("a.py", 1)
    twice = [
        Finding("RW315", "m", place, (), ("/b",)),
        Finding("RW315", "m", place),
        Finding("RW315", "m", place, ("c",), ("/a",)),
    ]
    assert each_once(twice) == (Finding("RW315", "m", place, ("c",), ("/a", "/b")),)


def test_a_place_is_told_once_with_all_reasons() -> None:
    here, there = Place("a.py", 1), Place("b.py", 1)
    found = each_once(
        [
            doubtful("RW101", "the name of this publisher is unknown", ["x", "y"], here, ("1",)),
            doubtful("RW101", "the name of this publisher is unknown", ["z", "x"], here, ("2",), remedy="do it"),
            doubtful("RW101", "the name of this client is unknown", ["x"], here),
            doubtful("RW101", "the name of this publisher is unknown", ["x"], there),
        ]
    )
    assert [f.message for f in found] == [
        "the name of this client is unknown because of x",
        "the name of this publisher is unknown because of x; y; z: do it",
        "the name of this publisher is unknown because of x",
    ]
    assert found[1].causes == ("1", "2")
    many = doubtful("RW101", "this is unknown", [str(n) for n in range(9)], here)
    assert many.message == "this is unknown because of 0; 1; 2; 3; 4; 5; and 3 more"
