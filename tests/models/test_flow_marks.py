# SPDX-License-Identifier: Apache-2.0
"""Marks of information flow: which one a name has, and what is told of a wrong one."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

from rosward.frontends.cpp.flow_marks import marked, own_marks
from rosward.frontends.cpp.model_headers import model_headers
from rosward.frontends.cpp.parse import CppParser
from rosward.models.flow_marks import MARKS, FlowMark, mark_of, wrong
from rosward.models.marked_stubs import Wrong, scope_of
from rosward.models.stub_marks import OWN, StubMarks, wrong_marks
from rosward.models.tables import own_models

LINK = '''
"""A library."""
from _rosward import changes, pure as computes, releases, sink, source, stops
from other import Far as Near

sink("network", __name__)

class Base:
    @source("clock")
    def when(self): ...

@source("device", "file")
class Link(Base):
    pipe: Channel
    def __init__(self, port): ...
    def receive(self): ...
    @sink("device")
    def send(self, data): ...
    @computes
    def check(self, data): ...
    def channel(self) -> Channel: ...
    def lost(self): ...
    @stops("timer")
    def drop(self, timer): ...
    @stops
    def halt(self): ...

class Channel:
    @sink("log", "file")
    @source("env")
    def put(self, data): ...
    def again(self) -> "Channel": ...
    def far(self) -> Near: ...

Alias = Link
if True:
    @releases("salted")
    def digest(data): ...
def plain(): ...
'''
OTHER = """
from _rosward import sink
from link import Base as Far2
class Far:
    @sink("process")
    def run(self): ...
"""
COMPUTING = """
from _rosward import pure
pure(__name__)
class Array:
    def get(self): return self.items
    def put(self, x):
        self.items[0] = x
    def add(self, x):
        self.items.append(x)
    def fill(self, x):
        self._changed()
