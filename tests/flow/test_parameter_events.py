# SPDX-License-Identifier: Apache-2.0
"""What code gives to a parameter leaves the node: the client library publishes it, and answers who asks for it."""

from __future__ import annotations

from pathlib import Path

import pytest

from .reported import reported, said_of

PROGRAM = """
import rclpy
from rclpy.node import Node
from rclpy.parameter import Parameter
from std_msgs.msg import Float64


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.declare_parameter('gain', 1.0)
        self.create_subscription(Float64, '/in', self.on_in, 10)

    def on_in(self, msg):
        {0}


rclpy.init()
rclpy.spin(Robot())
"""
SINKS = ("topic:/parameter_events", "response:/robot/get_parameters")


@pytest.mark.parametrize(
    "statement",
    [
        "self.set_parameters([Parameter('gain', value=msg.data)])",
        "self.set_parameters_atomically([Parameter('gain', Parameter.Type.DOUBLE, msg.data)])",
        "self.declare_parameter('more', msg.data)",
        "self.set_parameters([Parameter(str(msg.data), value=1.0)])",
    ],
)
def test_what_is_given_is_told(tmp_path: Path, statement: str) -> None:
    (tmp_path / "robot.py").write_text(PROGRAM.format(statement))
    rows = reported(tmp_path / "robot.py")
    for sink in SINKS:
        said = said_of(rows, sink)
        assert said is not None
        assert "topic:/in" in said.data | said.control


def test_what_holds_nothing_is_no_output(tmp_path: Path) -> None:
    (tmp_path / "robot.py").write_text(PROGRAM.format("self.declare_parameter('more', 2.0)"))
    assert {row.sink for row in reported(tmp_path / "robot.py")}.isdisjoint(SINKS)


def test_what_refuses_one_parameter_decides_no_other(tmp_path: Path) -> None:
    """A callback that looks at the name of each parameter leaves early for one of them."""
    program = PROGRAM.replace(
        "        self.create_subscription(Float64, '/in', self.on_in, 10)",
        "        self.declare_parameter('other', 1.0)\n"
        "        self.gain = 1.0\n"
        "        self.out = self.create_publisher(Float64, '/out', 10)\n"
        "        self.add_on_set_parameters_callback(self.on_set)\n"
        "        self.create_timer(1.0, self.on_in)\n\n"
        "    def on_set(self, parameters):\n"
        "        for parameter in parameters:\n"
        "            if parameter.name == 'gain':\n"
        "                if parameter.value < 0.0:\n"
        "                    return SetParametersResult(successful=False)\n"
        "                self.gain = parameter.value\n"
        "        return SetParametersResult(successful=True)",
    ).replace("def on_in(self, msg)", "def on_in(self)")
    program = program.replace("import rclpy\n", "import rclpy\nfrom rcl_interfaces.msg import SetParametersResult\n", 1)
    (tmp_path / "robot.py").write_text(program.format("self.out.publish(Float64(data=self.gain))"))
    said = said_of(reported(tmp_path / "robot.py"), "topic:/out")
    assert said is not None
    assert said.data == {"parameter:gain"}
    assert said.control == frozenset()
