# SPDX-License-Identifier: Apache-2.0
"""Promise: what comes from outside is a source, however it is used: for its value, in a condition, and where it fails to come.

Each row of `SOURCES` is put into each of `USES`.
"""

from __future__ import annotations

import textwrap
from itertools import product
from pathlib import Path
from typing import Final, NamedTuple

import pytest
from sampling import sample

from .reported import reported, said_by, said_of

PROGRAM: Final = """
import contextlib
import csv
import os
import pathlib
import socket
import subprocess

import can
import rclpy
import requests
import serial
import smbus2
import tf2_ros
import yaml
from rclpy.node import Node
from std_msgs.msg import Float64


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.buffer = tf2_ros.Buffer()
        self.listener = tf2_ros.TransformListener(self.buffer, self)
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.port = serial.Serial('/dev/ttyUSB0')
        self.bus = smbus2.SMBus(1)
        self.can = can.Bus('can0')
        self.out = self.create_publisher(Float64, '/out', 10)
        self.create_timer(1.0, self.tick)

    def say(self, value):
        self.out.publish(Float64(data=value))

    def tick(self):
{}


rclpy.init()
rclpy.spin(Robot())
"""
SOURCES: Final = {
    "self.buffer.lookup_transform('a', 'b', rclpy.time.Time()).transform.translation.x": "tf",
    "self.buffer.transform(Float64(), 'map').data": "tf",
    "float(self.socket.recv(10))": "network",
    "float(self.socket.recvfrom(10)[0].decode())": "network",
    "requests.get('http://x', timeout=1).json()['v']": "network",
    "float(subprocess.check_output(['x']))": "process",
    "float(os.popen('x').read())": "process",
    "float(self.port.readline())": "device",
    "float(next(iter(self.port)))": "device",
    "float([line for line in self.port][0])": "device",
    "float(self.bus.read_byte_data(1, 2))": "device",
    "float(self.can.recv().data[0])": "device",
    "float(open('x').read())": "file",
    "float([line for line in open('x')][0])": "file",
    "float(list(open('x'))[0])": "file",
    "float(next(csv.reader(open('x')))[0])": "file",
    "yaml.safe_load(open('x'))['v']": "file",
    "float(pathlib.Path('x').read_text())": "file",
}


class Use(NamedTuple):
    """What is done with it, and how strong the source is then, at least."""

    does: str
    strength: str = "control"


USES: Final = {
    "value": Use("self.say({})", "data"),
    "kept": Use("self.value = {}\nself.say(self.value * 2.0)", "data"),
    "condition": Use("if {} > 1.0:\n    self.say(1.0)"),
    "early return": Use("if {} > 1.0:\n    return\nself.say(1.0)"),
    "failed": Use("good = 1.0\ntry:\n    {}\nexcept Exception:\n    good = 0.0\nself.say(good)"),
    "failed, returned": Use("try:\n    {}\nexcept Exception:\n    return\nself.say(1.0)"),
    "failed, what it says": Use("try:\n    {}\nexcept Exception as error:\n    self.say(float(len(str(error))))"),
    "did not fail": Use("try:\n    {}\nexcept Exception:\n    pass\nelse:\n    self.say(1.0)"),
    "suppressed": Use("good = 0.0\nwith contextlib.suppress(Exception):\n    {}\n    good = 1.0\nself.say(good)"),
    "failed in a function": Use(
        "def get():\n    return {}\ngood = 1.0\ntry:\n    get()\nexcept Exception:\n    good = 0.0\nself.say(good)"
    ),
    "turns": Use("count = 0.0\nwhile {} > count:\n    count += 1.0\nself.say(count)"),
}
ROWS: Final = sorted(product(SOURCES, USES))


def _write(program: Path, does: str) -> None:
    program.write_text(PROGRAM.format(textwrap.indent(does, " " * 8)))


@pytest.mark.parametrize(("source", "use"), sample(ROWS, 8))
def test_it_is_a_source(source: str, use: str, tmp_path: Path) -> None:
    program = tmp_path / "robot.py"
    _write(program, USES[use].does.replace("{}", source))
    said = said_of(reported(program), "topic:/out")
    assert said is not None
    assert SOURCES[source] in (said.data if USES[use].strength == "data" else said.data | said.control), said


@pytest.mark.parametrize(
    ("does", "source"),
    [
        ("good = 1.0\ntry:\n    open('x')\nexcept OSError:\n    good = 0.0\nself.say(good)", "file"),
        (
            "good = 1.0\ntry:\n    subprocess.check_call(['x'])\nexcept OSError:\n    good = 0.0\nself.say(good)",
            "process",
        ),
    ],
    ids=["a file that is not there", "a program that fails"],
)
def test_what_fails_decides(does: str, source: str, tmp_path: Path) -> None:
    program = tmp_path / "robot.py"
    _write(program, does)
    said = said_of(reported(program), "topic:/out")
    assert said is not None
    assert source in said.control


