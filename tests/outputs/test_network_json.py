# SPDX-License-Identifier: Apache-2.0
"""network.json: exactly the contract, the same bytes for the same network."""

from __future__ import annotations

import json
import re
from importlib import resources
from pathlib import Path
from typing import Any

import jsonschema
from hypothesis import given
from hypothesis import strategies as st

from rosward._version import __version__
from rosward.findings import Finding
from rosward.location import Place
from rosward.network.connect import connect
from rosward.network.graph import Network
from rosward.outputs.documents.network_json import network_json
from rosward.ros.entities import Parameter

from .networks import fleet, node, pub, talker_and_listener

SCHEMA = json.loads((resources.files("rosward.outputs") / "schemas" / "network.schema.json").read_text())
VALIDATOR = jsonschema.Draft202012Validator(SCHEMA)


def document(network: Network) -> dict[str, Any]:
    text = network_json(network)
    text.encode()
    parsed: dict[str, Any] = json.loads(text)
    VALIDATOR.validate(parsed)
    return parsed


def test_the_schema_is_one() -> None:
    jsonschema.Draft202012Validator.check_schema(SCHEMA)


def test_keys_stand_in_the_order_of_the_contract() -> None:
    parsed = document(talker_and_listener())
    assert list(parsed) == SCHEMA["required"]
    definitions = SCHEMA["$defs"]
    talker = parsed["nodes"][1]
    assert list(talker) == definitions["node"]["required"]
    assert list(talker["publishers"][0]) == definitions["entity"]["required"]
    assert list(talker["parameters"][0]) == definitions["parameter"]["required"]
    assert list(parsed["topics"][0]) == definitions["topic"]["required"]
    assert list(parsed["services"][0]) == definitions["offer"]["required"]
    assert list(parsed["diagnostics"][0]) == definitions["diagnostic"]["required"]


def test_an_entity_as_it_is_written() -> None:
    publishers = document(talker_and_listener())["nodes"][1]["publishers"]
    assert publishers[2] == {
        "name": "/robot_*/cmd_vel",
        "type": "geometry_msgs/msg/Twist",
        "system": False,
        "resolution": "pattern",
        "conditional": True,
        "callback": None,
        "qos": None,
        "depends_on": ["robot_id"],
        "created_at": [{"file": "src/demo/demo/node.py", "line": 31}],
    }
    assert publishers[1]["qos"] == {
        "reliability": "reliable",
        "durability": "volatile",
        "history": "keep_last",
        "depth": 10,
    }


def test_everything_is_sorted() -> None:
    parsed = document(fleet(3))
    for node_ in parsed["nodes"]:
        for key in ("publishers", "subscriptions", "service_servers"):
            names = [(e["name"], e["type"] or "") for e in node_[key]]
            assert names == sorted(names)
    for key in ("topics", "services", "actions"):
        names = [meeting["name"] for meeting in parsed[key]]
        assert names == sorted(names)


def test_diagnostics_have_the_severity_of_their_rule() -> None:
    partly = Finding("RW102", "b", Place("b.py", 2, 3), ("launch argument: ns",), ("/a",))
    network = connect("jazzy", [], [partly, Finding("RW013", "a", Place("a.py"))])
    assert document(network)["diagnostics"] == [
        {
            "code": "RW013",
            "severity": "note",
            "message": "a",
            "file": "a.py",
            "line": 0,
            "column": 1,
            "causes": [],
            "nodes": [],
        },
        {
            "code": "RW102",
            "severity": "warning",
            "message": "b",
            "file": "b.py",
            "line": 2,
            "column": 3,
            "causes": ["launch argument: ns"],
            "nodes": ["/a"],
        },
    ]


def test_values_that_json_has_no_word_for() -> None:
    values = [float("nan"), float("-inf"), b"\x01", (1, 2.5, "x"), object(), True, None]
    parameters = tuple(Parameter(f"p{i}", None, v, v, None) for i, v in enumerate(values))
    parsed = document(connect("jazzy", [node("/a", parameters=parameters)]))
    assert [p["value"] for p in parsed["nodes"][0]["parameters"]] == [
        ".nan",
        "-.inf",
        [1],
        [1, 2.5, "x"],
        None,
        True,
        None,
    ]


@given(st.text(alphabet=st.characters()))
def test_any_text_survives(text: str) -> None:
    parsed = document(connect("jazzy", [node("/a", pub("/" + text, "type " + text))]))
    assert "/" + text in [topic["name"] for topic in parsed["topics"]]


def test_the_version_is_that_of_the_package() -> None:
    project = (Path(__file__).parents[2] / "pyproject.toml").read_text()
    found = re.search(r'^version = "(.*)"$', project, re.MULTILINE)
    assert found
    assert found[1] == __version__
