# SPDX-License-Identifier: Apache-2.0
"""JSON that can be written as UTF-8 and read again, whatever the sources put into its texts."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

import rosward
from rosward.deployment.request import Request
from rosward.outputs.documents.json_text import json_text
from rosward.outputs.documents.launch_tree_json import launch_tree_json


@pytest.mark.parametrize("text", ["\ud800", "\udfff\ud800", "\0", "\x1b[31m", "\u2028\u202e\ufffe", "😀"])
def test_every_text(text: str) -> None:
    written = json_text({text: [text]})
    assert json.loads(written.encode("utf-8")) == {text: [text]}


def test_launch_tree(tmp_path: Path) -> None:
    (tmp_path / "a.launch.py").write_text(
        "from launch import LaunchDescription\nfrom launch_ros.actions import Node\ndef generate_launch_description():\n"
        "    return LaunchDescription([Node(package='p', executable='e', name='\\ud800', parameters=[{'p\\ud800': '\\ud800'}])])\n"
    )
    result = rosward.extract(tmp_path, request=Request(all_launch=True))
    assert json.loads(launch_tree_json(result.systems, result.findings).encode("utf-8"))


def test_json_is_written_in_one_place() -> None:
    outputs = Path(__file__).parents[2] / "src" / "rosward" / "outputs"
    writers = {p.relative_to(outputs).as_posix() for p in outputs.rglob("*.py") if "json.dumps" in p.read_text()}
    assert writers == {"documents/json_text.py", "report/frame.py", "report/page.py"}
