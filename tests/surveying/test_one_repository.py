# SPDX-License-Identifier: Apache-2.0
"""One repository in a process of its own: whatever happens to that, there is a row with its reason."""

from __future__ import annotations

import os
import sys
from pathlib import Path

import pytest

from rosward.surveying import apart
from rosward.surveying.identity import identity
from rosward.surveying.job import Bounds, Job, SurveyOptions, job_of
from rosward.surveying.part import Part, Repository, packed, unpacked
from rosward.surveying.state import state_of

from .checkouts import TALKER, put

BUSY = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String
rclpy.init()
node = Node("n")
""" + "".join(f"for i in range(250):\n    node.create_publisher(String, f'topic_{n}_{{i}}', 10)\n" for n in range(100))


DEFAULT = Bounds()


def job(path: Path | str, bounds: Bounds = DEFAULT) -> Job:
    return Job(os.fspath(path), SurveyOptions(), bounds, identity())


def analysed(given: Job) -> tuple[Part, Repository]:
    part = packed(apart.analysed_apart(given.line()))
    assert part is not None
    rows = unpacked(part)
    assert rows is not None
    return part, Repository(*rows["repositories"][0])  # type: ignore[arg-type]


def test_a_job_is_a_line() -> None:
    one = Job("/odd \udcff\n", SurveyOptions(exclude=("a\nb",)), Bounds(1, 2), "i", "k")
    assert job_of(one.line()) == one
    assert "\n" not in one.line()
    assert one.line().isascii()


def test_time_is_bounded(tmp_path: Path) -> None:
    put(tmp_path / "busy.py", BUSY)
    part, row = analysed(job(tmp_path, Bounds(seconds=1)))
    assert (row.state, row.reason, row.fault) == ("timeout", "it took more than 1 seconds of processor time", False)
    assert part.cpu > 0.5  # the kernel counts ticks for its limit and time for what it tells
    assert part.counts_for(Bounds(seconds=1), retry=False)
    assert not part.counts_for(Bounds(seconds=1), retry=True)
    assert not part.counts_for(Bounds(seconds=2), retry=False)


def test_memory_is_bounded(tmp_path: Path) -> None:
    put(tmp_path / "talker.py", TALKER)
    _, row = analysed(job(tmp_path, Bounds(memory=580 * 2**20)))
    assert (row.state, row.fault) == ("failed", False)
    assert row.reason == "it needs more than 580 MB of memory"


@pytest.mark.parametrize(
    ("program", "state", "reason", "fault", "kept"),
    [
        ("os.kill(os.getpid(), 11)", "failed", "rosward was killed (SIGSEGV); please report it", True, True),
        ("os.kill(os.getpid(), 9)", "failed", "it was killed (SIGKILL); the memory of the machine may be exhausted", False, False),
        ("os.kill(os.getpid(), 24)", "timeout", "it took more than 600 seconds of processor time", False, True),
        ("os._exit(7)", "failed", "the process ended with status 7", True, False),
        ("print('no JSON')", "failed", "the process ended with status 0", True, False),
        ("print('{\"length\": 3, \"sha256\": \"\", \"peak\": 1}\\nabc')", "failed", "the process ended with status 0", True, False),
        ("print('[1]')", "failed", "the process ended with status 0", True, False),
    ],
)  # fmt: skip
def test_how_a_process_ends(
    program: str, state: str, reason: str, fault: bool, kept: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """`kept`: another run takes it for granted."""
    said = 'import os; print(\'{"key": "k"}\', flush=True); '
    monkeypatch.setattr(apart, "isolated", lambda _: [sys.executable, "-S", "-c", said + program])
    part, row = analysed(job(tmp_path))
    assert (row.state, row.reason, row.fault) == (state, reason, fault)
    assert part.counts_for(Bounds(), retry=False) is kept


def test_a_process_that_hangs_is_ended(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Bounds, "wall", 0.1)
    monkeypatch.setattr(apart, "isolated", lambda _: [sys.executable, "-S", "-c", "import time; time.sleep(600)"])
    _, row = analysed(job(tmp_path))
    assert row.state == "timeout"


def test_another_rosward_does_nothing(tmp_path: Path) -> None:
    with pytest.raises(apart.OtherRoswardError, match="another version"):
        apart.analysed_apart(job(tmp_path)._replace(identity="other").line())


def test_the_state_changes_with_each_file(tmp_path: Path) -> None:
    folder = tmp_path / os.fsdecode(b"odd \xff\n")
    put(folder / "a.py", "x")
    (folder / "loop").symlink_to(folder)
    (folder / "gone").symlink_to("nowhere")
    os.mkfifo(folder / "pipe")
    with (folder / "huge.bag").open("wb") as huge:
        huge.truncate(2**40)
    states = [state_of(str(folder))]
    assert states == [state_of(str(folder))]
    put(folder / ".git" / "objects" / "x", "history is no source")
    (folder / ".git" / "objects" / "y").write_text("")
    states.append(state_of(str(folder)))
    put(folder / ".git" / "objects" / "z", "")
    assert states[-1] == state_of(str(folder))
    put(folder / "b.py", "x")
    states.append(state_of(str(folder)))
    (folder / "a.py").rename(folder / "c.py")
    states.append(state_of(str(folder)))
    put(folder / "c.py", "y")
    states.append(state_of(str(folder)))
    (folder / "gone").unlink()
    (folder / "gone").symlink_to("elsewhere")
    states.append(state_of(str(folder)))
    assert len(set(states)) == len(states)


@pytest.mark.parametrize("path", ["/nowhere/at/all", "/etc/passwd", "a\0b"])
def test_what_is_no_folder(path: str) -> None:
    _, row = analysed(job(path))
    assert row.state == "failed"
    assert row.reason is not None
    assert row.reason.startswith("cannot be read: ")
