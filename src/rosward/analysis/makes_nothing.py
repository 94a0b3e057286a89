# SPDX-License-Identifier: Apache-2.0
"""Which files have to do with ROS by name alone: they ask where a package is installed, or expand a description, and make nothing of ROS?

from ament_index_python.packages import get_package_share_directory     a converter of files: it is no part of the system
… and subprocess.run(["ros2", "run", …])                                it starts what is one, and is followed
"""

from __future__ import annotations

import re
from collections.abc import Container, Iterable, Mapping
from typing import TYPE_CHECKING, Final

from rosward.source import limits
from rosward.source.text import read_bytes

if TYPE_CHECKING:
    from rosward.analysis.source_tree import SourceTree
    from rosward.source.workspace import SourceFile

LIBRARIES: Final = frozenset(("ament_index_python", "xacro"))
"""Modelled libraries of ROS with which nothing can be made, read or sent."""

_LEADS_ELSEWHERE: Final = re.compile(
    rb"\b(?:exec\w*|eval|__import__|__builtins__|builtins|import_module|importlib|imp|runpy|pkgutil|pkg_resources|zipimport|ctypes"
    rb"|subprocess\w*|create_subprocess\w*|system|[pP]open\w*|p?spawn\w*|posix_spawn\w*|fork\w*|startfile|pty|pexpect"
    rb"|attrgetter|methodcaller|__getattribute__)\b"
    rb"|\bgetattr\b(?!\s*\(\s*[\w.]+\s*,\s*(['\"])\w+\1\s*[,)])"  # getattr(os, name): any of these; a name that stands there is read as such
)
"""What may run code that the file does not import, or start a program."""
_SYS: Final = re.compile(rb"\bsys\b")
_PATH: Final = re.compile(rb"\bpath\b")


def makes_nothing(
    candidates: Iterable[str],
    related: Container[str],
    importers: Mapping[str, set[str]],
    files: Mapping[str, SourceFile],
    sources: SourceTree,
) -> set[str]:
    """Those of these files that cannot do more than what they import, and import none that can have to do with ROS.

    `importers` has the files that import each one. One that changes `sys.path` may import any file of such a name.
    """
    imported: dict[str, set[str]] = {}
    for file, by in importers.items():
        for each in by:
            imported.setdefault(each, set()).add(file)
    leading: dict[str, set[str] | None] = {}
    found = set()
    for candidate in candidates:
        seen, work = {candidate}, [candidate]
        while work:
            file = work.pop()
            if file not in leading:
                leading[file] = _leads_to(file, imported.get(file, set()), files, sources)
            further = leading[file]
            if further is None or file in related:
                break
            work += further - seen
            seen |= further
        else:
            found.add(candidate)
    return found


def _leads_to(file: str, imported: set[str], files: Mapping[str, SourceFile], sources: SourceTree) -> set[str] | None:
    """The files that a file runs by importing them; None where it may run others, or start a program."""
    source, module = files.get(file), sources.module(file)
    text = None if source is None else read_bytes(source.path, file, limits.PYTHON_FILE)
    if module is None or not isinstance(text, bytes) or _LEADS_ELSEWHERE.search(text):
        return None
    found = _SYS.search(text)
    if found is None or not _PATH.search(text, found.end()):
        return imported
    names = {
        ".".join(name.split(".")[:end])
        for name in module.imports
        if name[0] != "."
        for end in range(1, name.count(".") + 2)
    }
    return imported.union(*({each.file for _, each in sources.named(name)} for name in names))
