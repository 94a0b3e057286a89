# SPDX-License-Identifier: Apache-2.0
"""Promise: what is kept is what was made; what may be from somebody else, or is damaged, is made anew; without a place nothing is kept."""

from __future__ import annotations

import os
import sys
from pathlib import Path

import pytest

from rosward.source import kept as keeping
from rosward.source.kept import cache_folder, kept, read_own, write_own


class Made:
    """Counts how often it is asked."""

    def __init__(self, content: bytes | None = b"content") -> None:
        self.count = 0
        self.content = content

    def __call__(self) -> bytes | None:
        self.count += 1
        return self.content


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    place = tmp_path / "cache"
    monkeypatch.setenv("ROSWARD_CACHE", str(place))
    return place


def entry(folder: Path) -> Path:
    (found,) = folder.iterdir()
    return found


def test_it_is_made_once(folder: Path) -> None:
    made = Made()
    assert [kept("x", made), kept("x", made), kept("y", made)] == [b"content"] * 3
    assert made.count == 2
    assert len(list(folder.iterdir())) == 2


@pytest.mark.parametrize(
    "damage",
    [b"", b"content", b"\0" * 40, b"x" * 32 + b"content"],
    ids=["empty", "bare", "zeros", "another digest"],
)
def test_what_is_damaged_is_made_anew(folder: Path, damage: bytes) -> None:
    made = Made()
    kept("x", made)
    entry(folder).write_bytes(damage)
    assert [kept("x", made), kept("x", made)] == [b"content"] * 2
    assert made.count == 2


@pytest.mark.usefixtures("folder")
def test_another_rosward_makes_its_own(monkeypatch: pytest.MonkeyPatch) -> None:
    made = Made()
    kept("x", made)
    monkeypatch.setattr(keeping, "_KEYS", ["other"])
    kept("x", made)
    assert made.count == 2


def test_old_ones_are_forgotten(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for number in range(20):
        monkeypatch.setattr(keeping, "_KEYS", [str(number)])
        kept("x", Made())
        kept("y", Made())
    assert len(list(folder.glob("x-*"))) == len(list(folder.glob("y-*"))) < 10
    assert (folder / "x-19").is_file()


@pytest.mark.skipif(sys.platform == "win32", reason="no such permissions")
@pytest.mark.parametrize("mode", [0o777, 0o770, 0o722])
def test_a_folder_that_others_may_write_is_none(folder: Path, mode: int) -> None:
    made = Made()
    kept("x", made)
    folder.chmod(mode)
    assert kept("x", made) is None
    assert made.count == 1


@pytest.mark.skipif(sys.platform == "win32", reason="no such permissions")
def test_a_file_that_others_may_write_is_made_anew(folder: Path) -> None:
    made = Made()
    kept("x", made)
    entry(folder).chmod(0o666)
    kept("x", made)
    assert made.count == 2
    assert entry(folder).stat().st_mode & 0o022 == 0


def test_a_folder_is_no_entry(folder: Path) -> None:
    made = Made()
    kept("x", made)
    place = entry(folder)
    place.unlink()
    place.mkdir()
    assert kept("x", made) == b"content"


@pytest.mark.skipif(not hasattr(os, "symlink") or sys.platform == "win32", reason="no links")
def test_a_link_is_not_followed(folder: Path, tmp_path: Path) -> None:
    made = Made()
    kept("x", made)
    place = entry(folder)
    other = tmp_path / "other"
    place.rename(other)
    place.symlink_to(other)
    kept("x", made)
    assert made.count == 2
    assert not place.is_symlink()


def test_a_pipe_is_not_waited_for(folder: Path) -> None:
    if not hasattr(os, "mkfifo"):
        pytest.skip("no pipes")
    made = Made()
    kept("x", made)
    place = entry(folder)
    place.unlink()  # and nobody writes into what takes its place
    os.mkfifo(place, 0o600)
    assert kept("x", made) == b"content"


@pytest.mark.parametrize("name", ["", "relative/folder"])
def test_no_place(monkeypatch: pytest.MonkeyPatch, name: str) -> None:
    monkeypatch.setenv("ROSWARD_CACHE", name)
    made = Made()
    assert cache_folder() is None
    assert kept("x", made) is None
    assert made.count == 0


def test_a_place_that_cannot_be_written(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "file").write_text("", encoding="utf-8")
    monkeypatch.setenv("ROSWARD_CACHE", str(tmp_path / "file" / "below"))
    made = Made()
    assert kept("x", made) is None
    assert made.count == 0
    assert not write_own(tmp_path / "file", "x", b"")
    assert read_own(tmp_path / "file", "x") is None


def test_nothing_is_not_kept(folder: Path) -> None:
    made = Made(None)
    assert [kept("x", made), kept("x", made)] == [None, None]
    assert made.count == 2
    assert not list(folder.iterdir())
