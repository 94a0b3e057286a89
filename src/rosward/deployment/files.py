# SPDX-License-Identifier: Apache-2.0
"""Which file is behind a path that a launch file names?

    find-pkg-share demo + '/launch/left.launch.py'    ->  'src/demo/launch/left.launch.py'
    'config/left.yaml' of the folder of the sources   ->  'config/left.yaml'
    '/home/me/left.yaml'                              ->  None

Files are named as in the workspace; those of an install prefix by their whole path.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final, final

from rosward.domain.text import parts_of
from rosward.domain.unknown import Cause
from rosward.domain.values import Choice, Hole, Unknown, Value
from rosward.engine.sources.remembered import memory_here
from rosward.models.file_paths import Location, location_of, path_of

if TYPE_CHECKING:
    from rosward.source.installed import Installed
    from rosward.source.workspace import SourceFile

_WORDS: Final = ((Cause.SHARE, "find-pkg-share"), (Cause.PREFIX, "find-pkg-prefix"))


@final
class WorkspaceFiles:
    """Implements `deployment.execution.launch_files.LaunchFiles` for a workspace and its underlays."""

    def __init__(self, installed: Installed) -> None:
        self._installed = installed

    def find(self, path: Value) -> str | None:
        """The name of the file behind an abstract path (not a Choice), None where there is none."""
        file = self._file(path)
        return None if file is None else file.relative

    def listing(self, path: Value) -> tuple[str, ...]:
        """The names in the folder at an abstract path; none where they are not all known."""
        location = location_of(path)
        if location is None or not location.package:
            return ()
        return self._installed.listing(location.package, location.relative) or ()

    def text(self, file: str) -> str | None:
        """The text of a file that was found; None where it is too large or no text."""
        memory = memory_here()
        if memory is not None:
            memory.touched.add(file)
        found = self._installed.file(file)
        return None if found is None else self._installed.text(found)

    def has_package(self, package: str) -> bool:
        """Whether a package is among the sources or in an underlay."""
        return self._installed.has_package(package)

    def show(self, path: Value) -> str:
        """A path for people: `$(find-pkg-share p)/x.yaml`, `*` for what is not known of it."""
        if isinstance(path, Choice):
            return " | ".join(self.show(option) for option in path.options)
        return "".join(part if isinstance(part, str) else _hole_text(part) for part in parts_of(path))

    def place_value(self, file: str) -> Value:
        """The path under which a file is installed: the inverse of `find`; that in the sources for a file outside of packages."""
        place = self._installed.place_of(file)
        if place is not None:
            return path_of(Location(*place))
        return path_of(Location("", file)) if not file.startswith("/") else Unknown((), "str")

    def _file(self, path: Value) -> SourceFile | None:
        location = location_of(path)
        if location is None or not location.relative:
            return None
        if location.package:
            return self._installed.share(location.package, location.relative)
        return self._installed.source(location.relative)


def _hole_text(hole: Hole) -> str:
    folders = {(reason.cause, reason.subject) for reason in hole.reasons}
    if len(folders) == 1:
        cause, package = folders.pop()
        for known, word in _WORDS:
            if cause is known:
                return f"$({word} {package})"
        if cause is Cause.SOURCES:
            return "."
    return "*"
