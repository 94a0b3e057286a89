# SPDX-License-Identifier: Apache-2.0
"""From RW314 to a declared node: what is written, from what, and that the next run uses it."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rosward.cli import main
from rosward.declaring.sketch import SeenEndpoint, Sketch, is_usable
from rosward.declaring.source import sketch_of_source
from rosward.declaring.write import declaration, with_declaration
from rosward.deployment.declared.read import read_package
from rosward.ros.entities import ENTITY_LISTS, Qos

NODE_INFO = """/front/lidar
  Subscribers:
    /parameter_events: rcl_interfaces/msg/ParameterEvent
    /front/cmd: std_msgs/msg/String
    /tf: tf2_msgs/msg/TFMessage
  Publishers:
    /front/scan: sensor_msgs/msg/LaserScan
    /parameter_events: rcl_interfaces/msg/ParameterEvent
    /rosout: rcl_interfaces/msg/Log
  Service Servers:
    /front/lidar/describe_parameters: rcl_interfaces/srv/DescribeParameters
    /front/lidar/restart: std_srvs/srv/Trigger
  Service Clients:

  Action Servers:
    /front/spin: demo_interfaces/action/Spin
  Action Clients:

"""
OTHER = "/front/camera\n  Subscribers:\n  Publishers:\n    /front/image: sensor_msgs/msg/Image\n"
CPP = """\
#include "sensor_msgs/msg/laser_scan.hpp"
// create_publisher<std_msgs::msg::String>("never", 1);
using sensor_msgs::msg::LaserScan;
using Spin = demo_interfaces::action::Spin;
class Lidar : public rclcpp::Node {
  Lidar() : rclcpp::Node("lidar") {
    declare_parameter("rate", 10.0);
    declare_parameter<std::string>("frame");
    /* create_service<std_srvs::srv::Trigger>("nor this", f); */
    scan_ = this->create_publisher<LaserScan>("scan", rclcpp::SensorDataQoS());
    map_ = create_publisher<nav_msgs::msg::OccupancyGrid>(
        "map", rclcpp::QoS(1).transient_local());
    cmd_ = create_subscription<std_msgs::msg::String>(topic_, 10, f);
    restart_ = create_service<std_srvs::srv::Trigger>("~/restart", f);
    spin_ = rclcpp_action::create_client<Spin>(this, "spin");
    odd_ = create_publisher<Unheard>("odd", 1);
  }
};
"""
PYTHON = """\
from std_msgs.msg import Bool as Flag, String
from std_srvs.srv import Trigger
class Driver(Node):
    def __init__(self):
        super().__init__('driver')
        self.create_publisher(String, "out", 10)  # create_publisher(String, "never", 1)
        self.create_subscription(Flag, 'in', self.f, 5)
        self.create_client(Trigger, "~/go")
"""
LAUNCH = '<launch><node pkg="acme" exec="lidar_node" namespace="front" name="lidar"/></launch>'
PACKAGE = "<package format='3'><name>demo</name><version>1.0.0</version></package>"


@pytest.fixture(autouse=True)
def in_a_folder_of_its_own(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Each test runs beside a workspace whose launch file starts what is not known."""
    for name, text in {"ws/demo/package.xml": PACKAGE, "ws/demo/launch/a.launch.xml": LAUNCH}.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)
    monkeypatch.chdir(tmp_path)


def extracted(*more: str) -> tuple[int, dict[str, Any]]:
    status = main(["extract", "ws", "--launch", "demo:a.launch.xml", "--format", "json", "-q", *more])
    node: dict[str, Any] = json.loads(Path("rosward-out/network.json").read_text())["nodes"][0]
    return status, node


def own(node: dict[str, Any]) -> dict[str, list[str]]:
    found = {key: [e["name"] for e in node[key] if not e["system"]] for key in ENTITY_LISTS}
    return {key: names for key, names in found.items() if names}


