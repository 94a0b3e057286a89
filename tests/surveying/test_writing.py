# SPDX-License-Identifier: Apache-2.0
"""Parts and tables: what is written whole, what is refused, and what happens on a full disk."""

from __future__ import annotations

import json
import os
import resource
from pathlib import Path

import pyarrow.parquet as pq
import pytest

from rosward.cli import main
from rosward.surveying.job import Bounds
from rosward.surveying.part import Part, pack, packed, unpacked
from rosward.surveying.part import Repository as Row
from rosward.surveying.parts import Parts
from rosward.surveying.repositories import Repository
from rosward.surveying.tables import Tables

ROW = Row("ok", None, False, True, "executables", 1, 2, 3, 4, "0.1.0", "{}")
FINDING = ["RW101", "error", "message", "a.py", 3, ["/n"], []]


def part(**rows: list[list[object]]) -> Part:
    return Part("key", 0.5, 7, pack(ROW, rows))  # type: ignore[arg-type]


def test_a_part_is_what_was_stored() -> None:
    one = part(findings=[FINDING])._replace(ended=Bounds(3, 4))
    again = packed(one.stored())
    assert again == one
    rows = unpacked(again)
    assert rows is not None
    assert rows["findings"] == [FINDING]


@pytest.mark.parametrize("rows", [
    [FINDING[:-1]], [[*FINDING, 1]], ["RW101"], [[None, *FINDING[1:]]], [[*FINDING[:4], "3", [], []]], [[*FINDING[:4], True, [], []]],
    [[*FINDING[:4], 2**63, [], []]], [[*FINDING[:4], 3, ["/n", 1], []]], {"a": 1},
])  # fmt: skip
def test_rows_of_another_form_are_none(rows: list[list[object]]) -> None:
    assert unpacked(part(findings=rows)) is None


def test_what_is_no_part() -> None:
    whole = part().stored()
    assert packed(whole) is not None
    for wrong in (
        b"",
        b"\n",
        whole[:-1],
        whole + b"x",
        b"[1]\n",
        b"{}\n",
        whole.replace(b'"cpu": 0.5', b'"cpu": NaN'),
        b"[" * 100_000,
    ):
        assert packed(wrong) is None
    for head in (
        {"peak": -1},
        {"peak": "1"},
        {"key": 1},
        {"cpu": "x"},
        {"ended": 3},
        {"ended": [1, 2, 3]},
        {"part": 2},
    ):
        line, _, body = whole.partition(b"\n")
        assert packed(json.dumps({**json.loads(line), **head}).encode() + b"\n" + body) is None


def test_a_bomb_is_not_unpacked(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("rosward.surveying.part._MOST_UNPACKED", 1_000)
    assert unpacked(part(findings=[FINDING] * 100)) is None
    assert unpacked(part()) is not None


def test_groups_end_where_the_rows_say(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Many repositories are written one after the other, and the file is the same each time."""
    monkeypatch.setattr("rosward.surveying.tables._GROUP", 10)
    one = part(findings=[FINDING] * 4)
    rows = unpacked(one)
    assert rows is not None
    for name in ("a", "b"):
        with Tables(str(tmp_path / name)) as tables:
            for number in range(10):
                tables.add(Repository(f"r{number}", f"/r{number}"), one, rows)
    file = pq.ParquetFile(tmp_path / "a" / "findings.parquet")
    assert [file.metadata.row_group(n).num_rows for n in range(file.num_row_groups)] == [12, 12, 12, 4]
    assert (tmp_path / "a" / "findings.parquet").read_bytes() == (tmp_path / "b" / "findings.parquet").read_bytes()


def test_tables_are_whole_or_not_there(tmp_path: Path) -> None:
    def write() -> None:
        with Tables(str(tmp_path)) as tables:
            rows = unpacked(part())
            assert rows is not None
            tables.add(Repository("a", "/a"), part(), rows)
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        write()
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("failing", ["part", "table"])
def test_a_full_disk(
    failing: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """A bound of this process on the size of files does as a full disk would; here nothing is analysed."""
    (tmp_path / "in" / "a").mkdir(parents=True)
    random = [["RW101", "error", os.urandom(100).hex(), "a.py", 3, [], []] for _ in range(100)]
    monkeypatch.setattr("rosward.surveying.run.analysed_apart", lambda _: part(findings=random).stored())
    monkeypatch.setattr("sys.dont_write_bytecode", True)  # it would be cut off, and be there for the next run
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    if failing == "table":
        monkeypatch.setattr("rosward.surveying.parts.write_bytes", writer_without_bound(before))
    try:
        resource.setrlimit(resource.RLIMIT_FSIZE, (2_000, before[1]))
        assert main(["survey", str(tmp_path / "in"), "-j", "1", "-o", str(tmp_path / "out")]) == 2
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)
    assert f"rosward: cannot write to {tmp_path}/out: File too large" in capsys.readouterr().err
    left = [path for path in (tmp_path / "out").rglob("*") if path.is_file()]
    assert len(left) == (failing == "table")


def writer_without_bound(before: tuple[int, int]) -> object:
    from rosward.outputs.whole_files import write_bytes

    def write(folder: str, name: str, content: bytes) -> str:
        now = resource.getrlimit(resource.RLIMIT_FSIZE)
        resource.setrlimit(resource.RLIMIT_FSIZE, before)
        try:
            return write_bytes(folder, name, content)
        finally:
            resource.setrlimit(resource.RLIMIT_FSIZE, now)

    return write


def test_parts_are_found_again(tmp_path: Path) -> None:
    parts = Parts(str(tmp_path))
    assert parts.read("/a") is None
    parts.write("/odd \udcff", part().stored())
    assert parts.read("/odd \udcff") == part()
    assert parts.read("/a") is None


@pytest.mark.skipif(os.geteuid() == 0, reason="root may write everywhere")
def test_no_permission(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "in" / "a").mkdir(parents=True)
    (tmp_path / "out").mkdir(mode=0o500)
    assert main(["survey", str(tmp_path / "in"), "-o", str(tmp_path / "out")]) == 2
    assert "Permission denied" in capsys.readouterr().err
