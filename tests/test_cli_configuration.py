# SPDX-License-Identifier: Apache-2.0
"""rosward.toml holds for every command, and docs/configuration.md says what may stand in it. Wrong values are in tests/test_cli_findings.py."""

from __future__ import annotations

import argparse
import json
import re
from pathlib import Path

import pytest

from rosward.cli import main
from rosward.cli.command_line import command_line
from rosward.cli.configuration_keys import KEYS, NEVER

PAGE = (Path(__file__).parents[1] / "docs" / "configuration.md").read_text(encoding="utf-8")
NODE = """\
import sys
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

rclpy.init()
node = Node("{name}")
node.create_publisher(String, "a/" + input(), 10)
"""


@pytest.fixture(autouse=True)
def workspace(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Two programs, one of them in a folder of other people's code."""
    monkeypatch.chdir(tmp_path)
    program("talker", "ws/src/talker.py")
    program("vendor", "ws/src/third_party/lib/vendor.py")


def program(name: str, file: str) -> None:
    Path(file).parent.mkdir(parents=True, exist_ok=True)
    Path(file).write_text(NODE.format(name=name), encoding="utf-8")


def configure(text: str) -> None:
    Path("ws/rosward.toml").write_text(text, encoding="utf-8")


def extracted(*arguments: str) -> tuple[list[str], list[str]]:
    """Nodes, and codes of findings with their files."""
    main(["extract", "ws", "--format", "json", "-o", "out", *arguments])
    document = json.loads(Path("out/network.json").read_text(encoding="utf-8"))
    found = sorted({f"{d['code']} {d['file']}" for d in document["diagnostics"]})
    return [n["fqn"] for n in document["nodes"]], found


def parsers() -> dict[str, argparse.ArgumentParser]:
    """The commands that read the file; `enclaves suggest` and the like by both words."""
    found: dict[str, argparse.ArgumentParser] = {}
    work = [("", command_line())]
    for name, parser in work:
        for action in parser._actions:
            if isinstance(action, argparse._SubParsersAction):
                work += [(f"{name} {word}".strip(), inner) for word, inner in action.choices.items()]
            elif action.dest == "no_config":
                found[name] = parser
    return found


# Every option is a key, or there is a reason why not


@pytest.mark.parametrize("command", parsers())
def test_everything_that_the_command_line_can_say_is_a_key(command: str) -> None:
    options = {o[2:] for a in parsers()[command]._actions for o in a.option_strings if o.startswith("--")}
    assert options - set(KEYS) - set(NEVER) == set()


def test_the_page_lists_every_key_with_its_kind() -> None:
    rows = dict(
        re.findall(r"^\| `([\w-]+)` \| (.*?) \|", PAGE.partition("## Keys")[2].partition("##")[0], re.MULTILINE)
    )
    assert rows == {key: option.kind for key, option in KEYS.items()}


def test_the_page_lists_what_is_no_key() -> None:
    missing = [key for key in NEVER if key != "help" and f"`--{key}`" not in PAGE]
    assert missing == []


def test_the_examples_of_the_page_are_understood(tmp_path: Path) -> None:
    for number, text in enumerate(re.findall(r"```toml\n(.*?)```", PAGE, re.DOTALL)):
        folder = tmp_path / f"example{number}"
        folder.mkdir()
        (folder / "talker.py").write_text(NODE.format(name="talker"), encoding="utf-8")
        (folder / "pyproject.toml").write_text(text, encoding="utf-8")
        for each in ("models", "stubs"):
            (folder / each).mkdir()
        assert main(["explain", "RW101", str(folder / "talker.py")]) == 0, text


# It holds for every command


def test_for_explain_launch_tree_and_check(capsys: pytest.CaptureFixture[str]) -> None:
    Path("ws/a.launch.xml").write_text('<launch><node pkg="a" exec="b" name="left"/></launch>', encoding="utf-8")
    configure('launch = ["a.launch.xml"]\n')
    assert main(["explain", "left", "ws"]) == 0
    main(["launch-tree", "ws", "--json"])
    assert [s["name"] for s in json.loads(capsys.readouterr().out.partition("\n{")[2].join(["{", ""]))["systems"]]
    main(["extract", "ws", "-q", "--format", "policy", "-o", "out"])
    capsys.readouterr()
    main(["check", "out/policy.xml", "ws"])
    assert "talker" not in capsys.readouterr().out


def test_a_table_for_one_command(capsys: pytest.CaptureFixture[str]) -> None:
    configure('[command.explain]\nformat = "json"\n')
    assert main(["explain", "talker", "ws"]) == 0
    assert json.loads(capsys.readouterr().out)["nodes"][0]["name"] == "/talker"
    assert main(["explain", "talker", "ws", "--format", "text"]) == 0
    assert capsys.readouterr().out.startswith("node /talker\n")


def test_what_the_command_line_starts_replaces_what_the_file_starts() -> None:
    for name in ("left", "right"):
        text = f'<launch><node pkg="a" exec="b" name="{name}"/></launch>'
        Path(f"ws/{name}.launch.xml").write_text(text, encoding="utf-8")
    configure('launch = ["left.launch.xml"]\n')
    assert extracted()[0] == ["/left"]
    assert extracted("--launch", "ws/right.launch.xml")[0] == ["/right"]


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ('distr = "humble"', "no option 'distr'; did you mean 'distro'?"),
        ('Exclude = ["a"]', "did you mean 'exclude'?"),
        ('[command.chek]\nformat = "json"', "no command 'chek'; did you mean 'check'?"),
        ('[command.extract]\ngit = "HEAD"', "extract has no option 'git'"),
        ('[command.extract]\nformat = "pdf"', "format: choose from"),
        ("command = 3", "must be a table"),
        ('exclude = ["!a"]', "cannot be revoked"),
        ('exclude = ["**"]', "does not name anything specific"),
        ('exclude = ["../a"]', "leads out of its folder"),
        ('[ignore-in]\n"a/**" = ["RW999"]', "unknown: RW999"),
        ('ignore-in = ["RW102"]', "must be a table"),
    ],
)
def test_what_is_not_understood_is_refused(text: str, told: str, capsys: pytest.CaptureFixture[str]) -> None:
    configure(text)
    assert main(["extract", "ws"]) == 2
    assert told in capsys.readouterr().err


