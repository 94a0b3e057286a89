# SPDX-License-Identifier: Apache-2.0
"""Promise: what is written down and read again is the same, part by part; and nothing else than what is written can come out."""

from __future__ import annotations

import json
from collections.abc import Iterator
from typing import Any

import pytest
from compiled import interpreted

from rosward.domain.compound import External, Tuple
from rosward.domain.heap import Obj
from rosward.domain.unknown import Cause, Reason
from rosward.domain.values import FALSE, NONE, TRUE, UNBOUND, Choice, Const, Hole, Text, Unknown, Value
from rosward.engine.libraries.model_library import ModelLibrary
from rosward.engine.libraries.stub_files import own_names
from rosward.engine.libraries.written import NotWrittenError, Reader, Writer
from rosward.ir.program import Code
from rosward.location import Place
from rosward.models.native import Arguments, MissingArgumentError
from rosward.models.tables import own_models

PLACE = Place("a.py", 3, 7)
REASON = Reason(Cause.PARAMETER, "topic", PLACE)


def again(value: object) -> Any:
    """The value, written and read."""
    writer = Writer()
    return Reader(writer.lines).line(writer.line(value))


@pytest.mark.parametrize(
    "value",
    [
        *(
            NONE,
            TRUE,
            FALSE,
            Const(1),
            Const(1.5),
            Const(float("inf")),
            Const("\ud800 ü\n"),
            Const(b"\xff"),
            Const(2j),
            Const(1 << 200),
        ),
        Text(("/a", Hole((REASON,), "word"))),
        Unknown((REASON,), "str", "HOME"),
        Choice((Const(1), Const("1"), External("a.b"))),
        Tuple((NONE, Tuple(()))),
        UNBOUND,
    ],
    ids=repr,
)
def test_a_value(value: Value) -> None:
    found = again(value)
    assert found == value
    assert found.__class__ is value.__class__
    assert hash(found) == hash(value)


def test_not_a_number() -> None:
    assert again(Const(float("nan"))).value != again(Const(float("nan"))).value


def test_zeros_keep_their_sign() -> None:
    assert str(again(Const(-0.0)).value) == "-0.0"


@interpreted
def test_a_record_keeps_what_is_none_and_what_is_usual() -> None:
    obj = Obj(
        "list", External("list"), {"x": NONE}, None, Const(1), {Const("k"): TRUE}, frozenset({Const("k")}), many=True
    )
    found = again(obj)
    assert {name: getattr(found, name) for name in Obj.__slots__} == {
        name: getattr(obj, name) for name in Obj.__slots__
    }


def test_missing_arguments_are_missing_still() -> None:
    with pytest.raises(MissingArgumentError):
        again(Arguments((NONE,)))[1]


def test_what_is_not_known_is_not_written() -> None:
    with pytest.raises(NotWrittenError):
        Writer().line(object())


@interpreted
def test_the_operations_of_all_models() -> None:
    """Each code that the models lead to is read as it was lowered, with the numbers of its operations."""
    library = ModelLibrary(own_models())
    for name in own_names():
        found = library.model(name)
        assert found is not None
        library.load_model(found)
    writer = Writer()
    lines = {address: writer.line(record) for address, record in library.records()}
    reader = Reader(writer.lines)
    seen: dict[int, Any] = {}
    for address, record in library.records():
        for ours, theirs in _pairs(record, reader.line(lines[address]), seen):
            assert ours.__class__ is theirs.__class__
            assert not isinstance(ours, (str, int, float, bytes)) or repr(ours) == repr(theirs)
    assert sum(isinstance(each, Code) for each in seen.values()) > 2_000


_WHEN_ASKED = ("waits", "_hash")
"""Slots that are filled when somebody asks for them."""


def _pairs(ours: Any, theirs: Any, seen: dict[int, Any]) -> Iterator[tuple[Any, Any]]:
    pending = [(ours, theirs)]
    while pending:
        one, other = pending.pop()
        yield one, other
        if id(one) in seen or isinstance(one, (str, int, float, bytes, type(None))):
            continue
        seen[id(one)] = one
        if isinstance(one, dict):
            assert list(one) == list(other)
            pending += zip(one.values(), other.values(), strict=True)
        elif isinstance(one, (tuple, list)):
            pending += zip(one, other, strict=True)
        elif isinstance(one, frozenset):
            assert one == other
        slots = [slot for made in type(one).__mro__ for slot in getattr(made, "__slots__", ())]
        pending += [(getattr(one, slot), getattr(other, slot)) for slot in slots if slot not in _WHEN_ASKED]


def test_lines_are_plain_json() -> None:
    writer = Writer()
    writer.line(Const("x"))
    assert [json.loads(line) for line in writer.lines] == [[12, "x"]]
