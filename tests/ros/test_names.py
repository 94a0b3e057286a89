# SPDX-License-Identifier: Apache-2.0
# mypy: disable-error-code="arg-type, list-item"
"""Promise: names become what rcl makes of them, and a name with holes covers whatever its holes may hold."""

from __future__ import annotations

import re

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from rosward.ros import names, validation
from rosward.ros.distro import Distro
from rosward.ros.names import InvalidName, RemapKind, RemapRule, expand, may_be_equal, remap_node, resolve, widen

TOPIC, SERVICE, BOTH = RemapKind.TOPIC, RemapKind.SERVICE, RemapKind.BOTH


def rule(match: str, target: str, node: str | None = None, kind: RemapKind = BOTH) -> RemapRule:
    return RemapRule(node, kind, match, target)


def covers(pattern: str, name: str) -> bool:
    """As DDS permissions match, by fnmatch: a hole also holds `/`."""
    return re.fullmatch(".*".join(map(re.escape, pattern.split("*"))), name) is not None


# Expansion


@pytest.mark.parametrize(
    ("name", "namespace", "expected"),
    [
        ("chatter", "/", "/chatter"),
        ("chatter", "/ns", "/ns/chatter"),
        ("/chatter", "/ns", "/chatter"),
        ("~", "/ns", "/ns/node"),
        ("~/x", "/ns", "/ns/node/x"),
        ("~/x", "/", "/node/x"),
        ("~x", "/ns", "/ns/nodex"),
        ("{node}/x", "/ns", "/ns/node/x"),
        ("{ns}/x", "/ns", "/ns/x"),
        ("/a{namespace}/{node}", "/ns", "/a/ns/node"),
        ("{ns}/x", "/", "//x"),
        # holes
        ("*", "/ns", "/*"),
        ("*/cmd_vel", "/ns", "/*cmd_vel"),
        ("*x", "/ns", "/*x"),
        ("**", "/ns", "/*"),
        ("robot_*/cmd", "/ns", "/ns/robot_*/cmd"),
        ("robot_*/cmd", "/", "/robot_*/cmd"),
        ("/*/cmd", "/ns", "/*/cmd"),
        ("cmd", "*", "/*cmd"),
        ("cmd", "/*", "/*cmd"),
        ("cmd", "/r*", "/r*/cmd"),
        ("cmd", "/a/*", "/a/*/cmd"),
        ("~/x", "/*", "/*node/x"),
        ("~*", "/ns", "/ns/node*"),
        ("*~/x", "/ns", "/ns/node/x"),
        ("*{ns}/x", "/ns", "/*ns/x"),
        ("a/{n*}/x", "/ns", "/ns/a/*/x"),
        ("{*}/x", "/ns", "/*x"),
        ("a{*", "/ns", "/ns/a*"),
        ("*x}/y", "/ns", "/*y"),
        ("a*{node}", "/ns", "/ns/a*node"),
    ],
)
def test_expand(name: str, namespace: str, expected: str) -> None:
    assert expand(name, "node", namespace) == expected


def test_expand_in_a_node_of_unknown_name() -> None:
    assert expand("~/x", "*", "/") == "/*/x"
    assert expand("~/x", "arm_*", "/ns") == "/ns/arm_*/x"
    assert expand("{node}/x", "*", "*") == "/*/x"


@pytest.mark.parametrize(
    "name",
    [
        "",
        "/",
        "a/",
        "1a",
        "a/1",
        "~xy",
        "a~",
        "a*~",
        "{x}",
        "{}",
        "{1}",
        "{{node}}",
        "{node",
        "node}",
        "{n/s}",
        "a-b",
        "ä",
        "*/",
        "1*",
        "*/1",
        "*-",
        "*~xy",
        "a b",
        "{node}}",
        "*{x}",
    ],
)
def test_expand_rejects(name: str) -> None:
    with pytest.raises(InvalidName):
        expand(name, "node", "/ns")


def test_expand_rejects_wrong_nodes() -> None:
    for node_name, namespace in (("1a", "/"), ("", "/"), ("a/b", "/"), ("a", "ns"), ("a", ""), ("a", "/ns/")):
        with pytest.raises(InvalidName):
            expand("chatter", node_name, namespace)


def test_full_namespace() -> None:
    cases = {
        "": "/",
        "/": "/",
        "hub": "/hub",
        "a/b": "/a/b",
        "/a": "/a",
        "*": "/*",
        "*/b": "/*b",
        "a*": "/a*",
        "/*": "/*",
    }
    assert {namespace: names.full_namespace(namespace) for namespace in cases} == cases


def test_fully_qualified() -> None:
    assert names.fully_qualified("/", "n") == "/n"
    assert names.fully_qualified("/a", "n") == "/a/n"
    assert names.fully_qualified("/*", "n") == "/*n"


# Validation


@pytest.mark.parametrize(
    "name", ["/a", "/a__b", "/_a", "/a/b1", "/*", "*", "/*/a", "/a*", "/*1", "*1", "/" + "a" * 246]
)
def test_valid_full_names(name: str) -> None:
    assert validation.validate_full(name) is None


