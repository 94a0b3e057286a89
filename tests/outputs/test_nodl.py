# SPDX-License-Identifier: Apache-2.0
"""NoDL 2 documents: valid by the schema of ros-tooling/nodl, with names that fit any instance of the node."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import jsonschema
import pytest
import yaml
from referencing import Registry, Resource

from rosward.outputs.policies.nodl import nodl_document
from rosward.ros.entities import EntityKind, Node, Parameter, Qos

from .networks import entity, node, pub, sub

FOLDER = Path(__file__).parent / "schemas"
SCHEMAS = {f"{n}.schema.yaml": yaml.safe_load((FOLDER / f"{n}.schema.yaml").read_text()) for n in ("nodl", "parameter")}
REGISTRY: Registry[Any] = Registry().with_resources([(k, Resource.from_contents(v)) for k, v in SCHEMAS.items()])
VALIDATOR = jsonschema.Draft7Validator(SCHEMAS["nodl.schema.yaml"], registry=REGISTRY)


def document(made: Node) -> dict[str, Any]:
    parsed: dict[str, Any] = yaml.safe_load(nodl_document(made))
    VALIDATOR.validate(parsed)
    return parsed


def names(made: dict[str, Any], section: str) -> list[str]:
    return [each["name"] for each in made.get(section, [])]


RELIABLE = Qos("reliable", "volatile", "keep_last", 10)


def test_a_talker() -> None:
    made = node("/talker", pub("/chatter", qos=RELIABLE))
    assert nodl_document(made) == (
        "nodl_version: 2\n"
        "description: Node talker of demo/talker, extracted from its source by rosward.\n"
        "publishers:\n"
        "- name: chatter\n"
        "  type: std_msgs/msg/String\n"
        "  qos:\n"
        "    history: KEEP_LAST\n"
        "    depth: 10\n"
        "    reliability: RELIABLE\n"
        "    durability: VOLATILE\n"
    )


@pytest.mark.parametrize(
    ("fqn", "name", "written"),
    [
        ("/arm", "/arm/state", "~/state"),
        ("/left/arm", "/left/arm/state", "~/state"),
        ("/left/arm", "/left/state", "state"),
        ("/left/arm", "/right/state", "/right/state"),
        ("/left/arm", "/leftover", "/leftover"),
        ("/left/arm", "/left/armed", "armed"),
        ("/arm", "/x", "x"),
    ],
)
def test_names_are_those_of_any_instance(fqn: str, name: str, written: str) -> None:
    assert names(document(node(fqn, pub(name, qos=RELIABLE))), "publishers") == [written]


def test_every_kind_has_its_section_and_implicit_entities_have_none() -> None:
    made = document(
        node(
            "/n",
            pub("/p", qos=RELIABLE),
            sub("/s", qos=RELIABLE),
            entity(EntityKind.SERVICE_SERVER, "/ss", "std_srvs/srv/Empty"),
            entity(EntityKind.SERVICE_CLIENT, "/sc", "std_srvs/srv/Empty"),
            entity(EntityKind.ACTION_SERVER, "/as", "nav2_msgs/action/Spin"),
            entity(EntityKind.ACTION_CLIENT, "/ac", "nav2_msgs/action/Spin"),
        )
    )
    sections = ("publishers", "subscriptions", "service_servers", "service_clients", "action_servers", "action_clients")
    assert [names(made, s) for s in sections] == [["p"], ["s"], ["ss"], ["sc"], ["as"], ["ac"]]


@pytest.mark.parametrize(
    ("qos", "written", "known"),
    [
        (None, {"history": "SYSTEM_DEFAULT", "reliability": "SYSTEM_DEFAULT"}, False),
        (Qos("best_effort", None, "keep_all", None), {"history": "KEEP_ALL", "reliability": "BEST_EFFORT"}, True),
        (Qos("reliable", None, "keep_last", None), {"history": "SYSTEM_DEFAULT", "reliability": "RELIABLE"}, False),
        (Qos("reliable", None, "keep_last", 0), {"history": "SYSTEM_DEFAULT", "reliability": "RELIABLE"}, True),
    ],
)
def test_qos_that_is_not_known_is_said_to_be_so(qos: Qos | None, written: dict[str, Any], known: bool) -> None:
    (endpoint,) = document(node("/n", pub("/p", qos=qos)))["publishers"]
    assert endpoint["qos"] == written
    assert ("QoS is unknown" in endpoint.get("description", "")) is not known


def test_what_nodl_cannot_say_stands_at_the_head() -> None:
    text = nodl_document(node("/n", pub("/robot_*/cmd"), pub("/p", None), pub("/q", qos=RELIABLE, conditional=True)))
    assert text.startswith(
        "# Not described: publisher /p, whose type is unknown.\n"
        "# Not described: publisher /robot_*/cmd, whose name is not completely known.\n"
    )
    (only,) = yaml.safe_load(text)["publishers"]
    assert (only["name"], only["description"]) == ("q", "only in some executions")


def test_parameters() -> None:
    made = node(
        "/n",
        parameters=(
            Parameter("rate", "double", 2.5, 2.5, None),
            Parameter("frames", None, ["a", "b"], None, None),
            Parameter("port", "integer", None, None, None),
            Parameter("use_sim_time", "bool", False, False, None),
            Parameter("what", None, None, None, None),
        ),
    )
    assert document(made)["parameters"] == {
        "rate": {"type": "double", "default_value": 2.5},
        "frames": {"type": "string_array", "default_value": ["a", "b"]},
        "port": {"type": "int"},
    }
    assert "# Not described: parameter what, whose type is unknown." in nodl_document(made)


def test_hostile_names_break_nothing() -> None:
    made = node("/n", pub("/x\n- evil: 1", qos=RELIABLE), pub("/y", "a/msg/B\n: c", qos=RELIABLE))
    text = nodl_document(made)
    assert "publishers" not in yaml.safe_load(text)
