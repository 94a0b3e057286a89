# SPDX-License-Identifier: Apache-2.0
"""What a user asks for, as it is written on the command line: read, written and read again it is the same."""

from __future__ import annotations

import contextlib
from collections.abc import Callable

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rosward.deployment.request import (
    LaunchRequest,
    NodeRequest,
    Request,
    RequestError,
    assignments,
    parse_assignment,
    parse_launch,
    parse_node,
)

NAMES = st.from_regex(r"[a-z][a-z0-9_]{0,8}", fullmatch=True)
ARGUMENT_NAMES = st.from_regex(r"[a-z][a-z0-9_.-]{0,8}", fullmatch=True)
FILES = st.lists(NAMES, min_size=1, max_size=3).map(lambda parts: f"{'/'.join(parts)}.launch.py")
VALUES = st.text(st.characters(codec="utf-8", exclude_characters=","), max_size=12)
ARGUMENTS = st.lists(st.tuples(ARGUMENT_NAMES, VALUES), max_size=3).map(tuple)


@given(st.builds(LaunchRequest, FILES, st.none() | NAMES, ARGUMENTS))
def test_a_launch_request_is_read_as_it_is_written(request: LaunchRequest) -> None:
    text = ",".join([str(request), *(f"{name}:={value}" for name, value in request.arguments)])
    assert parse_launch(text) == request


@given(st.builds(NodeRequest, NAMES, NAMES, st.none() | NAMES))
def test_a_node_request_is_read_as_it_is_written(request: NodeRequest) -> None:
    name = f":{request.name}" if request.name else ""
    assert parse_node(f"{request.package}/{request.executable}{name}") == request


@given(st.text(max_size=30), st.sampled_from([parse_launch, parse_node, parse_assignment]))
def test_any_text_is_read_or_refused(text: str, read: Callable[[str], object]) -> None:
    with contextlib.suppress(RequestError):
        assert read(text)


@pytest.mark.parametrize(
    ("text", "arguments"),
    [
        ("p:a.launch.py,list:=1,2,3", (("list", "1,2,3"),)),
        ("p:a.launch.py,a:=1,2,b:=x", (("a", "1,2"), ("b", "x"))),
        ("p:a.launch.py,rules:=x,/a:=/b", (("rules", "x,/a:=/b"),)),  # no launch argument is called /a
        ("p:a.launch.py,empty:=", (("empty", ""),)),
        (
            "p:a.launch.py,rgb.profile:=640x480,30,a-b.c_1:=1.5,x.y",
            (("rgb.profile", "640x480,30"), ("a-b.c_1", "1.5,x.y")),
        ),
        ("p:a.launch.py,a:=1,.b:=2", (("a", "1,.b:=2"),)),
        ("p:a.launch.py,nested:=b:=c", (("nested", "b:=c"),)),
    ],
)
def test_a_value_may_hold_commas(text: str, arguments: tuple[tuple[str, str], ...]) -> None:
    assert parse_launch(text) == LaunchRequest("a.launch.py", "p", arguments)


@pytest.mark.parametrize("text", ["", ":", "p:", "a/b:x.launch.py", ",a:=1"])
def test_launch_requests_that_are_refused(text: str) -> None:
    with pytest.raises(RequestError):
        parse_launch(text)


def test_a_word_that_gives_nothing_belongs_to_the_file_name() -> None:
    """So the refusal shows it: there is no launch file x.launch.py,side=left."""
    assert parse_launch("p:x.launch.py,side=left") == LaunchRequest("x.launch.py,side=left", "p")


@pytest.mark.parametrize("text", ["", "p", "p/", "/e", "p/e:", ":n", "p:n/e"])
def test_node_requests_that_are_refused(text: str) -> None:
    with pytest.raises(RequestError):
        parse_node(text)


def test_the_last_value_of_a_name_counts() -> None:
    assert assignments(["a:=1", "b:=2", "a:=3"]) == (("a", "3"), ("b", "2"))


def test_what_deploys() -> None:
    assert not Request().deploys
    assert not Request(params=("a.yaml",)).deploys
    assert Request(all_launch=True).deploys
    assert Request(nodes=(NodeRequest("p", "e"),)).deploys
    assert Request(launches=(LaunchRequest("x"),)).deploys
