# SPDX-License-Identifier: Apache-2.0
"""A store keeps what it is given, within bounds, and takes nothing for an answer that is none."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from rosward.cache.store import Store


def _same(answer: bytes) -> bytes:
    return answer


def _files(folder: Path) -> list[Path]:
    return sorted(p for p in folder.rglob("*") if p.is_file())


def test_what_is_kept_is_there(tmp_path: Path) -> None:
    store = Store(str(tmp_path))
    assert store.kept("a", b"q", _same) is None
    store.keep("a", b"q", b"answer")
    assert store.kept("a", b"q", _same) == b"answer"
    assert Store(str(tmp_path)).kept("a", b"q", _same) == b"answer"
    assert store.kept("b", b"q", _same) is None
    assert store.kept("a", b"other", _same) is None


def test_the_first_answer_that_is_accepted_counts(tmp_path: Path) -> None:
    store = Store(str(tmp_path))
    for number in range(5):
        store.keep("a", b"q", b"%d" % number)
        for path in _files(tmp_path):
            os.utime(path, ns=(1, path.stat().st_mtime_ns - 10**9))
    assert len(_files(tmp_path)) == 3
    assert store.kept("a", b"q", _same) == b"4"
    assert store.kept("a", b"q", lambda answer: answer if answer == b"2" else None) == b"2"
    assert store.kept("a", b"q", _same) == b"2"  # it was used last
    assert store.kept("a", b"q", lambda answer: answer if answer == b"0" else None) is None


@pytest.mark.parametrize(
    "spoil",
    [
        lambda data: data[:0],
        lambda data: data[:-1],
        lambda data: data + b"x",
        lambda data: data[: len(data) // 2] + b"x" + data[len(data) // 2 + 1 :],
        lambda data: b"something else" + data[:0],
        lambda data: data.partition(b"\n")[0] + b"\n",
    ],
)
def test_a_spoilt_entry_is_none(tmp_path: Path, spoil: object) -> None:
    store = Store(str(tmp_path))
    store.keep("a", b"q", b"answer" * 100)
    (path,) = _files(tmp_path)
    path.write_bytes(spoil(path.read_bytes()))  # type: ignore[operator]
    assert store.kept("a", b"q", _same) is None
    store.keep("a", b"q", b"answer")
    assert store.kept("a", b"q", _same) == b"answer"


def test_an_entry_that_is_no_file_is_none(tmp_path: Path) -> None:
    """A pipe would be read for ever."""
    store = Store(str(tmp_path))
    store.keep("a", b"q", b"answer")
    (path,) = _files(tmp_path)
    path.unlink()
    os.mkfifo(path)
    assert store.kept("a", b"q", _same) is None


def test_it_stays_within_its_bounds(tmp_path: Path) -> None:
    store = Store(str(tmp_path), most_bytes=20_000)
    for number in range(30):
        store.keep("a", b"%d" % number, os.urandom(1_000))
        for path in _files(tmp_path):
            os.utime(path, ns=(1, path.stat().st_mtime_ns - 10**9))
    store.kept("a", b"0", _same)
    store.close()
    assert sum(path.stat().st_size for path in _files(tmp_path)) <= 20_000
    assert store.kept("a", b"0", _same) is not None
    assert store.kept("a", b"1", _same) is None
    assert store.kept("a", b"29", _same) is not None


@pytest.mark.slow
def test_it_is_looked_through_now_and_then(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """By whichever runs it is filled, and however much each writes: it never outgrows its bounds, and few runs pay for that."""
    looks: list[int] = []
    tidy = Store._tidy

    def counted(store: Store) -> None:
        looks.append(1)
        tidy(store)

    monkeypatch.setattr(Store, "_tidy", counted)
    largest = 0
    for number in range(400):
        store = Store(str(tmp_path), most_bytes=100_000)
        store.keep("a", b"%d" % number, os.urandom(500))
        if number % 100 == 0:
            store.keep("b", b"%d" % number, os.urandom(20_000))
        store.close()
        largest = max(largest, sum(p.stat().st_size for p in _files(tmp_path)))
    assert 80_000 < largest <= 100_000 + 20_000
    assert 20 < len(looks) < 60


def test_runs_that_write_little_are_counted_too(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    looks: list[int] = []
    monkeypatch.setattr(Store, "_tidy", lambda _: looks.append(1))
    for _ in range(600):
        store = Store(str(tmp_path))
        store.keep("a", b"q", b"answer")
        store.close()
    assert len(looks) == 2


def test_what_is_no_tally_makes_each_run_look(tmp_path: Path) -> None:
    """A pipe would be written to for ever."""
    store = Store(str(tmp_path), most_bytes=10_000)
    store.keep("a", b"q", b"answer")
    store.close()
    (tally,) = tmp_path.rglob("written")
    tally.unlink()
    os.mkfifo(tally)
    store.keep("a", b"other", os.urandom(20_000))
    store.close()
    assert not tally.exists()
    assert store.kept("a", b"other", _same) is None


def test_a_folder_that_cannot_be_written_keeps_nothing(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("", encoding="utf-8")
    store = Store(str(tmp_path / "file"))
    store.keep("a", b"q", b"answer")
    store.close()
    assert store.kept("a", b"q", _same) is None


def test_it_may_be_deleted_at_any_time(tmp_path: Path) -> None:
    store = Store(str(tmp_path / "c"))
    store.keep("a", b"q", b"answer")
    for path in _files(tmp_path):
        path.unlink()
    assert store.kept("a", b"q", _same) is None
    store.close()


def test_only_the_user_reads_what_is_kept(tmp_path: Path) -> None:
    Store(str(tmp_path / "c")).keep("a", b"q", b"answer")
    (path,) = _files(tmp_path)
    assert path.stat().st_mode & 0o077 == 0
