# SPDX-License-Identifier: Apache-2.0
"""The tree of what launch files start: for people, and as JSON under its schema."""

from __future__ import annotations

import json
from importlib import resources

import jsonschema
from hypothesis import given
from hypothesis import strategies as st

from rosward.findings import Finding
from rosward.location import Place
from rosward.network.launch_tree import GivenParameter, Inclusion, LaunchEntry, LaunchSystem, Shown
from rosward.outputs.documents.launch_tree_json import launch_tree_json
from rosward.outputs.terminal.launch_tree import launch_tree_text

SCHEMA = json.loads((resources.files("rosward.outputs") / "schemas" / "launch-tree.schema.json").read_text())
VALIDATOR = jsonschema.Draft202012Validator(SCHEMA)

SHOWN = st.builds(Shown, st.text(max_size=8), st.text(max_size=8))
MAYBE = st.none() | SHOWN
PLACES = st.builds(Place, st.text(max_size=8), st.integers(0, 99))
ENTRIES = st.builds(
    LaunchEntry,
    kind=st.sampled_from(["node", "lifecycle", "container", "component", "process"]),
    package=MAYBE,
    executable=MAYBE,
    plugin=MAYBE,
    container=MAYBE,
    name=MAYBE,
    namespace=MAYBE,
    remaps=st.lists(st.tuples(SHOWN, SHOWN), max_size=2).map(tuple),
    parameters=st.lists(
        st.builds(
            GivenParameter,
            kind=st.sampled_from(["global", "rule", "dict", "file"]),
            name=st.text(max_size=5),
            value=SHOWN,
            scope=st.just("/**"),
            place=st.none() | PLACES,
        ),
        max_size=2,
    ).map(tuple),
    words=st.lists(SHOWN, max_size=2).map(tuple),
    environment=st.lists(st.tuples(st.text(max_size=5), SHOWN), max_size=2).map(tuple),
    place=PLACES,
    trail=st.lists(st.builds(Inclusion, PLACES, st.text(max_size=5), st.integers(0, 3)), max_size=2).map(tuple),
    program=st.text(max_size=8),
    conditional=st.booleans(),
    why=st.lists(st.text(max_size=5), max_size=2).map(tuple),
    event=st.sampled_from(["", "timer"]),
)
SYSTEMS = st.lists(
    st.builds(LaunchSystem, st.text(max_size=8), st.text(max_size=8), st.lists(ENTRIES, max_size=3).map(tuple)),
    max_size=2,
)
FINDING = Finding("RW316", "The condition is not known.", Place("a.launch.py", 3))


def test_the_schema_is_one() -> None:
    jsonschema.Draft202012Validator.check_schema(SCHEMA)


@given(SYSTEMS)
def test_any_tree_is_as_the_schema_says(systems: list[LaunchSystem]) -> None:
    document = json.loads(launch_tree_json(systems, [FINDING]))
    VALIDATOR.validate(document)
    assert [len(s["entries"]) for s in document["systems"]] == [len(s.entries) for s in systems]


@given(SYSTEMS)
def test_any_tree_is_printed(systems: list[LaunchSystem]) -> None:
    """Each entry has a line, whatever its texts hold; nothing in them reaches the terminal as a command."""
    text = launch_tree_text(systems, [FINDING])
    assert "\x1b" not in text
    assert text.count("─ ") >= sum(len(s.entries) for s in systems)


def test_every_field_is_in_the_schema() -> None:
    definitions = SCHEMA["$defs"]
    assert definitions["entry"]["required"] == list(LaunchEntry._fields)
    assert definitions["parameter"]["required"] == list(GivenParameter._fields)
    assert definitions["inclusion"]["required"] == list(Inclusion._fields)
    assert definitions["system"]["required"] == list(LaunchSystem._fields)
