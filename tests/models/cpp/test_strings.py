# SPDX-License-Identifier: Apache-2.0
"""`std::string`, streams, formatting, paths: what texts become."""

from __future__ import annotations

import pytest

from models.cpp.fake_cpp import INT, STRING, CppMachine
from models.fake import REASON, text
from rosward.domain.compound import External
from rosward.domain.slots import TypeOf
from rosward.domain.values import NONE, Const, Ref, Unknown, Value
from rosward.models.cpp.values.slots import read

NPOS = 2**64 - 1


def values(*given: str | float) -> tuple[Value, ...]:
    return tuple(Const(each) for each in given)


@pytest.mark.parametrize(
    ("string", "method", "args", "result"),
    [
        ("a/b/c", "find", ("/",), 1),
        ("a/b/c", "rfind", ("/",), 3),
        ("abc", "find", ("x",), NPOS),
        ("a.b-c", "find_first_of", ("-.",), 1),
        ("aab", "find_last_not_of", ("b",), 1),
        ("robot/arm", "substr", (6,), "arm"),
        ("robot", "substr", (1, 2), "ob"),
        ("robot", "substr", (1, NPOS), "obot"),
        ("b", "compare", ("a",), 1),
        ("abc", "starts_with", ("ab",), True),
        ("/a/b.yaml", "stem", (), "b"),
        ("/a/b.yaml", "extension", (), ".yaml"),
        ("/a/b.yaml", "parent_path", (), "/a"),
        ("abc", "size", (), 3),
    ],
)
def test_what_a_string_says(string: str, method: str, args: tuple[str | int, ...], result: object) -> None:
    machine = CppMachine()
    assert machine.method(machine.variable(Const(string)), method, *values(*args)) == Const(result)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("string", "method", "args", "after"),
    [
        ("a", "append", ("bc",), "abc"),
        ("a", "append", (2, "x"), "axx"),
        ("abc", "insert", (1, "x"), "axbc"),
        ("abcd", "erase", (1, 2), "ad"),
        ("abcd", "replace", (1, 2, "x"), "axd"),
        ("abc", "resize", (2,), "ab"),
        ("ab", "push_back", ("c",), "abc"),
        ("ab", "pop_back", (), "a"),
        ("/sensor", "remove_prefix", (1,), "sensor"),
        ("a.txt", "replace_extension", ("yaml",), "a.yaml"),
    ],
)
def test_what_a_string_becomes(string: str, method: str, args: tuple[str | int, ...], after: str) -> None:
    machine = CppMachine()
    place = machine.variable(Const(string))
    machine.method(place, method, *values(*args))
    assert read(machine, place) == Const(after)


def test_a_text_of_which_a_part_is_known() -> None:
    machine = CppMachine()
    name = machine.variable(text("/robot_", "*", "/cmd"))
    assert machine.method(name, "find", Const("_")) == Const(6)
    assert machine.method(name, "substr", Const(1)) == text("robot_", "*", "/cmd")
    assert machine.method(name, "empty") == Const(False)
    machine.method(name, "append", Const("_x"))
    assert read(machine, name) == text("/robot_", "*", "/cmd_x")
    assert isinstance(machine.method(name, "rfind", Const("z")), Unknown)


def test_a_part_that_is_not_there_is_an_exception() -> None:
    machine = CppMachine()
    machine.method(machine.variable(Const("ab")), "substr", Const(3))
    assert machine.thrown == ["out_of_range"]


def shown(machine: CppMachine, *pieces: Value) -> Value:
    stream = machine.call(External("std.ostringstream"), ())
    for piece in pieces:
        machine.binary("<<", stream, piece)
    return machine.method(stream, "str")


def test_streams_put_in() -> None:
    machine = CppMachine()
    wide = machine.function_of("setw", Const(3)), machine.function_of("setfill", Const("0"))
    assert shown(machine, *values("cam", 3, 0.5, True)) == Const("cam30.51")
    assert shown(machine, *wide, Const(7), Const(8)) == Const("0078")
    assert shown(machine, External("std.hex"), Const(255), External("std.endl")) == Const("ff\n")
    assert shown(machine, External("std.fixed"), machine.function_of("setprecision", Const(1)), Const(2.25)) == Const(
        "2.2"
    )
    assert shown(machine, Const("n"), Unknown((REASON,), "int")) != Const("n")
    assert shown(machine, *values(1e6, "_", 1234567.0)) == Const("1e+06_1.23457e+06")


