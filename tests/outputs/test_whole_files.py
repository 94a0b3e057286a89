# SPDX-License-Identifier: Apache-2.0
"""Promise: a file that holds the content already is left in place and looks written now; any other is replaced as a whole."""

from __future__ import annotations

import os
import stat
from pathlib import Path

import pytest

from rosward.outputs.whole_files import write_text

LONG_AGO = 1_000_000_000


def test_the_same_content_is_left_in_place(tmp_path: Path) -> None:
    path = Path(write_text(str(tmp_path), "a/b.txt", "same"))
    os.utime(path, (LONG_AGO, LONG_AGO))
    before = path.stat()
    assert write_text(str(tmp_path), "a/b.txt", "same") == str(path)
    after = path.stat()
    assert after.st_ino == before.st_ino
    assert after.st_mtime > LONG_AGO
    assert path.read_text() == "same"


@pytest.mark.parametrize("text", ["other", "sama", "", "same and more"])
def test_other_content_is_replaced(tmp_path: Path, text: str) -> None:
    path = Path(write_text(str(tmp_path), "b.txt", "same"))
    with path.open(encoding="utf-8") as reader:
        write_text(str(tmp_path), "b.txt", text)
        assert reader.read() == "same"  # who reads has the old file
    assert path.read_text() == text


@pytest.mark.skipif(os.name != "posix", reason="links and modes are those of POSIX")
def test_what_is_not_as_it_would_be_written_is_replaced(tmp_path: Path) -> None:
    path = Path(write_text(str(tmp_path), "b.txt", "same"))
    path.chmod(0o600)
    write_text(str(tmp_path), "b.txt", "same")
    assert stat.S_IMODE(path.stat().st_mode) == 0o644
    other = tmp_path / "c.txt"
    other.hardlink_to(path)
    write_text(str(tmp_path), "b.txt", "same")
    assert path.stat().st_nlink == other.stat().st_nlink == 1
    target = tmp_path / "target"
    target.write_text("same")
    target.chmod(0o644)
    path.unlink()
    path.symlink_to(target)
    write_text(str(tmp_path), "b.txt", "same")
    assert not path.is_symlink()
