# SPDX-License-Identifier: Apache-2.0
"""Which values can an environment variable have of which a path is made? Those for which there is a file.

$(find-pkg-share demo)/param/$(env MODEL).yaml, with param/burger.yaml and param/waffle.yaml    MODEL: 'burger', 'waffle'
"""

from __future__ import annotations

from typing import Protocol, final

from rosward.deployment.execution.launch_files import LaunchFiles
from rosward.domain.text import make, parts_of
from rosward.domain.unknown import Cause, Reason
from rosward.domain.values import Hole, Value
from rosward.effects.variables import Variables

__all__ = ["NamedFiles"]


class Folders(LaunchFiles, Protocol):
    """Files, and what is in their folders."""

    def listing(self, path: Value) -> tuple[str, ...]:
        """The names in the folder at an abstract path; none where they are not all known."""


@final
class NamedFiles:
    """The files of a launch, which keep in mind by which variables they are named."""

    def __init__(self, files: Folders, variables: Variables) -> None:
        self._files = files
        self._variables = variables
        self.text = files.text
        self.has_package = files.has_package
        self.show = files.show

    def find(self, path: Value) -> str | None:
        """The name of the file behind an abstract path, None where there is none."""
        found = self._files.find(path)
        if found is None:
            self._look(path)
        return found

    def _look(self, path: Value) -> None:
        parts = parts_of(path)
        for index, part in enumerate(parts):
            reason = _variable(part)
            if reason is None:
                continue
            before, behind = parts[index - 1] if index else "", "".join(map(_plain, parts[index + 1 : index + 2]))
            if isinstance(before, str) and "/" in before:
                folder, _, start = before.rpartition("/")
                end = behind.partition("/")[0]
                names = self._files.listing(make((*parts[: index - 1], folder)))
                values = [n[len(start) : len(n) - len(end)] for n in names if _fits(n, start, end)]
                self._variables.named(reason.subject, values, reason.place)
            return


def _fits(name: str, start: str, end: str) -> bool:
    return name.startswith(start) and name.endswith(end) and len(name) > len(start) + len(end)


def _plain(part: str | Hole) -> str:
    return part if isinstance(part, str) else ""


def _variable(part: str | Hole) -> Reason | None:
    """The variable that a part of a path stands for."""
    only = part.reasons[0] if isinstance(part, Hole) and len(part.reasons) == 1 else None
    return only if only is not None and only.cause is Cause.ENVIRONMENT else None
