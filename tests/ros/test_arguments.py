# SPDX-License-Identifier: Apache-2.0
# mypy: disable-error-code="arg-type, list-item"
"""Promise: a command line is read as rcl reads it, with the types that rcl gives to values."""

from __future__ import annotations

import contextlib
import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rosward.ros.arguments import (
    InvalidArgument,
    ParameterRule,
    ParamsFile,
    RosArguments,
    key_fits_node,
    parameters_of_node,
    parse_arguments,
    parse_parameter_rule,
    parse_remap_rule,
)
from rosward.ros.names import RemapKind, RemapRule
from rosward.ros.parameter_values import ParameterValue, effective_value, parse_value, scalar_value

UNKNOWN = ParameterValue(None, None)


def parse(line: str) -> RosArguments:
    return parse_arguments(line.split())


def parameter(name: str, kind: str, value: object, node: str = "/**") -> ParameterRule:
    return ParameterRule(node, name, ParameterValue(kind, value))


def test_a_whole_line() -> None:
    found = parse(
        "talker --speed 2 --ros-args -r chatter:=/x --remap __ns:=/left -p rate:=10 --params-file a.yaml"
        " --param talker:loud:=true -e /talker --disable-rosout-logs --log-level debug -- -v a:=b"
    )
    assert found == RosArguments(
        remaps=(
            RemapRule(None, RemapKind.BOTH, "chatter", "/x"),
            RemapRule(None, RemapKind.NAMESPACE, "", "/left"),
            RemapRule(None, RemapKind.BOTH, "a", "b"),
        ),
        overrides=(
            parameter("rate", "integer", 10),
            ParamsFile("a.yaml"),
            parameter("loud", "bool", True, "talker"),
        ),
        enclave="/talker",
        rosout_logs=False,
        user_arguments=("talker", "--speed", "2", "-v"),
        deprecated=("a:=b",),
    )
    assert found.params_files == ("a.yaml",)
    assert [rule.name for rule in found.parameters] == ["rate", "loud"]


def test_nothing() -> None:
    assert parse_arguments([]) == RosArguments()


def test_without_the_flag_words_are_for_the_user_or_old_remap_rules() -> None:
    found = parse("-r a:=b -p x:=1 -- c:=d --disable-rosout-logs")
    assert [(rule.match, rule.replacement) for rule in found.remaps] == [("a", "b"), ("c", "d")]
    assert found.user_arguments == ("-r", "-p", "x:=1", "--", "--disable-rosout-logs")
    assert found.overrides == ()
    assert found.rosout_logs


def test_the_last_enclave_counts() -> None:
    assert parse("--ros-args -e bad -e /good").enclave == "/good"
    assert parse("--ros-args -e bad -e /good").errors == ()
    assert parse("--ros-args -e /good -e bad").errors != ()
    assert parse("").enclave is None


@pytest.mark.parametrize(
    "line",
    [
        *(
            "-r",
            "-p",
            "-e",
            "--params-file",
            "--log-level",
            "--foo",
            "word",
            "a:=b",
            "--en-rosout-logs",
            "-r a",
            "-p a",
        ),
        *(
            "-r a__b:=c",
            "-p /ns/node:x:=1",
            "-p x:={a:1}",
            "-p x:=",
            "-e a",
            "--log-level loud",
            "--log-level a:=b:=info",
        ),
    ],
)
def test_errors(line: str) -> None:
    assert len(parse(f"--ros-args {line}").errors) == 1


def test_what_can_be_read_beside_an_error_is_there() -> None:
    found = parse("--ros-args --foo -r a:=b")
    assert len(found.errors) == len(found.remaps) == 1


def test_switches_of_logging() -> None:
    assert parse("--ros-args --disable-rosout-logs --enable-rosout-logs").rosout_logs
    assert not parse("--ros-args --enable-rosout-logs --disable-rosout-logs").rosout_logs
    assert parse("--ros-args --disable-stdout-logs --enable-external-lib-logs --log-config-file x").errors == ()
    assert parse("--ros-args --log-level a.b:=WARN --log-level info --log-file-name x").errors == ()


# Remap rules


@pytest.mark.parametrize(
    ("text", "node", "kind", "match", "target"),
    [
        ("a:=b", None, "both", "a", "b"),
        ("/a/b:=~/c", None, "both", "/a/b", "~/c"),
        ("~/a:=/b/c", None, "both", "~/a", "/b/c"),
        ("arm:a:=b", "arm", "both", "a", "b"),
        ("rostopic://a:=b", None, "topic", "a", "b"),
        ("arm:rosservice:///a:=b", "arm", "service", "/a", "b"),
        ("rostopic:/a:=b", "rostopic", "both", "/a", "b"),
        ("rostopic:=b", None, "both", "rostopic", "b"),
        ("__node:=b", None, "node", "", "b"),
        ("arm:__name:=b", "arm", "node", "", "b"),
        ("__ns:=/", None, "namespace", "", "/"),
        ("__ns:=/a/b/", None, "namespace", "", "/a/b/"),
        ("_a_1:=b_", None, "both", "_a_1", "b_"),
        # holes
        ("*:=b", None, "both", "*", "b"),
        ("a/*:=/*/b_*", None, "both", "a/*", "/*/b_*"),
        ("__ns:=*", None, "namespace", "", "*"),
        ("__ns:=/r*/b", None, "namespace", "", "/r*/b"),
        ("__ns:=*/b", None, "namespace", "", "*/b"),
        ("__node:=*", None, "node", "", "*"),
        ("arm_*:a:=b", "arm_*", "both", "a", "b"),
    ],
)
def test_remap_rule(text: str, node: str | None, kind: str, match: str, target: str) -> None:
    assert parse_remap_rule(text) == RemapRule(node, RemapKind(kind), match, target)


