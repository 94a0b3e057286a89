# SPDX-License-Identifier: Apache-2.0
"""Prepares units from a dictionary of files, without a file system."""

from __future__ import annotations

import posixpath
from collections.abc import Iterable, Mapping, Sequence

from rosward.findings import Finding
from rosward.frontends.cpp.prepared import Prepared, Translation
from rosward.frontends.cpp.preprocess import Preprocessor
from rosward.location import Place


def preprocessor(files: Mapping[str, str]) -> Preprocessor:
    """Reads the `files`."""

    def read(path: str) -> str | Finding:
        return files.get(path, Finding("RW002", "no such file", Place(path)))

    def find(name: str, including: str, includes: Sequence[str], quoted: bool) -> str | None:
        folders = [posixpath.dirname(including)] * quoted + list(includes)
        paths = [posixpath.normpath(posixpath.join(folder, name)) for folder in folders]
        return next((path for path in paths if path in files), None)

    return Preprocessor(read, str, find, {"RCLCPP_VERSION_GTE": (28, 1, 6)})


def translate(
    main: str, files: Mapping[str, str] | None = None, definitions: Iterable[tuple[str, str, bool]] = ()
) -> Translation:
    """The unit of a source, which may include the `files`, also from the folder `include`."""
    return preprocessor({"main.cpp": main, **(files or {})}).translate("main.cpp", ("include",), definitions)


def prepared(
    main: str, files: Mapping[str, str] | None = None, definitions: Iterable[tuple[str, str, bool]] = ()
) -> Prepared:
    """The source of a unit."""
    return translate(main, files, definitions).files[-1]


def lines(text: str) -> list[str]:
    """The lines that hold something, without needless blanks."""
    return [" ".join(line.split()) for line in text.split("\n") if line.strip()]
