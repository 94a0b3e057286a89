# SPDX-License-Identifier: Apache-2.0
"""What rosward itself fails on costs that piece of input and nothing else, and is told: RW299, exit status 3.

There is no input that is known to make it fail, so the tests break it in one place: where `divmod` is called, or in one reader or writer.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any
from xml.etree import ElementTree as ET

import pytest

import rosward
from rosward.analysis.launched import launched
from rosward.cli import main
from rosward.deployment.declared import declarations
from rosward.deployment.execution import includes
from rosward.deployment.request import Request
from rosward.engine.budget import Budget
from rosward.engine.python import native_calls
from rosward.frontends.registry import PYTHON
from rosward.models.native import perform as real_perform
from rosward.outputs.formats import FORMATS
from rosward.outputs.report.packed import document_in
from rosward.pipeline import Result
from rosward.rules import RULES, Severity
from rosward.source import packages

NODE = """\
import rclpy
from std_msgs.msg import String
rclpy.init()
node = rclpy.create_node('{name}')
node.create_publisher(String, 'before_{name}', 10)
{line}
node.create_publisher(String, 'after_{name}', 10)
rclpy.spin(node)
"""
PACKAGE = """\
<package format="3"><name>demo</name><version>1.0.0</version><description>D</description>
<maintainer email="a@b.cd">A</maintainer><license>Apache-2.0</license><export><build_type>ament_cmake</build_type></export></package>
"""
CMAKE = "project(demo)\ninstall(PROGRAMS bad.py good.py DESTINATION lib/demo)\n"


@pytest.fixture
def workspace(tmp_path: Path) -> Path:
    root = tmp_path / "ws"
    root.mkdir()
    (root / "bad.py").write_text(NODE.format(name="bad", line="divmod(7, 2)"))
    (root / "good.py").write_text(NODE.format(name="good", line=""))
    (root / "package.xml").write_text(PACKAGE)
    (root / "CMakeLists.txt").write_text(CMAKE)
    return root


@pytest.fixture(params=[RecursionError, MemoryError, KeyError, AssertionError])
def broken(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> type[Exception]:
    """Whoever calls `divmod` makes rosward fail."""
    error: type[Exception] = request.param

    def failing(native: Any, call: Any) -> Any:
        if call.name == "builtins.divmod":
            raise error("/home/somebody/secret")
        return real_perform(native, call)

    monkeypatch.setattr(native_calls, "perform", failing)
    return error


def names(result: Result) -> set[str]:
    return {e.name for n in result.network.nodes for e in n.entities if not e.system}


def internal(result: Result) -> list[tuple[str, int]]:
    return [(f.place.file, f.place.line) for f in result.findings if f.code == "RW299"]


def test_a_program_costs_no_other(workspace: Path, broken: type[Exception]) -> None:
    result = rosward.extract(workspace)
    assert names(result) == {"/before_bad", "/before_good", "/after_good"}
    assert internal(result) == [("bad.py", 6)]
    assert not result.complete
    message = next(f.message for f in result.findings if f.code == "RW299")
    assert broken.__name__ in message
    assert "rosward/models/" in message or "rosward/engine/python/native_calls.py:" in message
    assert "somebody" not in message
    assert str(workspace) not in message
    assert "report" in message


def test_the_net_can_be_taken_away(workspace: Path, broken: type[Exception]) -> None:
    with pytest.raises(broken):
        rosward.extract(workspace, budget=Budget(net=False))


@pytest.mark.usefixtures("broken")
def test_a_callback_costs_the_callbacks(workspace: Path) -> None:
    line = "node.create_timer(1.0, lambda: (node.create_publisher(String, 'first', 10), divmod(1, 2)))"
    (workspace / "bad.py").write_text(NODE.format(name="bad", line=line))
    result = rosward.extract(workspace)
    assert {"/before_bad", "/after_bad", "/first", "/after_good"} <= names(result)
    assert set(internal(result)) == {("bad.py", 6)}


@pytest.mark.usefixtures("broken")
def test_what_is_launched_costs_no_other(workspace: Path) -> None:
    (workspace / "all.launch.py").write_text(
        "from launch import LaunchDescription\nfrom launch.actions import OpaqueFunction\nfrom launch_ros.actions import Node\n"
        "def broken(context):\n    return [divmod(1, 2)]\n"
        "def generate_launch_description():\n    return LaunchDescription([Node(package='demo', executable='bad.py'),\n"
        "        OpaqueFunction(function=broken), Node(package='demo', executable='good.py')])\n"
    )
    (workspace / "broken.launch.py").write_text("divmod(1, 2)\ndef generate_launch_description(): return []\n")
    (workspace / "more.launch.xml").write_text(
        '<launch><include file="$(dirname)/broken.launch.py"/><node pkg="demo" exec="good.py"/></launch>'
    )
    result = rosward.extract(workspace, request=Request(all_launch=True))
    assert {"/before_bad", "/after_good"} <= names(result)
    assert "/after_bad" not in names(result)
    assert {f for f, _ in internal(result)} == {"bad.py", "all.launch.py", "broken.launch.py"}
    systems, findings = launched(workspace, request=Request(all_launch=True))
    assert sum(len(s.entries) for s in systems) == 3
    assert any(f.code == "RW299" for f in findings)


def failing(*_: object, **__: object) -> Any:
    raise RuntimeError("no")


@pytest.mark.parametrize(
    ("module", "name", "lost"),
    [(packages, "describe", ""), (includes, "read_xml", "more.launch.xml"), (declarations, "read_package", "")],
)
def test_a_reader_costs_what_it_reads(
    workspace: Path, monkeypatch: pytest.MonkeyPatch, module: Any, name: str, lost: str
) -> None:
    (workspace / "more.launch.xml").write_text(
        '<launch><node pkg="demo" exec="good.py"/><node pkg="joy" exec="joy_node"/></launch>'
    )
    monkeypatch.setattr(module, name, failing)
    result = rosward.extract(workspace, request=Request(all_launch=True))
    assert internal(result)
    assert lost in {file for file, _ in internal(result)} or not lost
    assert names(rosward.extract(workspace)) == {"/before_bad", "/after_bad", "/before_good", "/after_good"}


def test_a_source_file_costs_no_other(workspace: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    failing_one = PYTHON._replace(lower=lambda t, f, *o: failing() if f == "bad.py" else PYTHON.lower(t, f, *o))
    monkeypatch.setattr("rosward.analysis.source_tree.front_end_of", lambda *_: failing_one)
    result = rosward.extract(workspace)
    assert names(result) == {"/before_good", "/after_good"}
    assert internal(result) == [("bad.py", 0)]


COMMANDS = (
    ("extract", "-o", "{out}"),
    ("explain", "/before_good"),
    ("list", "topics"),
    ("check", "{policy}"),
    ("enclaves", "suggest"),
)


@pytest.mark.parametrize("command", COMMANDS, ids=lambda c: c[0])
def test_the_exit_status_of_a_fault_is_3(
    command: tuple[str, ...],
    workspace: Path,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    good = ["extract", str(workspace), "-o", str(tmp_path / "good"), "-q", "--format", "policy,json"]
    assert main(good) == 0

    monkeypatch.setattr(
        native_calls, "perform", lambda n, c: failing() if c.name == "builtins.divmod" else real_perform(n, c)
    )
    baseline = str(tmp_path / "baseline.json")
    assert main([*good, "--write-baseline", baseline]) == 3
    assert main([*good, "--baseline", baseline]) == 3
    places = {"out": str(tmp_path / "out"), "policy": str(tmp_path / "good" / "policy.xml")}
    first, *rest = [word.format(**places) for word in command]
    capsys.readouterr()
    assert main([first, *rest, str(workspace)]) == 3
    told = capsys.readouterr()
    assert "RW299" in told.err
    assert "report" in told.err


@pytest.mark.parametrize(
    "step",
    [
        "rosward.analysis.read.make_plan",
        "rosward.pipeline.with_enclaves",
        "rosward.pipeline.size_findings",
        "rosward.pipeline.connect",
        "rosward.network.checks._wildcards",
        "rosward.network.loose_ends.loose_ends",
        "rosward.enclaves.compact.compact",
    ],
)
def test_a_step_on_the_way_of_everything_costs_what_it_gives(
    step: str,
    workspace: Path,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.setattr(step, failing)
    out = tmp_path / "out"
    wanted = ["--format", "json,policy,permissions,dot,mermaid,svg,html,sarif,junit", "--compact"]
    assert main(["extract", str(workspace), "-o", str(out), *wanted]) == 3
    text = (out / "network.json").read_text()
    document = json.loads(text)
    assert {"bad", "good"} == {n["name"] for n in document["nodes"]}
    assert all(f'"/{name}"' in text for name in ("before_bad", "after_bad", "before_good", "after_good"))
    assert text.count('"RW299"') == 1
    assert "rosward failed here (RuntimeError in rosward/" in text
    assert "RW299" in capsys.readouterr().err
    assert len(ET.parse(out / "policy.xml").getroot().findall(".//enclave")) == 2
    for file in ("graph.dot", "graph.mmd", "graph.svg", "report.html", "findings.sarif", "findings.junit.xml"):
        assert (out / file).is_file()
    assert "RW299" in (out / "findings.sarif").read_text()


def test_without_the_net_a_step_raises(workspace: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("rosward.network.checks._wildcards", failing)
    with pytest.raises(RuntimeError):
        rosward.extract(workspace, budget=Budget(net=False))


WRITTEN = {each.name: each for each in FORMATS if each.files}


@pytest.mark.parametrize("broken_format", WRITTEN)
def test_a_format_costs_no_other(
    broken_format: str,
    workspace: Path,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    one = WRITTEN[broken_format]
    monkeypatch.setattr(f"rosward.outputs.{one.writer}.{'text' if one.needs == 'findings' else 'files'}", failing)
    out = tmp_path / "out"
    assert main(["extract", str(workspace), "-o", str(out), "--format", ",".join(WRITTEN)]) == 3
    files = {name: each.files[0].partition("/")[0] for name, each in WRITTEN.items()}
    there = {p.name for p in out.iterdir()}
    assert files[broken_format] not in there
    assert there >= {file for one, file in files.items() if one != broken_format}
    message = f"the format {broken_format} was not written"
    told = capsys.readouterr()
    assert message in told.err
    assert message in " ".join(told.out.split())
    telling = {name for name, each in WRITTEN.items() if each.tells} - {broken_format}
    assert len(telling) > 2
    for name in telling:
        text = (out / files[name]).read_text()
        assert message in (document_in(text) if name == "html" else text), name


@pytest.mark.parametrize(
    "step", ["rosward.outputs.documents.github.github_commands", "rosward.outputs.terminal.summary.summary"]
)
def test_what_is_printed_costs_nothing_that_is_written(
    step: str, workspace: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(step, failing)
    out = tmp_path / "out"
    assert main(["extract", str(workspace), "-o", str(out), "--format", "json,github"]) == 3
    assert (out / "network.json").is_file()
    assert "RW299" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("step", "kept"),
    [
        ("rosward.analysis.systems.entry", "all.launch.xml"),
        ("rosward.outputs.terminal.launch_tree._entry", "RW299"),
        ("rosward.analysis.read.make_plan", "good.py"),
    ],
)
def test_the_launch_tree_shows_the_rest(
    step: str, kept: str, workspace: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    (workspace / "all.launch.xml").write_text('<launch><node pkg="demo" exec="good.py"/></launch>')
    monkeypatch.setattr(step, failing)
    assert main(["launch-tree", str(workspace)]) == 3
    printed = capsys.readouterr()
    assert "RW299" in printed.out
    assert kept in printed.out
    assert printed.err.count("\n") == 1


@pytest.mark.parametrize(
    ("step", "kept"),
    [
        ("rosward.diff.compare._beyond", "nodes gained: 1"),
        ("rosward.diff.compare._change", "permissions gained: 11"),
        ("rosward.diff.of_nodes.snapshot_of", "nothing was compared"),
        ("rosward.pipeline.connect", "nodes gained: 1"),
        ("rosward.outputs.terminal.diff_text._line", "the differences were not written"),
    ],
)
def test_a_comparison_tells_the_rest(
    step: str,
    kept: str,
    workspace: Path,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    new = tmp_path / "new"
    new.mkdir()
    (new / "bad.py").write_text(NODE.format(name="bad", line=""))
    (new / "more.py").write_text(NODE.format(name="more", line=""))
    (workspace / "good.py").unlink()
    monkeypatch.setattr(step, failing)
    assert main(["diff", str(workspace), str(new)]) == 3
    printed = capsys.readouterr()
    assert "RW299" in printed.err
    assert kept in printed.out


def test_any_other_fault_is_told_in_one_line(
    workspace: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("rosward.explanation.listing.rows_of", failing)
    assert main(["list", "nodes", str(workspace)]) == 3
    told = capsys.readouterr().err
    assert told.startswith("rosward: internal error (RuntimeError in rosward/cli/listing.py:")
    assert told.count("\n") == 1


def test_the_rule_is_an_error() -> None:
    assert RULES["RW299"].severity is Severity.ERROR
