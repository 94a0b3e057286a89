# SPDX-License-Identifier: Apache-2.0
"""Promise: a string method on constants is Python's own; on a text with holes it covers what any filling gives."""

from __future__ import annotations

from typing import Any

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from models.fake import REASON, FakeMachine, abstract, covers, text
from rosward.domain.choice import join_all
from rosward.domain.compound import Slice, Tuple
from rosward.domain.text import concat, make, pattern
from rosward.domain.unknown import Origin
from rosward.domain.values import EMPTY, UNBOUND, Choice, Const, Hole, Ref, Unknown, Value
from rosward.models.native import Machine
from rosward.models.python.operators.operators import percent
from rosward.models.python.strings.methods import format_value

ALPHABET = "ab/A_ %{}-1.\tÄßΣ"
words = st.text(alphabet=ALPHABET, max_size=6)
segments = words.map(lambda w: w.replace("/", "") or "w")
short = st.text(alphabet="ab/ -", max_size=3)
counts = st.integers(-2, 9)
Strategies = tuple[st.SearchStrategy[object], ...]
shapes = st.sampled_from(("", "word", "digits"))


@st.composite
def fillings(draw: st.DrawFn) -> tuple[Value, str]:
    """A text with holes, and what it may be when it runs."""
    parts: list[str | Hole] = []
    concrete = ""
    for _ in range(draw(st.integers(1, 4))):
        if draw(st.booleans()):
            known = draw(words)
            parts.append(known)
            concrete += known
            continue
        shape = draw(shapes)
        parts.append(Hole((REASON,), shape))
        by_shape = {
            "": words,
            "word": words.map(lambda w: w.replace("/", "") or "w"),
            "digits": st.integers(-9, 99).map(str),
        }
        concrete += draw(by_shape[shape])
    return make(parts), concrete


def outcome(function: Any, *args: object) -> object:
    """What Python says, or the exception class."""
    try:
        return function(*args)
    except Exception as error:
        return error.__class__


def check(machine: FakeMachine, result: Value, expected: object) -> None:
    if isinstance(expected, type):
        return  # it raises when it runs; any result will do
    assert result is not UNBOUND, machine.deaths
    assert covers(machine, result, expected), (result, expected)


METHODS = [
    ("upper", ()), ("lower", ()), ("title", ()), ("capitalize", ()), ("swapcase", ()), ("casefold", ()),
    ("strip", (short,)), ("lstrip", (short,)), ("rstrip", (short,)), ("strip", ()), ("lstrip", ()),
    ("rstrip", (st.none(),)),
    ("removeprefix", (short,)), ("removesuffix", (short,)),
    ("replace", (short, words)), ("replace", (short, words, counts)),
    ("split", (short,)), ("split", (short, counts)), ("rsplit", (short, counts)), ("split", ()),
    ("splitlines", ()),
    ("partition", (short,)), ("rpartition", (short,)),
    ("startswith", (short,)), ("endswith", (short,)), ("startswith", (st.tuples(short, short),)),
    ("find", (short,)), ("count", (short,)), ("index", (short,)),
    ("zfill", (counts,)), ("ljust", (counts,)), ("rjust", (counts, st.just("x"))), ("center", (counts,)),
    ("expandtabs", ()),
    ("isdigit", ()), ("isalpha", ()), ("isspace", ()), ("isascii", ()), ("isidentifier", ()), ("islower", ()),
    ("encode", ()),
]  # fmt: skip


@pytest.mark.parametrize(("name", "strategies"), METHODS)
@given(data=st.data())
def test_method_of_constant_is_pythons_own(name: str, strategies: Strategies, data: st.DataObject) -> None:
    machine = FakeMachine()
    receiver, args = data.draw(words), [data.draw(s) for s in strategies]
    expected = outcome(getattr(str, name), receiver, *args)
    result = machine.native(f"str.{name}", Const(receiver), *(abstract(machine, a) for a in args))
    if isinstance(expected, type):
        assert machine.deaths == [expected.__name__]
    else:
        check(machine, result, expected)
        assert not isinstance(result, Unknown)


