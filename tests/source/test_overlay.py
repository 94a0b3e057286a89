# SPDX-License-Identifier: Apache-2.0
"""The text of an editor stands over the file, wherever sources are read."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

import rosward
from rosward.source import disk
from rosward.source.overlay import overlaid

NODE = """import rclpy
from rclpy.node import Node
from std_msgs.msg import String

rclpy.init()
Node("talker").create_publisher(String, "saved", 10)
"""


def test_what_is_read_is_what_is_shown(tmp_path: Path) -> None:
    path = tmp_path / "a.py"
    path.write_text("saved")
    with overlaid({str(path): b"shown"}):
        assert disk.read(path, 100) == b"shown"
        assert disk.head(str(path), 2) == b"sh"
        assert isinstance(disk.read(path, 3), disk.Unread)
        assert disk.read(tmp_path / "x" / ".." / "a.py", 100) == b"shown"
    assert disk.read(path, 100) == b"saved"


def test_an_overlay_makes_no_file(tmp_path: Path) -> None:
    with overlaid({str(tmp_path / "a.py"): b"shown"}):
        assert not disk.is_file(tmp_path / "a.py")
        with pytest.raises(OSError, match="No such file"):
            disk.head(str(tmp_path / "a.py"), 2)


def test_a_result_of_what_is_shown_is_none_of_what_was_saved(tmp_path: Path) -> None:
    path = tmp_path / "a.py"
    path.write_text("saved")
    with overlaid({str(path): b"shown"}), disk.watching() as trace:
        disk.read(path, 100)
        assert disk.holds(trace.seen)
    assert not disk.holds(trace.seen)


def test_an_analysis_sees_it_in_its_own_thread(tmp_path: Path) -> None:
    path = tmp_path / "talker.py"
    path.write_text(NODE)
    shown = {os.fspath(path): NODE.replace("saved", "shown").encode()}

    def names() -> set[str]:
        return {e.name for n in rosward.extract(tmp_path).network.nodes for e in n.entities if not e.system}

    with overlaid(shown):
        assert names() == {"/shown"}
    assert names() == {"/saved"}