@pytest.mark.parametrize(
    "text",
    [
        "",
        "a",
        "a:=",
        ":=a",
        "a:b",
        "a__b:=c",
        "a:=__b",
        "a:=~",
        "~:=a",
        "a:={node}",
        "a:=b/",
        "a/:=b",
        "a:=1",
        "a.b:=c",
        "/ns/arm:a:=b",
        "a::=b",
        "a:b:c:=d",
        "__ns:=a",
        "__ns:=//",
        "__node:=/a",
        "__node:=a/b",
        "__ns:=",
        "a:=b c",
        "a:=b:=c",
    ],
)
def test_no_remap_rule(text: str) -> None:
    with pytest.raises(InvalidArgument):
        parse_remap_rule(text)


@given(st.lists(st.sampled_from([*":/~_*.a1", ":=", "__ns", "__node", "rostopic://"]), max_size=8).map("".join))
def test_a_rule_is_read_back_or_rejected(text: str) -> None:
    try:
        found = parse_remap_rule(text)
    except InvalidArgument:
        return
    scheme = {RemapKind.TOPIC: "rostopic://", RemapKind.SERVICE: "rosservice://"}.get(found.kind, "")
    match = {RemapKind.NODE: "__node", RemapKind.NAMESPACE: "__ns"}.get(found.kind, found.match)
    prefix = "" if found.node is None else f"{found.node}:"
    assert f"{prefix}{scheme}{match}:={found.replacement}" == text


# Parameters


@pytest.mark.parametrize(
    ("text", "node", "name"),
    [
        ("x:=1", "/**", "x"),
        ("arm:x:=1", "arm", "x"),
        ("a.b.c:=1", "/**", "a.b.c"),
        ("a/b:=1", "/**", "a/b"),
        ("a__b:=1", "/**", "a__b"),
        ("arm:/a//b.c:=1", "arm", "/a//b.c"),
        ("qos_overrides./tf.publisher.depth:=1", "/**", "qos_overrides./tf.publisher.depth"),
        ("arm_*:x_*:=1", "arm_*", "x_*"),
    ],
)
def test_parameter_rule(text: str, node: str, name: str) -> None:
    assert parse_parameter_rule(text) == parameter(name, "integer", 1, node)


@pytest.mark.parametrize(
    "text", ["x", "1x:=1", "__x:=1", "a..b:=1", "a-b:=1", "a:b:c:=1", "/ns/arm:x:=1", "~/a:=1", "a.:=1"]
)
def test_no_parameter_rule(text: str) -> None:
    with pytest.raises(InvalidArgument):
        parse_parameter_rule(text)


@pytest.mark.parametrize(
    ("text", "kind", "value"),
    [
        *(
            ("1", "integer", 1),
            ("-1", "integer", -1),
            ("010", "integer", 8),
            ("0x1F", "integer", 31),
            ("08", "double", 8.0),
        ),
        *(("9223372036854775807", "integer", 2**63 - 1), ("9223372036854775808", "double", 2.0**63)),
        *(("1.", "double", 1.0), (".5", "double", 0.5), ("5e3", "double", 5000.0), ("0x1p3", "double", 8.0)),
        *(
            ("1e400", "string", "1e400"),
            ("1e-310", "string", "1e-310"),
            ("0e0", "double", 0.0),
            ("-.inf", "double", -math.inf),
        ),
        *(("y", "bool", True), ("Off", "bool", False), ("tRUE", "string", "tRUE"), ("null", "string", "null")),
        *(("~", "string", "~"), ("0b11", "string", "0b11"), ("1_000", "string", "1_000"), ("a b", "string", "a b")),
        *(("'y'", "string", "y"), ('"1"', "string", "1"), ("!!str 5", "string", "5"), ("''", "string", "")),
        *(("[1, 2]", "integer_array", (1, 2)), ("[a, b]", "string_array", ("a", "b")), ("[]", "not_set", None)),
        *(("[[1, 2], [3]]", "integer_array", (3,)), ("1\n---\nx", "integer", 1), (" 1 # one", "integer", 1)),
        *(("9" * 5000, "string", "9" * 5000), ("infinity", "double", math.inf)),
        ("robot_*", "string", "robot_*"),
    ],
)
def test_value(text: str, kind: str, value: object) -> None:
    found = parse_value(text)
    assert (found.type, found.value) == (kind, value)
    assert type(found.value) is type(value)