def test_streams_take_out() -> None:
    machine = CppMachine()
    stream = machine.call(External("std.istringstream"), values("axis 3"))
    word, number = machine.variable(Const("")), machine.variable(Const(0))
    machine.binary(">>", machine.binary(">>", stream, word), number)
    assert (read(machine, word), read(machine, number)) == (Const("axis"), Const(3))
    assert machine.truth(stream) is True
    machine.binary(">>", stream, word)
    assert machine.truth(stream) is False


def test_getline_takes_piece_by_piece() -> None:
    machine = CppMachine()
    stream = machine.call(External("std.stringstream"), (text("a,", "*"),))
    piece = machine.variable(Const(""))
    assert machine.truth(machine.function_of("getline", stream, piece, Const(","))) is True
    assert read(machine, piece) == Const("a")
    assert machine.truth(machine.function_of("getline", stream, piece, Const(","))) is None
    assert isinstance(read(machine, piece), Unknown)


@pytest.mark.parametrize(
    ("value", "written"),
    [(3, "3"), (0.5, "0.500000"), (True, "1"), (-2, "-2"), ("a", "97")],
)
def test_to_string(value: str | float, written: str) -> None:
    assert CppMachine().function_of("to_string", Const(value)) == Const(written)


def test_snprintf_writes_to_its_first_argument() -> None:
    machine = CppMachine()
    place = machine.variable(Const(""))
    machine.function_of("snprintf", place, *values(32, "cam%02zu/%s_%c%%", 4, "image", "x"))
    assert read(machine, place) == Const("cam04/image_x%")
    machine.function_of("snprintf", place, *values(4, "%s", "abcdef"))
    assert read(machine, place) == Const("abc")
    machine.function_of("snprintf", place, *values(32, "cam%d"), Unknown((REASON,), "int"))
    assert not isinstance(read(machine, place), Const)


def test_fmt() -> None:
    machine = CppMachine()
    assert machine.call(External("fmt.format"), values("{}/{:>3}", "a", 7)) == Const("a/  7")
    assert machine.call(External("fmt.format"), values("{}", True)) == Const("true")


def test_helpers_of_other_libraries() -> None:
    machine = CppMachine()
    name = machine.variable(Const("a:b:c"))
    machine.call(External("boost.algorithm.replace_all"), (name, *values(":", "/")))
    assert read(machine, name) == Const("a/b/c")
    pieces = machine.call(External("rcpputils.split"), (name, Const("/")))
    assert isinstance(pieces, Ref)
    assert machine.obj(pieces).items == values("a", "b", "c")
    assert machine.call(External("absl.StrJoin"), (pieces, Const("-"))) == Const("a-b-c")
    assert machine.call(External("absl.StrCat"), values("a", 1)) == Const("a1")


def test_numbers_from_texts() -> None:
    machine = CppMachine()
    assert machine.function_of("stoi", Const("12 m")) == Const(12)
    assert machine.function_of("stoul", *values("0x10"), NONE, Const(16)) == Const(16)
    assert machine.function_of("stod", Const("2.5")) == Const(2.5)
    assert machine.function_of("atoi", Const("x")) == Const(0)
    machine.function_of("stoi", Const("x"))
    assert machine.thrown == ["invalid_argument"]


def test_the_environment_is_not_known_unless_somebody_sets_it() -> None:
    machine = CppMachine()
    value = machine.function_of("getenv", Const("ROBOT_NAME"))
    assert machine.truth(value) is None
    machine.environment = {"ROBOT_NAME": Const("ant"), "GONE": None}
    assert machine.function_of("getenv", Const("ROBOT_NAME")) == Const("ant")
    assert machine.function_of("getenv", Const("GONE")) == NONE


def test_a_string_of_characters() -> None:
    machine = CppMachine()
    assert machine.call(STRING, values(3, "x")) == Const("xxx")
    letters = machine.call(TypeOf("std.vector", (TypeOf("char", ()),)), ())
    machine.method(letters, "push_back", Const("a"))
    machine.method(letters, "push_back", Const(98))
    ends = (machine.method(letters, "begin"), machine.method(letters, "end"))
    assert machine.call(STRING, ends) == Const("ab")
    assert machine.function_of("max", Const(1), Const(2), types=(INT,)) == Const(2)
