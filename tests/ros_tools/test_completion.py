# SPDX-License-Identifier: Apache-2.0
"""What the shell offers when somebody presses Tab: the protocol of argcomplete, spoken to a process as bash speaks it."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Final

import pytest

from rosward.cli import main
from rosward.ros.distro import DISTROS

pytest.importorskip("argcomplete")

EXAMPLES: Final = Path(__file__).parent.parent.parent / "examples"


def offered(line: str, folder: Path) -> list[str]:
    """What stands below the cursor, which is at the end of the line."""
    answer = folder / "offered.txt"
    environment = {
        **os.environ,
        "_ARGCOMPLETE": "1",
        "_ARGCOMPLETE_IFS": "\n",
        "_ARGCOMPLETE_SUPPRESS_SPACE": "1",
        "_ARGCOMPLETE_STDOUT_FILENAME": str(answer),
        "COMP_LINE": line,
        "COMP_POINT": str(len(line.encode())),
        "COMP_TYPE": "9",
    }
    command = [sys.executable, "-c", "import sys; from rosward.cli import main; sys.exit(main())"]
    done = subprocess.run(command, env=environment, cwd=folder, capture_output=True, text=True, check=False, timeout=60)
    assert done.stderr == ""
    assert done.returncode == 0
    return answer.read_text(encoding="utf-8").split("\n")


@pytest.fixture
def workspace(tmp_path: Path) -> Path:
    """An example beside its result."""
    shutil.copytree(EXAMPLES, tmp_path / "src")
    (tmp_path / "groups.toml").touch()
    return tmp_path


@pytest.mark.parametrize(
    ("line", "expected"),
    [
        ("rosward ext", ["extract"]),
        ("rosward extract --all", ["--all-launch"]),
        ("rosward extract --distro ", list(DISTROS)),
        ("rosward extract --launch delivery_bringup:f", ["delivery_bringup:fleet.launch.py"]),
        ("rosward extract src --launch delivery_bringup:b", ["delivery_bringup:building.launch.xml"]),
        ("rosward extract --node delivery_base/b", ["delivery_base/base_driver", "delivery_base/battery_monitor"]),
        ("rosward extract --format json,h", ["json,html"]),
        ("rosward extract --format json,js", [""]),
        ("rosward extract --arg ", [""]),
        ("rosward extract --enclaves ", ["node", "process", "launch", "src/", "groups.toml"]),
        ("rosward nodl delivery_fleet/m", ["delivery_fleet/monitor"]),
        ("rosward explain RW40", ["RW401", "RW402", "RW403", "RW404", "RW405"]),
    ],
)
def test_what_is_offered(line: str, expected: list[str], workspace: Path) -> None:
    assert offered(line, workspace) == expected


def test_names_of_the_last_result_are_offered_to_explain(workspace: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(workspace)
    assert main(["extract", "-q", "--format", "json"]) == 0
    assert offered("rosward explain /building/doors/o", workspace) == ["/building/doors/open"]
    Path("rosward-out/network.json").write_text('{"nodes": [1, {"fqn": []}], "topics": {}}', encoding="utf-8")
    assert offered("rosward explain /b", workspace) == [""]


def test_names_of_the_last_result_are_offered_to_flow(workspace: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Nothing is analysed: without a result there are the kinds alone."""
    monkeypatch.chdir(workspace)
    assert offered("rosward flow --to net", workspace) == ["network"]
    assert offered("rosward flow --to par", workspace) == ["parameter:"]
    assert offered("rosward flow --from /p", workspace) == [""]
    assert main(["extract", "-q", "--format", "json"]) == 0
    assert offered("rosward flow --from /building/doors/o", workspace) == ["/building/doors/open"]
    assert offered("rosward flow --from /x --to /porter/cmd", workspace) == ["/porter/cmd_vel"]
    assert offered("rosward flow --to node:/fleet/m", workspace) == ["node:/fleet/monitor"]
    assert offered("rosward flow --to request:/building/doors/o", workspace) == ["request:/building/doors/open"]
    assert offered("rosward flow --to parameter:diagnostic_updater.p", workspace) == [
        "parameter:diagnostic_updater.period"
    ]
    assert offered("rosward flow --to topic:/building/doors/o", workspace) == [""]


