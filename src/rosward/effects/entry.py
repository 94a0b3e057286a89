# SPDX-License-Identifier: Apache-2.0
"""Where does a process start?"""

from __future__ import annotations

from typing import NamedTuple


class Entry(NamedTuple):
    """How a process starts: the file, run as `__main__`, or imported and then a function of it called, or classes of it instantiated."""

    file: str
    module: str
    function: str = ""
    classes: tuple[str, ...] = ()
    package: str | None = None
    executable: str | None = None
    label: str = ""
    probe: bool = False  # counts only where it makes a node
    assumed: bool = False  # nothing is known to start it
