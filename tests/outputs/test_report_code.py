# SPDX-License-Identifier: Apache-2.0
"""The lines of source in the report: those around each place, of files below the root alone, and not without end."""

from __future__ import annotations

from pathlib import Path

from rosward.location import Place
from rosward.network.connect import connect
from rosward.outputs.background import Background
from rosward.outputs.report.packed import packed
from rosward.outputs.report.source_lines import source_lines

from .networks import node, pub
from .reports import Report


def written(folder: Path, name: str, lines: int = 30) -> None:
    path = folder / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("".join(f"line {number}\n" for number in range(1, lines + 1)), encoding="utf-8")


def test_four_lines_on_both_sides(tmp_path: Path) -> None:
    written(tmp_path, "demo/talker.py")
    found = source_lines(tmp_path, [Place("demo/talker.py", 2), Place("demo/talker.py", 20)])
    numbers = [*range(1, 7), *range(16, 25)]
    assert found.lines == {"demo/talker.py": {str(n): f"line {n}" for n in numbers}}
    assert found.left_out == 0


def test_the_lines_of_every_place_of_the_document(tmp_path: Path) -> None:
    for name in ("a.py", "b.py", "launch.py"):
        written(tmp_path, name)
    made = pub("/x", created_at=(Place("b.py", 20),), path=(Place("a.py", 9), Place("b.py", 20)))
    launched = node("/a", made, defined_at=Place("a.py", 29), launched_by=Place("launch.py", 1), system=False)
    code = Report(connect("jazzy", [launched]), Background(tmp_path))["code"]
    assert {file: list(lines) for file, lines in code.items()} == {
        "a.py": [str(n) for n in (*range(5, 14), *range(25, 32))],
        "b.py": [str(n) for n in range(16, 25)],
        "launch.py": [str(n) for n in range(1, 6)],
    }


def test_nothing_from_outside_of_the_root(tmp_path: Path) -> None:
    written(tmp_path, "secret.py")
    root = tmp_path / "root"
    root.mkdir()
    (root / "link.py").symlink_to(tmp_path / "secret.py")
    places = [Place("../secret.py", 3), Place("link.py", 3), Place(str(tmp_path / "secret.py"), 3), Place("no.py", 3)]
    assert source_lines(root, [*places, Place("", 1), Place("a\0.py", 1)]).lines == {}


def test_a_bound_on_all_of_it_and_what_is_left_out_is_counted(tmp_path: Path) -> None:
    written(tmp_path, "a.py", 1000)
    written(tmp_path, "b.py")
    places = [Place("a.py", number) for number in range(100, 1000, 100)]
    found = source_lines(tmp_path, [*places, Place("b.py", 3)], limit=500)
    assert list(found.lines) == ["a.py"]
    assert found.left_out == 7
    assert sum(len(text) for text in found.lines["a.py"].values()) < 500


def test_hostile_source_is_shown_and_does_nothing(tmp_path: Path) -> None:
    (tmp_path / "a.py").write_text("x = '</script><script>alert(1)</script>'\x1b[31m\u202e\n", encoding="utf-8")
    report = Report(connect("jazzy", [node("/a", defined_at=Place("a.py", 1))]), Background(tmp_path))
    assert report["code"]["a.py"]["1"] == "x = '</script><script>alert(1)</script>'\\x1b[31m\\u202e"
    assert "<" not in packed(report.text)
