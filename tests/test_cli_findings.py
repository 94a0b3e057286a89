# SPDX-License-Identifier: Apache-2.0
"""Findings on the command line: what a comment, a code, a baseline and a configuration file do to output and exit status."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from rosward.cli import main

HEAD = """\
import sys
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

rclpy.init()
node = Node("talker")
"""
UNKNOWN = "node.create_publisher(String, input(), 10){comment}\n"  # RW101, an error
PARTLY = "node.create_publisher(String, 'a/' + input(), 10){comment}\n"  # RW102, a warning


@pytest.fixture(autouse=True)
def in_a_folder_of_its_own(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Each test runs in an empty folder, which is the root of a repository."""
    (tmp_path / ".git").mkdir()
    monkeypatch.chdir(tmp_path)


def program(*lines: str, file: str = "talker.py", comment: str = "") -> None:
    path = Path(file)
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(HEAD + "".join(line.format(comment=comment) for line in lines), encoding="utf-8")


def extract(*arguments: str) -> int:
    return main(["extract", "--format", "json", *arguments])


def codes(folder: str = "rosward-out") -> list[str]:
    document = json.loads((Path(folder) / "network.json").read_text(encoding="utf-8"))
    return [d["code"] for d in document["diagnostics"]]


# Comments


def test_a_comment_ignores_a_warning_and_it_is_counted(capsys: pytest.CaptureFixture[str]) -> None:
    program(PARTLY)
    assert extract() == 0
    assert "RW102" in codes()
    program(PARTLY, comment="  # rosward: ignore")
    assert extract() == 0
    assert codes() == []
    assert " ignored." in capsys.readouterr().out


def test_a_comment_does_not_make_an_incomplete_result_complete() -> None:
    program(UNKNOWN, comment="  # rosward: ignore[RW101]")
    assert extract() == 1
    assert codes() == ["RW101"]


def test_an_accepted_error_is_ignored_by_a_comment(capsys: pytest.CaptureFixture[str]) -> None:
    program(UNKNOWN, comment="  # rosward: ignore[RW101]")
    Path("rosward.toml").write_text('accepted = ["RW101"]\n', encoding="utf-8")
    assert extract() == 0
    assert codes() == []
    out = capsys.readouterr().out
    assert "Incomplete (known): 1 error accepted" in out
    assert "rosward.toml" in out


def test_acceptance_alone_ignores_nothing() -> None:
    program(UNKNOWN)
    Path("rosward.toml").write_text('accepted = ["RW101"]\n', encoding="utf-8")
    assert extract() == 1


@pytest.mark.parametrize(
    ("comment", "told"),
    [
        ("  # rosward: ignore", "no finding on this line"),
        ("  # rosward: ignore[RW103]", "no RW103"),
        ("  # rosward: ignore[RW999]", "no code RW999"),
        ("  # rosward: ignore[", "contain no code"),
    ],
)
def test_a_comment_without_a_finding_is_a_note(comment: str, told: str, capsys: pytest.CaptureFixture[str]) -> None:
    program("node.create_publisher(String, '/tf', 10){comment}\n", comment=comment)  # tools read it: no loose end
    assert extract("-v") == 0
    assert codes() == ["RW010"]
    assert told in capsys.readouterr().out


def test_with_a_node_alone_a_comment_without_a_finding_is_not_told() -> None:
    """Other programs of the sources may have the finding."""
    program("node.create_publisher(String, 'a', 10)  # rosward: ignore\n", file="demo/demo/talker.py")
    Path("demo/package.xml").write_text("<package format='3'><name>demo</name></package>", encoding="utf-8")
    Path("bringup.launch.xml").write_text("<launch/>", encoding="utf-8")
    extract("--launch", "bringup.launch.xml")
    assert "RW010" not in codes()


def test_a_comment_in_a_launch_file() -> None:
    include = '<include file="$(find-pkg-share elsewhere)/x.launch.py"/>'
    launch = "<launch>\n<!-- rosward: ignore[RW311] -->\n" + include + "\n</launch>"
    Path("a.launch.xml").write_text(launch, encoding="utf-8")
    Path("rosward.toml").write_text('accepted = ["RW311"]\n', encoding="utf-8")
    extract("--launch", "a.launch.xml")
    assert "RW311" not in codes()
    Path("a.launch.xml").write_text(launch.replace("RW311", "RW310"), encoding="utf-8")
    extract("--launch", "a.launch.xml")
    assert "RW311" in codes()


# Baseline


