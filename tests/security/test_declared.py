# SPDX-License-Identifier: Apache-2.0
"""Promise: a node that nobody knew is declared in a minute, and then its process may do what the declaration says, and no more.

RW314, `rosward declare` from a running node and from a search of source, `rosward check` of the policy without a finding, a real DDS.
"""

from __future__ import annotations

from collections import Counter
from pathlib import Path

import pytest

import rosward
from rosward import Network
from rosward.cli import main
from rosward.deployment.request import LaunchRequest, Request
from rosward.enclaves.grants import enclaves

from .cyclone import Cyclone
from .keystore import Keystore
from .test_enforcement import enforced, everything, rightful

FILES = {
    "ws/demo/package.xml": "<package format='3'><name>demo</name><version>1.0.0</version></package>",
    "ws/demo/launch/robot.launch.xml": """<launch>
  <node pkg="acme" exec="lidar_node" namespace="front"/>
  <node pkg="acme" exec="base_node"><remap from="odom" to="odometry"/></node>
</launch>
""",
    "lidar.txt": """/front/lidar
  Subscribers:
  Publishers:
    /front/scan: sensor_msgs/msg/LaserScan
    /tf: tf2_msgs/msg/TFMessage
  Service Servers:
    /front/lidar/restart: std_srvs/srv/Trigger
  Service Clients:
  Action Servers:
  Action Clients:
    /dock: test_msgs/action/Fibonacci
""",
    "base.cpp": """class Base : public rclcpp::Node {
  Base() : Node("base") {
    odom_ = create_publisher<nav_msgs::msg::Odometry>("odom", 10);
    cmd_ = create_subscription<geometry_msgs::msg::Twist>("cmd_vel", 10, f);
    dock_ = rclcpp_action::create_server<test_msgs::action::Fibonacci>(this, "/dock", a, b, c);
  }
};
""",
}
ROBOT = ["ws", "--models", "models", "--launch", "demo:robot.launch.xml"]


def network() -> Network:
    request = Request((LaunchRequest("robot.launch.xml", "demo"),))
    return rosward.extract("ws", models=["models"], request=request).network


@pytest.fixture(autouse=True)
def declared(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Both nodes are declared, and somebody has looked through it."""
    for name, text in FILES.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)
    monkeypatch.chdir(tmp_path)
    assert main(["extract", "ws", "--launch", "demo:robot.launch.xml", "--format", "none", "-q"]) == 1
    assert main(["declare", "acme/lidar_node", "--from", "lidar.txt"]) == 0
    assert main(["declare", "acme/base_node", "--from", "base.cpp"]) == 0
    file = Path("models/nodes/acme.yaml")
    file.write_text("".join(line for line in file.read_text().splitlines(True) if " open: " not in line))


def test_the_policy_is_checked_without_a_finding() -> None:
    assert main(["extract", *ROBOT, "--format", "policy", "-o", "out", "-q"]) == 0
    assert main(["check", "out/policy.xml", *ROBOT]) == 0


def test_it_is_enforced(dds: Cyclone, keystore: Keystore, tally: Counter[str]) -> None:
    robot = network()
    assert {n.fqn for n in robot.nodes} == {"/front/lidar", "/base"}
    tried = everything([robot])
    allowed = enforced(dds, keystore, robot, tried)
    for enclave in enclaves(robot):
        expected = rightful(enclave, tried)
        assert allowed[enclave.path] == expected, enclave.path
        assert len(expected) < len(tried)
        tally["policies of declared nodes enforced"] += 1
    topics = {e.topic for e in allowed["/base"]}
    assert "rt/odometry" in topics
    assert "rt/front/scan" not in topics
