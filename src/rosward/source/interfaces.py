# SPDX-License-Identifier: Apache-2.0
"""Which messages, services and actions does an interface package have?

    from std_msgs.msg import *      names("std_msgs", "msg")  ->  {"Bool", "Byte", …, "String", …}

Those of the workspace are found by their files. Those of common packages come with rosward (`data/interfaces.json`:
the names in the packages' public repositories, humble to rolling together). Of any other package nothing is known.
"""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import TYPE_CHECKING, Final, final

if TYPE_CHECKING:
    from rosward.source.workspace import Workspace

KINDS: Final = ("msg", "srv", "action")
_NOTHING: Final = frozenset[str]()


@final
class InterfaceIndex:
    """The interfaces of the workspace, and of the packages that rosward knows."""

    def __init__(self, workspace: Workspace | None = None) -> None:
        self._own: dict[str, dict[str, set[str]]] = {}
        self._common: dict[str, dict[str, str]] | None = None
        for file in workspace.interface_files if workspace is not None else ():
            kind = _kind(os.fspath(file.path))
            if kind and file.package is not None:
                self._own.setdefault(file.package.name, {}).setdefault(kind, set()).add(
                    file.path.name.partition(".")[0]
                )

    def names(self, package: str, kind: str) -> frozenset[str] | None:
        """The names of the interfaces of one kind (`msg`, `srv`, `action`); `None` where the package is not known."""
        if kind not in KINDS:
            return None
        own = self._own.get(package)
        if own is not None:
            return frozenset(own.get(kind, _NOTHING))
        if self._common is None:
            self._common = json.loads((Path(__file__).parent / "data" / "interfaces.json").read_bytes())
        common = self._common.get(package)
        return None if common is None else frozenset(common.get(kind, "").split())

    def has(self, module: str, name: str) -> bool | None:
        """Whether `from MODULE import NAME` (`std_msgs.msg`, `String`) brings an interface; `None` if not known."""
        package, _, kind = module.partition(".")
        names = self.names(package, kind)
        return None if names is None else name in names

    def is_local(self, package: str) -> bool:
        """Whether the workspace holds interfaces of that package."""
        return package in self._own


def _kind(path: str) -> str:
    """The kind of an interface file: by its suffix, or, for IDL, by its folder."""
    suffix = path.rpartition(".")[2]
    if suffix in KINDS:
        return suffix
    folder = path.rsplit(os.sep, 2)[-2] if path.count(os.sep) >= 2 else ""
    return folder if folder in KINDS else ""
