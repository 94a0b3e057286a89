# SPDX-License-Identifier: Apache-2.0
"""Where in the source something stands.

Place("src/demo/talker.py", 20, 9)  ->  src/demo/talker.py:20:9
"""

from __future__ import annotations

from rosward.records import NamedTuple


class Place(NamedTuple):
    """A position in a source file.

    `file` is relative to the root of the analysis and written with `/`; `line` and `column` count from 1.
    A `line` of 0 means the file as a whole.
    """

    file: str
    line: int = 0
    column: int = 1

    def __str__(self) -> str:
        return f"{self.file}:{self.line}" if self.line else self.file


def names_of_path(path: str) -> list[str] | None:
    """The names in a relative path, `.` and `..` resolved; None where it leads above its beginning."""
    names: list[str] = []
    for name in path.split("/"):
        if name == "..":
            if not names:
                return None
            names.pop()
        elif name not in ("", "."):
            names.append(name)
    return names
