# SPDX-License-Identifier: Apache-2.0
"""The two sides that `rosward diff` compares: files, folders, or what git has of a commit and of the work tree.

rosward diff old.json new.json                two files
rosward diff old_ws new_ws                    two folders, each extracted with the same options
rosward diff --git main..HEAD src             src at both commits, each in a temporary folder
"""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from rosward.cli.shared import WrongUseError, extracted, request_of
from rosward.guard import Steps
from rosward.records import NamedTuple
from rosward.safe import printable
from rosward.source.exclude import Exclusion

if TYPE_CHECKING:
    from rosward.diff.compare import Differences
    from rosward.diff.snapshot import ComparedState
    from rosward.git.git import Git

__all__ = ["differences"]


class _Side(NamedTuple):
    """One of two states of the same sources: it is in `folder`, and stands for what is in `around`; `here` is where the command runs, in it."""

    name: str
    folder: str
    around: tuple[str, ...]
    here: str

    def place(self, path: str) -> str:
        """A path of an option, as it is on this side; what is in neither stays."""
        absolute = os.path.abspath(path)  # noqa: PTH100
        for around in self.around:
            if absolute == around or absolute.startswith(f"{around.rstrip(os.sep)}{os.sep}"):
                return os.path.normpath(os.path.join(self.folder, os.path.relpath(absolute, around)))  # noqa: PTH118
        inside = os.path.join(self.here, path)  # noqa: PTH118
        return inside if os.path.lexists(inside) else path


def differences(options: argparse.Namespace) -> Differences:
    """What came and went, from the first side to the second. Raises WrongUseError."""
    from rosward.diff.compare import compare
    from rosward.source.json_fields import UnreadableError

    try:
        if options.git is not None:
            return _of_git(options)
        if len(options.paths) != 2:
            raise WrongUseError("pass two files or folders, OLD and NEW, or commits with --git OLD..NEW")
        if all(map(os.path.isdir, options.paths)):
            old, new = (os.path.abspath(p) for p in options.paths)  # noqa: PTH100
            sides = [_Side(p, p, (old, new), p) for p in (old, new)]
            return _of_sources(options, sides, [[side.folder] for side in sides])
        first, second = (_of_file(path) for path in options.paths)
    except UnreadableError as error:
        raise WrongUseError(str(error)) from error
    if first.kind != second.kind:
        raise WrongUseError(
            f"{options.paths[0]} is a {first.kind}, {options.paths[1]} a {second.kind}: both must be of the same kind"
        )
    return compare(first, second)


def _of_file(path: str) -> ComparedState:
    from rosward.diff.compare import read_snapshot

    if os.path.isdir(path):  # noqa: PTH112
        raise WrongUseError(f"{path} is a folder: compare two folders or two files")
    return read_snapshot(path)


def _of_git(options: argparse.Namespace) -> Differences:
    from rosward.git.folders import scratch_folder
    from rosward.git.git import Git, GitError
    from rosward.git.tree import write_commit, write_work_tree

    with scratch_folder() as scratch:
        try:
            git = Git(os.getcwd())  # noqa: PTH109
            top = os.path.realpath(git.top)
            names = _revisions(git, options.git)
            sides, notes = [], dict[str, None]()
            for number, (name, commit) in enumerate(names):
                folder = os.path.join(scratch, str(number), os.path.basename(top) or "root")  # noqa: PTH118, PTH119
                told = write_work_tree(git, folder) if commit is None else write_commit(git, commit, folder)
                notes.update(dict.fromkeys(f"{name}: {note}" for note in told))
                here = os.path.join(folder, os.path.relpath(os.path.realpath("."), top))  # noqa: PTH118
                sides.append(_Side(name, folder, tuple(dict.fromkeys((top, git.top))), os.path.normpath(here)))
        except GitError as error:
            raise WrongUseError(f"--git: {error}") from error
        paths = [[side.place(p) for p in options.paths or ["."]] for side in sides]
        for at, path in enumerate(options.paths or ["."]):
            if not any(each[at].startswith(f"{side.folder}") for each, side in zip(paths, sides, strict=True)):
                raise WrongUseError(f"{path} is not in the repository {top}")
            if not any(os.path.lexists(each[at]) for each in paths):
                raise WrongUseError(f"{path} is in neither {names[0][0]} nor {names[1][0]}")
        found = _of_sources(options, sides, paths)
        return found._replace(notes=(*notes, *found.notes))


