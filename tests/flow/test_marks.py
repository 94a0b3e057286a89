# SPDX-License-Identifier: Apache-2.0
"""What marks of models do to flows: stubs of the user, and attributes of declarations in C++."""

from __future__ import annotations

from pathlib import Path

import pytest

import rosward
from rosward.engine.budget import Budget
from rosward.influence.check import against
from rosward.influence.graph import graph_of
from rosward.influence.policy import read_policy
from rosward.ros.flows import STRENGTHS

STUB = '''
"""acme: a link."""
from _rosward import changes, hands, pure, releases, sink, source

class Link:
    def __init__(self, port): ...
    @sink("device")
    def send(self, data) -> None: ...
    @source("device")
    def receive(self): ...
    def keep(self, data): ...
    @pure
    def check(self, data) -> int: ...
    @changes("out")
    def fill(self, out, data) -> None: ...
    def channel(self) -> Channel: ...
class Channel:
    @sink("network")
    def put(self, data): ...

@hands("acme.Link")
def serve(handler) -> None: ...
@releases("a digest with a secret salt")
def digest(data) -> str: ...
@pure
def scale(data, by):
    return data * by
'''
CLOUD = '"""cloud."""\nfrom _rosward import sink\nsink("network", __name__)\n'
PROGRAM = """
import subprocess, sys
import rclpy
from rclpy.node import Node
from std_msgs.msg import String
import cloud
from acme import Link, digest, scale

class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.link, self.other = Link('a'), Link('b')
        self.pipe = subprocess.Popen(['x'], stdin=subprocess.PIPE)
        self.out = self.create_publisher(String, '/out', 10)
        self.create_subscription(String, '/in', self.on_in, 10)

    def on_in(self, msg):
        {0}

rclpy.init()
rclpy.spin(Robot())
"""
SEND = "self.out.publish(String(data={}))"
HEADER = """
#pragma once
#include <string>
namespace acme
{
[[rosward::sink("network")]] void upload(const std::string & text);
[[rosward::source("device")]] double measure();
[[rosward::pure]] double scale(double value, double by);
[[rosward::releases("a digest with a secret salt")]] double digest(double value);
class [[rosward::sink("device")]] Arm
{
public:
  void move(double value);
  [[rosward::source("clock")]] double ticks();
};
}
"""
CPP = """
#include "acme.hpp"
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/float64.hpp"
using std_msgs::msg::Float64;

class App : public rclcpp::Node
{{
public:
  App() : Node("app")
  {{
    out_ = create_publisher<Float64>("out", 10);
    sub_ = create_subscription<Float64>("in", 10, std::bind(&App::on, this, std::placeholders::_1));
  }}
private:
  void on(const Float64::SharedPtr msg)
  {{
    Float64 made;
    {0}
    out_->publish(made);
  }}
  acme::Arm arm_;
  rclcpp::Publisher<Float64>::SharedPtr out_;
  rclcpp::Subscription<Float64>::SharedPtr sub_;
}};

int main(int argc, char ** argv)
{{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<App>());
}}
"""


def said(result: rosward.Result) -> set[str]:
    """Each sink, with its data and what decides it."""
    found = set()
    for node in result.network.nodes:
        for sink in node.flows.sinks if node.flows is not None else ():
            ways = (f"{s} {' '.join(sorted(map(str, sink.of(s))))}" for s in STRENGTHS[:2] if sink.of(s))
            found.add("; ".join((str(sink.sink), *ways)))
    return found


def analysed(folder: Path, **files: str) -> rosward.Result:
    for name, text in files.items():
        path = folder / name.replace("__", "/").replace("_dot_", ".")
        path.parent.mkdir(exist_ok=True)
        path.write_text(text)
    models = [folder / "models"] if (folder / "models").is_dir() else []
    return rosward.extract(folder / "src", models=models, budget=Budget()._replace(flow=True, net=False))


@pytest.mark.parametrize(
    ("statement", "expected"),
    [
        ("self.link.send(msg.data)", {"device; data topic:/in"}),
        ("self.link.channel().put(msg.data)", {"network; data topic:/in"}),
        ("cloud.upload(msg.data)", {"network; data topic:/in"}),
        ("cloud.Client('x').put(msg.data)", {"network; data topic:/in"}),
        (SEND.format("self.link.receive()"), {"topic:/out; data device"}),
        (f"self.link.send(msg.data); {SEND.format('self.link.receive()')}", {"device; data topic:/in", "topic:/out; data device"}),
        (f"self.link.keep(msg.data); {SEND.format('self.link.receive()')}", {"topic:/out; data device topic:/in"}),
        (f"self.link.keep(msg.data); {SEND.format('self.other.receive()')}", {"topic:/out; data device"}),
        (f"self.link.check(msg.data); {SEND.format('self.link.receive()')}", {"topic:/out; data device"}),
        (SEND.format("str(self.link.check(msg.data))"), {"topic:/out; data topic:/in"}),
        ("b = String(); self.link.fill(b, msg.data); self.out.publish(b)", {"topic:/out; data topic:/in"}),
        (SEND.format("digest(msg.data)"), {"topic:/out"}),
        (f"if msg.data: {SEND.format('digest(msg.data)')}", {"topic:/out; control topic:/in"}),
        (SEND.format("scale(msg.data, 2)"), {"topic:/out; data topic:/in"}),
        ("sys.stdout.write(msg.data)", {"stdout; data topic:/in"}),
        ("self.pipe.stdin.write(msg.data)", {"process; data process random topic:/in"}),
    ],
)  # fmt: skip
def test_marks_of_stubs(tmp_path: Path, statement: str, expected: set[str]) -> None:
    given = {"models__acme_dot_pyi": STUB, "models__cloud_dot_pyi": CLOUD}
    result = analysed(tmp_path, src__robot_dot_py=PROGRAM.format(statement), **given)
    assert said(result) - {"process"} == expected
    assert not [f for f in result.network.findings if f.place.file.startswith("models:")]


