# SPDX-License-Identifier: Apache-2.0
"""`rosward watch`: extract once, and again after each change."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator
from pathlib import Path

import pytest

from rosward.cli import main
from rosward.cli.watch import watch

NODE = """import rclpy
from rclpy.node import Node
from std_msgs.msg import String

def main():
    rclpy.init()
    node = Node("talker")
    node.create_publisher(String, "chatter", 10)
    rclpy.spin(node)

if __name__ == "__main__":
    main()
"""


def test_once_and_again_after_each_change() -> None:
    done: list[int] = []

    async def changes() -> AsyncIterator[None]:
        for _ in range(2):
            yield None

    asyncio.run(watch(changes, lambda: done.append(1)))
    assert len(done) == 3


def test_what_changes_while_it_works_counts_for_the_next_time() -> None:
    news: asyncio.Queue[bool] = asyncio.Queue()
    done: list[int] = []

    async def changes() -> AsyncIterator[None]:
        while await news.get():
            yield None

    async def work() -> None:
        loop = asyncio.get_running_loop()

        def once() -> None:
            done.append(1)
            loop.call_soon_threadsafe(news.put_nowait, len(done) < 3)

        await watch(changes, once)

    asyncio.run(work())
    assert len(done) == 3


def test_the_outputs_are_those_of_extract_each_time(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    pytest.importorskip("watchfiles")
    source, output = tmp_path / "a.py", tmp_path / "out"
    source.write_text(NODE)

    async def changes(path: Path, own: Path) -> AsyncIterator[None]:
        assert (path, own) == (tmp_path, output)
        for text in (NODE.replace("chatter", "news"), "", NODE):
            source.write_text(text)
            yield None

    monkeypatch.setattr("rosward.server.watching.changes", changes)
    assert main(["watch", str(tmp_path), "-o", str(output), "--format", "policy", "--no-config"]) == 0
    assert "chatter</topic>" in (output / "policy.xml").read_text()
    told = capsys.readouterr().out
    assert told.count("rosward read ") >= 3
    assert main(["extract", str(tmp_path), "-o", str(tmp_path / "one"), "--format", "policy", "--no-config"]) == 0
    assert (tmp_path / "one/policy.xml").read_text() == (output / "policy.xml").read_text()


def test_one_folder_is_watched(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["watch", str(tmp_path), str(tmp_path), "--no-config"]) == 2
    assert "single PATH" in capsys.readouterr().err
