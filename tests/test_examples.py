# SPDX-License-Identifier: Apache-2.0
"""The robot in `examples/` comes out exactly, and README.md says of it, and of the tool, what is true."""

from __future__ import annotations

import json
import re
import xml.etree.ElementTree as ET
from importlib import resources
from pathlib import Path
from typing import Any

import jsonschema
import pytest
import xmlschema

import rosward
from rosward.cli import main

ROOT = Path(__file__).parent.parent
README = (ROOT / "README.md").read_text(encoding="utf-8")
SCHEMAS = resources.files("rosward.outputs") / "schemas"
KINDS = {
    "publishers": "pub",
    "subscriptions": "sub",
    "service_servers": "ss",
    "service_clients": "sc",
    "action_servers": "as",
    "action_clients": "ac",
}

EXPECTED = """
/building/door_gateway pub /building/doors/laboratory/open
/building/door_gateway pub /building/doors/lobby/open
/building/door_gateway ss /building/doors/open
/fleet/gateway ac /porter/deliver default
/fleet/gateway pub /fleet/deliveries
/fleet/gateway ss /fleet/request_delivery
/fleet/monitor pub /fleet/alarms default
/fleet/monitor ss /fleet/monitor/reset
/fleet/monitor sub /diagnostics default
/fleet/monitor sub /porter/heartbeat default
/porter/base_driver pub /diagnostics
/porter/base_driver pub /porter/battery
/porter/base_driver pub /porter/heartbeat
/porter/base_driver pub /porter/odom
/porter/base_driver pub /tf
/porter/base_driver ss /porter/base_driver/enable
/porter/base_driver sub /porter/cmd_vel
/porter/battery_monitor pub /diagnostics
/porter/battery_monitor pub /porter/battery_low
/porter/battery_monitor pub /porter/heartbeat
/porter/battery_monitor sub /porter/battery default
/porter/camera pub /porter/camera/camera_info conditional
/porter/camera pub /porter/camera/image_raw conditional
/porter/delivery_planner as /porter/deliver
/porter/delivery_planner pub /porter/heartbeat
/porter/delivery_planner pub /porter/teleop/mux/planner
/porter/delivery_planner sc /building/doors/open conditional
/porter/delivery_planner sub /porter/battery_low
/porter/delivery_planner sub /porter/pose
/porter/dock_detector pub /porter/dock/pose
/porter/dock_detector pub /porter/heartbeat
/porter/dock_detector pub /tf
/porter/dock_detector ss /porter/dock/find
/porter/dock_detector sub /porter/camera/camera_info default
/porter/dock_detector sub /porter/camera/image_raw default
/porter/lidar_filter pub /porter/heartbeat
/porter/lidar_filter pub /porter/scan
/porter/lidar_filter sub /porter/sensors/front/scan default
/porter/lidar_filter sub /porter/sensors/rear/scan default
/porter/localisation pub /porter/heartbeat
/porter/localisation pub /porter/pose
/porter/localisation pub /tf
/porter/localisation pub /tf_static
/porter/localisation sub /map
/porter/localisation sub /porter/initial_pose
/porter/localisation sub /porter/scan
/porter/localisation sub /tf
/porter/localisation sub /tf_static
/porter/teleop/mux pub /porter/cmd_vel
/porter/teleop/mux pub /porter/heartbeat
/porter/teleop/mux pub /porter/teleop/mux/active
/porter/teleop/mux sub /porter/teleop/mux/joystick
/porter/teleop/mux sub /porter/teleop/mux/planner
/porter/teleop/mux sub /porter/teleop/mux/remote
"""