# What is not read


def test_what_is_excluded_is_not_read_and_told(capsys: pytest.CaptureFixture[str]) -> None:
    assert extracted()[0] == ["/talker", "/vendor"]
    configure('exclude = ["**/third_party/**"]\n')
    nodes, found = extracted()
    assert nodes == ["/talker"]
    assert "RW011 " in found
    assert "not read: 1 file or folder excluded by a pattern" in capsys.readouterr().out


@pytest.mark.parametrize(
    "pattern", ["third_party", "third_party/", "vend*.py", "ws/src/third_party", "/ws/src/third_party", "src/**/lib"]
)
def test_exclude_on_the_command_line(pattern: str) -> None:
    """Relative to the working directory; a name without `/` at any depth."""
    expected = ["/talker", "/vendor"] if pattern.startswith("src") else ["/talker"]
    assert extracted("--exclude", pattern)[0] == expected


def test_an_import_of_what_is_excluded_leads_outside_of_the_sources() -> None:
    Path("ws/src/talker.py").write_text(
        "import rclpy\nfrom std_msgs.msg import String\nfrom third_party.lib.vendor import node\nnode.create_publisher(String, 'x', 1)\n",
        encoding="utf-8",
    )
    assert "RW208 src/talker.py" not in extracted()[1]
    assert "RW208 src/talker.py" in extracted("--exclude", "third_party")[1]


def test_a_script_and_a_launch_file_that_are_excluded_are_not_among_the_sources() -> None:
    Path("ws/src/a.launch.xml").write_text(
        '<launch><include file="$(dirname)/b.launch.xml"/></launch>', encoding="utf-8"
    )
    Path("ws/src/b.launch.xml").write_text('<launch><node pkg="a" exec="b" name="inner"/></launch>', encoding="utf-8")
    assert extracted("--launch", "ws/src/a.launch.xml")[0] == ["/inner"]
    nodes, found = extracted("--launch", "ws/src/a.launch.xml", "--exclude", "b.launch.xml")
    assert nodes == []
    assert any(f.startswith("RW31") for f in found)


def test_what_is_named_is_read() -> None:
    configure('exclude = ["third_party"]\n')
    main(["extract", "ws/src/third_party", "--format", "json", "-o", "out"])
    assert '"/vendor"' in Path("out/network.json").read_text(encoding="utf-8")


def test_codes_are_ignored_in_some_files() -> None:
    configure('[ignore-in]\n"src/third_party/**" = ["RW102", "RW302"]\n')
    nodes, found = extracted()
    assert nodes == ["/talker", "/vendor"]
    assert "RW102 src/talker.py" in found
    assert not [f for f in found if "third_party" in f]