@pytest.mark.parametrize(
    "value",
    [
        "float(now.to_msg().sec)",
        "float(now.seconds_nanoseconds()[0])",
        "float((now - rclpy.duration.Duration(seconds=1)).to_msg().nanosec)",
        "float((now - self.start).to_msg().sec)",
    ],
)
def test_what_a_method_of_a_time_gives_is_in_it(value: str, tmp_path: Path) -> None:
    program = tmp_path / "robot.py"
    _write(program, f"self.start = self.get_clock().now()\nnow = self.get_clock().now()\nself.say({value})")
    said = said_of(reported(program), "topic:/out")
    assert said is not None
    assert "clock" in said.data


CACHE: Final = """
import message_filters
import rclpy
from rclpy.node import Node
from rclpy.time import Time
from sensor_msgs.msg import Temperature


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.out = self.create_publisher(Temperature, '/out', 10)
        self.cache = message_filters.Cache(message_filters.Subscriber(self, Temperature, '/in'), 10)
        self.create_subscription(Temperature, '/when', self.on_when, 10)

    def on_when(self, msg):
        found = self.cache.getElemBeforeTime(Time.from_msg(msg.header.stamp))
        if found is not None:
            self.out.publish(found)


rclpy.init()
rclpy.spin(Robot())
"""


def test_what_is_asked_of_a_cache_decides_what_it_gives(tmp_path: Path) -> None:
    said = said_by(tmp_path, CACHE, "topic:/out")
    assert said.data == {"topic:/in"}
    assert said.control == {"topic:/when"}


SERVER: Final = """
import rclpy
from example_interfaces.action import Fibonacci
from rclpy.action import ActionServer, CancelResponse, GoalResponse
from rclpy.node import Node
from std_msgs.msg import Int32


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.limit = self.most = 5
        self.out = self.create_publisher(Int32, '/out', 10)
        self.stopped = self.create_publisher(Int32, '/stopped', 10)
        self.create_subscription(Int32, '/limit', self.on_limit, 10)
        self.create_subscription(Int32, '/most', self.on_most, 10)
        self.server = ActionServer(
            self, Fibonacci, '/count', self.run, goal_callback=self.on_goal, cancel_callback=self.on_cancel
        )

    def on_limit(self, msg):
        self.limit = msg.data

    def on_most(self, msg):
        self.most = msg.data

    def on_goal(self, goal):
        return GoalResponse.REJECT if goal.order > self.limit else GoalResponse.ACCEPT

    def on_cancel(self, goal):
        if self.most > 3:
            return CancelResponse.ACCEPT
        return CancelResponse.REJECT

    def run(self, goal):
        self.out.publish(Int32(data=1))
        if goal.is_cancel_requested:
            self.stopped.publish(Int32(data=1))
        goal.succeed()
        return Fibonacci.Result()


rclpy.init()
rclpy.spin(Robot())
"""


@pytest.mark.parametrize(
    ("sink", "decides"),
    [
        ("topic:/out", {"goal:/count", "topic:/limit"}),
        ("topic:/stopped", {"goal:/count", "topic:/limit", "topic:/most", "cancel:/count"}),
        ("result:/count", {"goal:/count", "topic:/limit"}),
    ],
)
def test_what_decides_that_a_goal_is_accepted_decides_what_is_done_for_it(
    sink: str, decides: set[str], tmp_path: Path
) -> None:
    said = said_by(tmp_path, SERVER, sink)
    assert decides <= said.control


OTHER_SERVER: Final = SERVER.replace(
    "        self.server = ",
    "        self.free = self.create_publisher(Int32, '/free', 10)\n"
    "        self.other = ActionServer(self, Fibonacci, '/other', self.run_other)\n"
    "        self.server = ",
).replace(
    "    def run(self, goal):",
    "    def run_other(self, goal):\n        self.free.publish(Int32(data=1))\n        return Fibonacci.Result()\n\n"
    "    def run(self, goal):",
)


def test_what_decides_that_a_goal_is_accepted_decides_nothing_for_another_server(tmp_path: Path) -> None:
    said = said_by(tmp_path, OTHER_SERVER, "topic:/free")
    assert said.data | said.control == frozenset()


CLIENT: Final = """
import rclpy
from example_interfaces.action import Fibonacci
from rclpy.action import ActionClient
from rclpy.node import Node
from std_msgs.msg import Int32


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.out = self.create_publisher(Int32, '/out', 10)
        self.client = ActionClient(self, Fibonacci, '/count')
        self.client.send_goal_async(Fibonacci.Goal(order=3)).add_done_callback(self.on_answer)

    def on_answer(self, future):
        if future.result().accepted:
            self.out.publish(Int32(data=1))


rclpy.init()
rclpy.spin(Robot())
"""


def test_whether_a_goal_is_accepted_comes_from_the_server(tmp_path: Path) -> None:
    said = said_by(tmp_path, CLIENT, "topic:/out")
    assert "result:/count" in said.control