def test_from_the_finding_to_a_declared_node(capsys: pytest.CaptureFixture[str]) -> None:
    status, node = extracted()
    assert (status, node["interface"]) == (1, "unknown")
    main(["extract", "ws", "--launch", "demo:a.launch.xml", "--format", "none"])
    assert "`rosward declare acme/lidar_node` creates a declaration for it" in capsys.readouterr().out

    Path("info.txt").write_text(NODE_INFO + OTHER)
    assert main(["declare", "acme/lidar_node", "--from", "info.txt", "--node", "/front/lidar"]) == 0
    status, node = extracted("--models", "models")
    assert (status, node["interface"]) == (1, "partial"), "a run is not all that a program does, until somebody says so"

    file = Path("models/nodes/acme.yaml")
    file.write_text("".join(line for line in file.read_text().splitlines(True) if " open: " not in line))
    status, node = extracted("--models", "models")
    assert (status, node["interface"]) == (0, "declared")
    assert own(node) == {
        "publishers": ["/front/scan"],
        "subscriptions": ["/front/cmd", "/tf"],
        "service_servers": ["/front/lidar/restart"],
        "action_servers": ["/front/spin"],
    }


def test_a_skeleton_says_that_nothing_is_said() -> None:
    assert main(["declare", "acme/lidar_node"]) == 0
    assert extracted("--models", "models")[1]["interface"] == "partial"


def test_a_snapshot_says_more_of_qos() -> None:
    entity = {"name": "/scan", "type": "sensor_msgs/msg/LaserScan", "seen": 1, "ros_prefix": True}
    qos = {"reliability": "best_effort", "durability": "volatile", "history": "keep_last", "depth": 5}
    empty: dict[str, Any] = {key: [] for key in ENTITY_LISTS}
    node = {"name": "lidar", "namespace": "/", "asked": 1, "count": 1, "seen": 1, "enclaves": [], **empty}
    node["publishers"] = [{**entity, "qos": [qos]}, {**entity, "name": "/lidar/odd", "qos": [{**qos, "depth": 7}]}]
    document = {
        "schema_version": 1,
        "looks": 1,
        "ros_distro": "jazzy",
        "nodes": [node],
        "without_node": [],
        "problems": [],
    }
    Path("robot.json").write_text(json.dumps(document))
    assert main(["declare", "acme/lidar_node", "--from", "robot.json"]) == 0
    text = Path("models/nodes/acme.yaml").read_text()
    assert "- {name: /scan, type: sensor_msgs/msg/LaserScan, qos: sensor_data}" in text
    assert '- {name: "~/odd", type: sensor_msgs/msg/LaserScan, qos: {reliability: BEST_EFFORT,' in text


def test_source_in_cpp_is_searched_and_not_trusted() -> None:
    found = sketch_of_source({"lidar.cpp": CPP})
    assert (found.node, found.client_library) == ("lidar", "rclcpp")
    assert found.parameters == (("rate", "double"), ("frame", "string"))
    assert [(e.kind, e.name, e.type) for e in found.entities] == [
        ("publishers", "scan", "sensor_msgs/msg/LaserScan"),
        ("publishers", "map", "nav_msgs/msg/OccupancyGrid"),
        ("service_servers", "~/restart", "std_srvs/srv/Trigger"),
        ("action_clients", "spin", "demo_interfaces/action/Spin"),
    ]
    assert found.entities[0].qos == Qos("best_effort", "volatile", "keep_last", 5)
    assert found.entities[1].qos == Qos("reliable", "transient_local", "keep_last", 1)
    assert found.told == (
        "lidar.cpp:13: subscriptions of std_msgs::msg::String: its name is not a literal (topic_)",
        "lidar.cpp:16: publishers of Unheard: its package is unknown",
    )
    assert found.open == "found by a text search of lidar.cpp, not verified"


