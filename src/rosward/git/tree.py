# SPDX-License-Identifier: Apache-2.0
"""How do the files of a commit, or of the work tree, get into a folder where they can be read?

    write_commit(git, "9d1f…", "/tmp/x/ws")   ->  notes: ("submodule third_party/nav is not read",)

The user's own folder is only read. No path leads out of the new one: neither by its name nor by a symbolic link, for links are made last, and
those that lead out are taken away again. What no analysis reads, such as images, and what is too large to be read, keeps its name and size only.
"""

from __future__ import annotations

import contextlib
import os
import re
import stat
from collections.abc import Iterable, Iterator
from typing import Final

from rosward.git.folders import make_folders
from rosward.git.git import Git, GitError, TreeEntry
from rosward.records import NamedTuple

__all__ = ["write_commit", "write_work_tree"]

_LARGEST: Final = 8_000_000
_LARGEST_LINK: Final = 4_096
_ALL: Final = 2_000_000_000
_MEDIA: Final = re.compile(
    r".*\.(7z|avi|bag|bin|bmp|bz2|dae|db3|deb|dwg|fbx|gif|glb|gz|hdf5|ico|jpe?g|mcap|mov|mp[34]|np[yz]|obj|onnx|otf|pcd|pdf|pgm|pkl|ply|png"
    r"|pptx?|pth?|rar|so|stl|tar|tflite|tgz|tiff?|ttf|wav|webp|woff|xz|zip)",
    re.IGNORECASE | re.DOTALL,
)
_FILES: Final = frozenset({"100644", "100755", "100664"})
_LINK: Final = "120000"


class _Link(NamedTuple):
    path: str
    target: str


def write_commit(git: Git, commit: str, folder: str) -> tuple[str, ...]:
    """Write the files of a commit below a new folder; what of it is not there, in words. Raises GitError."""
    entries = git.entries(commit)
    notes = [f"submodule {e.path} is not read" for e in entries if e.kind == "commit"]
    files = [e for e in entries if e.mode in _FILES]
    read = [e for e in files if not _is_bulk(e.path, e.size or 0)]
    links = [e for e in entries if e.mode == _LINK and (e.size or 0) <= _LARGEST_LINK]
    if sum(e.size or 0 for e in read) > _ALL:
        raise GitError(f"{commit[:12]} has more than {_ALL:,} bytes of source")
    os.makedirs(folder)  # noqa: PTH103
    for entry in files:
        if _is_bulk(entry.path, entry.size or 0):
            _write(folder, entry.path, b"", entry.size or 0)
    for entry, data in _with_contents(git, read):
        _write(folder, entry.path, data, len(data))
    made = [_Link(entry.path, os.fsdecode(data)) for entry, data in _with_contents(git, links)]
    return (*notes, *_link(folder, made))


def write_work_tree(git: Git, folder: str) -> tuple[str, ...]:
    """The same of the work tree: what git knows, and what it does not ignore. Raises GitError."""
    notes: list[str] = []
    links: list[_Link] = []
    total = 0
    top = os.path.realpath(git.top)
    paths = git.work_tree()
    plain = {inner for inner in {os.path.dirname(p) for p in paths} if _is_plain(top, inner)}  # noqa: PTH120
    os.makedirs(folder)  # noqa: PTH103
    for path in paths:
        there = os.path.join(top, path)  # noqa: PTH118
        if os.path.dirname(path) not in plain:  # noqa: PTH120
            continue  # a link has taken the place of the folder: deleted, as git sees it
        try:
            status = os.lstat(there)
        except OSError:
            continue  # deleted, not yet committed
        if stat.S_ISLNK(status.st_mode):
            with contextlib.suppress(OSError):
                links.append(_Link(path, os.readlink(there)))  # noqa: PTH115
        elif stat.S_ISDIR(status.st_mode):
            notes.append(f"submodule {path.rstrip('/')} is not read")
        elif stat.S_ISREG(status.st_mode):
            total += 0 if _is_bulk(path, status.st_size) else status.st_size
            if total > _ALL:
                raise GitError(f"the work tree has more than {_ALL:,} bytes of source")
            _write(folder, path, b"" if _is_bulk(path, status.st_size) else _content(there, path), status.st_size)
    return (*notes, *_link(folder, links))


def _is_plain(top: str, inner: str) -> bool:
    """Whether a folder below the real path `top` is reached without a symbolic link."""
    there = os.path.join(top, inner) if inner else top  # noqa: PTH118
    return os.path.realpath(there) == there


def _is_bulk(path: str, size: int) -> bool:
    """Whether only name and size are kept; a file that is too large to be read is then told as that."""
    return size > _LARGEST or _MEDIA.fullmatch(path) is not None


def _with_contents(git: Git, entries: list[TreeEntry]) -> Iterator[tuple[TreeEntry, bytes]]:
    return zip(entries, git.contents(e.name for e in entries), strict=True)


def _content(path: str, name: str) -> bytes:
    try:
        handle = os.open(path, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK)
        with os.fdopen(handle, "rb") as file:
            return file.read(_LARGEST)
    except OSError as error:
        raise GitError(f"{name} cannot be read: {error.strerror or error}") from error


def _place(folder: str, path: str) -> str:
    """Where a path of the repository is; its name alone must not lead elsewhere."""
    parts = path.split("/")
    if any(part in ("", ".", "..") or part.lower() == ".git" or "\0" in part for part in parts):
        raise GitError(f"{path!r} is not a valid file name")
    return os.path.join(folder, *parts)  # noqa: PTH118


def _write(folder: str, path: str, data: bytes, size: int) -> None:
    place = _place(folder, path)
    with _os_errors_named(path):
        make_folders(os.path.dirname(place))  # noqa: PTH120
        with open(place, "xb") as file:  # noqa: PTH123
            file.write(data)
            if len(data) < size:
                file.truncate(size)


@contextlib.contextmanager
def _os_errors_named(path: str) -> Iterator[None]:
    try:
        yield
    except OSError as error:
        raise GitError(f"{path} cannot be written: {error.strerror or error}") from error


def _link(folder: str, links: Iterable[_Link]) -> list[str]:
    """Make the links that stay within the folder; the others, in words."""
    notes: list[str] = []
    made: list[tuple[str, str]] = []
    wanted = [(link, _place(folder, link.path)) for link in links if link.target and "\0" not in link.target]
    for link, place in wanted:  # all folders before any link: none is made through a link
        with _os_errors_named(link.path):
            make_folders(os.path.dirname(place))  # noqa: PTH120
    for link, place in wanted:
        with _os_errors_named(link.path):
            os.symlink(link.target, place)  # noqa: PTH211
        made.append((link.path, place))
    inside = os.path.join(os.path.realpath(folder), "")  # noqa: PTH118
    outside = [(path, place) for path, place in made if not f"{os.path.realpath(place)}/".startswith(inside)]
    for path, place in outside:
        os.unlink(place)  # noqa: PTH108
        notes.append(f"the symbolic link {path} leads out of the sources and is not followed")
    return notes
