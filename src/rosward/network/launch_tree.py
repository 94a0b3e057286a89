# SPDX-License-Identifier: Apache-2.0
"""What launch files start, in plain words: the records that `launch-tree` prints and the comparison with the real launch reads."""

from __future__ import annotations

from typing import Final

from rosward.location import Place
from rosward.records import NamedTuple

CONTAINER: Final = "container:"
"""How the label of a process begins that only components tell of: the name of their container follows."""


class Shown(NamedTuple):
    """A value as text, `*` for what is not known, and where it comes from ('' : written in the launch file itself)."""

    text: str
    source: str = ""


class GivenParameter(NamedTuple):
    """A parameter that a node is given; `kind` is global, rule, dict or file (then `value` is its path), `scope` the key in a dict."""

    kind: str
    name: str
    value: Shown
    scope: str
    place: Place | None


class Inclusion(NamedTuple):
    """An include: where it is written, the file that it includes, and a number that tells its turns apart."""

    place: Place
    file: str
    turn: int


class LaunchEntry(NamedTuple):
    """One node, component, container or process. `program` says what is behind it: its source, a declaration, or why that is not known.

    `trail` are the includes that lead to it, outermost first; `event` is what has to happen before it is started.
    """

    kind: str
    package: Shown | None
    executable: Shown | None
    plugin: Shown | None
    container: Shown | None
    name: Shown | None
    namespace: Shown | None
    remaps: tuple[tuple[Shown, Shown], ...]
    parameters: tuple[GivenParameter, ...]
    words: tuple[Shown, ...]
    environment: tuple[tuple[str, Shown], ...]
    place: Place
    trail: tuple[Inclusion, ...]
    program: str
    conditional: bool
    why: tuple[str, ...]
    event: str


class LaunchSystem(NamedTuple):
    """All that one launch file starts (`name` as the user asked for it)."""

    name: str
    file: str
    entries: tuple[LaunchEntry, ...]
