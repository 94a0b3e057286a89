# SPDX-License-Identifier: Apache-2.0
"""Which file does an `#include` lead to?

    #include "demo/driver.hpp"     beside the file, then in the folders of headers      ->  /ws/demo/include/demo/driver.hpp

Only files of the sources are found; what leads out of them is a header from elsewhere.
"""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Final, final

from rosward.findings import Finding
from rosward.frontends.cpp.model_headers import modelled, of_ros
from rosward.records import NamedTuple
from rosward.source import disk, limits
from rosward.source.boundary import EVERYWHERE, Boundary
from rosward.source.parameter_header import parameter_header
from rosward.source.text import place_name, read_bytes
from rosward.source.yaml_nodes import Malformed

_MADE: Final = "//made//"
"""Stands in the path of a header that a build makes, between the file that it is made of and its name."""

_NAME_LIMIT: Final = 500


class HeadersAsked(NamedTuple):
    """What was asked of the headers of a workspace: which paths are files, and what tells the text of each that was read from any other.

    `generated` are the headers that builds make.
    """

    generated: str
    files: Mapping[str, bool]
    texts: Mapping[str, str]


@final
class Headers:
    """The files of a workspace, as an `#include` finds and reads them; `folders` are those that may be read."""

    __slots__ = ("_boundary", "_files", "_folders", "_generated", "_modelled", "_root", "_texts", "_written")

    def __init__(self, root: Path, folders: Sequence[str], boundary: Boundary = EVERYWHERE) -> None:
        self._root = root
        self._folders = tuple(folder.rstrip(os.sep) + os.sep for folder in folders)
        self._boundary = boundary
        self._modelled = modelled()
        self._files: dict[str, bool] = {}
        self._texts: dict[str, str] = {}
        self._generated: dict[str, dict[str, str]] = {}
        self._written: dict[str, tuple[str, str]] = {}

    def write(self, path: str, named: str, text: str) -> None:
        """A file that is nowhere but here."""
        self._written[path] = named, text

    def generate(self, name: str, source: str, package: str) -> None:
        """A build makes the header `name` of the description of parameters in the file `source`, in the folder of a package."""
        self._generated.setdefault(name, {})[package] = source

    def asked(self) -> HeadersAsked:
        """All that was asked so far, with the answers."""
        return HeadersAsked(repr(self._generated), dict(self._files), dict(self._texts))

    def answers(self, asked: HeadersAsked) -> bool:
        """Whether the same questions have the same answers here; if so, they count as asked."""
        if not (
            repr(self._generated) == asked.generated
            and all(_told(self._read(path)) == told for path, told in asked.texts.items())
            and all(self._look(path) is found for path, found in asked.files.items())
        ):
            return False
        self._files.update(asked.files)
        self._texts.update(asked.texts)
        return True

    def find(self, name: str, including: str, includes: Sequence[str], quoted: bool) -> str | None:
        """The file that is meant by a name in the file `including`."""
        if name.startswith("/") or "\0" in name or len(name) > _NAME_LIMIT:
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
        return self._made(name, including)

    def above(self, name: str, including: str) -> str | None:
        """A header that no folder of headers has, and that stands where its name says, seen from a folder above the file:
        a build may copy it to where it is looked for, or get its folders in a way that nobody knows. One of ROS is from elsewhere."""
        is_below = "/" in name[1:] and ".." not in name and not of_ros(name, self._modelled)
        folder = including.rpartition(os.sep)[0] if is_below else ""
        while (folder + os.sep).startswith(self._folders):
            for path in (f"{folder}{os.sep}{name}", f"{folder}{os.sep}include{os.sep}{name}"):
                if "\0" not in name and len(name) <= _NAME_LIMIT and self._is_file(path):
                    return path
            folder = folder.rpartition(os.sep)[0]
        return None

    def included(self, name: str, including: str, includes: Sequence[str], quoted: bool) -> str | None:
        """The file that is read where a name is included in the file `including`."""
        return self.find(name, including, includes, quoted) or self.above(name, including)

    def _made(self, name: str, including: str) -> str | None:
        """A header that a build makes: of the package around the file that includes it, else of any."""
        base = name.rpartition("/")[2]
        packages = self._generated.get(base, {})
        own = [folder for folder in packages if including.startswith(folder + os.sep)]
        folder = max(own, key=len) if own else next(iter(packages), None)
        return None if folder is None else f"{packages[folder]}{_MADE}{base}"

    def _is_file(self, path: str) -> bool:
        known = self._files.get(path)
        if known is None:
            known = self._files[path] = self._look(path)
        return known

    def _look(self, path: str) -> bool:
        return path.startswith(self._folders) and disk.is_file(path) and not self._boundary.leads_out(path)

    def named(self, path: str) -> str:
        """How places call the file."""
        if path in self._written:
            return self._written[path][0]
        return place_name(path.partition(_MADE)[0], self._root)

    def read(self, path: str) -> str | Finding:
        """The text of a file; C++ is UTF-8 or does not mind."""
        text = self._read(path)
        self._texts[path] = _told(text)
        return text

    def _read(self, path: str) -> str | Finding:
        if path in self._written:
            return self._written[path][1]
        if _MADE in path:
            return self._make(path.partition(_MADE)[0])
        data = read_bytes(path, self.named(path), limits.CPP_FILE)
        if isinstance(data, Finding):
            return data
        text = data.decode("utf-8-sig", "replace").replace("\0", " ")
        return text.replace("\r\n", "\n").replace("\r", "\n") if "\r" in text else text

    def _make(self, source: str) -> str | Finding:
        """The header that is made of a description of parameters."""
        file = self.named(source)
        data = read_bytes(source, file, limits.PARAMETERS_FILE)
        if isinstance(data, Finding):
            return data
        try:
            return parameter_header(data.decode("utf-8-sig", "replace"), file)
        except Malformed as problem:
            message = f"The parameters of this header were not read: {problem.message}."
            return Finding("RW008", message, problem.place)


def _told(text: str | Finding) -> str:
    """What tells a text, or why there is none, from any other."""
    return disk.digest((text if isinstance(text, str) else f"!{text!r}").encode("utf-8", "surrogatepass"))