def test_not_a_number() -> None:
    for text in (".nan", "nan", "-NaN"):
        found = parse_value(text)
        assert found.type == "double"
        assert isinstance(found.value, float)
        assert math.isnan(found.value)


@pytest.mark.parametrize("text", ["", "{a: 1}", "a: b", "[1, 2.0]", "[a, 1]", "[1", "&a", "@a", "[1, ]x", "- "])
def test_no_value(text: str) -> None:
    with pytest.raises(InvalidArgument):
        parse_value(text)


@pytest.mark.parametrize("text", ["*", "1*", "*.5", "[1, *]", "[1*, 2]", "{*}", "*a", "tru*e"])
def test_a_hole_that_decides_the_type(text: str) -> None:
    assert parse_value(text) == UNKNOWN


@given(st.integers(-(2**63), 2**63 - 1))
def test_integers(number: int) -> None:
    assert scalar_value(str(number)) == ("integer", number)
    assert scalar_value(hex(number)) == ("integer", number)


@given(st.floats(allow_nan=False, allow_subnormal=False))
def test_doubles(number: float) -> None:
    assert scalar_value(repr(number)) == ("double", number)


@given(st.text(max_size=8), st.booleans())
def test_every_scalar_has_a_type(text: str, quoted: bool) -> None:
    found = scalar_value(text, quoted=quoted)
    assert found.type in ("bool", "integer", "double", "string")
    assert found.type == "string" or not quoted
    assert found.type != "string" or found.value == text


@given(st.text(max_size=12))
def test_any_value_is_read_or_rejected(text: str) -> None:
    with contextlib.suppress(InvalidArgument):
        parse_value(text)


# Several values


def test_the_type_comes_before_the_order() -> None:
    one, two, word = ParameterValue("integer", 1), ParameterValue("integer", 2), ParameterValue("string", "a")
    items, nothing = ParameterValue("integer_array", (1,)), ParameterValue("not_set", None)
    assert effective_value([one, two]) == two
    assert effective_value([one, word]) == effective_value([word, one]) == one
    assert effective_value([items, word]) == word
    assert effective_value([one, nothing]) == one
    assert effective_value([nothing]) == effective_value([]) == nothing
    assert effective_value([one, UNKNOWN]) == UNKNOWN


@pytest.mark.parametrize(
    ("key", "node", "fits"),
    [
        *(("/**", "/a", True), ("/**", "/a/b", True), ("/*", "/a", True), ("/*", "/a/b", False), ("a", "/a", True)),
        *(("a", "/b/a", False), ("/b/a", "/b/a", True), ("b/a", "/b/a", True), ("/*/a", "/b/a", True)),
        *(("/*/a", "/a", False), ("/**/a", "/a", True), ("/**/a", "/b/c/a", True), ("/b/**", "/b/c/a", True)),
        *(("/b/**", "/c/a", False), ("/b/*", "/b/c/a", False)),
        *(("/**", "/*", True), ("a", "/*", None), ("a", "/b*", False), ("/*/a", "/b*", None)),
    ],
)
def test_keys(key: str, node: str, fits: bool | None) -> None:
    assert key_fits_node(key, node) is fits


def test_parameters_of_a_node() -> None:
    def found(line: str, node: str) -> dict[str, object]:
        return {
            key: value.value for key, value in parameters_of_node(parse(f"--ros-args {line}").parameters, node).items()
        }

    assert found("-p x:=1 -p arm:x:=2 -p leg:x:=3 -p y:=4", "/arm") == {"x": 2, "y": 4}
    assert found("-p arm:x:=2 -p x:=1", "/arm") == {"x": 1}
    assert found("-p arm:x:=1 -p x:=2 -p arm:x:=3", "/arm") == {"x": 2}
    assert found("-p arm:x:=1 -p y:=2", "/ns/arm") == {"y": 2}
    assert found("-p arm:x:=1 -p y:=2", "/*") == {"x": None, "y": 2}


# Holes


def test_words_that_holes_make_unreadable() -> None:
    found = parse("* --ros-args -r * --robot_* -p *")
    assert found.unknown == ("-r *", "--robot_*", "-p *")
    assert found.user_arguments == ("*",)
    assert found.errors == ()


@given(st.lists(st.sampled_from(["--ros-args", "--", "-r", "-p", "a:=b", "x:=1", "-e", "/e", "w", "*", "--log-level"])))
def test_no_word_is_lost(words: list[str]) -> None:
    found = parse_arguments(words)
    if not found.errors and not found.unknown:
        left, pairs = iter(words), 0
        for word in left:
            if word in ("-r", "-p", "-e", "--log-level") and word not in found.user_arguments:
                pairs += 1
                next(left, None)  # its value, also where that looks like an option
        assert len(found.user_arguments) + len(found.deprecated) + 2 * pairs <= len(words)
    assert set(found.user_arguments) <= set(words)


@given(st.lists(st.text(max_size=6)))
def test_any_line_is_read(words: list[str]) -> None:
    parse_arguments(words)
    parse_arguments(["--ros-args", *words])
