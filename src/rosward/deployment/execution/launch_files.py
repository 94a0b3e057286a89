# SPDX-License-Identifier: Apache-2.0
"""What does the execution ask of the files that launch files name?"""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol

if TYPE_CHECKING:
    from rosward.domain.values import Value


class LaunchFiles(Protocol):
    """The files that launch files name."""

    def find(self, path: Value) -> str | None:
        """The workspace-relative name of the file behind an abstract path, None where there is none."""

    def text(self, file: str) -> str | None:
        """The text of a file, named as in the workspace."""

    def has_package(self, package: str) -> bool:
        """Whether a package is among the sources."""

    def show(self, path: Value) -> str:
        """A path for people: '$(find-pkg-share p)/x.yaml'."""
