# SPDX-License-Identifier: Apache-2.0
"""`rosward enclaves suggest` and `extract --compact` on the command line; docs/enclaves.md shows what they print."""

from __future__ import annotations

import json
import shutil
from pathlib import Path
from typing import Final

import pytest

from rosward.cli import main

ROOT: Final = Path(__file__).parent.parent.parent
PANEL: Final = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String
from std_srvs.srv import Trigger

rclpy.init()
panel = Node("panel")
for robot in range(250):
    for topic in ("battery", "pose", "status"):
        panel.create_subscription(String, f"/fleet/robot_{robot}/{topic}", print, 10)
    panel.create_client(Trigger, f"/fleet/robot_{robot}/stop")
rclpy.spin(panel)
"""


@pytest.fixture
def fleet(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> tuple[str, ...]:
    """The options that start the fleet of the example, in a folder with its sources."""
    shutil.copytree(ROOT / "examples" / "delivery_robot", tmp_path / "delivery_robot")
    monkeypatch.chdir(tmp_path)
    return ("--launch", "delivery_bringup:fleet.launch.py")


@pytest.mark.slow
def test_a_suggestion_becomes_policies(fleet: tuple[str, ...], capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["enclaves", "suggest", *fleet, "--max", "4", "--write", "e.toml", "--json"]) == 0
    suggested = json.loads(capsys.readouterr().out)["suggestion"]["enclaves"]
    assert main(["extract", *fleet, "--enclaves", "e.toml", "--format", "json,policy,permissions", "-q"]) == 0
    nodes = json.loads(Path("rosward-out/network.json").read_text("utf-8"))["nodes"]
    assert {n["fqn"]: n["enclave"] for n in nodes} == {
        node: e["path"] for e in suggested for p in e["processes"] for node in p["nodes"]
    }
    for enclave in suggested:
        document = Path(f"rosward-out/permissions{enclave['path']}/permissions.xml").read_text("utf-8")
        assert enclave["permissions_bytes"] == len(document) + document.count("\n") + 2048
        assert enclave["path"] in Path("rosward-out/enclaves.txt").read_text("utf-8")


def test_permissions_that_are_too_large(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("fleet_panel.py").write_text(PANEL, encoding="utf-8")
    assert main(["extract", "--format", "policy,permissions"]) == 0
    warned = capsys.readouterr().out
    line = "fleet_panel.py:7  the signed permissions of enclave /panel take about 72 KB, but at most 60 KB are safe"
    assert line in warned
    assert main(["extract", "--format", "policy,permissions", "--compact", "-v"]) == 0
    noted = capsys.readouterr().out
    line = "enclave /panel: service client /fleet/robot_*/stop replaces 250 names; it also allows any other name of this form"
    assert line in noted
    assert "RW304" not in noted
    document = Path("rosward-out/permissions/panel/permissions.xml").read_text("utf-8")
    assert len(document) + document.count("\n") + 2048 <= 60 * 1024


@pytest.mark.slow
def test_without_need_nothing_is_compacted(fleet: tuple[str, ...]) -> None:
    assert main(["extract", *fleet, "--format", "policy,permissions", "-q", "-o", "plain"]) == 0
    assert main(["extract", *fleet, "--format", "policy,permissions", "-q", "-o", "compact", "--compact"]) == 0
    plain = {p.relative_to("plain"): p.read_bytes() for p in Path("plain").rglob("*") if p.is_file()}
    assert plain == {p.relative_to("compact"): p.read_bytes() for p in Path("compact").rglob("*") if p.is_file()}


@pytest.mark.parametrize(
    "arguments",
    [
        ("enclaves",),
        ("enclaves", "suggest", "--max", "0"),
        ("enclaves", "suggest", "--max", "2", "--price", "3"),
        ("extract", "--enclaves", "nowhere"),
    ],
)
def test_wrong_use(arguments: tuple[str, ...]) -> None:
    with pytest.raises(SystemExit) as error:
        main([*arguments])
    assert error.value.code == 2


def test_what_cannot_be_done(fleet: tuple[str, ...], capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["enclaves", "suggest", *fleet, "--write", "enclaves.txt"]) == 2
    assert main(["extract", *fleet, "--enclaves", "missing.toml"]) == 2
    assert "rosward: --enclaves missing.toml: " in capsys.readouterr().err
    Path("nothing.py").write_text("x = 1\n", encoding="utf-8")
    assert main(["enclaves", "suggest", "nothing.py"]) == 2