@pytest.mark.parametrize(
    "name", ["", "a", "/", "/a/", "//a", "/1", "/a/1*", "/a~", "/a{b}", "/a-b", "/ä", "/" + "a" * 247]
)
def test_invalid_full_names(name: str) -> None:
    assert validation.validate_full(name) is not None


def test_lengths() -> None:
    assert validation.validate_node_name("a" * 255) is None
    assert validation.validate_node_name("a" * 256) is not None
    assert validation.validate_namespace("/" + "a" * 244) is None
    assert validation.validate_namespace("/" + "a" * 245) is not None
    assert validation.validate_enclave("/" + "a" * 254) is None
    assert validation.validate_enclave("/" + "a" * 255) is not None
    assert validation.validate_full("/*" + "a" * 246) is None  # the hole may be empty


def test_root_is_a_namespace_and_an_enclave_but_no_topic() -> None:
    assert validation.validate_namespace("/") is validation.validate_enclave("/") is None
    assert validation.validate_full("/") is not None


# Remapping


@pytest.mark.parametrize(
    ("rules", "expected"),
    [
        ([], "/ns/chatter"),
        ([rule("chatter", "x")], "/ns/x"),
        ([rule("chatter", "/x")], "/x"),
        ([rule("chatter", "~/x")], "/ns/node/x"),
        ([rule("/ns/chatter", "x")], "/ns/x"),
        ([rule("/chatter", "x")], "/ns/chatter"),
        ([rule("chatter", "a"), rule("chatter", "b")], "/ns/a"),
        ([rule("chatter", "a"), rule("a", "b")], "/ns/a"),
        ([rule("chatter", "x", "node")], "/ns/x"),
        ([rule("chatter", "x", "other")], "/ns/chatter"),
        ([rule("chatter", "x", kind=TOPIC)], "/ns/x"),
        ([rule("chatter", "x", kind=SERVICE)], "/ns/chatter"),
        ([rule("{other}", "x"), rule("chatter", "y")], "/ns/y"),
    ],
)
def test_remap(rules: list[RemapRule], expected: str) -> None:
    assert resolve("chatter", TOPIC, rules, "node", "/ns") == (expected,)


def test_a_rule_that_may_fit_leaves_both_names() -> None:
    assert resolve("robot_*/cmd", TOPIC, [rule("/robot_1/cmd", "/x")], "node", "/") == ("/x", "/robot_*/cmd")
    assert resolve("robot_*/cmd", TOPIC, [rule("/robot_1/x", "/x")], "node", "/") == ("/robot_*/cmd",)
    assert resolve("*", TOPIC, [rule("a", "b"), rule("c", "d")], "node", "/") == ("/b", "/d", "/*")
    assert resolve("cmd", TOPIC, [rule("cmd", "x", "arm_*")], "arm_1", "/") == ("/x", "/cmd")
    assert resolve("cmd", TOPIC, [rule("cmd", "x", "arm_*")], "leg", "/") == ("/cmd",)


def test_an_unknown_namespace_is_the_same_on_both_sides() -> None:
    assert resolve("cmd", TOPIC, [rule("cmd", "x")], "node", "/*") == ("/*x",)
    assert resolve("~/cmd", TOPIC, [rule("~/cmd", "x")], "*", "/a") == ("/a/x",)
    assert resolve("cmd", TOPIC, [rule("/ns/cmd", "/x")], "node", "/*") == ("/x", "/*cmd")
    assert resolve("/cmd", TOPIC, [rule("cmd", "/x")], "node", "/*") == ("/x", "/cmd")


def test_what_a_rule_makes_is_validated() -> None:
    with pytest.raises(InvalidName):
        resolve("{ns}/x", TOPIC, [], "node", "/")
    with pytest.raises(InvalidName):
        resolve("x", TOPIC, [rule("x", "{other}")], "node", "/")
    assert resolve("{ns}/x", TOPIC, [], "node", "/*") == ("/*/x",)


def test_remap_node() -> None:
    node, space = RemapKind.NODE, RemapKind.NAMESPACE
    rules = [rule("", "q", kind=node), rule("", "/x", "node", kind=space), rule("", "/y", "q", kind=space)]
    assert remap_node("node", "", rules) == ("q", "/y")
    assert remap_node("node", "ns", []) == ("node", "/ns")
    assert remap_node("node", "ns", [rule("", "q", "other", kind=node)]) == ("node", "/ns")
    assert remap_node("node", "", [rule("", "a", kind=node), rule("", "b", kind=node)]) == ("a", "/")
    assert remap_node("node", "", [rule("", "*", kind=space)]) == ("node", "/*")
    assert remap_node("arm_*", "", [rule("", "arm_x", "arm_1", kind=node)]) == ("arm_*", "/")
    assert remap_node("*", "/a", [rule("", "/b", "arm", kind=space)]) == ("*", "/*")


def test_action_names() -> None:
    assert [d.value for d in Distro if not d.facts.actions_are_remapped] == ["humble", "iron"]


# Laws

