# SPDX-License-Identifier: Apache-2.0
"""Which file does an `#include` lead to?

    #include "demo/driver.hpp"     beside the file, then in the folders of headers      ->  /ws/demo/include/demo/driver.hpp

Only files of the sources are found; what leads out of them is a header from elsewhere.
"""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path
from typing import final

from rosward.findings import Finding
from rosward.source import limits
from rosward.source.boundary import EVERYWHERE, Boundary
from rosward.source.text import place_name, read_bytes


@final
class Headers:
    """The files of a workspace, as an `#include` finds and reads them; `folders` are those that may be read."""

    __slots__ = ("_boundary", "_files", "_folders", "_root")

    def __init__(self, root: Path, folders: Sequence[str], boundary: Boundary = EVERYWHERE) -> None:
        self._root = root
        self._folders = tuple(folder.rstrip(os.sep) + os.sep for folder in folders)
        self._boundary = boundary
        self._files: dict[str, bool] = {}

    def find(self, name: str, including: str, includes: Sequence[str], quoted: bool) -> str | None:
        """The file that is meant by a name in the file `including`."""
        if name.startswith("/") or "\0" in name or len(name) > 500:
            return None
        folders = (including.rpartition(os.sep)[0], *includes) if quoted else includes
        for folder in folders:
            path = (
                os.path.normpath(f"{folder}{os.sep}{name}")
                if ".." in name or "./" in name
                else f"{folder}{os.sep}{name}"
            )
            if self._is_file(path):
                return path
        return None

    def _is_file(self, path: str) -> bool:
        known = self._files.get(path)
        if known is None:
            known = path.startswith(self._folders) and os.path.isfile(path) and not self._boundary.leads_out(path)  # noqa: PTH113
            self._files[path] = known
        return known

    def named(self, path: str) -> str:
        """How places call the file."""
        return place_name(path, self._root)

    def read(self, path: str) -> str | Finding:
        """The text of a file; C++ is UTF-8 or does not mind."""
        data = read_bytes(path, self.named(path), limits.CPP_FILE)
        if isinstance(data, Finding):
            return data
        text = data.decode("utf-8-sig", "replace").replace("\0", " ")
        return text.replace("\r\n", "\n").replace("\r", "\n") if "\r" in text else text