PARAMETER: Final = """
import rclpy
from rcl_interfaces.msg import SetParametersResult
from rclpy.node import Node
from std_msgs.msg import Float64


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.limit = 3.0
        self.declare_parameter('gain', 1.0)
        self.add_on_set_parameters_callback(self.judge)
        self.out = self.create_publisher(Float64, '/out', 10)
        self.create_subscription(Float64, '/limit', self.on_limit, 10)
        self.create_timer(1.0, lambda: self.out.publish(Float64(data=self.get_parameter('gain').value)))

    def on_limit(self, msg):
        self.limit = msg.data

    def judge(self, parameters):
        if parameters[0].value > self.limit:
            return SetParametersResult(successful=False)
        return SetParametersResult(successful=True)


rclpy.init()
rclpy.spin(Robot())
"""


def test_what_decides_that_a_parameter_is_set_decides_what_is_made_of_it(tmp_path: Path) -> None:
    said = said_by(tmp_path, PARAMETER, "topic:/out")
    assert said.data == {"parameter:gain"}
    assert said.control == {"topic:/limit"}


def test_another_parameter_decides_that_a_parameter_is_set(tmp_path: Path) -> None:
    declared = "declare_parameter('gain', 1.0)"
    most = PARAMETER.replace("> self.limit:", "> self.get_parameter('most').value:")
    said = said_by(
        tmp_path, most.replace(declared, f"{declared}\n        self.declare_parameter('most', 2.0)"), "topic:/out"
    )
    assert said.data == {"parameter:gain"}
    assert said.control == {"parameter:most"}


CALLED: Final = """
import rclpy
import pyaudio
import sounddevice
import websocket
from pynput import keyboard
from rclpy.node import Node
from std_msgs.msg import String


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.out = self.create_publisher(String, '/out', 10)
        self.heard = {}

    def on_it(self, it, *others):
        self.out.publish(String(data=str(it)))


rclpy.init()
rclpy.spin(Robot())
"""


@pytest.mark.parametrize(
    "registers",
    [
        "websocket.WebSocketApp('ws://x', on_message=self.on_it).run_forever()",
        "websocket.WebSocketApp('ws://x', None, None, self.on_it).run_forever()",
        "self.web = websocket.WebSocketApp('ws://x'); self.web.on_message = self.on_it; self.web.run_forever()",
    ],
)
def test_what_arrives_at_a_web_socket_comes_from_the_network(registers: str, tmp_path: Path) -> None:
    said = said_by(tmp_path, CALLED.format(registers), "topic:/out")
    assert "network" in said.data


@pytest.mark.parametrize(
    ("does", "source"),
    [
        (
            "ready, _, _ = select.select([self.socket], [], [], 1.0)\nfor each in ready:\n    self.say(float(each.recv(9)))",
            "network",
        ),
        (
            "ready, _, _ = select.select([self.port], [], [], 1.0)\nif ready:\n    self.say(float(ready[0].readline()))",
            "device",
        ),
        ("ready, _, _ = select.select([sys.stdin], [], [], 1.0)\nself.say(float(len(ready)))", "stdin"),
        ("import cv2\nimage = numpy.zeros((3, 3))\ncv2.VideoCapture(0).read(image)\nself.say(image.sum())", "device"),
    ],
    ids=["socket", "port", "terminal", "camera into a picture"],
)
def test_what_is_waited_for_or_filled_is_read_from_there(does: str, source: str, tmp_path: Path) -> None:
    program = tmp_path / "robot.py"
    _write(program, "import select, sys, numpy\n" + does)
    said = said_of(reported(program), "topic:/out")
    assert said is not None
    assert source in said.data
    assert said.data <= {source}


@pytest.mark.parametrize(
    "registers",
    [
        "sounddevice.InputStream(callback=self.on_it)",
        "keyboard.Listener(on_press=self.on_it)",
        "pyaudio.PyAudio().open(input=True, stream_callback=self.on_it)",
        "sounddevice.RawStream(callback=self.on_it)",
    ],
)
def test_what_a_function_of_a_library_calls_a_callback_with_comes_from_there(registers: str, tmp_path: Path) -> None:
    said = said_by(tmp_path, CALLED.format(registers), "topic:/out")
    assert "device" in said.data


def test_only_what_is_asked_of_a_server_is_sent_to_it(tmp_path: Path) -> None:
    """The address of a server goes nowhere before something is asked, and no answer is in what is asked."""
    program = tmp_path / "robot.py"
    asked = "redis.Redis(host=self.declare_parameter('host', 'x').value)\n        self.heard.get(os.environ['KEY'])"
    program.write_text("import os\nimport redis\n" + CALLED.format(asked))
    rows = [row for row in reported(program) if row.sink == "network"]
    assert [sorted(row.data) for row in rows] == [["env", "parameter:host"]]
