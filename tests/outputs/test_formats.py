# SPDX-License-Identifier: Apache-2.0
"""Promise: what the table of formats says is what is written, printed, offered and documented."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Final

import pytest

from rosward.cli import main
from rosward.cli.command_line import command_line
from rosward.outputs.documents import github, junit, network_json, sarif
from rosward.outputs.formats import BY_NAME, DEFAULT_FORMATS, FORMATS, OF_FINDINGS, Format
from rosward.outputs.graphs import dot, mermaid, svg
from rosward.outputs.policies import permissions, policy_files
from rosward.outputs.report import page
from rosward.outputs.writing import FindingsWriter, NetworkWriter

ROOT: Final = Path(__file__).parents[2]

NETWORK_WRITERS: Final[dict[str, NetworkWriter]] = {
    "json": network_json.files,
    "policy": policy_files.files,
    "permissions": permissions.files,
    "dot": dot.files,
    "mermaid": mermaid.files,
    "svg": svg.files,
    "html": page.files,
}
FINDINGS_WRITERS: Final[dict[str, FindingsWriter]] = {"sarif": sarif.text, "junit": junit.text, "github": github.text}
"""As the type checker sees them: the table names their modules only."""


def test_every_writer_is_of_its_type() -> None:
    modules = {name: writer.__module__ for name, writer in [*NETWORK_WRITERS.items(), *FINDINGS_WRITERS.items()]}
    assert modules == {each.name: f"rosward.outputs.{each.writer}" for each in FORMATS}
    assert set(FINDINGS_WRITERS) == set(OF_FINDINGS)


@pytest.mark.parametrize("chosen", [each for each in FORMATS if each.files], ids=lambda each: each.name)
def test_a_format_writes_its_files_and_no_other(chosen: Format, tmp_path: Path) -> None:
    (tmp_path / "talker.py").write_text(
        "import rclpy\nfrom std_msgs.msg import String\nrclpy.init()\nn = rclpy.create_node('talker')\n"
        "n.create_publisher(String, 'chatter', 10)\n"
    )
    out = tmp_path / "out"
    assert main(["extract", str(tmp_path / "talker.py"), "-q", "-o", str(out), "--format", chosen.name]) == 0
    written = {p.relative_to(out).as_posix() for p in out.rglob("*") if p.is_file()}
    assert written == {name.replace("ENCLAVE", "talker") for name in chosen.files}


def test_a_printed_format_writes_no_file(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "talker.py").write_text("import rclpy\nrclpy.init()\nrclpy.create_node(input())\n")
    assert main(["extract", str(tmp_path), "-q", "-o", str(tmp_path / "out"), "--format", "github"]) == 1
    assert capsys.readouterr().out.startswith("::error file=")
    assert not (tmp_path / "out").exists()


def test_without_nodes_there_is_no_policy(tmp_path: Path) -> None:
    (tmp_path / "empty.py").write_text("import rclpy\nrclpy.init()\n")
    main(["extract", str(tmp_path), "-q", "-o", str(tmp_path / "out"), "--format", ",".join(BY_NAME)])
    assert not [p for p in (tmp_path / "out").rglob("*") if "polic" in p.name or "perm" in p.name]
    assert json.loads((tmp_path / "out" / "network.json").read_text())["nodes"] == []


def test_the_page_on_outputs_lists_every_format_with_its_files() -> None:
    page_text = (ROOT / "docs" / "outputs.md").read_text(encoding="utf-8")
    rows = re.findall(
        r"^\|([^|]*)\|([^|]*)\|[^|]*\|$", page_text.partition("| `--format`")[2].partition("\n\n")[0], re.M
    )
    names = [name for cell, _ in rows for name in re.findall(r"`(\w+)`", cell)]
    files = [file for _, cell in rows for file in re.findall(r"`([^`]+)`", cell)]
    assert sorted(names) == sorted([*BY_NAME, "none"])
    assert sorted(files) == sorted(file for each in FORMATS for file in each.files)
    usual = " ".join(page_text.split()).partition("the default is")[2].partition(".")[0]
    assert sorted(re.findall(r"`(\w+)`", usual)) == sorted(DEFAULT_FORMATS)


@pytest.mark.parametrize("command", ["check", "audit"])
def test_commands_that_show_findings_offer_every_format_of_them(command: str) -> None:
    parser = command_line()
    (commands,) = (a for a in parser._actions if a.dest == "command")
    assert isinstance(commands.choices, dict)
    (option,) = (a for a in commands.choices[command]._actions if "--format" in a.option_strings)
    assert option.choices == ("text", "json", *OF_FINDINGS)