@pytest.fixture(scope="module")
def written(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The outputs of the README's first command."""
    folder = tmp_path_factory.mktemp("examples")
    formats = "json,policy,svg,dot,html,permissions"
    assert main(["extract", str(ROOT / "examples"), "-q", "-o", str(folder), "--format", formats]) == 0
    return folder


@pytest.fixture(scope="module")
def network(written: Path) -> dict[str, Any]:
    """network.json of the robot."""
    parsed: dict[str, Any] = json.loads((written / "network.json").read_text(encoding="utf-8"))
    return parsed


def node(network: dict[str, Any], fqn: str) -> dict[str, Any]:
    return next(n for n in network["nodes"] if n["fqn"] == fqn)


def test_every_entity_is_found_and_no_other(network: dict[str, Any]) -> None:
    found = []
    for each in network["nodes"]:
        for kind, word in KINDS.items():
            for entity in (e for e in each[kind] if not e["system"]):
                resolution = [] if entity["resolution"] == "exact" else [entity["resolution"]]
                conditional = ["conditional"] if entity["conditional"] else []
                found.append(" ".join([each["fqn"], word, entity["name"], *resolution, *conditional]))
    assert sorted(found) == sorted(EXPECTED.split("\n")[1:-1])


def test_the_example_is_complete_and_without_doubts(network: dict[str, Any]) -> None:
    assert network["diagnostics"] == []


def test_every_type_and_qos_is_known(network: dict[str, Any]) -> None:
    for each in network["nodes"]:
        for kind in KINDS:
            for entity in each[kind]:
                assert entity["type"], (each["fqn"], entity["name"])
                if kind in ("publishers", "subscriptions"):
                    assert entity["qos"]["depth"] is not None, (each["fqn"], entity["name"])


def test_the_door_client_of_a_helper_class_is_found_in_the_action(network: dict[str, Any]) -> None:
    (client,) = (c for c in node(network, "/porter/delivery_planner")["service_clients"] if not c["system"])
    source = ROOT / "examples" / client["created_at"][0]["file"]
    line = source.read_text(encoding="utf-8").splitlines()[client["created_at"][0]["line"] - 1]
    assert client["type"] == "delivery_interfaces/srv/OpenDoor"
    assert "create_client(OpenDoor, DOOR_SERVICE)" in line


def test_default_names_say_which_parameter_they_depend_on(network: dict[str, Any]) -> None:
    (client,) = node(network, "/fleet/gateway")["action_clients"]
    assert client["depends_on"] == ["robots"]
    assert {e["name"]: e["depends_on"] for e in node(network, "/porter/lidar_filter")["subscriptions"]} == {
        "/porter/sensors/front/scan": ["inputs"],
        "/porter/sensors/rear/scan": ["inputs"],
    }


def test_each_node_is_a_process_of_its_own_with_its_executable(network: dict[str, Any]) -> None:
    assert {n["process"] for n in network["nodes"]} == {
        *(f"delivery_base/{n}" for n in ("base_driver", "battery_monitor", "teleop_mux")),
        *(f"delivery_fleet/{n}" for n in ("door_gateway", "fleet_gateway", "monitor")),
        *(f"delivery_navigation/{n}" for n in ("delivery_planner", "localisation")),
        *(f"delivery_perception/{n}" for n in ("camera", "dock_detector", "lidar_filter")),
    }
    assert all(n["process"] == f"{n['package']}/{n['executable']}" for n in network["nodes"])


def test_outputs_are_valid_by_their_schemas(written: Path, network: dict[str, Any]) -> None:
    schema = json.loads((SCHEMAS / "network.schema.json").read_text(encoding="utf-8"))
    jsonschema.Draft202012Validator(schema).validate(network)
    policy = xmlschema.XMLSchema10(str(SCHEMAS / "policy.xsd"))
    policies = [written / "policy.xml", *sorted((written / "policies").rglob("policy.xml"))]
    assert len(policies) == 12
    for file in policies:
        policy.validate(str(file))
    assert len(list((written / "permissions").rglob("permissions.xml"))) == 11
    ET.parse(written / "graph.svg")


def test_the_policy_grants_the_late_client_and_no_wildcard(written: Path) -> None:
    planner = ET.parse(written / "policies" / "porter" / "delivery_planner" / "policy.xml")
    requested = [services for services in planner.iter("services") if services.get("request") == "ALLOW"]
    assert [service.text for services in requested for service in services] == ["/building/doors/open"]
    assert not [e for e in ET.parse(written / "policy.xml").iter() if "*" in (e.text or "")]


def test_the_readme_shows_what_the_terminal_prints(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    shown, doubts = re.findall(r"```text\n(.*?)```", README, re.DOTALL)
    program = next(p for p in re.findall(r"```python\n(.*?)```", README, re.DOTALL) if "hello" in p)
    (tmp_path / "hello.py").write_text(program, encoding="utf-8")
    (tmp_path / "examples").symlink_to(ROOT / "examples")
    monkeypatch.chdir(tmp_path)
    assert main(["extract", "examples"]) == 0
    assert capsys.readouterr().out == shown
    assert main(["extract", "hello.py"]) == 1
    assert doubts in capsys.readouterr().out


def test_the_readme_shows_how_to_use_the_library(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    program = next(p for p in re.findall(r"```python\n(.*?)```", README, re.DOTALL) if "import rosward" in p)
    monkeypatch.chdir(ROOT)
    exec(compile(program, "README.md", "exec"), {"rosward": rosward})
    lines = capsys.readouterr().out.splitlines()
    assert len(lines) == len(EXPECTED.split("\n")[1:-1]) + 1
    assert lines[-1] == "complete"


def test_the_picture_of_the_readme_is_that_of_the_example(written: Path) -> None:
    """CONTRIBUTING.md says how to write it anew."""
    labels = re.compile(r"<text[^>]*>([^<]*)</text>")
    picture = (ROOT / "docs" / "img" / "delivery.svg").read_text(encoding="utf-8")
    assert labels.findall(picture) == labels.findall((written / "graph.svg").read_text(encoding="utf-8"))


@pytest.mark.parametrize("page", ["README.md", "CONTRIBUTING.md", "examples/README.md", "bench/README.md"])
def test_links_lead_somewhere(page: str) -> None:
    file = ROOT / page
    for target in re.findall(r"\]\(([^)#]+)\)", file.read_text(encoding="utf-8")):
        if not target.startswith("https://"):
            assert (file.parent / target).exists(), target
