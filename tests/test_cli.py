# SPDX-License-Identifier: Apache-2.0
"""The command line: what it writes where, what it prints, and its exit status."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from rosward._version import __version__
from rosward.cli import main

TALKER = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

rclpy.init()
node = Node("talker")
node.create_publisher(String, {name}, 10)
rclpy.spin(node)
"""
DEFAULT = [
    "enclaves.txt",
    "graph.dot",
    "graph.svg",
    "network.json",
    "policies/talker/policy.xml",
    "policy.xml",
    "report.html",
]


@pytest.fixture(autouse=True)
def in_a_folder_of_its_own(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Each test runs in an empty folder."""
    monkeypatch.chdir(tmp_path)


def program(name: str = '"chatter"', file: str = "talker.py") -> Path:
    path = Path(file)
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(TALKER.format(name=name), encoding="utf-8")
    return path


def files(folder: str = "rosward-out") -> list[str]:
    return sorted(str(p.relative_to(folder)) for p in Path(folder).rglob("*") if p.is_file())


def wrong(*arguments: str) -> None:
    """The parser refuses these arguments with exit status 2."""
    with pytest.raises(SystemExit) as exit_:
        main(list(arguments))
    assert exit_.value.code == 2


def test_a_complete_result_is_status_0_and_the_default_files(capsys: pytest.CaptureFixture[str]) -> None:
    program()
    assert main(["extract"]) == 0
    assert files() == DEFAULT
    out, err = capsys.readouterr()
    assert out.startswith("rosward read 1 file (8 lines) for jazzy: 1 node in 1 process.\n")
    assert "Complete: no errors" in out
    assert str(Path("rosward-out") / "report.html") in out
    assert err == ""


def test_an_unknown_name_is_status_1_and_all_files_are_written(capsys: pytest.CaptureFixture[str]) -> None:
    program("input()")
    assert main(["extract", "talker.py"]) == 1
    assert files() == DEFAULT
    out = capsys.readouterr().out
    assert "error RW101" in out
    assert "talker.py:7" in out


def test_a_file_that_does_not_parse_is_status_1_and_the_rest_is_there() -> None:
    program()
    Path("broken.py").write_text("import rclpy\ndef (\n", encoding="utf-8")
    assert main(["extract", "-q"]) == 1
    assert "/chatter" in Path("rosward-out/policy.xml").read_text(encoding="utf-8")


def test_an_unknown_name_gets_a_rule_only_when_asked_for() -> None:
    program("input()")
    for unknown, rule in (("deny", False), ("wildcard", True)):
        assert main(["extract", "-q", "--unknown", unknown]) == 1
        assert ("<topic>/*</topic>" in Path("rosward-out/policy.xml").read_text(encoding="utf-8")) is rule


@pytest.mark.parametrize(
    ("formats", "expected"),
    [
        ("json", ["network.json"]),
        ("svg,dot", ["graph.dot", "graph.svg"]),
        ("mermaid", ["graph.md", "graph.mmd"]),
        (" html , json,html", ["network.json", "report.html"]),
        ("policy", ["enclaves.txt", "policies/talker/policy.xml", "policy.xml"]),
        ("permissions", ["permissions/talker/permissions.xml"]),
    ],
)
def test_format_chooses_the_files(formats: str, expected: list[str]) -> None:
    program()
    assert main(["extract", "-q", "--format", formats]) == 0
    assert files() == expected


def test_output_goes_where_it_is_told_and_the_folder_is_made() -> None:
    program()
    assert main(["extract", "-q", "-o", "a/b", "--format", "json"]) == 0
    assert files("a/b") == ["network.json"]
    assert not Path("rosward-out").exists()


def test_a_second_run_gives_the_same_bytes() -> None:
    program()
    texts = []
    for _ in range(2):
        assert main(["extract", "-q", "--format", "json,policy,svg,dot,html,mermaid,permissions"]) == 0
        texts.append({f: (Path("rosward-out") / f).read_bytes() for f in files()})
    assert texts[0] == texts[1]


def test_quiet_prints_nothing(capsys: pytest.CaptureFixture[str]) -> None:
    program("input()")
    assert main(["extract", "-q"]) == 1
    assert capsys.readouterr() == ("", "")


def test_verbose_prints_every_doubt(capsys: pytest.CaptureFixture[str]) -> None:
    path = program()
    late = "".join(f"node.create_publisher(String, input(), {n})\n" for n in range(1, 10))
    path.write_text(path.read_text(encoding="utf-8").replace("rclpy.spin", late + "rclpy.spin"), encoding="utf-8")
    assert main(["extract"]) == 1
    short = capsys.readouterr().out
    assert main(["extract", "-v"]) == 1
    long = capsys.readouterr().out
    assert "use -v to list all" in short
    assert "use -v to list all" not in long
    assert "talker.py:15" in long


def test_paths_may_be_several_files_and_folders() -> None:
    program(file="a/one.py")
    program('"other"', file="b/two.py")
    program('"third"', file="c/three.py")
    assert main(["extract", "-q", "a/one.py", "b"]) == 0
    policy = Path("rosward-out/policy.xml").read_text(encoding="utf-8")
    assert "/chatter" in policy
    assert "/other" in policy
    assert "/third" not in policy


def test_tests_are_read_only_when_asked_for() -> None:
    program()
    program('"in_a_test"', file="test/test_talker.py")
    for option, found in (([], False), (["--tests"], True)):
        assert main(["extract", "-q", *option]) in (0, 1)
        assert ("/in_a_test" in Path("rosward-out/network.json").read_text(encoding="utf-8")) is found


def test_distro_decides_what_the_client_library_adds() -> None:
    program()
    for distro, found in (("humble", False), ("jazzy", True)):
        assert main(["extract", "-q", "--distro", distro]) == 0
        assert ("get_type_description" in Path("rosward-out/policy.xml").read_text(encoding="utf-8")) is found


def test_models_describe_a_library() -> None:
    Path("talker.py").write_text(
        "import rclpy\nfrom acme import Radio\nfrom rclpy.node import Node\n\n"
        'rclpy.init()\nnode = Node("talker")\nRadio(node)\nrclpy.spin(node)\n',
        encoding="utf-8",
    )
    Path("models").mkdir()
    Path("models/acme.pyi").write_text(
        "from rclpy.node import Node\nfrom std_msgs.msg import String\n\n\nclass Radio:\n"
        "    def __init__(self, node: Node) -> None:\n        node.create_publisher(String, 'radio', 10)\n",
        encoding="utf-8",
    )
    for option, found in (([], False), (["--models", "models"], True)):
        # without the model, a node is in hands that nobody knows
        assert main(["extract", "-q", *option]) == (0 if found else 1)
        assert ("/radio" in Path("rosward-out/policy.xml").read_text(encoding="utf-8")) is found


def test_a_path_that_is_not_there_is_status_2(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["extract", "nowhere", "talker.py"]) == 2
    out, err = capsys.readouterr()
    assert (out, err) == ("", "rosward: no such file or folder: nowhere, talker.py\n")
    assert not Path("rosward-out").exists()


def test_a_models_folder_that_is_not_there_is_status_2(capsys: pytest.CaptureFixture[str]) -> None:
    program()
    assert main(["extract", "--models", "nowhere"]) == 2
    assert capsys.readouterr().err == "rosward: --models: no such folder: nowhere\n"


def test_a_folder_without_python_is_status_2(capsys: pytest.CaptureFixture[str]) -> None:
    Path("notes.txt").write_text("nothing to see", encoding="utf-8")
    assert main(["extract"]) == 2
    assert "nothing to read" in capsys.readouterr().err
    assert not Path("rosward-out").exists()


def test_python_without_ros_is_no_error_and_says_so(capsys: pytest.CaptureFixture[str]) -> None:
    Path("plain.py").write_text("print(1)\n", encoding="utf-8")
    assert main(["extract", "-v"]) == 0
    assert "RW007" in capsys.readouterr().out
    assert files() == ["graph.dot", "graph.svg", "network.json", "report.html"]


@pytest.mark.skipif(os.geteuid() == 0, reason="root may write anywhere")
def test_a_folder_that_may_not_be_written_is_status_2(capsys: pytest.CaptureFixture[str]) -> None:
    program()
    Path("locked").mkdir(mode=0o500)
    assert main(["extract", "-o", "locked/out"]) == 2
    assert capsys.readouterr().err == "rosward: cannot write to locked/out: Permission denied\n"


def test_a_file_in_the_way_of_the_output_is_status_2(capsys: pytest.CaptureFixture[str]) -> None:
    program()
    Path("taken").write_text("", encoding="utf-8")
    assert main(["extract", "-o", "taken"]) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert err.startswith("rosward: cannot write to taken: ")
    assert Path("taken").read_text(encoding="utf-8") == ""


@pytest.mark.parametrize(
    "arguments",
    [
        (),
        ("report",),
        ("extract", "--format", "pdf"),
        ("extract", "--format", ","),
        ("extract", "--distro", "foxy"),
        ("extract", "--unknown", "maybe"),
        ("extract", "-q", "-v"),
        ("extract", "--no-such-option"),
    ],
)
def test_wrong_use_is_status_2(arguments: tuple[str, ...], capsys: pytest.CaptureFixture[str]) -> None:
    wrong(*arguments)
    assert "--help` for usage" in capsys.readouterr().err


@pytest.mark.parametrize(
    "arguments",
    [
        ("extract", "--quiet", "--format", "none", "talker.py"),
        ("extract", "talker.py", "--quiet", "--format", "none"),
        ("explain", "/chatter", "talker.py", "--distro", "humble"),
        ("explain", "/chatter", "--distro", "humble", "talker.py"),
        ("explain", "/chatter", "--distro", "humble", "--", "talker.py"),
        ("list", "topics", "--system", "talker.py"),
    ],
)
def test_a_path_may_stand_before_and_behind_options(arguments: tuple[str, ...]) -> None:
    program()
    Path("another.py").write_text("not Python", encoding="utf-8")  # read, it would be a finding
    assert main(list(arguments)) == 0


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        (("extract", "--unkown=deny"), "unrecognized arguments: --unkown=deny; did you mean --unknown?"),
        (("snapshot", "here"), "unrecognized arguments: here"),
        (("explain",), "the following arguments are required: NAME\n"),
    ],
)
def test_wrong_use_says_what_is_wrong_and_no_more(
    arguments: tuple[str, ...], says: str, capsys: pytest.CaptureFixture[str]
) -> None:
    wrong(*arguments)
    said = capsys.readouterr().err
    assert says in said
    assert len(said.splitlines()) == 2


def test_an_argument_as_ros2_launch_takes_it_is_told_how_it_is_given_here(capsys: pytest.CaptureFixture[str]) -> None:
    program()
    assert main(["extract", ".", "side:=left"]) == 2
    assert "--arg side:=left" in capsys.readouterr().err


def test_help_and_version_are_status_0(capsys: pytest.CaptureFixture[str]) -> None:
    for option in ("--version", "--help"):
        with pytest.raises(SystemExit) as exit_:
            main([option])
        assert exit_.value.code == 0
    assert capsys.readouterr().out.startswith(f"rosward {__version__}\n")


def test_a_reader_that_goes_away_is_no_traceback() -> None:
    program()
    command = f'"{sys.executable}" -m rosward extract | true'
    done = subprocess.run(command, shell=True, capture_output=True, text=True, check=False)
    assert "Traceback" not in done.stderr
    assert "BrokenPipe" not in done.stderr


def test_python_dash_m_is_the_same_command() -> None:
    program("input()")
    done = subprocess.run([sys.executable, "-m", "rosward", "extract"], capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (1, "")
    assert "RW101" in done.stdout
