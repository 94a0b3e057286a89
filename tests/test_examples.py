# SPDX-License-Identifier: Apache-2.0
"""The robot in `examples/` comes out exactly, and README.md and examples/README.md say of it what is true.

What README.md shows as a run is held in tests/docs.
"""

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

pytestmark = pytest.mark.usefixtures("remembered")

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
/porter/compartment pub /porter/cargo/full conditional
/porter/compartment pub /porter/cargo/weight conditional
/porter/compartment pub /porter/heartbeat
/porter/compartment ss /porter/compartment/lock conditional
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
/porter/lidar pub /diagnostics
/porter/lidar pub /porter/heartbeat
/porter/lidar pub /porter/sensors/front/scan default
/porter/lidar ss /porter/lidar/motor
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

FLEET = "delivery_bringup:fleet.launch.py"
BUILDING = """
/building/door_gateway pub /building/doors/laboratory/open
/building/door_gateway pub /building/doors/lobby/open
/building/door_gateway ss /building/doors/open
/fleet/gateway ac /porter1/deliver bound
/fleet/gateway ac /porter2/deliver bound
/fleet/gateway pub /fleet/deliveries
/fleet/gateway ss /fleet/request_delivery
/fleet/watch pub /building/alarms default
/fleet/watch ss /fleet/watch/reset
/fleet/watch sub /diagnostics default
/fleet/watch sub /fleet/heartbeat bound
"""
EACH_ROBOT = """
/ROBOT/base_driver pub /diagnostics
/ROBOT/base_driver pub /fleet/heartbeat
/ROBOT/base_driver pub /ROBOT/battery
/ROBOT/base_driver pub /ROBOT/odom
/ROBOT/base_driver pub /tf
/ROBOT/base_driver ss /ROBOT/base_driver/enable
/ROBOT/base_driver sub /ROBOT/cmd_vel
/ROBOT/battery_monitor pub /diagnostics
/ROBOT/battery_monitor pub /fleet/heartbeat
/ROBOT/battery_monitor pub /ROBOT/battery_low
/ROBOT/battery_monitor sub /ROBOT/battery bound
/ROBOT/compartment pub /fleet/heartbeat
/ROBOT/compartment pub /ROBOT/cargo/full conditional
/ROBOT/compartment pub /ROBOT/cargo/weight conditional
/ROBOT/compartment ss /ROBOT/compartment/lock conditional
/ROBOT/delivery_planner as /ROBOT/deliver
/ROBOT/delivery_planner pub /fleet/heartbeat
/ROBOT/delivery_planner pub /ROBOT/teleop/mux/planner
/ROBOT/delivery_planner sc /building/doors/open conditional
/ROBOT/delivery_planner sub /ROBOT/battery_low
/ROBOT/delivery_planner sub /ROBOT/pose
/ROBOT/lidar_filter pub /fleet/heartbeat
/ROBOT/lidar_filter pub /ROBOT/scan
/ROBOT/lidar_filter sub /ROBOT/sensors/front/scan bound
/ROBOT/lidar_filter sub /ROBOT/sensors/mast/scan bound
/ROBOT/lidar_filter sub /ROBOT/sensors/rear/scan bound
/ROBOT/lidar_front pub /diagnostics
/ROBOT/lidar_front pub /fleet/heartbeat
/ROBOT/lidar_front pub /ROBOT/sensors/front/scan bound
/ROBOT/lidar_front ss /ROBOT/lidars/front/motor
/ROBOT/lidar_mast pub /diagnostics
/ROBOT/lidar_mast pub /fleet/heartbeat
/ROBOT/lidar_mast pub /ROBOT/sensors/mast/scan bound
/ROBOT/lidar_mast ss /ROBOT/lidars/mast/motor
/ROBOT/lidar_rear pub /diagnostics
/ROBOT/lidar_rear pub /fleet/heartbeat
/ROBOT/lidar_rear pub /ROBOT/sensors/rear/scan bound
/ROBOT/lidar_rear ss /ROBOT/lidars/rear/motor
/ROBOT/localisation pub /fleet/heartbeat
/ROBOT/localisation pub /ROBOT/pose
/ROBOT/localisation pub /tf
/ROBOT/localisation pub /tf_static
/ROBOT/localisation sub /map
/ROBOT/localisation sub /ROBOT/initial_pose
/ROBOT/localisation sub /ROBOT/scan
/ROBOT/localisation sub /tf
/ROBOT/localisation sub /tf_static
/ROBOT/teleop/mux pub /fleet/heartbeat
/ROBOT/teleop/mux pub /ROBOT/cmd_vel
/ROBOT/teleop/mux pub /ROBOT/teleop/mux/active
/ROBOT/teleop/mux sub /ROBOT/teleop/mux/joystick
/ROBOT/teleop/mux sub /ROBOT/teleop/mux/planner
/ROBOT/teleop/mux sub /ROBOT/teleop/mux/remote
"""
CAMERA = """
/porter1/camera_mount pub /tf_static
/porter1/dock_detector pub /fleet/heartbeat
/porter1/dock_detector pub /porter1/dock/pose
/porter1/dock_detector pub /tf
/porter1/dock_detector ss /porter1/dock/find
/porter1/dock_detector sub /porter1/eye/camera_info bound
/porter1/dock_detector sub /porter1/eye/image_raw bound
/porter1/eye pub /porter1/eye/camera_info conditional
/porter1/eye pub /porter1/eye/image_raw conditional
"""
CONTAINERS = {"/porter1/lidars", "/porter2/lidars"}
"""Nodes that have nothing but what the client library gives them."""
PORTER_1, PORTER_2 = (EACH_ROBOT.replace("ROBOT", name) for name in ("porter1", "porter2"))


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


