# SPDX-License-Identifier: Apache-2.0
"""What is written stays in the output folder, is whole, and does nothing to who opens it, whatever names the input holds."""

from __future__ import annotations

import json
import os
import shutil
import signal
import subprocess
import sys
import time
from html.parser import HTMLParser
from pathlib import Path
from random import Random
from typing import Final
from xml.etree import ElementTree

import pytest

from hostile.guard import harmless, watched
from rosward.outputs.whole_files import write_text

EVIL: Final = (
    "../../x",
    "/../..",
    "..",
    "/etc/passwd",
    "a" * 5_000,
    "/a" * 3_000,
    "nul\0nul",
    "new\nline",
    "\x1b[2J\x1b]0;title\x07",
    "<script>document.title='pwned'</script>",
    '"><img src=x onerror="document.title=\'pwned\'">',
    "</svg></style></script><script>document.title='pwned'</script>",
    "javascript:document.title='pwned'",
    "{{7*7}}{% for x in y %}",
    "]]><x/>--><y/>&z;",
    '\\N\\"; x [URL="javascript:alert(1)"];',
    "\u202egnp.exe",
    "\ud800",
)
FORMATS: Final = "json,policy,svg,dot,html,permissions"


def program(names: tuple[str, ...]) -> str:
    """A program that uses each name wherever a name can stand; each in a try, since rcl refuses most of them."""
    lines = ["import rclpy", "from std_msgs.msg import String", "rclpy.init()", "good = rclpy.create_node('good')"]
    lines += ["good.create_publisher(String, 'chatter', 10)"]
    for name in names:
        for call in (
            f"rclpy.create_node({name!r})",
            f"rclpy.create_node('n', namespace={name!r})",
            f"rclpy.create_node('m', cli_args=['--ros-args', '--enclave', {name!r}])",
            f"good.create_publisher(String, {name!r}, 10)",
            f"good.create_publisher(String, 'x' + input() + {name!r}, 10)",
            f"good.create_publisher({name!r}, 'y', 10)",
            f"good.create_publisher(getattr(String, {name!r}), 'z', 10)",
            f"good.declare_parameter({name!r}, {name!r})",
            f"good.create_publisher(String, good.declare_parameter('p', {name!r}).value, 10)",
            f"open({name!r}).read()",
        ):
            lines += ["try:", f"    {call}", "except Exception:", "    pass"]
    return "\n".join([*lines, "rclpy.spin(good)", ""])


def launch(names: tuple[str, ...]) -> str:
    """A launch file that gives each name to each attribute of a node."""
    lines = [
        "from launch import LaunchDescription",
        "from launch_ros.actions import Node",
        "",
        "def generate_launch_description():",
    ]
    lines += ["    return LaunchDescription(["]
    for name in names:
        lines.append(f"        Node(package='ws', executable='plain.py', name={name!r}),")
        lines.append(
            f"        Node(package='ws', executable='plain.py', namespace={name!r}, remappings=[('chatter', {name!r})]),"
        )
        lines.append(f"        Node(package='ws', executable='plain.py', ros_arguments=['--enclave', {name!r}]),")
        lines.append(
            f"        Node(package={name!r}, executable={name!r}, name='x', parameters=[{{{name!r}: {name!r}}}]),"
        )
    return "\n".join([*lines, "    ])", ""])


