# SPDX-License-Identifier: Apache-2.0
"""Promise: our data classes do what those of the standard library do."""

from __future__ import annotations

import copy
import dataclasses
import pickle
from typing import Any

import pytest

from rosward import records


@records.dataclass(frozen=True, slots=True)
class Frozen:
    a: int
    b: str = "x"
    c: list[int] = records.field(default_factory=list)

    @property
    def both(self) -> str:
        return f"{self.a}{self.b}"


@records.dataclass(slots=True)
class Open:
    a: int
    c: dict[str, int] = records.field(default_factory=dict)


@records.dataclass(frozen=True, eq=False)
class Single:
    a: int = 1


@pytest.mark.parametrize("of", [records, dataclasses], ids=["ours", "theirs"])
def test_as_the_standard_library(of: Any) -> None:
    class Plain:
        x: int
        y: tuple[int, ...] = ()
        z: Any = of.field(default=None, compare=False)

    point: Any = of.dataclass(frozen=True, slots=True)(Plain)
    one = point(1, y=(2,))
    assert (one.x, one.y, one.z) == (1, (2,), None)
    assert repr(one).endswith("Plain(x=1, y=(2,), z=None)")
    assert point(1) == point(1, z=3)
    assert point(1) != point(2)
    assert point(1) != (1, (), None)
    assert len({point(1), point(1, (), 4), point(2)}) == 2
    assert of.replace(one, x=5) == point(5, (2,))
    assert point.__match_args__ == ("x", "y", "z")
    assert not hasattr(one, "__dict__")
    wrong = [
        point,
        lambda: point(1, (), 3, 4),
        lambda: point(1, x=2),
        lambda: point(1, w=2),
        lambda: of.replace(one, w=1),
    ]
    for make in wrong:
        with pytest.raises(TypeError):
            make()
    for name in ("x", "w"):
        with pytest.raises((AttributeError, TypeError)):
            setattr(one, name, 1)
    with pytest.raises(AttributeError):
        del one.x


def test_each_object_has_its_own_default() -> None:
    assert Frozen(1).c is not Frozen(1).c
    one = Open(1)
    one.c["k"] = 1
    one.a = 7
    assert Open(1).c == {}
    assert one == Open(7, {"k": 1})
    assert Frozen(1).both == "1x"
    with pytest.raises(TypeError):
        hash(one)


def test_without_equality_each_is_its_own() -> None:
    assert Single() != Single()
    assert len({Single(), Single()}) == 2


def test_copies() -> None:
    one = Frozen(1, "y", [3])
    assert pickle.loads(pickle.dumps(one)) == copy.deepcopy(one) == copy.copy(one) == one


def test_the_standard_library_takes_them() -> None:
    one = Frozen(1, "y", [3])
    assert dataclasses.is_dataclass(one)
    assert [each.name for each in dataclasses.fields(one)] == ["a", "b", "c"]
    assert dataclasses.asdict(one) == {"a": 1, "b": "y", "c": [3]}
    assert dataclasses.replace(one, a=2) == Frozen(2, "y", [3])
