# SPDX-License-Identifier: Apache-2.0
"""A workspace that is watched: a change makes a new result, many at once make one, and what a build writes makes none."""

from __future__ import annotations

import contextlib
import sys
import time
from pathlib import Path
from typing import Any

import pytest

from rosward.server.limits import Limits

from .page import Page, opened

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="asks the kernel in /proc what is watched")


@pytest.fixture
def workspace(tmp_path: Path) -> Path:
    folder = tmp_path / "ws"
    (folder / "src").mkdir(parents=True)
    (folder / "src/talker.py").write_text("", encoding="utf-8")
    return folder


def begin(page: Page, workspace: Path, **settings: object) -> dict[str, Any]:
    body = {"path": str(workspace), "watch": True, "settings": settings}
    result = page.wait(page.post("/api/workspaces", body)["id"])
    page.wait_for(lambda: result if is_watched(workspace) else None)
    return result


def is_watched(folder: Path) -> bool:
    """Whether the kernel watches a folder for this process."""
    inode = f" ino:{folder.stat().st_ino:x} "
    for file in Path("/proc/self/fdinfo").iterdir():
        with contextlib.suppress(OSError):  # it was closed meanwhile
            if any("inotify wd:" in line and inode in line for line in file.read_text(encoding="utf-8").splitlines()):
                return True
    return False


def automatic(page: Page) -> dict[str, Any] | None:
    return next((r for r in page.results() if r["automatic"] and r["state"] == "done"), None)


def test_a_change_makes_a_new_result_of_the_same_settings(page: Page, workspace: Path) -> None:
    first = begin(page, workspace, distro="humble")
    assert first["watched"] is True
    for text in ("a = 1", "a = 2", "a = 3"):
        (workspace / "src/talker.py").write_text(text, encoding="utf-8")
    second = page.wait_for(lambda: automatic(page))
    assert (second["group"], second["settings"]) == (first["group"], "humble")
    assert len(page.results()) == 2
    (workspace / "src/talker.py").write_text("a = 4", encoding="utf-8")
    page.wait_for(lambda: next((r for r in page.results() if r["automatic"] and r["id"] != second["id"]), None))
    page.wait_for(lambda: page.results()[0] if len(page.results()) == 2 else None)
    assert first["id"] in {r["id"] for r in page.results()}, "of the automatic ones the last is kept, and the first one"


def test_what_a_build_writes_makes_none(page: Page, workspace: Path) -> None:
    begin(page, workspace)
    for name in ("build/a.py", "install/b.py", "log/c.py", ".git/d.py", "src/__pycache__/e.pyc", "src/photo.png"):
        (workspace / name).parent.mkdir(parents=True, exist_ok=True)
        (workspace / name).write_text("x", encoding="utf-8")
    time.sleep(0.8)
    assert len(page.results()) == 1


def test_it_ends_when_nobody_wants_it(page: Page, workspace: Path) -> None:
    first = begin(page, workspace)
    page.post(f"/api/results/{first['id']}/watch", {"on": False})
    assert page.results()[0]["watched"] is False
    (workspace / "src/talker.py").write_text("b = 1", encoding="utf-8")
    time.sleep(0.6)
    assert len(page.results()) == 1
    page.post(f"/api/results/{first['id']}/watch", {"on": True})
    assert page.results()[0]["watched"] is True


def test_our_own_results_are_no_change(tmp_path: Path) -> None:
    workspace = tmp_path / "ws"
    workspace.mkdir()
    with opened(workspace / "results") as page:
        begin(page, workspace)
        time.sleep(0.6)
        assert len(page.results()) == 1


def test_the_number_of_watched_workspaces_is_bounded(tmp_path: Path) -> None:
    with opened(tmp_path / "results", Limits(watched=1)) as page:
        for name in ("a", "b"):
            (tmp_path / name).mkdir()
        begin(page, tmp_path / "a")
        assert "already being watched" in page.refused("/api/workspaces", {"path": str(tmp_path / "b"), "watch": True})


def test_an_upload_cannot_be_watched(page: Page) -> None:
    sent = page.send({"a.py": b""}).json()["id"]
    assert "only folders" in page.refused(f"/api/results/{sent}/watch", {"on": True})