@pytest.mark.parametrize(("name", "strategies"), METHODS)
@given(data=st.data())
def test_method_of_text_covers_every_filling(name: str, strategies: Strategies, data: st.DataObject) -> None:
    machine = FakeMachine()
    (receiver, concrete), args = data.draw(fillings()), [data.draw(s) for s in strategies]
    assert covers(machine, receiver, concrete)
    result = machine.native(f"str.{name}", receiver, *(abstract(machine, a) for a in args))
    check(machine, result, outcome(getattr(str, name), concrete, *args))


@given(receiver=fillings(), old=short, new=fillings())
def test_replacement_by_a_text_covers_every_filling(
    receiver: tuple[Value, str], old: str, new: tuple[Value, str]
) -> None:
    machine = FakeMachine()
    result = machine.native("str.replace", receiver[0], Const(old), new[0])
    check(machine, result, receiver[1].replace(old, new[1]))


@given(separator=fillings(), items=st.lists(fillings(), max_size=4), known=st.integers(0, 4))
def test_join_covers_every_filling(separator: tuple[Value, str], items: list[tuple[Value, str]], known: int) -> None:
    machine = FakeMachine()
    expected = separator[1].join(i[1] for i in items)
    check(machine, machine.native("str.join", separator[0], Tuple(tuple(i[0] for i in items))), expected)
    if items:
        rest = join_all(i[0] for i in items[known:]) if items[known:] else Const("zz")
        check(
            machine,
            machine.native("str.join", separator[0], machine.new_list([i[0] for i in items[:known]], rest)),
            expected,
        )


bounds = st.none() | st.integers(-5, 5)


@given(receiver=fillings(), start=bounds, stop=bounds, step=st.sampled_from((None, 1, 2, -1)))
def test_slices_and_characters_cover_every_filling(
    receiver: tuple[Value, str], start: int | None, stop: int | None, step: int | None
) -> None:
    machine = FakeMachine()
    result = machine.load_item(receiver[0], Slice(Const(start), Const(stop), Const(step)))
    check(machine, result, receiver[1][start:stop:step])
    if start is not None:
        check(machine, machine.load_item(receiver[0], Const(start)), outcome(lambda: receiver[1][start]))


values = (
    fillings()
    | st.integers(-50, 50).map(lambda n: (Const(n), n))
    | st.floats(-5, 5).map(lambda n: (Const(n), n))
    | st.integers(-50, 50).map(lambda n: (Unknown((REASON,), "int"), n))
    | st.integers(-50, 50).map(lambda n: (Unknown((REASON,)), n))
    | words.map(lambda w: (Unknown((REASON,)), w))
    | st.none().map(lambda n: (Const(n), n))
)
specs = st.sampled_from(
    ("", "d", "02d", "3d", "3", "03", ">6", "s", ".1f", ".2", "<4s", "+d", "x", "*^7", "é", ",", " d", "-5d")
)


@given(value=values, spec=specs, conversion=st.sampled_from(("", "s", "r", "a")))
def test_format_value_covers_every_filling(value: tuple[Value, object], spec: str, conversion: str) -> None:
    machine = FakeMachine()
    convert: Any = {"": lambda v: v, "s": str, "r": repr, "a": ascii}[conversion]
    expected = outcome(lambda: format(convert(value[1]), spec))
    piece = format_value(machine, value[0], conversion, Const(spec))
    if piece is not UNBOUND:
        check(machine, join_all(concat([Const("<"), o, Const(">")]) for o in _options(piece)), _within(expected))
    else:
        assert isinstance(expected, type)


def _options(value: Value) -> tuple[Value, ...]:
    return value.options if isinstance(value, Choice) else (value,)


def _within(expected: object) -> object:
    return expected if isinstance(expected, type) else f"<{expected}>"


templates = st.lists(
    words.map(lambda w: w.replace("{", "{{").replace("}", "}}"))
    | st.sampled_from(
        ("{}", "{!r}", "{:>4}", "{a}", "{a!s:>3}", "{0}", "{1}", "{:02d}", "{:{a}}", "{0[0]}", "{a.b}", "{", "{2}")
    ),
    max_size=4,
).map("".join)