@pytest.mark.parametrize(
    ("statement", "expected"),
    [
        ('acme::upload(std::to_string(msg->data));', {"network; data topic:/in", "topic:/out"}),
        ("made.data = acme::measure();", {"topic:/out; data device"}),
        ("made.data = acme::scale(msg->data, 2.0);", {"topic:/out; data topic:/in"}),
        ("made.data = acme::digest(msg->data);", {"topic:/out"}),
        ("arm_.move(msg->data);", {"device; data topic:/in", "topic:/out"}),
        ("made.data = arm_.ticks();", {"topic:/out; data clock"}),
    ],
)  # fmt: skip
def test_attributes_of_declarations(tmp_path: Path, statement: str, expected: set[str]) -> None:
    """A library that is installed without its code: its header is among the sources."""
    assert said(analysed(tmp_path, src__acme_dot_hpp=HEADER, src__main_dot_cpp=CPP.format(statement))) == expected


def test_a_wrong_attribute_is_told(tmp_path: Path) -> None:
    header = HEADER.replace('"network"', '"netwrok"')
    result = analysed(tmp_path, src__acme_dot_hpp=header, src__main_dot_cpp=CPP.format(""))
    told = [(f.message[:29], f.place.file, f.place.line) for f in result.network.findings if f.code == "RW214"]
    assert told == [("'netwrok' is no kind of sink;", "acme.hpp", 6)]


def test_a_wrong_mark_is_told_without_flow(tmp_path: Path) -> None:
    (tmp_path / "models").mkdir()
    (tmp_path / "models" / "acme.pyi").write_text(
        STUB.replace('"device"', '"devices"', 1).replace("pure,", "pure, snik,")
    )
    (tmp_path / "a.py").write_text("import rclpy\n")
    result = rosward.extract(tmp_path / "a.py", models=[tmp_path / "models"])
    told = [
        (f.message.partition(";")[0], f.place.file, f.place.line) for f in result.network.findings if f.code == "RW214"
    ]
    assert told == [
        ("_rosward has no snik", "models:acme.pyi", 3),
        ("'devices' is no kind of sink", "models:acme.pyi", 7),
    ]


@pytest.mark.parametrize(
    ("statement", "expected"),
    [
        (f"if msg.data == 'x': {SEND.format('digest(self.get_namespace())')}", ["RW606"]),
        (SEND.format("digest(msg.data)"), []),
    ],
)
def test_what_is_protected_decides_what_a_library_releases(statement: str, expected: list[str], tmp_path: Path) -> None:
    result = analysed(tmp_path, models__acme_dot_pyi=STUB, src__robot_dot_py=PROGRAM.format(statement))
    policy = read_policy({"rule": [{"name": "kept", "from": ["/in"], "not-to": ["network"]}]})
    found = against(graph_of(result.network.nodes), policy)
    assert [f.code for f in found] == expected
    assert all(f.message == "/in decides what acme.digest releases" for f in found)


HANDLERS = """
    async def each(self, link, *more):
        await link.send(self.kept)

    def plain(self, rate, link):
        link.send(self.kept)
"""


@pytest.mark.parametrize(
    "registered",
    ["acme.serve(self.each)", "acme.serve(partial(self.plain, 3))", "acme.serve(lambda k: self.plain(1, k))"],
)
def test_what_a_library_calls_a_callback_with(registered: str, tmp_path: Path) -> None:
    program = PROGRAM.format("self.kept = msg.data").replace(
        "from acme import", "from functools import partial\nimport acme\nfrom acme import"
    )
    program = program.replace("self.pipe =", f"self.kept = ''; {registered}; self.pipe =").replace(
        "\nrclpy.init", HANDLERS + "\nrclpy.init"
    )
    assert said(analysed(tmp_path, models__acme_dot_pyi=STUB, src__robot_dot_py=program)) - {"process"} == {
        "device; data topic:/in"
    }


@pytest.mark.parametrize("module", ["websockets", "websockets.server", "websockets.asyncio.server"])
def test_a_server_of_web_sockets_sends_into_the_network(module: str, tmp_path: Path) -> None:
    program = PROGRAM.format("self.kept = msg.data").replace("from acme import Link, digest, scale", f"import {module}")
    program = program.replace(
        "self.link, self.other = Link('a'), Link('b')", f"self.kept = ''; {module}.serve(self.each, '0.0.0.0', 8765)"
    )
    program = program.replace("\nrclpy.init", HANDLERS + "\nrclpy.init")
    assert said(analysed(tmp_path, src__robot_dot_py=program)) - {"process"} == {"network; data topic:/in"}