PIECES = st.sampled_from([*"ab1_/~{}*", "{node}", "{ns}", "*/", "node", "ns"])
HOLEY = st.lists(PIECES, max_size=6).map("".join)
FILLING = st.lists(st.sampled_from([*"ab1_/~{}", "{node}", "{ns}", "ns", "/ns"]), max_size=3).map("".join)
NODE_HOLEY = st.sampled_from(["node", "*", "n*", "*e", "a*b"])
SPACE_HOLEY = st.sampled_from(["/", "/ns", "*", "/*", "/n*", "/*/b", "/*s", "/a/*"])


def fill(data: st.DataObject, name: str, filling: st.SearchStrategy[str] = FILLING) -> str:
    first, *rest = re.sub(r"\*+", "*", name).split("*")
    return first + "".join(data.draw(filling) + part for part in rest)


@given(st.data(), HOLEY, NODE_HOLEY, SPACE_HOLEY)
def test_expansion_covers_every_filling(data: st.DataObject, name: str, node: str, space: str) -> None:
    full_node = fill(data, node)
    full_space = names.full_namespace(fill(data, space))
    try:
        concrete = expand(fill(data, name), full_node, full_space)
    except InvalidName:
        return
    assume(validation.validate_full(concrete) is None)
    assert covers(expand(name, node, names.full_namespace(space)), concrete)


@given(st.data(), HOLEY)
def test_no_filling_repairs_an_invalid_name(data: st.DataObject, name: str) -> None:
    filled = fill(data, name)
    for validate in (
        validation.validate_name,
        validation.validate_full,
        validation.validate_namespace,
        validation.validate_node_name,
        validation.validate_enclave,
    ):
        if validate(filled) is None:
            assert validate(name) is None


RULE_NAME = st.sampled_from(["a", "/a", "b", "/ns/a", "~/a", "/node/a", "a/b", "ns/a", "/b", "a*", "*", "/*/a"])
RULES = st.lists(
    st.builds(
        RemapRule,
        st.sampled_from([None, None, "node", "n", "n*"]),
        st.sampled_from([TOPIC, SERVICE, BOTH]),
        RULE_NAME,
        RULE_NAME,
    ),
    max_size=3,
)
SHORT = st.lists(st.sampled_from(["a", "/", "b", "*", "~", "ns"]), min_size=1, max_size=4).map("".join)


@given(st.data(), SHORT, RULES, NODE_HOLEY, SPACE_HOLEY)
def test_remapping_covers_every_filling(
    data: st.DataObject, name: str, rules: list[RemapRule], node: str, space: str
) -> None:
    filling = st.sampled_from(["", "a", "/", "/a", "ns", "/ns", "node", "~", "b", "ode"])
    concrete_rules = [
        RemapRule(
            r.node and fill(data, r.node, filling),
            r.kind,
            fill(data, r.match, filling),
            fill(data, r.replacement, filling),
        )
        for r in rules
    ]
    try:
        concrete = resolve(
            fill(data, name, filling),
            TOPIC,
            concrete_rules,
            fill(data, node, filling),
            names.full_namespace(fill(data, space, filling)),
        )
    except InvalidName:
        return
    assert len(concrete) == 1
    assert any(covers(found, concrete[0]) for found in resolve(name, TOPIC, rules, node, names.full_namespace(space)))


@given(SHORT, RULES)
def test_known_names_have_one_answer(name: str, rules: list[RemapRule]) -> None:
    assume("*" not in name)
    known = [r for r in rules if not r.maybe and "*" not in f"{r.node}{r.match}{r.replacement}"]
    for space in ("/", "/ns"):
        try:
            found = resolve(name, TOPIC, known, "node", space)
        except InvalidName:
            continue
        assert len(found) == 1
        full = expand(name, "node", space)
        matching = [
            r
            for r in known
            if r.kind is not SERVICE and r.node in (None, "node") and expand(r.match, "node", space) == full
        ]
        assert found[0] == (expand(matching[0].replacement, "node", space) if matching else full)


@given(HOLEY)
def test_expansion_leaves_absolute_names(name: str) -> None:
    try:
        once = expand(name, "node", "/ns")
    except InvalidName:
        return
    if validation.validate_full(once) is None:
        assert expand(once, "other", "/elsewhere") == once


@given(st.data(), st.text("ab*", max_size=6), st.text("ab*", max_size=6))
def test_may_be_equal(data: st.DataObject, one: str, other: str) -> None:
    assert may_be_equal(one, other) == may_be_equal(other, one) == may_be_equal(one[::-1], other[::-1])
    filled = fill(data, one, st.text("ab", max_size=3))
    assert may_be_equal(filled, other) == covers(other, filled)
    if covers(other, filled):
        assert may_be_equal(one, other)


@given(st.lists(st.text("ab/*", max_size=5), min_size=1, max_size=4))
def test_widen_covers_all(several: list[str]) -> None:
    assert all(covers(widen(several), name) for name in several)


def test_widen() -> None:
    assert widen(["/a/x", "/b/x"]) == "/*/x"
    assert widen(["/a", "/a"]) == "/a"
    assert widen(["/", "/a"]) == "/*"
    assert widen(["/aa", "/a"]) == "/a*"
