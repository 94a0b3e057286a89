# SPDX-License-Identifier: Apache-2.0
"""Promise: of each topic it is told whether its content stays, with the enclaves that use it, or where and from which enclave it leaves."""

from __future__ import annotations

from pathlib import Path

import pytest

from rosward.cli import main

_NODE = """
import socket
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Robot(Node):
    def __init__(self):
        super().__init__('{name}')
        self.socket = socket.socket()
        self.pub = self.create_publisher(String, '{sends}', 10)
        self.create_subscription(String, '{gets}', self.on, 10)

    def on(self, msg):
        {does}


rclpy.init()
rclpy.spin(Robot())
"""
_PUBLISH = "self.pub.publish(msg)"


def test_where_content_stays_and_where_it_leaves(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for name, gets, sends, does in (
        ("maps", "/scan", "/map", _PUBLISH),
        ("planner", "/map", "/plan", _PUBLISH),
        ("uplink", "/plan", "/state", "self.pub.publish(String(data='sent'))\n        self.socket.send(msg.data)"),
        ("other", "/news", "/echo", _PUBLISH),
        ("reader", "/echo", "/nothing", "pass"),
    ):
        program = _NODE.format(name=name, gets=gets, sends=sends, does=does)
        (tmp_path / f"{name}.py").write_text(program)
    assert main(["flow", str(tmp_path), "--suggest-private"]) == 0
    leaving = "".join(
        f"  {t}\n    to network of /uplink  uplink.py:17  in enclave /uplink\n" for t in ("/map", "/plan", "/scan")
    )
    assert capsys.readouterr().out == (
        f"content leaves the robot\n{leaving}\n"
        "no node of the system subscribes\n  /nothing\n  /state\n\n"
        "content stays in the system (enclaves that publish → that subscribe)\n"
        "  /echo  /other → /reader\n"
        "  /news  none → /other\n"
    )