def test_what_is_in_the_baseline_does_not_count_even_when_lines_move(capsys: pytest.CaptureFixture[str]) -> None:
    program(UNKNOWN)
    assert extract("--write-baseline", "known.json") == 1
    capsys.readouterr()
    program("\n\nprint(1)\n", UNKNOWN)
    assert extract("--baseline", "known.json") == 0
    out = capsys.readouterr().out
    assert "Incomplete (known): 1 error in the baseline" in out
    assert "RW101" not in out
    assert codes() == ["RW101"]


def test_a_new_error_counts(capsys: pytest.CaptureFixture[str]) -> None:
    program(UNKNOWN)
    extract("--write-baseline", "known.json")
    capsys.readouterr()
    program(UNKNOWN, "node.create_subscription(String, input(), print, 10)\n")
    assert extract("--baseline", "known.json") == 1
    assert "Incomplete: 1 error," in capsys.readouterr().out


def of_version_1(message: str) -> str:
    """A baseline as it was written while fingerprints depended on the words of messages."""
    entry = {"fingerprint": "3f2a", "code": "RW101", "file": "talker.py", "message": message}
    return json.dumps({"version": 1, "findings": [entry]})


def test_a_baseline_of_version_1_is_read_by_what_its_messages_name(capsys: pytest.CaptureFixture[str]) -> None:
    program(UNKNOWN)
    extract("--write-baseline", "new.json")
    (entry,) = json.loads(Path("new.json").read_text())["findings"]
    assert "is unknown because of run-time input" in entry["message"]
    old = entry["message"].replace("is unknown", "is not known").replace("run-time input", "input when it runs")
    Path("known.json").write_text(of_version_1(old))
    assert extract("--baseline", "known.json") == 0
    Path("known.json").write_text(of_version_1(old.replace("publisher", "subscription")))
    assert extract("--baseline", "known.json") == 1
    capsys.readouterr()


def test_a_baseline_is_the_same_for_every_path_of_the_repository() -> None:
    program(UNKNOWN, file="src/demo/talker.py")
    assert extract("src", "--write-baseline", "known.json") == 1
    assert extract("--baseline", "known.json") == 0
    assert extract("src/demo/talker.py", "--baseline", "known.json") == 0


@pytest.mark.parametrize("text", ["", "{", "[]", '{"version": 9}', '{"version": 1, "findings": [1]}', "[" * 100_000])
def test_a_file_that_is_no_baseline_is_status_2(text: str, capsys: pytest.CaptureFixture[str]) -> None:
    program(UNKNOWN)
    Path("known.json").write_text(text, encoding="utf-8")
    assert extract("--baseline", "known.json") == 2
    assert "known.json" in capsys.readouterr().err


def test_a_baseline_that_is_not_there_is_status_2() -> None:
    program(UNKNOWN)
    assert extract("--baseline", "known.json") == 2


# Code scanning


def test_sarif_and_junit_are_written_with_paths_from_the_repository() -> None:
    program(UNKNOWN, file="src/demo/talker.py")
    assert main(["extract", "src", "--format", "sarif,junit", "--write-baseline", "known.json"]) == 1
    assert sorted(p.name for p in Path("rosward-out").iterdir()) == ["findings.junit.xml", "findings.sarif"]
    (run,) = json.loads(Path("rosward-out/findings.sarif").read_text(encoding="utf-8"))["runs"]
    (result,) = run["results"]
    assert result["locations"][0]["physicalLocation"]["artifactLocation"]["uri"] == "src/demo/talker.py"
    assert result["locations"][0]["physicalLocation"]["region"]["startLine"] == 8
    assert "baselineState" not in result
    main(["extract", "src", "--format", "sarif", "--baseline", "known.json"])
    (run,) = json.loads(Path("rosward-out/findings.sarif").read_text(encoding="utf-8"))["runs"]
    assert run["results"][0]["baselineState"] == "unchanged"


# Configuration


def test_options_come_from_the_nearest_file_above_the_path() -> None:
    program(PARTLY, file="ws/src/talker.py")
    Path("pyproject.toml").write_text('[tool.rosward]\nignore = ["RW205"]\noutput = "far"\n', encoding="utf-8")
    Path("ws/pyproject.toml").write_text("[project]\nname = 'no-rosward-here'\n", encoding="utf-8")
    assert main(["extract", "ws/src", "--format", "json"]) == 0
    assert Path("far/network.json").exists()
    Path("ws/rosward.toml").write_text('output = "near"\nformat = ["json", "sarif"]\n', encoding="utf-8")
    assert main(["extract", "ws/src"]) == 0
    assert sorted(p.name for p in Path("ws/near").iterdir()) == ["findings.sarif", "network.json"]