def rows_of(network: dict[str, Any]) -> list[str]:
    """A row for each entity that is not the client library's, as in the tables above."""
    found = []
    for each in network["nodes"]:
        for kind, word in KINDS.items():
            for entity in (e for e in each[kind] if not e["system"]):
                resolution = [] if entity["resolution"] == "exact" else [entity["resolution"]]
                conditional = ["conditional"] if entity["conditional"] else []
                found.append(" ".join([each["fqn"], word, entity["name"], *resolution, *conditional]))
    return sorted(found)


def test_every_entity_is_found_and_no_other(network: dict[str, Any]) -> None:
    assert rows_of(network) == sorted(EXPECTED.split("\n")[1:-1])


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
        "delivery_cargo/compartment",
        "delivery_drivers/lidar_driver",
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
    assert len(policies) == 14
    for file in policies:
        policy.validate(str(file))
    assert len(list((written / "permissions").rglob("permissions.xml"))) == 13
    ET.parse(written / "graph.svg")


def test_the_policy_grants_the_late_client_and_no_wildcard(written: Path) -> None:
    planner = ET.parse(written / "policies" / "porter" / "delivery_planner" / "policy.xml")
    requested = [services for services in planner.iter("services") if services.get("request") == "ALLOW"]
    assert [service.text for services in requested for service in services] == ["/building/doors/open"]
    assert not [e for e in ET.parse(written / "policy.xml").iter() if "*" in (e.text or "")]


