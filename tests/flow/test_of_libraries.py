# SPDX-License-Identifier: Apache-2.0
"""Promise: what a library sends, asks and gets over the entities that it makes is an output or a source of the node, as if the program did it."""

from __future__ import annotations

import textwrap
from pathlib import Path

import pytest
from sampling import sample

from .reported import rows_of, said_by, said_of

HEAD = """
import rclpy
from geometry_msgs.msg import PoseStamped
from nav_msgs.msg import Path
from rclpy.node import Node
from std_msgs.msg import Float64, String


"""
PARAMETERS = """
from rclpy.parameter import Parameter
from rclpy.parameter_client import AsyncParameterClient

class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.client = AsyncParameterClient(self, 'other')
        self.out = self.create_publisher(Float64, '/out', 10)
        self.create_subscription(Float64, '/in', self.on_in, 10)

    def on_in(self, msg):
        self.client.set_parameters([Parameter('speed', Parameter.Type.DOUBLE, msg.data)])
        self.client.get_parameters(['limit'], callback=self.got)

    def got(self, future):
        self.out.publish(Float64(data=future.result().values[0].double_value))

rclpy.init()
rclpy.spin(Robot())
"""
EVENTS = """
from rclpy.parameter_event_handler import ParameterEventHandler

class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.handler = ParameterEventHandler(self)
        self.handler.add_parameter_callback('speed', 'other', self.changed)
        self.handler.add_parameter_event_callback(self.happened)
        self.out = self.create_publisher(Float64, '/out', 10)
        self.who = self.create_publisher(String, '/who', 10)

    def changed(self, parameter):
        self.out.publish(Float64(data=parameter.value.double_value))

    def happened(self, event):
        self.who.publish(String(data=event.node))

rclpy.init()
rclpy.spin(Robot())
"""
WAITED = """
from rclpy.wait_for_message import wait_for_message

rclpy.init()
node = Node('robot')
out = node.create_publisher(Float64, '/out', 10)
found, message = wait_for_message(Float64, node, '/once', time_to_wait=1.0)
if found:
    out.publish(message)
"""
NAVIGATES = """
from nav2_simple_commander.robot_navigator import BasicNavigator, TaskResult

class Tour(BasicNavigator):
    def __init__(self):
        super().__init__('tour')
        self.out = self.create_publisher(String, '/out', 10)
        self.done = self.create_publisher(String, '/done', 10)
        self.way = self.create_publisher(Path, '/way', 10)
        self.create_subscription(PoseStamped, '/pose', self.on_pose, 10)
        self.create_subscription(PoseStamped, '/start', self.setInitialPose, 10)
        self.create_subscription(String, '/map', lambda msg: self.changeMap(msg.data), 10)

    def on_pose(self, msg):
        self.way.publish(self.getPath(PoseStamped(), msg))
        self.goToPose(msg)
        while not self.isTaskComplete():
            self.out.publish(String(data=str(self.getFeedback().distance_remaining)))
        if self.getResult() == TaskResult.SUCCEEDED:
            self.done.publish(String(data='done'))

rclpy.init()
rclpy.spin(Tour())
"""
DIAGNOSES = """
import diagnostic_updater
from diagnostic_msgs.msg import DiagnosticStatus

class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.value = 0.0
        self.updater = diagnostic_updater.Updater(self)
        self.updater.setHardwareID('arm')
        self.updater.add('value', self.diagnose)
        self.create_subscription(Float64, '/in', self.on_in, 10)

    def on_in(self, msg):
        self.value = msg.data

    def diagnose(self, status):
        status.summary(DiagnosticStatus.OK, 'fine')
        status.add('value', str(self.value))
        return status

rclpy.init()
rclpy.spin(Robot())
"""


@pytest.mark.parametrize(
    ("program", "sink", "strength", "source"),
    sample(
        [
            (PARAMETERS, "request:/other/set_parameters", "data", "topic:/in"),
            (PARAMETERS, "topic:/out", "data", "response:/other/get_parameters"),
            (EVENTS, "topic:/out", "data", "topic:/parameter_events"),
            (EVENTS, "topic:/who", "data", "topic:/parameter_events"),
            (WAITED, "topic:/out", "data", "topic:/once"),
            (NAVIGATES, "goal:/navigate_to_pose", "data", "topic:/pose"),
            (NAVIGATES, "goal:/compute_path_to_pose", "data", "topic:/pose"),
            (NAVIGATES, "topic:/way", "data", "result:/compute_path_to_pose"),
            (NAVIGATES, "topic:/out", "data", "feedback:/navigate_to_pose"),
            (NAVIGATES, "topic:/done", "control", "result:/navigate_to_pose"),
            (NAVIGATES, "topic:/initialpose", "data", "topic:/start"),
            (NAVIGATES, "request:/map_server/load_map", "data", "topic:/map"),
            (DIAGNOSES, "topic:/diagnostics", "data", "topic:/in"),
        ],
        3,
    ),
)
def test_what_a_library_does_is_said(program: str, sink: str, strength: str, source: str, tmp_path: Path) -> None:
    said = said_by(tmp_path, HEAD + textwrap.dedent(program), sink)
    assert source in getattr(said, strength), said


