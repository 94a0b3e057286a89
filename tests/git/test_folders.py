# SPDX-License-Identifier: Apache-2.0
"""Folders nested deeper than Python recurses are made, and taken away with all that is in them; links are not followed."""

from __future__ import annotations

import os
from pathlib import Path

from rosward.git.folders import make_folders, scratch_folder


def test_deep_folders(tmp_path: Path) -> None:
    kept = tmp_path / "kept"
    kept.mkdir()
    (kept / "file").write_text("x")
    with scratch_folder() as folder:
        deep = "/".join([folder, *["d"] * 1_500])
        make_folders(deep)
        make_folders(deep)
        Path(deep, "n.py").write_text("x")
        Path(folder, "link").symlink_to(kept)
    assert not os.path.lexists(folder)
    assert (kept / "file").read_text() == "x"