@pytest.fixture(scope="module")
def fleet(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The outputs for the launched fleet: two robots, of which the first has a camera, and the building."""
    folder = tmp_path_factory.mktemp("fleet")
    formats = ["--format", "json,policy"]
    assert main(["extract", str(ROOT / "examples"), "--launch", FLEET, "-q", "-o", str(folder), *formats]) == 0
    return folder


@pytest.fixture(scope="module")
def fleet_network(fleet: Path) -> dict[str, Any]:
    """network.json of the fleet."""
    parsed: dict[str, Any] = json.loads((fleet / "network.json").read_text(encoding="utf-8"))
    return parsed


def test_the_launched_fleet_is_found_and_nothing_else(fleet_network: dict[str, Any]) -> None:
    expected = [row for table in (BUILDING, PORTER_1, PORTER_2, CAMERA) for row in table.split("\n")[1:-1]]
    assert rows_of(fleet_network) == sorted(expected)
    assert {n["fqn"] for n in fleet_network["nodes"]} == {row.split()[0] for row in expected} | CONTAINERS
    assert fleet_network["diagnostics"] == []


def test_bound_names_say_which_parameter_binds_them(fleet_network: dict[str, Any]) -> None:
    bound = {
        (n["fqn"].rpartition("/")[2], *e["depends_on"])
        for n in fleet_network["nodes"]
        for kind in KINDS
        for e in n[kind]
        if e["resolution"] == "bound"
    }
    assert bound == {
        ("battery_monitor", "input"),
        ("dock_detector", "camera"),
        ("gateway", "robots"),
        ("lidar_filter", "inputs"),
        *((f"lidar_{place}", "place") for place in ("front", "mast", "rear")),
        ("watch", "topics.heartbeat"),
    }


def test_each_launched_process_says_where_it_is_started(fleet_network: dict[str, Any]) -> None:
    launch = ROOT / "examples"
    executables = {n["fqn"]: f"{n['package']}/{n['executable']}" for n in fleet_network["nodes"]}
    assert executables["/fleet/watch"] == "delivery_fleet/monitor"
    assert executables["/porter1/eye"] == "delivery_perception/camera"
    assert len(executables) == 28
    assert len({n["process"] for n in fleet_network["nodes"]}) == 22
    for each in fleet_network["nodes"]:
        place = each["launched_by"]
        line = (launch / place["file"]).read_text(encoding="utf-8").splitlines()[place["line"] - 1]
        assert "<node " in line or "Node(" in line or "Container(" in line, place


def test_the_policy_of_the_fleet_has_an_enclave_for_each_process(fleet: Path, fleet_network: dict[str, Any]) -> None:
    """That is one for each node, but for the lidars of a robot, which share the enclave of their container."""
    nodes: dict[str, list[str]] = {}
    for each in fleet_network["nodes"]:
        robot, is_lidar = each["fqn"].split("/")[1], "/lidar_" in each["fqn"] and "filter" not in each["fqn"]
        nodes.setdefault(f"/{robot}/lidars" if is_lidar else each["fqn"], []).append(each["fqn"])
    policy = ET.parse(fleet / "policy.xml")
    profiles = {
        e.get("path"): sorted(f"{p.get('ns')}/{p.get('node')}" for p in e.iter("profile"))
        for e in policy.iter("enclave")
    }
    assert profiles == {enclave: sorted(names) for enclave, names in nodes.items()}
    xmlschema.XMLSchema10(str(SCHEMAS / "policy.xsd")).validate(str(fleet / "policy.xml"))


def test_no_robot_may_do_anything_with_the_names_of_the_other(fleet: Path) -> None:
    for enclave in ET.parse(fleet / "policy.xml").iter("enclave"):
        own = str(enclave.get("path")).split("/")[1]
        others = {"porter1", "porter2"} - {own}
        named = {(e.text or "").strip().split("/")[1] for e in enclave.iter() if (e.text or "").strip().startswith("/")}
        assert own == "fleet" or not named & others, enclave.get("path")


def test_the_list_of_enclaves_names_the_option_for_each(fleet: Path, fleet_network: dict[str, Any]) -> None:
    _, *paragraphs = (fleet / "enclaves.txt").read_text(encoding="utf-8").strip().split("\n\n")
    starts = dict(p.split("\n", 1) for p in paragraphs)
    assert set(starts) == {n["enclave"] for n in fleet_network["nodes"]}
    for enclave, start in starts.items():
        assert re.search(rf"--enclave\W+{enclave}\b", start), start


def test_the_launch_tree_shows_each_process_with_its_program(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["launch-tree", str(ROOT / "examples"), "--launch", FLEET]) == 0
    shown = capsys.readouterr().out
    assert len(re.findall(r"^\W*program +\S+\.py$", shown, re.MULTILINE)) == 17
    assert len(re.findall(r"^\W*program +\S+\.cpp$", shown, re.MULTILINE)) == 8
    assert len(re.findall(r"^\W*program +declared: ", shown, re.MULTILINE)) == 3


def test_other_systems_of_the_same_launch_files(tmp_path: Path) -> None:
    """As examples/README.md tells of them."""
    page = (ROOT / "examples" / "README.md").read_text(encoding="utf-8")
    told = re.findall(r"`--launch '?(delivery_bringup:[^`']*)'?`", page)
    assert told == ["delivery_bringup:robot.launch.py", "delivery_bringup:building.launch.xml,robots:=[anna, berta]"]
    networks = []
    for number, launch in enumerate(told):
        folder = tmp_path / str(number)
        assert (
            main(["extract", str(ROOT / "examples"), "--launch", launch, "-q", "-o", str(folder), "--format", "json"])
            == 0
        )
        networks.append(json.loads((folder / "network.json").read_text(encoding="utf-8")))
    robot, building = networks
    assert [n["fqn"] for n in robot["nodes"] if n["resolution"] != "default"] == []
    (server,) = node(robot, "/porter/delivery_planner")["action_servers"]
    assert (server["name"], server["resolution"], server["depends_on"]) == ("/porter/deliver", "default", ["robot"])
    assert [c["name"] for c in node(building, "/fleet/gateway")["action_clients"]] == [
        "/anna/deliver",
        "/berta/deliver",
    ]


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
