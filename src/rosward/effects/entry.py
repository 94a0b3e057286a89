# SPDX-License-Identifier: Apache-2.0
"""Where does a process start?"""

from __future__ import annotations

from rosward.records import NamedTuple


class Entry(NamedTuple):
    """How a process starts: the file, run as `__main__`, or imported and then a function of it called, or classes of it instantiated.

    `program`: of a language with a linker, what the process is linked of (`engine.found.Sources.program`); then the function or class is one of it,
    and `file` the source that it is named after. `host`: the function template of a model that makes the class, where it is no component.
    """

    file: str
    module: str
    function: str = ""
    classes: tuple[str, ...] = ()
    package: str | None = None
    executable: str | None = None
    label: str = ""
    probe: bool = False  # counts only where it makes a node
    assumed: bool = False  # nothing is known to start it
    program: str = ""
    host: str = ""
