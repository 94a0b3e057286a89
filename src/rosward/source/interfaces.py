# SPDX-License-Identifier: Apache-2.0
"""Which messages, services and actions does an interface package have, and which fields have they?

    from std_msgs.msg import *      names("std_msgs", "msg")  ->  {"Bool", "Byte", …, "String", …}
    Trigger.Response()              definition("std_srvs", "srv", "Trigger", "Response")  ->  success: bool, message: string

Those of the workspace are found by their files. Those of common packages come with rosward (`data/interfaces.json`:
the names in the packages' public repositories, humble to rolling together; `data/definitions.json`: the fields of those
that are used most, by `tools/interface_definitions.py`). Of any other package nothing is known.
"""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final, final

from rosward.findings import Finding
from rosward.source import limits
from rosward.source.definitions import Definition, read_definition
from rosward.source.text import decode, read_bytes

if TYPE_CHECKING:
    from rosward.source.workspace import SourceFile, Workspace

KINDS: Final = ("msg", "srv", "action")
_NOTHING: Final = frozenset[str]()


@final
class InterfaceIndex:
    """The interfaces of the workspace, and of the packages that rosward knows."""

    def __init__(self, workspace: Workspace | None = None) -> None:
        self._own: dict[str, dict[str, set[str]]] = {}
        self._common: dict[str, dict[str, str]] | None = None
        self._texts: dict[str, dict[str, dict[str, str]]] | None = None
        self._files: dict[tuple[str, str, str], list[SourceFile]] = {}
        self._definitions: dict[tuple[str, str, str], dict[str, Definition] | None] = {}
        for file in workspace.interface_files if workspace is not None else ():
            kind = _kind(os.fspath(file.path))
            if kind and file.package is not None:
                name = file.path.name.partition(".")[0]
                self._own.setdefault(file.package.name, {}).setdefault(kind, set()).add(name)
                self._files.setdefault((file.package.name, kind, name), []).append(file)

    def names(self, package: str, kind: str) -> frozenset[str] | None:
        """The names of the interfaces of one kind (`msg`, `srv`, `action`); `None` where the package is not known."""
        if kind not in KINDS:
            return None
        own = self._own.get(package)
        if own is not None:
            return frozenset(own.get(kind, _NOTHING))
        if self._common is None:
            self._common = _data("interfaces.json")
        common = self._common.get(package)
        return None if common is None else frozenset(common.get(kind, "").split())

    def has(self, module: str, name: str) -> bool | None:
        """Whether `from MODULE import NAME` (`std_msgs.msg`, `String`) brings an interface; `None` if not known."""
        package, _, kind = module.partition(".")
        names = self.names(package, kind)
        return None if names is None else name in names

    def definition(self, package: str, kind: str, name: str, part: str = "") -> Definition | None:
        """The fields of a message, or of a `part` of a service or action (`Request`, `Goal`); `None` where they are not known."""
        key = (package, kind, name)
        if key not in self._definitions:
            self._definitions[key] = self._read(*key) if kind in KINDS else None
        parts = self._definitions[key]
        return None if parts is None else parts.get(part)

    def _read(self, package: str, kind: str, name: str) -> dict[str, Definition] | None:
        if package in self._own:
            files = self._files.get((package, kind, name), [])
            text = _text(files[0]) if len(files) == 1 else None
            return None if text is None else read_definition(text, package, kind, closed=True)
        if self._texts is None:
            self._texts = _data("definitions.json")
        known = self._texts.get(package, {}).get(kind, {}).get(name)
        return None if known is None else read_definition(known, package, kind, closed=False)


def _data(name: str) -> Any:  # what `json` gives
    return json.loads((Path(__file__).parent / "data" / name).read_bytes())


def _text(file: SourceFile) -> str | None:
    """The text of a .msg, .srv or .action file; None for IDL, and where it cannot be read."""
    if file.path.suffix[1:] not in KINDS:
        return None
    data = read_bytes(file.path, file.relative, limits.INTERFACE_FILE)
    text = data if isinstance(data, Finding) else decode(data, file.relative)
    return None if isinstance(text, Finding) else text.text


def _kind(path: str) -> str:
    """The kind of an interface file: by its suffix, or, for IDL, by its folder."""
    suffix = path.rpartition(".")[2]
    if suffix in KINDS:
        return suffix
    folder = path.rsplit(os.sep, 2)[-2] if path.count(os.sep) >= 2 else ""
    return folder if folder in KINDS else ""
