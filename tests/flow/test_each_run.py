# SPDX-License-Identifier: Apache-2.0
"""Promise: what is said of a program does not depend on where its objects stand in memory, or how Python hashes texts."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path
from typing import Final

import pytest

_PROGRAM: Final = """
import camera_library
import rclpy
import window_library
from rclpy.node import Node
from std_msgs.msg import Float64


class Window(Node):
    def __init__(self):
        super().__init__('window')
        self.out = self.create_publisher(Float64, '/out', 10)
        self.level = 0.0
        self.ui = window_library.Window()
{widgets}
        self.create_subscription(Float64, '/in', self.on_in, 10)
        self.create_timer(0.1, self.tick)

    def on_in(self, msg):
        self.level = msg.data
{updates}

    def changed(self, *values):
        self.out.publish(Float64(data=self.level))

    def tick(self):
        self.out.publish(Float64(data=camera_library.read(self.ui.slider1.moved, self.ui.row2)))


rclpy.init()
rclpy.spin(Window())
"""
_WIDGETS: Final = """
        self.ui.slider{n} = window_library.Slider{kind}(self, self.ui.row{kind}.inner)
        self.ui.slider{n}.moved.connect(self.changed)
        self.ui.row{kind}.inner.style = window_library.style(self.ui.slider{before}, camera_library.look{kind})
"""


def _said(program: Path, seed: int) -> str:
    into = program.parent / f"said{seed}"
    command = [sys.executable, "-m", "rosward", "flow", str(program), "--format", "json", "-o", str(into), "--no-cache"]
    subprocess.run(command, env={**os.environ, "PYTHONHASHSEED": str(seed)}, capture_output=True, check=True)
    return (into / "flow.json").read_text()


@pytest.mark.parametrize("several", [3, 100])
def test_flows_are_the_same_in_each_run(several: int, tmp_path: Path) -> None:
    """With more objects, those that cannot be told apart are one."""
    widgets = "".join(_WIDGETS.format(n=n, before=max(n - 1, 0), kind=n % 7) for n in range(several))
    updates = "".join(
        f"        self.ui.slider{n}.set(self.ui.row{n % 7}.inner.value, msg.data)\n" for n in range(several)
    )
    program = tmp_path / "window.py"
    program.write_text(_PROGRAM.format(widgets=widgets, updates=updates))
    first = _said(program, 3)
    assert '"topic:/out"' in first
    assert _said(program, 4) == first
