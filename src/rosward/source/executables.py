# SPDX-License-Identifier: Apache-2.0
"""Where is the source of each executable that a package declares?

EntryPoint("talker", "demo.talker", "main")  ->  Executable(demo, "talker", CONSOLE_SCRIPT, demo/demo/talker.py)
install(PROGRAMS scripts/listener.py …)      ->  Executable(demo, "listener.py", SCRIPT, demo/scripts/listener.py)
"""

from __future__ import annotations

import os
import re
from typing import TYPE_CHECKING, Final

from rosward.findings import Finding
from rosward.source import disk, limits
from rosward.source.text import read_bytes
from rosward.source.workspace import Executable, ExecutableKind

if TYPE_CHECKING:
    from rosward.location import Place
    from rosward.source.imports import ImportResolver
    from rosward.source.packages import DescribedPackage

_SHEBANG: Final = re.compile(rb"#![^\n]*\bpython[0-9.]*\b")


def executables(described: DescribedPackage, resolver: ImportResolver) -> tuple[list[Executable], list[Finding]]:
    """The executables of one package whose source is Python, and what is wrong with them."""
    package = described.package
    found: list[Executable] = []
    findings: list[Finding] = []
    for name, module, function, place in described.declared.entry_points:
        target = resolver.entry_module(module, package)
        file = target.file if target is not None else None
        if file is None:
            own = disk.is_folder(os.path.join(package.path, module.partition(".")[0]))  # noqa: PTH118
            message = f"The executable {name!r} starts the module {module!r}, which is not among the sources."
            findings.append(Finding("RW009" if own else "RW016", message, place))
        elif target is not None and target.guess:
            message = f"The executable {name!r} starts the module {module!r}, assumed to be {file.relative}."
            findings.append(Finding("RW009", message, place))
        found.append(Executable(package, name, ExecutableKind.CONSOLE_SCRIPT, file, place, module, function))
    top = os.fspath(package.path)
    scripts: list[tuple[str, str, Place]] = list(described.cmake.scripts)
    for script, place in described.declared.scripts:
        path = os.path.normpath(os.path.join(top, script))  # noqa: PTH118
        scripts.append((os.path.basename(path), path, place))  # noqa: PTH119
    for name, path, place in scripts:
        if not path.startswith(top + os.sep) or not disk.is_file(path) or resolver.is_left_out(path):
            findings.append(Finding("RW009", f"The script {name!r} is not among the sources.", place))
        elif is_python_script(path):
            found.append(Executable(package, name, ExecutableKind.SCRIPT, resolver.file_at(path, package), place))
    return found, findings


def is_python_script(path: str) -> bool:
    """Whether the file is Python: by its suffix, or by its first line."""
    if path.endswith(".py"):
        return True
    data = read_bytes(path, path, limits.PYTHON_FILE)
    return isinstance(data, bytes) and _SHEBANG.match(data) is not None
