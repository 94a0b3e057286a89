# SPDX-License-Identifier: Apache-2.0
"""Which repositories are surveyed, and what is each called?

    repositories_in("checkouts")                        each folder in it, by its name
    repositories_of([b"/data/a", b"b"], "/data")        a, b: relative to the folder of the list if below it, else the whole path

Each folder is there once, by the first of its names. Names are what Parquet can hold: a byte that is no UTF-8 is `\\xff`, and of two names that
would be the same one gets `#2`.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator
from typing import Final

from rosward.records import NamedTuple
from rosward.safe import printable

__all__ = ["Found", "Repository", "SurveyError", "check_output", "repositories_at", "repositories_of"]

_MOST_BYTES: Final = 2**28
"""Of a list."""


class SurveyError(Exception):
    """A survey that cannot be carried out; the message says why."""


class Repository(NamedTuple):
    """One repository: its name in the tables, and its folder, absolute."""

    name: str
    path: str


class Found(NamedTuple):
    """The repositories, sorted; how many entries were links, and how many a folder that was there already."""

    repositories: tuple[Repository, ...]
    links: int = 0
    duplicates: int = 0


def repositories_at(path: str, output: str, *, null: bool = False) -> Found:
    """Those in a folder, or those that a file lists, one a line, or each ended by a NUL. Raises SurveyError."""
    try:
        if os.path.isdir(path):  # noqa: PTH112
            return _in_folder(path, output)
        with open(path, "rb") as file:  # noqa: PTH123  it may be a pipe
            text = file.read(_MOST_BYTES + 1)
    except OSError as error:
        raise SurveyError(f"cannot read {path}: {error.strerror or error}") from error
    if len(text) > _MOST_BYTES:
        raise SurveyError(f"{path} is larger than {_MOST_BYTES // 2**20} MB")
    if not null and b"\0" in text:
        raise SurveyError(f"{path} is no list of paths: it has NUL characters; use --null if they separate the paths")
    paths = (line.removesuffix(b"\r") if not null else line for line in text.split(b"\0" if null else b"\n"))
    found = repositories_of([p for p in paths if p], os.path.dirname(path) or ".")  # noqa: PTH120
    if not found.repositories:
        raise SurveyError(f"{path} lists no repository")
    return found


def _in_folder(folder: str, output: str) -> Found:
    links, paths = 0, []
    own = os.path.realpath(output)
    if own == os.path.realpath(folder):
        raise SurveyError("the output folder is the folder with the repositories; choose another one with -o")
    with os.scandir(os.fsencode(folder)) as entries:
        for entry in entries:
            if entry.name.startswith(b"."):
                continue
            if entry.is_symlink():
                links += os.path.isdir(entry.path)  # noqa: PTH112
            elif entry.is_dir() and os.path.realpath(os.fsdecode(entry.path)) != own:
                paths.append(entry.name)
    if not paths:
        raise SurveyError(f"{folder} contains no folders; each folder in it is one repository")
    return repositories_of(paths, folder)._replace(links=links)


def repositories_of(paths: Iterable[str | bytes | os.PathLike[str]], base: str) -> Found:
    """Those at several paths, relative ones below a folder."""
    base = os.path.abspath(base)  # noqa: PTH100
    sorted_paths = sorted(os.path.normpath(os.path.join(os.fsencode(base), os.fsencode(path))) for path in paths)  # noqa: PTH118
    by_place: dict[bytes, bytes] = {}
    for path in sorted(sorted_paths, key=_is_link):
        by_place.setdefault(_place(path), path)
    kept = sorted(by_place.values())
    named = zip(_names(kept, os.fsencode(base)), kept, strict=True)
    repositories = sorted(Repository(name, os.fsdecode(path)) for name, path in named)
    return Found(tuple(repositories), duplicates=len(sorted_paths) - len(kept))


def _is_link(path: bytes) -> bool:
    return b"\0" not in path and os.path.islink(path)  # noqa: PTH114


def _place(path: bytes) -> bytes:
    try:
        return os.path.realpath(path)
    except (OSError, ValueError):
        return path


def _names(paths: list[bytes], base: bytes) -> Iterator[str]:
    taken: set[str] = set()
    for path in paths:
        short = path.removeprefix(base.rstrip(b"/") + b"/").decode("utf-8", "backslashreplace")
        name, number = short, 1
        while name in taken:
            number += 1
            name = f"{short}#{number}"
        taken.add(name)
        yield name


def check_output(output: str, repositories: Iterable[Repository]) -> None:
    """Raise SurveyError where the output would be written into a repository, whose state it would change."""
    place = os.path.realpath(output)
    above = {place}
    while (parent := os.path.dirname(place)) != place:  # noqa: PTH120
        above.add(parent)
        place = parent
    for repository in repositories:
        if os.path.abspath(repository.path) in above or os.fsdecode(_place(os.fsencode(repository.path))) in above:  # noqa: PTH100
            raise SurveyError(
                f"the output folder {printable(output)} is in the repository {printable(repository.name)}; "
                "choose another one with -o"
            )