SERVES = """
import threading
from http.server import BaseHTTPRequestHandler, HTTPServer

robot = None

class Page(BaseHTTPRequestHandler):
    def do_POST(self):
        robot.out.publish(Float64(data=float(self.rfile.read(int(self.headers['Content-Length'])))))
        robot.asked.publish(String(data=self.path))

    def do_GET(self):
        self.wfile.write(str(robot.value).encode())

class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.value = 0.0
        self.out = self.create_publisher(Float64, '/out', 10)
        self.asked = self.create_publisher(String, '/asked', 10)
        self.create_subscription(Float64, '/in', self.on_in, 10)

    def on_in(self, msg):
        self.value = msg.data

rclpy.init()
robot = Robot()
threading.Thread(target=HTTPServer(('', 8000), Page).serve_forever).start()
rclpy.spin(robot)
"""
STREAMS = """
import socketserver
import threading

class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.value = 0.0
        self.out = self.create_publisher(String, '/out', 10)
        self.line = self.create_publisher(String, '/line', 10)
        self.create_subscription(Float64, '/in', self.on_in, 10)
        robot = self

        class Stream(socketserver.StreamRequestHandler):
            def handle(self):
                for line in self.rfile:
                    robot.line.publish(String(data=line.decode()))
                robot.out.publish(String(data=self.request.recv(10).decode()))
                self.request.sendall(str(robot.value).encode())

        threading.Thread(target=socketserver.TCPServer(('', 8000), Stream).serve_forever).start()

    def on_in(self, msg):
        self.value = msg.data

rclpy.init()
rclpy.spin(Robot())
"""
LISTENS = """
import paho.mqtt.client as mqtt

class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.out = self.create_publisher(String, '/out', 10)
        self.more = self.create_publisher(String, '/more', 10)
        self.client = mqtt.Client()
        self.client.on_message = self.arrived
        self.client.message_callback_add('more', self.more_arrived)
        self.client.loop_start()

    def arrived(self, client, userdata, message):
        self.out.publish(String(data=message.payload.decode()))

    def more_arrived(self, client, userdata, message):
        self.more.publish(String(data=message.payload.decode()))

rclpy.init()
rclpy.spin(Robot())
"""
DATAGRAMS = """
import socketserver
import threading

class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.out = self.create_publisher(String, '/out', 10)
        robot = self

        class Datagram(socketserver.BaseRequestHandler):
            def handle(self):
                data, where = self.request
                robot.out.publish(String(data=data.decode()))
                where.sendto(b'taken', self.client_address)

        threading.Thread(target=socketserver.UDPServer(('', 8000), Datagram).serve_forever).start()

rclpy.init()
rclpy.spin(Robot())
"""
MENU = """
from interactive_markers import InteractiveMarkerServer, MenuHandler

class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.server = InteractiveMarkerServer(self, 'marks')
        self.menu = MenuHandler()
        self.menu.apply(self.server, 'arm')
        self.menu.insert('go', callback=self.chosen)
        self.out = self.create_publisher(String, '/out', 10)

    def chosen(self, feedback):
        self.out.publish(String(data=feedback.marker_name))

rclpy.init()
rclpy.spin(Robot())
"""
DERIVED = """
from paho.mqtt.client import Client

class Listener(Client):
    def __init__(self, robot):
        super().__init__()
        self.robot = robot

    def on_message(self, client, userdata, message):
        self.robot.out.publish(String(data=message.payload.decode()))

class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.out = self.create_publisher(String, '/out', 10)
        Listener(self).loop_start()

rclpy.init()
rclpy.spin(Robot())
"""


@pytest.mark.parametrize(
    ("program", "sink", "source"),
    sample(
        [
            (SERVES, "topic:/out", "network"),
            (SERVES, "topic:/asked", "network"),
            (SERVES, "network", "topic:/in"),
            (STREAMS, "topic:/line", "network"),
            (STREAMS, "topic:/out", "network"),
            (STREAMS, "network", "topic:/in"),
            (LISTENS, "topic:/out", "network"),
            (LISTENS, "topic:/more", "network"),
            (DATAGRAMS, "topic:/out", "network"),
            (DERIVED, "topic:/out", "network"),
            (MENU, "topic:/out", "topic:/marks/feedback"),
        ],
        3,
    ),
)
def test_what_a_base_class_or_a_callback_brings_is_said(program: str, sink: str, source: str, tmp_path: Path) -> None:
    said = said_by(tmp_path, HEAD + textwrap.dedent(program), sink)
    assert source in said.data, said