def test_names_of_the_last_flows_are_offered(tmp_path: Path) -> None:
    (tmp_path / "rosward-out").mkdir()
    flows = tmp_path / "rosward-out" / "flow.json"
    sink = '{"sink": "topic:/out", "data": ["topic:/in", "parameter:gain", "file:/etc/x"], "control": [], "trigger": ["timer"]}'
    flows.write_text(f'{{"nodes": [{{"node": "/a", "sinks": [{sink}]}}]}}', encoding="utf-8")
    assert offered("rosward flow --to /", tmp_path) == ["/in", "/out"]
    assert offered("rosward flow --to file:", tmp_path) == ["file:/etc/x"]
    assert offered("rosward flow --from parameter:", tmp_path) == ["parameter:gain"]
    for broken in (
        "",
        "[",
        "[1]",
        '{"nodes": [{"sinks": [{"sink": 1, "data": "x", "control": [2, null]}, 3]}, 4]}',
        "[" * 9999,
    ):
        flows.write_text(broken, encoding="utf-8")
        assert offered("rosward flow --to /", tmp_path) == [""]


def test_two_launch_files_of_one_name_are_told_apart(tmp_path: Path) -> None:
    (tmp_path / "package.xml").write_text("<package><name>demo</name></package>", encoding="utf-8")
    for folder in ("launch/sim", "launch/real"):
        (tmp_path / folder).mkdir(parents=True)
        (tmp_path / folder / "robot.launch.xml").write_text("<launch/>", encoding="utf-8")
    expected = ["demo:launch/real/robot.launch.xml", "demo:launch/sim/robot.launch.xml"]
    assert offered("rosward extract --launch demo:", tmp_path) == expected


@pytest.mark.parametrize(
    ("shell", "said"), [("bash", "complete -o"), ("zsh", "#compdef rosward"), ("fish", "complete --command rosward")]
)
def test_each_shell_is_told_how_to_ask(shell: str, said: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["completion", shell]) == 0
    assert said in capsys.readouterr().out


@pytest.mark.skipif(shutil.which("bash") is None, reason="there is no bash")
def test_bash_completes_with_what_is_printed(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The script, a line that is typed, and what bash makes of it; `rosward` is this one."""
    assert main(["completion", "bash"]) == 0
    program = tmp_path / "rosward"
    program.write_text(
        f"#!{sys.executable}\n# PYTHON_ARGCOMPLETE_OK\nfrom rosward.cli import main\nmain()\n", encoding="utf-8"
    )
    program.chmod(0o755)
    typed = 'COMP_LINE="rosward compl"; COMP_POINT=13; COMP_TYPE=9; COMP_WORDS=(rosward compl); COMP_CWORD=1'
    script = (
        f'{capsys.readouterr().out}\n{typed}\n_python_argcomplete rosward compl rosward\necho "${{COMPREPLY[@]}}"\n'
    )
    environment = {**os.environ, "PATH": f"{tmp_path}{os.pathsep}{os.environ['PATH']}"}
    done = subprocess.run(
        ["bash", "-c", script], env=environment, capture_output=True, text=True, check=False, timeout=60
    )
    assert done.stdout.strip() == "completion"


def test_without_argcomplete_it_says_what_it_needs(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("argcomplete", "argcomplete.shell_integration"):
        monkeypatch.setitem(sys.modules, name, None)
    assert main(["completion", "bash"]) == 2
    assert "pip install 'rosward[completion]'" in capsys.readouterr().err


def test_the_shell_may_ask_rosward() -> None:
    """argcomplete asks programs only that say so near the start of the file."""
    for module in ("cli/__init__.py", "__main__.py"):
        file = Path(__file__).parent.parent.parent / "src" / "rosward" / module
        assert b"PYTHON_ARGCOMPLETE_OK" in file.read_bytes()[:1024]


def test_nothing_is_loaded_where_nobody_asks() -> None:
    code = "import sys; from rosward.cli import main; main(['launch-tree', '/nowhere']); sys.exit('argcomplete' in sys.modules)"
    environment = {k: v for k, v in os.environ.items() if k != "_ARGCOMPLETE"}
    subprocess.run([sys.executable, "-c", code], check=True, env=environment, capture_output=True, timeout=60)
