# SPDX-License-Identifier: Apache-2.0
# mypy: disable-error-code="arg-type"
"""What the words of a command line mean where parts of them are not known."""

from __future__ import annotations

import pytest

from rosward.domain.compound import Tuple
from rosward.domain.series import Series
from rosward.domain.text import pattern
from rosward.domain.unknown import Cause, Origin, Reason
from rosward.domain.values import Const, Hole, Text, Unknown, Value
from rosward.effects.configuration import Configuration, Given
from rosward.location import Place
from rosward.naming.command_line import CommandLine, behind, given_to, read_words

HOLE = Hole((Reason(Cause.CALL, "gethostname()", Place("a.launch.py", 3)),))
UNKNOWN = Unknown(HOLE.reasons, "str")


def read(*words: str | Value, **files: tuple[Given, ...]) -> CommandLine:
    configuration = Configuration(files={f"{name}.yaml": rows for name, rows in files.items()})
    return read_words(Series(tuple(_word(w) for w in ("--ros-args", *words))), configuration)


def _word(word: str | Value) -> Value:
    return Const(word) if isinstance(word, str) else word


def with_hole(*parts: str | Hole) -> Text:
    return Text(parts)


def test_nothing() -> None:
    assert read_words(Series()) == CommandLine()


def test_a_remap_rule_with_a_hole_in_its_target() -> None:
    line = read("-r", with_hole("__node:=a_", HOLE))
    (rule,) = line.remaps
    assert pattern(rule.target) == "a_*"
    assert rule.target == with_hole("a_", HOLE)
    assert not line.errors
    assert not line.missing


def test_a_target_keeps_its_origin() -> None:
    origin = Origin("launch argument", "to", settled=True)
    line = read("-r", Const("scan:=lidar", frozenset({origin})))
    assert line.remaps[0].target == Const("lidar", frozenset({origin}))


def test_a_word_that_may_be_anything() -> None:
    """It may be a parameter file, too: what it sets is open."""
    line = read(UNKNOWN, "-r", "a:=b")
    assert line.unreadable
    assert line.missing


def test_behind_the_end_of_ros_arguments_rules_are_of_the_old_form() -> None:
    """rcl reads `a:=b` among the program's own words as a remap rule, too, and `-p` is the program's."""
    line = read("-r", "a:=b", "--", "c:=d", "-p", "x")
    assert [r.match for r in line.rules] == ["a", "c"]
    assert not line.errors


def test_parameters_in_their_order() -> None:
    file = (Given("/**", "rate", Const(5)),)
    line = read("-p", "rate:=1", "--params-file", "a.yaml", "-p", "node:rate:=9", a=file)
    assert [g.value for g in line.parameters] == [Const(1), Const(5), Const(9)]


@pytest.mark.parametrize(
    ("word", "value"),
    [
        ("true", Const(True)),
        ("7", Const(7)),
        ("0.5", Const(0.5)),
        ("word", Const("word")),
        ("'7'", Const("7")),
        ("[1, 2]", Tuple((Const(1), Const(2)))),
        ("[]", Tuple(())),
    ],
)
def test_values_have_the_types_of_yaml(word: str, value: Value) -> None:
    assert read("-p", f"x:={word}").parameters[0].value == value


def test_a_value_with_a_hole_is_a_text_where_it_must_be_one() -> None:
    assert pattern(read("-p", with_hole("x:=robot_", HOLE)).parameters[0].value) == "robot_*"


def test_a_value_that_is_a_hole_may_have_any_type() -> None:
    assert isinstance(read("-p", with_hole("x:=", HOLE)).parameters[0].value, Unknown)


def test_a_parameter_file_that_is_not_known_is_open() -> None:
    line = read("--params-file", "none.yaml")
    assert not line.parameters
    assert [r.cause for r in line.missing] == [Cause.FILE]


def test_the_last_enclave_counts() -> None:
    assert read("--enclave", "/a", "-e", "/b").enclave == Const("/b")


def test_logs() -> None:
    assert not read("--disable-rosout-logs").rosout_logs
    assert read("--disable-rosout-logs", "--enable-rosout-logs").rosout_logs


@pytest.mark.parametrize("words", [("-r",), ("-r", "a"), ("-p", "x"), ("--no-such",), ("--enclave",)])
def test_what_rcl_refuses(words: tuple[str, ...]) -> None:
    assert read(*words).errors


def test_behind_a_mark() -> None:
    assert behind(Const("__ns:=/a:=b"), ":=") == Const("/a:=b")
    assert pattern(behind(with_hole("x:=", HOLE, "_y"), ":=")) == "*_y"


def given(node: str, name: str, value: int, *, nested: bool = False) -> Given:
    return Given(node, name, Const(value), nested=nested)


def test_the_later_row_of_a_fitting_key_wins() -> None:
    rows = [given("/**", "x", 1), given("/a", "x", 2), given("/b", "x", 3)]
    assert given_to("/a", rows) == {"x": Const(2)}
    assert given_to("/n/a", rows) == {"x": Const(1)}


def test_a_node_of_a_name_that_is_not_known_may_have_each() -> None:
    found = given_to("/*", [given("/**", "x", 1), given("/a", "x", 2)])
    assert isinstance(found["x"], Unknown)
    assert given_to("/*", [given("/a", "y", 2)])["y"] != Const(2)