@given(template=templates, first=values, second=values, named=values)
@example("{}{:02d}", (Unknown((REASON,)), 5), (Unknown((REASON,), "int"), -5), (EMPTY, ""))
def test_format_covers_every_filling(
    template: str, first: tuple[Value, object], second: tuple[Value, object], named: tuple[Value, object]
) -> None:
    machine = FakeMachine()
    result = machine.native("str.format", Const(template), first[0], second[0], a=named[0])
    expected = outcome(lambda: template.format(first[1], second[1], a=named[1]))
    if result is UNBOUND:
        assert isinstance(expected, type), expected
    else:
        check(machine, result, expected)


percent_templates = st.lists(
    words.map(lambda w: w.replace("%", "%%"))
    | st.sampled_from(
        ("%s", "%d", "%02d", "%5s", "%-5s", "%.1f", "%r", "%%", "%x", "%*d", "%+d", "%.2s", "%", "%c", "% d", "%i")
    ),
    max_size=4,
).map("".join)


@given(template=percent_templates, args=st.lists(values, max_size=3), single=st.booleans())
def test_percent_covers_every_filling(template: str, args: list[tuple[Value, object]], single: bool) -> None:
    machine = FakeMachine()
    if single and len(args) == 1:
        given_args, concrete = args[0]
    else:
        given_args, concrete = Tuple(tuple(a[0] for a in args)), tuple(a[1] for a in args)
    result = percent(machine, Const(template), given_args)
    expected = outcome(lambda: template % concrete)
    if result is UNBOUND:
        assert isinstance(expected, type), expected
    else:
        check(machine, result, expected)


@given(template=fillings(), value=values)
def test_unknown_templates_cover_every_filling(template: tuple[Value, str], value: tuple[Value, object]) -> None:
    machine = FakeMachine()
    check(machine, percent(machine, template[0], value[0]), outcome(lambda: template[1] % value[1]))
    result = machine.native("str.format", template[0], value[0])
    check(machine, result, outcome(lambda: template[1].format(value[1])))


@given(
    entries=st.dictionaries(st.sampled_from("abc"), values, min_size=1),
    template=st.sampled_from(("%(a)s/%(b)s", "%(c)d", "{a}{b}")),
)
def test_mappings_fill_templates(entries: dict[str, tuple[Value, object]], template: str) -> None:
    machine = FakeMachine()
    mapping = machine.new_dict({Const(k): v[0] for k, v in entries.items()})
    concrete = {k: v[1] for k, v in entries.items()}
    if "%" in template:
        result, expected = percent(machine, Const(template), mapping), outcome(lambda: template % concrete)
    else:
        result = machine.native("str.format_map", Const(template), mapping)
        expected = outcome(lambda: template.format_map(concrete))
    if result is UNBOUND:
        assert isinstance(expected, type)
    else:
        check(machine, result, expected)


# What is kept, seen by example


def shown(value: Value) -> list[str]:
    return sorted(pattern(o) for o in _options(value))


@pytest.mark.parametrize(
    ("name", "parts", "args", "result"),
    [
        ("lower", ("/Robot_", "*", "/CMD"), (), ["/robot_*/cmd"]),
        ("strip", ("/a/", "*", "/x/"), ("/",), ["a", "a/*/x"][1:]),
        ("lstrip", ("*", "/x"), ("/",), ["*/x", "x"]),
        ("removeprefix", ("/", "*", "/x"), ("/",), ["*/x"]),
        ("removesuffix", ("/", "*", "_node"), ("_node",), ["/*"]),
        ("replace", ("/robot_", "*", "/cmd"), ("/cmd", "/vel"), ["/robot_*/vel"]),
        ("replace", ("a-b", "*", "-c"), ("-", "_"), ["a_b*_c"]),
        ("zfill", ("x", "*"), (1,), ["x*"]),
    ],
)
def test_known_parts_stay(name: str, parts: tuple[str, ...], args: tuple[object, ...], result: list[str]) -> None:
    machine = FakeMachine()
    found = machine.native(f"str.{name}", text(*parts), *(abstract(machine, a) for a in args))
    assert shown(found) == result


