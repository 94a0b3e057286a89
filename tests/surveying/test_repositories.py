# SPDX-License-Identifier: Apache-2.0
"""Which repositories are surveyed: folders, lists, links, duplicates, odd names."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from rosward.surveying.repositories import SurveyError, check_output, repositories_at, repositories_of


def test_the_folders_in_a_folder(tmp_path: Path) -> None:
    for name in (b"b", b"a", b"odd \xff\n", b".hidden", b"out"):
        (tmp_path / os.fsdecode(name)).mkdir()
    (tmp_path / "file").touch()
    (tmp_path / "loop").symlink_to(tmp_path)
    (tmp_path / "link").symlink_to("a")
    (tmp_path / "broken").symlink_to("nowhere")
    found = repositories_at(str(tmp_path), str(tmp_path / "out"))
    assert [each.name for each in found.repositories] == ["a", "b", "odd \\xff\n"]
    assert Path(found.repositories[2].path).is_dir()
    assert (found.links, found.duplicates) == (2, 0)


def test_a_list_is_relative_to_its_folder(tmp_path: Path) -> None:
    for name in ("a", "sub/b"):
        (tmp_path / name).mkdir(parents=True)
    (tmp_path / "same").symlink_to("a")
    (tmp_path / "list").write_bytes(b"sub/b\r\nsame\na\n\na/../a\n#gone\n/elsewhere/c\nodd \xff\n")
    found = repositories_at(str(tmp_path / "list"), "out")
    assert [each.name for each in found.repositories] == ["#gone", "/elsewhere/c", "a", "odd \\xff", "sub/b"]
    assert found.duplicates == 2


def test_names_may_hold_line_ends_where_nul_separates_them(tmp_path: Path) -> None:
    (tmp_path / "list").write_bytes(b"a\nb\0c\0")
    assert [r.name for r in repositories_at(str(tmp_path / "list"), "out", null=True).repositories] == ["a\nb", "c"]
    with pytest.raises(SurveyError, match="use --null"):
        repositories_at(str(tmp_path / "list"), "out")


def test_no_two_have_one_name() -> None:
    found = repositories_of([b"/w/a\xff", "/w/a\\xff", "/w/a\\xff#2"], "/w")
    assert len({each.name for each in found.repositories}) == 3
    assert len({each.path for each in found.repositories}) == 3


def test_what_is_refused(tmp_path: Path) -> None:
    (tmp_path / "empty").mkdir()
    (tmp_path / "list").write_text("\n\n")
    (tmp_path / "a").mkdir()
    for path, output, told in (
        ("gone", "out", "No such file"),
        ("empty", "out", "contains no folders"),
        ("list", "out", "lists no repository"),
        ("", ".", "is the folder with the repositories"),
    ):
        with pytest.raises(SurveyError, match=told):
            repositories_at(str(tmp_path / path), str(tmp_path / output))


def test_the_output_is_not_in_a_repository(tmp_path: Path) -> None:
    (tmp_path / "a" / "sub").mkdir(parents=True)
    found = repositories_at(str(tmp_path), str(tmp_path / "out"))
    check_output(str(tmp_path / "out"), found.repositories)
    (tmp_path / "link").symlink_to("a/sub")
    for output in ("a", "a/sub/out", "link/out"):
        with pytest.raises(SurveyError, match="is in the repository a"):
            check_output(str(tmp_path / output), found.repositories)