def test_source_in_python_is_searched_too() -> None:
    found = sketch_of_source({"driver.py": PYTHON})
    assert (found.node, found.client_library) == ("driver", "rclpy")
    assert [(e.kind, e.name, e.type, e.at) for e in found.entities] == [
        ("publishers", "out", "std_msgs/msg/String", "driver.py:6"),
        ("subscriptions", "in", "std_msgs/msg/Bool", "driver.py:7"),
        ("service_clients", "~/go", "std_srvs/srv/Trigger", "driver.py:8"),
    ]


def test_what_is_in_the_file_stays() -> None:
    assert main(["declare", "acme/camera"]) == 0
    file = Path("models/nodes/acme.yaml")
    file.write_text(file.read_text().replace("    node: camera", "    # mine\n    node: camera"))
    assert main(["declare", "acme/lidar_node"]) == 0
    assert main(["declare", "acme/acme::Lidar"]) == 0
    package, findings = read_package(file.read_text(), "acme.yaml", "acme")
    assert package is not None
    assert not findings
    assert (sorted(package.executables), sorted(package.components)) == (["camera", "lidar_node"], ["acme::Lidar"])
    assert "    # mine\n" in file.read_text()


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["acme"], "not of the form PKG/EXE"),
        (["../acme/x"], "not of the form PKG/EXE"),
        (["acme/camera"], "declares acme/camera already"),
        (["acme/lidar", "--from", "absent.json"], "absent.json"),
        (["acme/lidar", "--from", "two.txt", "--node", "/nobody"], "/front/camera, /front/lidar"),
        (["acme/thing", "--from", "two.txt"], "choose one with --node: /front/camera, /front/lidar"),
        (["acme/lidar", "--from", "ws"], "no C++ or Python source"),
    ],
)
def test_what_cannot_be_declared(arguments: list[str], message: str, capsys: pytest.CaptureFixture[str]) -> None:
    Path("two.txt").write_text(NODE_INFO + OTHER)
    main(["declare", "acme/camera"])
    before = Path("models/nodes/acme.yaml").read_text()
    capsys.readouterr()
    assert main(["declare", *arguments]) == 2
    assert message in capsys.readouterr().err
    assert Path("models/nodes/acme.yaml").read_text() == before


def test_it_can_be_printed(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["declare", "acme/lidar_node", "-o", "-"]) == 0
    assert capsys.readouterr().out.startswith("# Created by `rosward declare`")
    assert not Path("models").exists()


texts = st.text(max_size=20)
seen = st.builds(
    SeenEndpoint,
    st.sampled_from(list(ENTITY_LISTS)),
    st.one_of(texts, st.sampled_from(("/scan", "~/x", "a/b"))),
    st.one_of(texts, st.sampled_from(("std_msgs/msg/String", "std_srvs/srv/Trigger", "a/action/B", "a/srv/B_Event"))),
    st.one_of(st.none(), st.builds(Qos, texts, texts, texts, st.integers(0, 9))),
    texts,
)
sketches = st.builds(
    Sketch,
    st.one_of(st.none(), st.from_regex(r"[A-Za-z_]\w{0,9}", fullmatch=True)),
    st.booleans(),
    st.sampled_from(("rclcpp", "rclpy")),
    entities=st.lists(seen, max_size=8).map(lambda every: tuple(filter(is_usable, every))),
    parameters=st.dictionaries(texts, st.sampled_from(("", "int")), max_size=3).map(lambda d: tuple(d.items())),
    told=st.lists(texts, max_size=2).map(tuple),
    open=texts,
)


@given(sketches, sketches)
def test_whatever_was_seen_the_file_can_be_read(one: Sketch, other: Sketch) -> None:
    """And it declares just that: no text of somebody else becomes a key of it."""
    text = with_declaration(declaration("acme", "one", one), "two", other)
    package, findings = read_package(text, "acme.yaml", "acme")
    assert package is not None, findings
    assert sorted(package.executables) == ["one", "two"]
    for name, sketch in (("one", one), ("two", other)):
        group = package.executables[name].nodes[0].group
        assert {(e.name, e.type) for e in group.endpoints} == {(e.name, e.type) for e in sketch.entities}
        assert group.open