def test_rsplit_keeps_the_last_component() -> None:
    machine = FakeMachine()
    found = machine.native("str.rsplit", text("/", "*", "/cmd"), Const("/"), Const(1))
    assert isinstance(found, Ref)
    items = machine.obj(found).items
    assert items is not None
    assert [pattern(i) for i in items] == ["/*", "cmd"]


def test_unknown_numbers_are_digits() -> None:
    machine = FakeMachine()
    number = Unknown((REASON,), "int")
    for value in (
        machine.native("str.format", Const("robot_{:02d}/x"), number),
        percent(machine, Const("robot_%02d/x"), Tuple((number,))),
        percent(machine, Const("robot_%d/x"), number),
        machine.native("str.format", Const("robot_{n}/x"), n=number),
    ):
        assert pattern(value) == "robot_*/x"
        assert value == make(("robot_", Hole((REASON,), "digits"), "/x"))


def test_origins_and_reasons_travel() -> None:
    machine = FakeMachine()
    one, two = frozenset({Origin("parameter", "ns")}), frozenset({Origin("argument", "n")})
    joined = machine.native("str.join", Const("/", one), Tuple((Const("a", two), Const("b"))))
    assert joined == Const("a/b", one | two)
    assert machine.native("str.format", Const("{}_{}"), Const("a", one), Const(1, two)) == Const("a_1", one | two)
    assert percent(machine, Const("%s%d", one), Tuple((Const("a"), Const(1, two)))) == Const("a1", one | two)
    result = machine.native("str.upper", make(("a", Hole((REASON,))), one))
    assert result == make(("A", Hole((REASON,))), one)
    split = machine.native("str.split", Const("a b", one))
    assert isinstance(split, Ref)
    assert machine.obj(split).items == (Const("a", one), Const("b", one))


def test_alternatives_are_taken_one_by_one() -> None:
    machine = FakeMachine()
    names = join_all((Const("a"), Const("b"), Const(3)))
    assert set(_options(machine.native("str.upper", names))) == {Const("A"), Const("B")}
    assert machine.deaths == []
    machine.native("str.upper", Const(3))
    assert machine.deaths == ["TypeError"]


@pytest.mark.parametrize(
    ("name", "args"),
    [
        ("ljust", (10**9,)),
        ("zfill", (10**12,)),
        ("center", (10**9,)),
        ("expandtabs", (10**9,)),
        ("format", ()),
        ("replace", ("", "x" * 4000)),
    ],
)
def test_nothing_huge_is_computed(name: str, args: tuple[object, ...]) -> None:
    machine = FakeMachine()
    receiver = "{:999999999}" if name == "format" else "\ta" * 1000
    values = [abstract(machine, a) for a in args] or [Const(1)]
    result = machine.native(f"str.{name}", Const(receiver), *values)
    assert not isinstance(result, Const)


def test_translate() -> None:
    machine = FakeMachine()
    table = machine.native("str.maketrans", Const("-/"), Const("__"), Const("x"))
    assert machine.native("str.translate", Const("a-b/cx"), table) == Const("a_b_c")
    assert pattern(machine.native("str.translate", text("a-", "*", "/x1"), table)) == "a_*_1"
    assert machine.native(
        "str.translate", Const("ab"), machine.native("str.maketrans", abstract(machine, {"a": "z"}))
    ) == Const("zb")


def test_keyword_arguments() -> None:
    machine = FakeMachine()
    found = machine.native("str.split", Const("a b c"), maxsplit=Const(1))
    assert covers(machine, found, ["a", "b c"])
    assert machine.native("str.encode", Const("a"), errors=Const("ignore")) == Const(b"a")
    assert machine.native("bytes.decode", Const(b"a"), encoding=Const("ascii")) == Const("a")


def test_fake_is_a_machine() -> None:
    machine: Machine = FakeMachine()
    assert machine.place
