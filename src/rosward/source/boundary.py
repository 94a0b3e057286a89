# SPDX-License-Identifier: Apache-2.0
"""Does a link lead out of what the user named?

    named: /ws          /ws/src/nodes -> /ws/shared/nodes      inside: it is read
                        /ws/src/home  -> /home/me          outside: it is not read, and RW012 says so

Whoever writes a repository chooses its links; whoever runs rosward chooses the folders. So links are followed only within those, unless
`--follow-links` asks for more.
"""

from __future__ import annotations

import os
from collections.abc import Iterable
from typing import Final, final

from rosward.source import disk

__all__ = ["EVERYWHERE", "Boundary"]


@final
class Boundary:
    """The folders that links may lead into: those of `named` paths, by their real path. With `follow`, any."""

    __slots__ = ("_follow", "_roots")

    def __init__(self, named: Iterable[str] = (), *, follow: bool = False) -> None:
        self._follow = follow
        self._roots: list[str] = []
        for path in named:
            self.extend(path)

    def extend(self, path: str) -> None:
        """Links may lead into this folder, too; of a file, into the folder that it really stands in."""
        real = disk.real_path(path)
        root = real if disk.is_folder(real) else os.path.dirname(real)  # noqa: PTH120
        if root not in self._roots:
            self._roots.append(root)

    def leads_out(self, path: str) -> bool:
        """Whether the link at a path leads to something that is there, and outside."""
        if self._follow:
            return False
        real = disk.real_path(path)
        return disk.exists(real) and not any(
            real == root or real.startswith(root.rstrip(os.sep) + os.sep) for root in self._roots
        )


EVERYWHERE: Final = Boundary(follow=True)
"""Links may lead anywhere."""