def test_the_command_line_replaces_what_the_file_says() -> None:
    program(PARTLY)
    Path("rosward.toml").write_text('distro = "humble"\nformat = "dot"\noutput = "a"\n', encoding="utf-8")
    assert main(["extract", "--distro", "kilted", "--format", "json", "-o", "b"]) == 0
    assert json.loads(Path("b/network.json").read_text(encoding="utf-8"))["distro"] == "kilted"
    assert not Path("a").exists()


def test_without_the_file_the_defaults_hold() -> None:
    program(PARTLY)
    Path("rosward.toml").write_text('distro = "humble"\n', encoding="utf-8")
    assert extract("--no-config") == 0
    assert json.loads(Path("rosward-out/network.json").read_text(encoding="utf-8"))["distro"] == "jazzy"


def test_launch_files_and_arguments_of_the_file() -> None:
    """Paths are relative to the file, wherever the command is run."""
    Path("ws").mkdir()
    launch = '<launch><arg name="n"/><node pkg="a" exec="b" name="$(var n)"/></launch>'
    Path("ws/a.launch.xml").write_text(launch, encoding="utf-8")
    Path("ws/rosward.toml").write_text('launch = ["a.launch.xml"]\narg = ["n:=camera"]\n', encoding="utf-8")
    assert extract("ws", "-o", "out") == 1
    document = json.loads(Path("out/network.json").read_text(encoding="utf-8"))
    assert [n["fqn"] for n in document["nodes"]] == ["/camera"]


def test_a_code_of_the_file_is_ignored_but_an_error_only_if_accepted() -> None:
    program(PARTLY, UNKNOWN)
    Path("rosward.toml").write_text('ignore = ["RW102", "RW302", "RW101"]\n', encoding="utf-8")
    assert extract() == 1
    assert codes() == ["RW101"]
    Path("rosward.toml").write_text('ignore = ["RW102", "RW302", "RW101"]\naccepted = ["RW101"]\n', encoding="utf-8")
    assert extract() == 0
    assert codes() == []


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ('colour = "red"', "no option 'colour'"),
        ('distro = "foxy"', "distro must be one of humble"),
        ('tests = "yes"', "tests must be true or false"),
        ('models = "m"', "models must be a list"),
        ('models = ["nowhere"]', "no such folder"),
        ('ignore = ["RW999"]', "unknown: RW999"),
        ('format = "pdf"', "choose from"),
        ('output = "../elsewhere"', "below the folder of the file"),
        ('output = "/tmp/elsewhere"', "below the folder of the file"),
        ('output = "link/out"', "below the folder of the file"),
        ("distro = ", "not valid TOML"),
        ("a = " + "[" * 20_000, "not valid TOML"),
    ],
)
def test_a_wrong_configuration_is_status_2(text: str, told: str, capsys: pytest.CaptureFixture[str]) -> None:
    program(PARTLY, file="ws/talker.py")
    Path("ws/link").symlink_to("/tmp")
    Path("ws/rosward.toml").write_text(text, encoding="utf-8")
    assert main(["extract", "ws"]) == 2
    assert told in capsys.readouterr().err


def test_a_pyproject_that_says_nothing_of_rosward_may_be_broken() -> None:
    program(PARTLY)
    Path("pyproject.toml").write_text("[[[", encoding="utf-8")
    assert extract() == 0


@pytest.mark.parametrize(("severity", "status"), [("error", 0), ("warning", 1), ("note", 1)])
def test_what_makes_a_run_fail_can_be_chosen(severity: str, status: int) -> None:
    program(PARTLY)  # a warning
    assert extract("--fail-on", severity) == status
    assert extract("--fail-on", severity, "--write-baseline", "known.json") == status
    assert extract("--fail-on", severity, "--baseline", "known.json") == 0


def test_annotations_for_github(capsys: pytest.CaptureFixture[str]) -> None:
    """One workflow command for each new finding, errors first, after the summary."""
    program(PARTLY, UNKNOWN, file="src/a,b.py")
    assert main(["extract", "src", "-q", "--format", "github"]) == 1
    lines = capsys.readouterr().out.splitlines()
    assert lines[0].startswith("::error file=src/a%2Cb.py,line=9,col=1,title=RW101 unknown name::")
    assert lines[1].startswith("::warning file=src/a%2Cb.py,line=8,col=1,title=RW")
    assert all(line.startswith("::") for line in lines)
