# SPDX-License-Identifier: Apache-2.0
"""What `rosward flow --format caret` writes: which callback publishes what, and which reads what another one wrote, in CARET's form."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
import yaml

from rosward.cli import main
from rosward.outputs.documents.caret_yaml import caret_yaml

EXAMPLES = Path(__file__).parents[2] / "examples"
HEAD = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class App(Node):
    def __init__(self):
        super().__init__("app")
        self.out = self.create_publisher(String, "out", 10)
"""
END = """

rclpy.init()
rclpy.spin(App())
"""


@pytest.fixture(autouse=True)
def workspace(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


def architecture(text: str) -> dict[str, Any]:
    """The nodes of a file that has the form which caret_analyze reads: its keys, and no name of a callback that is none."""
    document = yaml.safe_load(text)
    assert set(document) == {"named_paths", "executors", "nodes"}
    nodes = {node["node_name"]: node for node in document["nodes"]}
    assert len(nodes) == len(document["nodes"])
    for node in nodes.values():
        names = {callback["callback_name"] for callback in node.get("callbacks", ())}
        for callback in node.get("callbacks", ()):
            own = {"subscription_callback": ("topic_name", str), "timer_callback": ("period_ns", int)}
            key, kind = own[callback["callback_type"]]
            assert isinstance(callback[key], kind)
            assert isinstance(callback["symbol"], str)
        grouped = [name for group in node.get("callback_groups", ()) for name in group["callback_names"]]
        assert sorted(grouped) == sorted(names)
        for each in node.get("variable_passings", ()):
            assert {each["callback_name_write"], each["callback_name_read"]} <= names
        for each in node.get("publishes", ()):
            assert set(each["callback_names"]) <= {*names, "UNDEFINED"}
        assert {each["callback_name"] for each in node.get("subscribes", ())} <= names
        kinds = {each["context_type"] for each in node.get("message_contexts", ())}
        assert kinds <= {"callback_chain", "use_latest_message"}
    return nodes


def node(body: str, capsys: pytest.CaptureFixture[str], name: str = "/app") -> dict[str, Any]:
    Path("app.py").write_text(HEAD + body + END, encoding="utf-8")
    assert main(["flow", "--format", "caret"]) == 0
    found = architecture(capsys.readouterr().out)[name]
    assert isinstance(found, dict)
    return found


def callbacks(found: dict[str, Any]) -> dict[str, str]:
    """The functions by the names of the callbacks."""
    return {each["callback_name"]: each["symbol"].rpartition(".")[2] for each in found["callbacks"]}


def publishing(found: dict[str, Any], topic: str = "/out") -> list[str]:
    (names,) = [each["callback_names"] for each in found["publishes"] if each["topic_name"] == topic]
    return sorted(callbacks(found).get(name, name) for name in names)


def passings(found: dict[str, Any]) -> list[tuple[str, str]]:
    own = callbacks(found)
    return [
        (own[each["callback_name_write"]], own[each["callback_name_read"]])
        for each in found.get("variable_passings", ())
    ]


def contexts(found: dict[str, Any]) -> list[str]:
    return [
        f"{each['context_type']} {each['subscription_topic_name']} {each['publisher_topic_name']}"
        for each in found.get("message_contexts", ())
    ]


LATEST = """\
        self.last = String()
        self.create_subscription(String, "in", self.on_in, 10)
        self.create_subscription(String, "unused", self.on_unused, 10)
        self.create_timer(0.25, self.tick)

    def on_in(self, msg):
        self.last = msg

    def on_unused(self, msg):
        self.unused = msg

    def tick(self):
        self.out.publish(self.last)
"""


def test_a_timer_that_reads_what_a_subscription_wrote(capsys: pytest.CaptureFixture[str]) -> None:
    found = node(LATEST, capsys)
    assert publishing(found) == ["tick"]
    assert passings(found) == [("on_in", "tick")]
    assert contexts(found) == ["callback_chain /in /out"]
    assert [c["period_ns"] for c in found["callbacks"] if c["callback_type"] == "timer_callback"] == [250_000_000]


def test_a_subscription_that_publishes(capsys: pytest.CaptureFixture[str]) -> None:
    found = node(
        '        self.create_subscription(String, "in", self.on_in, 10)\n\n'
        "    def on_in(self, msg):\n        self.out.publish(msg)\n",
        capsys,
    )
    assert publishing(found) == ["on_in"]
    assert passings(found) == []
    assert contexts(found) == ["callback_chain /in /out"]


HELPER = """\
        self.a = self.b = ""
        self.create_subscription(String, "in_a", self.on_a, 10)
        self.create_subscription(String, "in_b", self.on_b, 10)
        self.create_timer(0.1, self.fast)
        self.create_timer(1.0, self.slow)

    def on_a(self, msg):
        self.send(msg.data)

    def on_b(self, msg):
        self.b = msg.data

    def fast(self):
        self.send("fast")

    def slow(self):
        self.send("slow")

    def send(self, text):
        self.out.publish(String(data=text))
"""


def test_one_statement_in_several_callbacks(capsys: pytest.CaptureFixture[str]) -> None:
    """Each of them publishes, the second timer too, for which the helper is not walked through again; none passes anything on."""
    found = node(HELPER, capsys)
    assert publishing(found) == ["fast", "on_a", "slow"]
    assert passings(found) == []
    assert contexts(found) == ["callback_chain /in_a /out"]


def test_what_is_sent_in_a_thread(capsys: pytest.CaptureFixture[str]) -> None:
    """CARET knows no threads: the latest message is all there is to say."""
    body = """\
        self.last = String()
        self.create_subscription(String, "in", self.on_in, 10)
        threading.Thread(target=self.work).start()

    def on_in(self, msg):
        self.last = msg

    def work(self):
        while True:
            self.out.publish(self.last)
"""
    Path("app.py").write_text("import threading\n" + HEAD + body + END, encoding="utf-8")
    assert main(["flow", "--format", "caret"]) == 0
    found = architecture(capsys.readouterr().out)["/app"]
    assert publishing(found) == ["UNDEFINED"]
    assert contexts(found) == ["use_latest_message /in /out"]


def test_two_subscriptions_of_one_topic(capsys: pytest.CaptureFixture[str]) -> None:
    body = """\
        self.create_subscription(String, "in", self.one, 10)
        self.create_subscription(String, "in", self.two, 10)

    def one(self, msg):
        self.out.publish(msg)

    def two(self, msg):
        pass
"""
    found = node(body, capsys)
    assert publishing(found) == ["one"]
    orders = {
        callbacks(found)[each["callback_name"]]: each.get("construction_order", 0) for each in found["subscribes"]
    }
    assert orders == {"one": 0, "two": 1}


def test_transforms_go_on_their_topic(capsys: pytest.CaptureFixture[str]) -> None:
    body = """\
        self.broadcaster = TransformBroadcaster(self)
        self.create_subscription(TransformStamped, "pose", self.on_pose, 10)

    def on_pose(self, msg):
        self.broadcaster.sendTransform(msg)
"""
    head = "from tf2_ros import TransformBroadcaster\nfrom geometry_msgs.msg import TransformStamped\n"
    Path("app.py").write_text(head + HEAD + body + END, encoding="utf-8")
    assert main(["flow", "--format", "caret"]) == 0
    found = architecture(capsys.readouterr().out)["/app"]
    assert publishing(found, "/tf") == ["on_pose"]
    assert contexts(found) == ["callback_chain /pose /tf"]


def test_a_period_that_is_not_known_is_told(capsys: pytest.CaptureFixture[str]) -> None:
    body = """\
        self.create_timer(float(input()), self.tick)

    def tick(self):
        self.out.publish(String())
"""
    Path("app.py").write_text(HEAD + body + END, encoding="utf-8")
    assert main(["flow", "--format", "caret"]) == 0
    out = capsys.readouterr().out
    assert "    period_ns: 0  # not known\n" in out
    assert publishing(architecture(out)["/app"]) == ["tick"]


def test_cpp(capsys: pytest.CaptureFixture[str]) -> None:
    """The example has drivers in C++, and helpers of libraries with timers of their own."""
    assert main(["flow", str(EXAMPLES), "--format", "caret"]) == 0
    found = architecture(capsys.readouterr().out)
    assert publishing(found["/porter/lidar"], "/porter/sensors/front/scan") == ["<lambda>"]
    assert passings(found["/porter/base_driver"]) == [("_on_command", "_step")]
    assert passings(found["/porter/lidar_filter"]) == []


def test_the_file_is_written(capsys: pytest.CaptureFixture[str]) -> None:
    Path("app.py").write_text(HEAD + LATEST + END, encoding="utf-8")
    assert main(["flow", "--format", "caret", "-o", "out"]) == 0
    assert capsys.readouterr().out == "wrote out/architecture.yaml\n"
    assert "/app" in architecture(Path("out/architecture.yaml").read_text(encoding="utf-8"))


def test_names_cannot_break_the_file() -> None:
    from outputs.networks import node as made
    from outputs.networks import pub, sub

    evil = "/a\nb: [\u202e\x1b'\""
    text = caret_yaml([made(evil, pub(evil), sub(evil), system=False), made("/robot_*/x", system=False)])
    found = architecture(text)
    assert list(found) == [evil]
    assert "# Left out" in text
    assert json.dumps(evil) in text
