# SPDX-License-Identifier: Apache-2.0
"""Trees that no honest `git add` makes: whatever a commit holds, nothing is written outside of the new folder."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

from rosward.git.git import Git, GitError
from rosward.git.tree import write_commit, write_work_tree


def git(*arguments: str, text: bytes = b"") -> bytes:
    identity = ["-c", "user.name=a", "-c", "user.email=a@example.org"]
    return subprocess.run(["git", *identity, *arguments], check=True, capture_output=True, input=text).stdout.strip()


@pytest.fixture
def repository(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Git:
    (tmp_path / "ws").mkdir()
    monkeypatch.chdir(tmp_path / "ws")
    monkeypatch.setenv("HOME", str(tmp_path))
    git("init", "-q")
    return Git(str(tmp_path / "ws"))


def blob(content: bytes) -> bytes:
    return git("hash-object", "-w", "--stdin", text=content)


def tree(*entries: tuple[bytes, bytes, bytes]) -> bytes:
    """Mode, object and name of each entry, as they are; git's own check of names is not asked."""
    raw = b"".join(mode + b" " + name + b"\0" + bytes.fromhex(obj.decode()) for mode, obj, name in entries)
    return git("hash-object", "-t", "tree", "-w", "--stdin", "--literally", text=raw)


def commit(root: bytes) -> str:
    return git("commit-tree", root.decode(), "-m", "x").decode()


@pytest.mark.parametrize("name", [b"..", b".git", b".GIT"])
def test_a_name_that_leads_elsewhere_is_refused(name: bytes, repository: Git, tmp_path: Path) -> None:
    inner = tree((b"100644", blob(b"x"), b"spy.py"))
    with pytest.raises(GitError):
        write_commit(repository, commit(tree((b"40000", inner, name))), str(tmp_path / "out"))
    assert not (tmp_path / "spy.py").exists()


def test_nothing_is_written_through_a_link(repository: Git, tmp_path: Path) -> None:
    """A link and a folder of one name; in the folder a file, or another link."""
    outside = tmp_path / "outside"
    outside.mkdir()
    link = blob(str(outside).encode())
    for mode in (b"100644", b"120000"):
        inner = tree((mode, blob(b"x"), b"spy.py"))
        root = tree((b"120000", link, b"a"), (b"40000", inner, b"a"))
        with pytest.raises(GitError):
            write_commit(repository, commit(root), str(tmp_path / f"out{mode.decode()}"))
    assert not list(outside.iterdir())


def test_links_that_lead_out_by_a_detour(repository: Git, tmp_path: Path) -> None:
    (tmp_path / "secret").write_text("secret", encoding="utf-8")
    root = tree(
        (b"120000", blob(b"."), b"a"),
        (b"120000", blob(b"a/../secret"), b"b"),
        (b"120000", blob(b"loop"), b"loop"),
    )
    notes = write_commit(repository, commit(root), str(tmp_path / "out"))
    assert not (tmp_path / "out" / "b").is_symlink()
    assert "the symbolic link b leads out of the sources and is not followed" in notes


def test_trees_that_stand_for_endless_files_are_refused(
    repository: Git, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Ten trees, each with the one before under ten names: ten thousand million files."""
    monkeypatch.setattr("rosward.git.git._LONGEST_LISTING", 2_000_000)  # to be quick
    root = tree((b"100644", blob(b"x"), b"f.py"))
    for _ in range(10):
        root = tree(*((b"40000", root, f"d{n}".encode()) for n in range(10)))
    with pytest.raises(GitError, match=r"more than|bytes"):
        write_commit(repository, commit(root), str(tmp_path / "out"))


def test_what_is_too_large_keeps_its_size_and_no_content(repository: Git, tmp_path: Path) -> None:
    root = tree((b"100644", blob(b"a" * 9_000_000), b"big.py"), (b"100644", blob(b"png"), b"x.png"))
    assert write_commit(repository, commit(root), str(tmp_path / "out")) == ()
    sizes = {p.name: (p.stat().st_size, p.read_bytes().strip(b"\0")) for p in (tmp_path / "out").iterdir()}
    assert sizes == {"big.py": (9_000_000, b""), "x.png": (3, b"")}


def test_a_tracked_folder_that_is_now_a_link_is_not_read_through(repository: Git, tmp_path: Path) -> None:
    """To git what it tracked in it is deleted; what lies behind the link is not of the repository."""
    outside = tmp_path / "outside"
    outside.mkdir()
    (outside / "spy.py").write_text("secret", encoding="utf-8")
    work = tmp_path / "ws"
    (work / "a").mkdir()
    (work / "a/spy.py").write_text("x = 1", encoding="utf-8")
    (work / ".gitignore").write_text("a\n", encoding="utf-8")
    git("add", "-f", "a/spy.py")
    (work / "a/spy.py").unlink()
    (work / "a").rmdir()
    (work / "a").symlink_to(outside)
    write_work_tree(repository, str(tmp_path / "out"))
    assert [p.name for p in (tmp_path / "out").rglob("*")] == [".gitignore"]


def test_a_work_tree_elsewhere_is_refused(repository: Git, tmp_path: Path) -> None:
    """The configuration comes with the repository, and can name any folder."""
    other = tmp_path / "other"
    other.mkdir()
    git("init", "-q", str(other))
    (other / "secret.py").write_text("secret", encoding="utf-8")
    git("config", "core.worktree", str(other))
    with pytest.raises(GitError, match="another repository"):
        write_work_tree(Git(str(repository.top)), str(tmp_path / "out"))
    assert not list(tmp_path.glob("out/*"))


def test_objects_with_long_names_are_read(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "ws").mkdir()
    monkeypatch.chdir(tmp_path / "ws")
    monkeypatch.setenv("HOME", str(tmp_path))
    git("init", "-q", "--object-format=sha256")
    (tmp_path / "ws/a.py").write_text("x = 1", encoding="utf-8")
    git("add", "a.py")
    git("commit", "-q", "-m", "x")
    repository = Git(str(tmp_path / "ws"))
    assert write_commit(repository, repository.commit("HEAD"), str(tmp_path / "out")) == ()
    assert (tmp_path / "out/a.py").read_text(encoding="utf-8") == "x = 1"


@pytest.mark.parametrize("lines", [10_000, 60], ids=["many", "a few too many"])
def test_objects_that_are_borrowed_from_everywhere(repository: Git, lines: int) -> None:
    """git compares each folder with all others: ten thousand of them would take it minutes."""
    borrowed = Path(repository.top, ".git/objects/info/alternates")
    borrowed.write_text("".join(f"/nowhere/{number}\n" for number in range(lines)), encoding="utf-8")
    with pytest.raises(GitError, match="more than 50 others"):
        Git(repository.top)
    borrowed.write_text("../../.git/objects\n# itself\n\n\0\n", encoding="utf-8")
    with pytest.raises(GitError, match="more than 50 others"):
        Git(repository.top)
    borrowed.write_text("/nowhere\n", encoding="utf-8")
    assert Git(repository.top).top == repository.top