@pytest.fixture(scope="module")
def evil(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the outputs `run` and `launch` of a workspace of evil names, made under watch."""
    folder = tmp_path_factory.mktemp("evil")
    workspace = folder / "ws"
    (workspace / "launch").mkdir(parents=True)
    (workspace / "talker.py").write_text(program(EVIL))
    (workspace / "plain.py").write_text(program(()))
    (workspace / "launch" / "evil.launch.py").write_text(launch(EVIL))
    (workspace / "<img src=x onerror=alert(1)>\n\x1b[2J.py").write_text(program(()).replace("'good'", "'other'"))
    (workspace / "CMakeLists.txt").write_text("project(ws)\ninstall(PROGRAMS talker.py plain.py DESTINATION lib/ws)\n")
    (workspace / "package.xml").write_text(
        "<package format='3'><name>ws</name><version>1.0.0</version><description>x</description>"
        "<maintainer email='a@b.cd'>A</maintainer><license>MIT</license></package>"
    )
    (folder / "shown").mkdir()
    for name, options in (("run", []), ("launch", ["--all-launch", "--enclaves", "launch"])):
        out = folder / "deep" / "down" / name
        out.parent.mkdir(parents=True, exist_ok=True)
        arguments = [
            "extract",
            "-v",
            str(workspace),
            *options,
            "--format",
            FORMATS,
            "--unknown",
            "wildcard",
            "-o",
            str(out),
        ]
        run = harmless(watched(arguments, inputs=workspace, outputs=out))
        assert run.status in (0, 1), run.stderr
        (folder / "shown" / name).write_text(run.stdout + run.stderr, encoding="utf-8", errors="surrogateescape")
    return folder


def outputs(folder: Path) -> list[Path]:
    """All files that were written."""
    return [p for p in (folder / "deep").rglob("*") if p.is_file()]


def test_everything_is_below_the_output_folder(evil: Path) -> None:
    assert {p.name for p in evil.iterdir()} == {"ws", "deep", "shown"}
    assert {p.name for p in (evil / "deep" / "down").iterdir()} == {"run", "launch"}
    assert len(outputs(evil)) > 10


def test_the_terminal_is_left_alone(evil: Path) -> None:
    for path in (evil / "shown").iterdir():
        text = path.read_text(encoding="utf-8")
        assert all(c == "\n" or c.isprintable() or c in "\xa0" for c in text)


def test_each_document_can_be_read(evil: Path) -> None:
    for path in outputs(evil):
        text = path.read_text(encoding="utf-8")
        if path.suffix in (".xml", ".svg"):
            root = ElementTree.fromstring(text)
            for element in root.iter():
                tag = str(element.tag).rpartition("}")[2].lower()
                assert tag not in ("script", "img", "iframe", "foreignobject", "x", "y")
                for name, value in element.attrib.items():
                    assert not name.lower().startswith("on")
                    assert "javascript:" not in value.lower() or not name.endswith("href")
        elif path.suffix == ".json":
            assert "/good" in {n["fqn"] for n in json.loads(text)["nodes"]} or path.parent.name == "launch"


class _Active(HTMLParser):
    """What in a page could act."""

    def __init__(self) -> None:
        super().__init__()
        self.found: list[tuple[str, list[tuple[str, str | None]]]] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        links = [v for n, v in attrs if n in ("href", "src", "xlink:href", "action", "formaction") and v]
        outside = [v for v in links if not v.startswith("#") and not v.startswith("https://")]
        if (
            tag in ("img", "iframe", "object", "embed", "form", "base")
            or outside
            or any(n.startswith("on") for n, _ in attrs)
        ):
            self.found.append((tag, attrs))


def test_the_report_holds_nothing_that_acts(evil: Path) -> None:
    for path in (evil / "deep").rglob("report.html"):
        page = _Active()
        text = path.read_text(encoding="utf-8")
        page.feed(text)
        assert page.found == []
        assert "document.title=&#39;pwned&#39;" in text or "document.title='pwned'</script>" not in text


@pytest.mark.skipif(shutil.which("chromium") is None, reason="no chromium here")
def test_no_script_of_the_input_runs_in_a_browser(evil: Path, tmp_path: Path) -> None:
    folder = evil / "deep" / "down" / "run"
    for path in (folder / "report.html", folder / "graph.svg"):
        browser = [
            "chromium",
            "--headless",
            "--no-sandbox",
            "--disable-gpu",
            f"--user-data-dir={tmp_path / 'profile'}",
            "--virtual-time-budget=2000",
        ]
        try:
            done = subprocess.run([*browser, "--dump-dom", path.as_uri()], capture_output=True, timeout=60, check=False)
        except subprocess.TimeoutExpired:
            pytest.skip("the browser does not start here")
        if done.returncode:
            pytest.skip("the browser does not start here")
        assert b"<title>pwned" not in done.stdout


# Where it is written


def small(folder: Path) -> Path:
    """A workspace of one node."""
    folder.mkdir()
    (folder / "talker.py").write_text(program(()))
    return folder


def test_links_within_the_output_folder_are_not_followed(tmp_path: Path) -> None:
    workspace, out, elsewhere = small(tmp_path / "ws"), tmp_path / "out", tmp_path / "elsewhere"
    out.mkdir()
    elsewhere.mkdir()
    (out / "policies").symlink_to(elsewhere)
    run = harmless(watched(["extract", str(workspace), "-o", str(out)], inputs=workspace, outputs=out))
    assert run.status == 2
    assert "symbolic link" in run.stderr or "cannot write" in run.stderr
    assert list(elsewhere.iterdir()) == []


def test_a_link_in_the_place_of_a_file_is_replaced(tmp_path: Path) -> None:
    workspace, out, victim = small(tmp_path / "ws"), tmp_path / "out", tmp_path / "victim"
    out.mkdir()
    victim.write_text("untouched")
    (out / "policy.xml").symlink_to(victim)
    harmless(watched(["extract", str(workspace), "-o", str(out)], inputs=workspace, outputs=out))
    assert victim.read_text() == "untouched"
    assert not (out / "policy.xml").is_symlink()


def test_an_output_folder_that_is_a_file_is_refused(tmp_path: Path) -> None:
    workspace, out = small(tmp_path / "ws"), tmp_path / "out"
    out.write_text("a file")
    for command in (["extract", str(workspace)], ["nodl", "ws/talker.py", str(workspace)]):
        run = harmless(watched([*command, "-o", str(out)], inputs=workspace, outputs=out))
        assert run.status == 2
    assert out.read_text() == "a file"


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() == 0, reason="root writes everywhere")
def test_an_output_folder_without_permission_is_refused(tmp_path: Path) -> None:
    workspace, out = small(tmp_path / "ws"), tmp_path / "out"
    out.mkdir(mode=0o500)
    assert harmless(watched(["extract", str(workspace), "-o", str(out)], inputs=workspace, outputs=out)).status == 2


def test_a_full_disk_leaves_the_old_file(tmp_path: Path) -> None:
    """No file may be longer than 3,000 bytes here, as on a disk with no more room."""
    workspace, out = small(tmp_path / "ws"), tmp_path / "out"
    out.mkdir()
    (out / "network.json").write_text("old")
    run = harmless(
        watched(["extract", str(workspace), "-o", str(out)], inputs=workspace, outputs=out, file_bytes=3_000)
    )
    assert run.status == 2
    assert (out / "network.json").read_text() == "old"
    assert [p.name for p in out.iterdir()] == ["network.json"]


@pytest.mark.parametrize("name", ["../x", "/etc/x", "a/../../x", "", "x\0y"])
def test_only_files_below_the_folder_are_written(tmp_path: Path, name: str) -> None:
    with pytest.raises(OSError, match="no file below"):
        write_text(str(tmp_path / "out"), name, "x")


# Whole or not at all

WRITER: Final = """\
import sys
from rosward.outputs.whole_files import write_text
number = int(sys.argv[2])
print('ready', flush=True)
while True:
    number += 1
    for name in ('a.xml', 'b/c.xml'):
        write_text(sys.argv[1], name, f'{number}\\n' * 20_000)
"""


def _whole(folder: Path) -> None:
    for name in ("a.xml", "b/c.xml"):
        lines = (folder / name).read_text().splitlines()
        assert len(lines) == 20_000
        assert len(set(lines)) == 1


def _writer(folder: Path, number: int) -> subprocess.Popen[bytes]:
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(p for p in sys.path if p)}
    return subprocess.Popen(
        [sys.executable, "-c", WRITER, str(folder), str(number)], stdout=subprocess.PIPE, env=environment
    )


def test_a_run_that_is_killed_leaves_whole_files(tmp_path: Path) -> None:
    """Two writers into one folder, killed at random moments: each file is whole, of one of them."""
    random = Random(3)
    for name in ("a.xml", "b/c.xml"):
        write_text(str(tmp_path), name, "0\n" * 20_000)
    kills = int(os.environ.get("ROSWARD_KILLS", "2"))
    for turn in range(kills):
        writers = [_writer(tmp_path, turn * 1_000_000), _writer(tmp_path, turn * 2_000_000)]
        for writer in writers:
            assert writer.stdout is not None
            writer.stdout.readline()
        time.sleep(random.random() * 0.05)
        _whole(tmp_path)
        for writer in writers:
            writer.send_signal(signal.SIGKILL)
            writer.wait()
            assert writer.stdout is not None
            writer.stdout.close()
        _whole(tmp_path)
        assert {p.suffix for p in tmp_path.rglob("*") if p.is_file() and not p.name.startswith(".rosward-")} == {".xml"}


def test_what_a_killed_run_left_is_taken_away_by_a_later_one(tmp_path: Path) -> None:
    old, new, own = tmp_path / ".rosward-old", tmp_path / ".rosward-new", tmp_path / "mine.txt"
    for path in (old, new, own):
        path.write_text("x")
    for path in (old, own):
        os.utime(path, (0, 0))
    write_text(str(tmp_path), "policy.xml", "text")
    assert {p.name for p in tmp_path.iterdir()} == {".rosward-new", "mine.txt", "policy.xml"}