def test_yaml_that_is_a_text_is_in_no_file(tmp_path: Path) -> None:
    rows = rows_of(
        tmp_path,
        HEAD
        + textwrap.dedent("""
        import yaml

        class Robot(Node):
            def __init__(self):
                super().__init__('robot')
                self.create_subscription(Float64, '/in', self.on_in, 10)

            def on_in(self, msg):
                self.get_logger().info(yaml.dump({'value': msg.data}))

        rclpy.init()
        rclpy.spin(Robot())
        """),
    )
    assert {row.sink for row in rows} == {"log"}


def test_a_callback_of_a_pin_runs_where_the_device_says_so(tmp_path: Path) -> None:
    said = said_by(
        tmp_path,
        HEAD
        + textwrap.dedent("""
        from gpiozero import Button

        class Robot(Node):
            def __init__(self):
                super().__init__('robot')
                self.pressed = 0.0
                self.out = self.create_publisher(Float64, '/out', 10)
                self.create_timer(1.0, lambda: self.out.publish(Float64(data=self.pressed)))
                self.button = Button(4)
                self.button.when_pressed = self.press

            def press(self):
                self.pressed = 1.0

        rclpy.init()
        rclpy.spin(Robot())
        """),
        "topic:/out",
    )
    assert "device" in said.trigger


def test_how_often_diagnostics_are_made_is_not_in_them(tmp_path: Path) -> None:
    said = said_by(tmp_path, HEAD + textwrap.dedent(DIAGNOSES), "topic:/diagnostics")
    assert said.data == {"topic:/in"}


def test_what_is_read_from_a_pin_or_a_port_comes_from_the_device(tmp_path: Path) -> None:
    rows = rows_of(
        tmp_path,
        HEAD
        + textwrap.dedent("""
        import serial
        from gpiozero import Button, DistanceSensor

        class Robot(Node):
            def __init__(self):
                super().__init__('robot')
                self.button, self.ahead = Button(4), DistanceSensor(echo=17, trigger=4)
                self.port = serial.Serial('/dev/ttyUSB0')
                self.ask = self.port.write
                for topic in ('pressed', 'ahead', 'waiting', 'constant'):
                    setattr(self, topic + '_out', self.create_publisher(Float64, topic, 10))
                self.create_timer(1.0, self.tick)

            def tick(self):
                if self.button.is_pressed:
                    self.pressed_out.publish(Float64(data=1.0))
                self.ahead_out.publish(Float64(data=self.ahead.distance * 2))
                self.waiting_out.publish(Float64(data=float(self.port.in_waiting)))
                self.constant_out.publish(Float64(data=float(bool(self.ask))))

        rclpy.init()
        rclpy.spin(Robot())
        """),
    )
    pressed, ahead, waiting, constant = (
        said_of(rows, f"topic:/{name}") for name in ("pressed", "ahead", "waiting", "constant")
    )
    assert pressed is not None
    assert ahead is not None
    assert waiting is not None
    assert pressed.control == ahead.data == waiting.data == {"device"}
    assert constant is None or not constant.data


def test_what_one_of_several_libraries_makes_is_what_either_makes(tmp_path: Path) -> None:
    rows = rows_of(
        tmp_path,
        HEAD
        + textwrap.dedent("""
        import random

        import acme
        import serial
        import paho.mqtt.client as mqtt

        class Robot(Node):
            def __init__(self):
                super().__init__('robot')
                self.link = random.choice([acme.Link, serial.Serial])()
                self.kinds = {}
                self.create_subscription(String, '/written', self.written, 1)
                self.create_subscription(String, '/told', self.told, 1)
                self.create_subscription(String, '/added', self.added, 1)

            def added(self, msg):
                self.kinds[msg.data] = acme.open
                self.kinds[msg.data + '?'] = mqtt.Client

            def written(self, msg):
                self.link.write(msg.data.encode())

            def told(self, msg):
                self.kinds[msg.data]().publish('x', msg.data)

        rclpy.init()
        rclpy.spin(Robot())
        """),
    )
    device, network = said_of(rows, "device"), said_of(rows, "network")
    assert device is not None, rows
    assert network is not None, rows
    assert "topic:/written" in device.data
    assert "topic:/told" in network.data
