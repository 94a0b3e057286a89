# SPDX-License-Identifier: Apache-2.0
"""Which file of the analysed packages does a path lead to?

os.path.join(get_package_share_directory('demo'), 'config', 'a.yaml')    Location('demo', 'config/a.yaml')
os.path.join(os.path.dirname(__file__), 'a.yaml')                        Location('', 'src/demo/demo/a.yaml')
Path(get_package_prefix('demo')) / 'share/demo/a.yaml'                   Location('demo', 'a.yaml')
'/etc/robot.yaml'                                                        None: no file of the sources

A path of the sources is a text that begins with a hole for the folder and goes on with known text.
"""

from __future__ import annotations

import re
from typing import Final, Protocol

from rosward.domain.text import make, parts_of
from rosward.domain.unknown import Cause, Reason
from rosward.domain.values import Hole, Text, Unknown, Value
from rosward.location import Place, names_of_path
from rosward.records import NamedTuple

_PACKAGE: Final = re.compile(r"\w[\w.-]*", re.ASCII)


class Location(NamedTuple):
    """A path below the share folder of a package, or, where `package` is '', below the folder of the sources; without `.` and `..`."""

    package: str
    relative: str


class Files(Protocol):
    """The files of the packages, as natives ask for them. `package` and `relative` are those of a `Location`."""

    def read(self, package: str, relative: str) -> str | None:
        """The text of a file; None where there is none, or it is too large or no text."""

    def is_file(self, package: str, relative: str) -> bool:
        """Whether there surely is such a file."""

    def is_folder(self, package: str, relative: str) -> bool:
        """Whether there surely is such a folder."""

    def listing(self, package: str, relative: str) -> tuple[str, ...] | None:
        """The names in a folder, sorted; None where they are not all known."""

    def name_of(self, package: str, relative: str) -> str | None:
        """The name of a file as the sources know it; None where there is none."""

    def modules(self, relative: str) -> tuple[str, ...]:
        """The files in Python, and the folders with such, in a folder of the sources, sorted."""


def location_of(value: Value) -> Location | None:
    """The location that a path (not a Choice) surely is; None for any other."""
    if not isinstance(value, Text) and not (isinstance(value, Unknown) and value.hint == "str"):
        return None
    first, *rest = parts_of(value)
    if not isinstance(first, Hole) or first.shape or len(rest) > 1:
        return None
    tail = rest[0] if rest else ""
    if not isinstance(tail, str) or (tail and not tail.startswith("/")):
        return None
    folders = {(reason.cause, reason.subject) for reason in first.reasons}
    if len(folders) != 1:
        return None
    cause, package = folders.pop()
    if cause is Cause.BESIDE:
        beside = names_of_path(f"{package}{tail}")
        return None if beside is None else Location("", "/".join(beside))
    parts = names_of_path(tail)
    if parts is None:
        return None
    if cause is Cause.SOURCES and not package:
        return Location("", "/".join(parts))
    if not _PACKAGE.fullmatch(package):
        return None
    if cause is Cause.PREFIX:
        return Location(package, "/".join(parts[2:])) if parts[:2] == ["share", package] else None
    return Location(package, "/".join(parts)) if cause is Cause.SHARE else None


def is_beside(path: Value) -> bool:
    """Whether a path begins with the folder of a module, which is not that of the sources where the module is installed."""
    first = parts_of(path)[0]
    return isinstance(first, Hole) and any(reason.cause is Cause.BESIDE for reason in first.reasons)


def path_of(location: Location) -> Value:
    """The path that leads to a location: the inverse of `location_of`."""
    cause = Cause.SHARE if location.package else Cause.SOURCES
    hole = Hole((Reason(cause, location.package, Place("", 0)),))
    return make((hole, f"/{location.relative}" if location.relative else ""))