def f(x): ...
"""


@pytest.fixture
def stubs(tmp_path: Path) -> StubMarks:
    for name, text in (
        ("link.pyi", LINK),
        ("other.pyi", OTHER),
        ("computing/__init__.pyi", COMPUTING),
        ("computing/inner.pyi", "x = 1"),
    ):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(text)
    return StubMarks((tmp_path,))


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("link.Link.send", FlowMark(sinks=("device",))),
        ("link.Alias.send", FlowMark(sinks=("device",))),
        ("link.Link.receive", FlowMark(sources=("device", "file"))),
        ("link.Link", FlowMark(sources=("device", "file"))),
        ("link.Link.check", FlowMark(pure=True)),
        ("link.Link.when", FlowMark(sources=("clock",))),
        ("link.Link.unheard", FlowMark(sources=("device", "file"))),
        ("link.Link.channel.put", FlowMark(sinks=("log", "file"), sources=("env",))),
        ("link.Link.channel.again.again.put", FlowMark(sinks=("log", "file"), sources=("env",))),
        ("link.Link.pipe.put", FlowMark(sinks=("log", "file"), sources=("env",))),
        ("link.Link.channel.far.run", FlowMark(sinks=("process",))),
        ("link.Near.run", FlowMark(sinks=("process",))),
        ("link.Link.lost.more", FlowMark(sources=("device", "file"))),
        ("link.Link.drop", FlowMark(stops=("timer",))),
        ("link.Link.halt", FlowMark(stops=("self",))),
        ("link.digest", FlowMark(releases=True)),
        ("link.plain", FlowMark(sinks=("network",))),
        ("link.unheard.of", FlowMark(sinks=("network",))),
        ("computing.f", FlowMark(pure=True)),
        ("computing.Array.get", FlowMark(pure=True)),
        ("computing.Array.put", FlowMark(pure=True, changes=("self",))),
        ("computing.Array.add", FlowMark(pure=True, changes=("self",))),
        ("computing.Array.fill", FlowMark(pure=True, changes=("self",))),
        ("computing.inner.f", FlowMark()),
        ("nothing.known", FlowMark()),
        ("", FlowMark()),
        ("a..b", FlowMark()),
        ("../etc/passwd", FlowMark()),
        (".".join("a" * 3000), FlowMark()),
    ],
)
def test_which_mark_a_name_has(stubs: StubMarks, name: str, expected: FlowMark) -> None:
    assert stubs.of(name) == expected


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("print", FlowMark(sinks=("stdout",))),
        ("eval", FlowMark(sinks=("code",))),
        ("open.write", FlowMark(sinks=("file",))),
        ("io.open.write", FlowMark(sinks=("file",))),
        ("socket.create_connection.sendall", FlowMark(sinks=("network",))),
        ("zmq.Context.socket.send_json", FlowMark(sinks=("network",))),
        ("requests.get.json", FlowMark(pure=True)),
        ("boto3.client.put_object", FlowMark(sinks=("network",), sources=("network",))),
        ("datetime.datetime.now", FlowMark(sources=("clock",))),
        ("datetime.datetime.strftime", FlowMark(pure=True)),
        ("numpy.random.default_rng.normal", FlowMark(sources=("random",))),
        ("numpy.random.choice", FlowMark(sources=("random",))),
        ("numpy.linalg.norm", FlowMark(pure=True)),
        ("numpy.ndarray.fill", FlowMark(pure=True, changes=("self",))),
        ("rclpy.timer.Timer.cancel", FlowMark(stops=("self",))),
        ("rclpy.node.Node.destroy_timer", FlowMark(stops=("timer",))),
        ("rclpy.impl.rcutils_logger.RcutilsLogger.info", FlowMark(sinks=("log",))),
        ("tf2_ros.buffer.Buffer.lookup_transform", FlowMark(sources=("tf",))),
        ("subprocess.Popen.stdin.write", FlowMark(sinks=("process",))),
        ("cv2.rectangle", FlowMark()),
    ],
)
def test_what_is_said_of_libraries(name: str, expected: FlowMark) -> None:
    assert StubMarks().of(name) == expected


def test_a_stub_of_the_user_goes_first(tmp_path: Path) -> None:
    (tmp_path / "requests.pyi").write_text("from _rosward import pure\npure(__name__)\n@pure\ndef get(url): ...\n")
    marks = StubMarks((tmp_path,))
    assert marks.of("requests.get") == FlowMark(pure=True)
    assert marks.of("requests.post") == StubMarks().of("requests.post")  # of that it says only what holds for all


@pytest.mark.parametrize("folder", OWN, ids=lambda f: f.name)
def test_own_marks_are_right(folder: Path) -> None:
    natives = own_models().natives
    assert [f.message for f in wrong_marks(folder, "", lambda name: f"_rosward.{name}" in natives)] == []


@pytest.mark.parametrize("file", sorted(OWN[1].rglob("*.pyi")), ids=lambda f: f.relative_to(OWN[1]).as_posix())
def test_a_file_of_marks_says_something(file: Path) -> None:
    text = file.read_text(encoding="utf-8")
    assert text.startswith("# SPDX-License-Identifier: Apache-2.0\n")
    tree = ast.parse(text)
    assert ast.get_docstring(tree)
    scope = scope_of(tree)
    work, said = [scope], False
    for each in work:
        said = said or each.mark is not None or bool(each.alias)
        work += each.inner.values()
    assert said


def test_attributes_of_own_headers_are_right() -> None:
    parser = CppParser()
    found = dict(own_marks(parser))
    for file in model_headers({}, parser):
        found.update(marked(file))
    assert {"std.printf", "send", "tf2", "rclcpp.Clock.now", "rclcpp.Time", "rclcpp.TimerBase.cancel"} <= found.keys()
    told = [
        (name, message)
        for name, said in found.items()
        for mark, words in said.words.items()
        for message in wrong(mark, words, None if said.is_scope and mark == "stops" else ("self", *said.parameters))
    ]
    assert told == []
    assert mark_of(found["tf2"].words) == FlowMark(pure=True, holds=True)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("@sink('netwrok')\ndef f(x): ...", "'netwrok' is no kind of sink"),
        ("@source('stdout')\ndef f(x): ...", "'stdout' is no kind of source"),
        ("@sink\ndef f(x): ...", "sink needs words"),
        ("@sink()\ndef f(x): ...", "sink names no kind"),
        ("@source(1)\ndef f(x): ...", "source takes words in quotes"),
        ("@stops('y')\ndef f(x): ...", "stops names 'y', which is no parameter"),
        ("@stops('x')\nclass A: ...", "stops marks a function"),
        ("@changes()\ndef f(x): ...", "changes names no parameter"),
        ("@changes\ndef f(x): ...", "changes needs words"),
        ("@changes('x')\n@pure\ndef f(x): ...", "pure and changes exclude each other"),
        ("@pure()\ndef f(x): ...", "pure takes no words"),
        ("@releases\ndef f(x): ...", "releases needs words"),
        ("@releases('')\ndef f(x): ...", "releases says in one text why"),
        ("sink('nowhere', __name__)", "'nowhere' is no kind of sink"),
        ("class A:\n    @sink('nowhere')\n    async def f(self): ...", "'nowhere' is no kind of sink"),
    ],
)
def test_a_wrong_mark_is_told(text: str, expected: str) -> None:
    told: list[Wrong] = []
    scope_of(ast.parse(f"from _rosward import {', '.join(m for m in MARKS if m != 'holds')}\n{text}"), told)
    assert [w.message[: len(expected)] for w in told] == [expected]
    assert told[0].line >= 2


def test_what_looks_like_a_mark_and_is_none() -> None:
    told: list[Wrong] = []
    scope = scope_of(ast.parse("def sink(x): return x\n@sink\ndef f(): ...\n@other.source\ndef g(): ..."), told)
    assert told == []
    assert scope.inner["f"].mark is None


@pytest.mark.parametrize(
    "text",
    [
        "class A(B): ...\nclass B(A): ...",
        "class A:\n    def f(self) -> A: ...\n    def g(self) -> f: ...",
        "from loop import A as A",
        "from loop import B as A\nfrom loop import A as B",
        "A = A",
        "class A(" + ", ".join(f"B{n}" for n in range(300)) + "): ...\n"
        + "\n".join(f"class B{n}(" + ", ".join(f"B{m}" for m in range(300)) + "): ..." for n in range(300)),
        "@" + "sink" + "('x')" * 200 + "\ndef A(): ...",
        "def A(): " + "x" + ".y" * 3000,
        "class A:\n    f: " + "A[" * 80 + "1" + "]" * 80,
        "\0",
        "def A(:",
    ],
)  # fmt: skip
def test_strange_stubs_end(tmp_path: Path, text: str) -> None:
    (tmp_path / "loop.pyi").write_text(f"from _rosward import sink\n{text}\n")
    marks = StubMarks((tmp_path,))
    for name in ("loop.A", "loop.A.f", "loop.A.f.f.f", "loop.A.none.g"):
        assert marks.of(name) == FlowMark()
    list(wrong_marks(tmp_path, "", lambda _: True))
