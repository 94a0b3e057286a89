# SPDX-License-Identifier: Apache-2.0
"""What does the preprocessor leave of a file, and what does it say beside?"""

from __future__ import annotations

from rosward.findings import Finding
from rosward.records import NamedTuple


class Choice(NamedTuple):
    """The lines `first` to `last` stand in branch number `branch` of the condition number `condition`, which nobody knows.

    Branches of one condition exclude each other; without `complete` it may be that none of them is taken.
    """

    condition: int
    branch: int
    first: int
    last: int
    complete: bool


class Registration(NamedTuple):
    """`RCLCPP_COMPONENTS_REGISTER_NODE(demo::Driver)` and the like, with its arguments."""

    macro: str
    arguments: tuple[str, ...]
    line: int


class Prepared(NamedTuple):
    """One file without comments, directives and macros, line by line where it was.

    `includes` are the files of the workspace that it includes, in their order, `external` the names of other headers. On the lines
    `expanded` a macro was expanded: their columns are not those of the file.
    """

    path: str
    file: str
    text: str
    includes: tuple[str, ...] = ()
    external: tuple[str, ...] = ()
    choices: tuple[Choice, ...] = ()
    registrations: tuple[Registration, ...] = ()
    expanded: frozenset[int] = frozenset()
    findings: tuple[Finding, ...] = ()


class Translation(NamedTuple):
    """A source with all headers of the workspace that it includes: each file once, an included one before what includes it."""

    main: str
    files: tuple[Prepared, ...]
    findings: tuple[Finding, ...] = ()