def _revisions(git: Git, text: str) -> list[tuple[str, str | None]]:
    """Names and commits of both sides; None for the work tree. A…B is as in `git diff`: from their common ancestor."""
    for mark in ("...", ".."):
        one, found, other = text.partition(mark)
        if found:
            old, new = git.commit(one or "HEAD"), git.commit(other or "HEAD")
            return [(one or "HEAD", git.common(old, new) if mark == "..." else old), (other or "HEAD", new)]
    return [(text, git.commit(text)), ("the work tree", None)]


def _of_sources(options: argparse.Namespace, sides: Sequence[_Side], paths: Sequence[list[str]]) -> Differences:
    from rosward.diff.compare import compare, not_compared

    _check(options, sides)
    snapshots, told, steps = [], [], Steps()
    for side, wanted in zip(sides, paths, strict=True):
        there = [path for path in wanted if os.path.lexists(path)]
        try:
            if not there:
                raise WrongUseError("none of the compared paths exists there")
            snapshots.append(_snapshot(options, side, there, steps))
        except WrongUseError as error:
            told.append((side, error))
            snapshots.append(_nothing())
    if len(told) > 1:
        raise told[0][1]
    notes = tuple(
        f"{side.name}: {_relative(str(error), side)}; nothing is started on that side" for side, error in told
    )
    for note in notes:
        print(f"rosward: {printable(note)}", file=sys.stderr)  # noqa: T201
    old, new = snapshots
    found = not_compared(steps.findings) if old is None or new is None else compare(old, new)
    return found._replace(notes=(*notes, *found.notes))


def _check(options: argparse.Namespace, sides: Sequence[_Side]) -> None:
    """What an option names has to be on one side at least."""
    for key in ("models", "underlay", "params"):
        for path in getattr(options, key):
            if not any(os.path.exists(side.place(path)) for side in sides):  # noqa: PTH110
                raise WrongUseError(f"--{key}: {path} exists on neither side")


def _relative(message: str, side: _Side) -> str:
    return message.replace(f"{side.folder}{os.sep}", "").replace(side.folder, ".")


def _nothing() -> ComparedState:
    from rosward.diff.snapshot import ComparedState
    from rosward.policies.records import Policy

    return ComparedState("network", frozenset(), frozenset(), Policy(()))


def _snapshot(options: argparse.Namespace, side: _Side, paths: list[str], steps: Steps) -> ComparedState | None:
    from rosward.diff.of_nodes import snapshot_of

    own = _moved(options, side)
    own.no_cache |= bool(options.git)  # its folder is another one each time
    result = extracted(own, paths, request_of(own))
    missing = "nothing was compared"
    return steps(lambda: snapshot_of(result.network.nodes, side.name), None, missing)


def _moved(options: argparse.Namespace, side: _Side) -> argparse.Namespace:
    """The options with their paths on this side. What is not there is left out, as if it were not yet written."""
    moved: dict[str, Any] = {
        key: [path for path in map(side.place, getattr(options, key)) if os.path.exists(path)]  # noqa: PTH110
        for key in ("models", "underlay", "params")
    }
    moved["launch"] = [_launch(text, side) for text in options.launch]
    moved["exclude"] = [
        Exclusion(side.place(e.base), e.pattern) if isinstance(e, Exclusion) else Exclusion(side.here, e)
        for e in options.exclude
    ]
    if options.enclaves is not None and options.enclaves.endswith(".toml"):
        moved["enclaves"] = side.place(options.enclaves)
    return argparse.Namespace(**{**vars(options), **moved})


def _launch(text: str, side: _Side) -> str:
    """A launch file as `--launch` takes it: `PKG:FILE` is found by its package, a path is moved."""
    file, comma, arguments = text.partition(",")
    by_package = ":" in file and not os.path.exists(file)  # noqa: PTH110
    return text if by_package else f"{side.place(file)}{comma}{arguments}"
