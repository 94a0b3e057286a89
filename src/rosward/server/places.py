# SPDX-License-Identifier: Apache-2.0
"""Where below a folder may a file of this name be written?

    'demo/demo/talker.py'         demo/demo/talker.py
    './demo//talker.py'           demo/talker.py
    '../.ssh/config', '/etc/x', 'C:\\x', 'a\\0b', 'A.py' beside 'a.py'         refused

Names come from browsers and zip files, so from anybody. A name that could mean another place on some machine is refused on every machine,
rather than mended: what was mended would be analysed under a name that its author did not give.
"""

from __future__ import annotations

import json
import re
import unicodedata
from collections.abc import Iterable
from pathlib import Path
from typing import Final, NamedTuple, final

from rosward.safe import printable
from rosward.server.limits import Limits

__all__ = [
    "NOT_SOURCE",
    "NOT_SOURCE_FOLDERS",
    "LeftOut",
    "Places",
    "UploadRefusedError",
    "read_left_out",
    "why_left_out",
    "write_left_out",
]

_DRIVE: Final = re.compile(r"[A-Za-z]:")
_LONGEST_PART: Final = 255
_NOT_SOURCE: Final = (
    "png jpg jpeg gif bmp tif tiff webp ico svgz ppm pgm mp4 avi mov mkv mp3 wav ogg flac pdf ttf otf woff woff2",
    "stl dae obj mtl glb gltf fbx ply pcd blend step stp db3 mcap bag npy npz h5 hdf5 pkl pickle onnx pt pth tflite engine",
    "so a o lib dll dylib exe bin deb rpm whl jar class pyc pyo zip tar gz tgz bz2 xz zst 7z rar",
)
NOT_SOURCE: Final = frozenset(ending for line in _NOT_SOURCE for ending in line.split())
NOT_SOURCE_FOLDERS: Final = frozenset({"__pycache__", "__MACOSX", "node_modules"})


class UploadRefusedError(Exception):
    """What was handed in is not taken; the message says why."""


class LeftOut(NamedTuple):
    """A file that was not taken from an upload, and why."""

    name: str
    why: str


def why_left_out(path: str) -> str:
    """Why a file is no source for rosward, by its name; empty where it may be one."""
    *folders, name = path.split("/")
    if any(
        folder in NOT_SOURCE_FOLDERS or (folder.startswith(".") and folder not in {".", ".."}) for folder in folders
    ):
        return "hidden or made by a tool"
    return "not text" if name.rpartition(".")[2].lower() in NOT_SOURCE and "." in name else ""


def write_left_out(file: Path, entries: Iterable[LeftOut]) -> None:
    """Keep what was left out of an upload beside it."""
    file.write_text(json.dumps(list(entries)), encoding="utf-8")


def read_left_out(file: Path) -> list[LeftOut]:
    """What `write_left_out` has kept."""
    return [LeftOut(*entry) for entry in json.loads(file.read_text(encoding="utf-8"))]


@final
class Places:
    """The names of one upload. Two that some file system holds for the same are a collision."""

    def __init__(self, limits: Limits) -> None:
        self._limits = limits
        self._known: dict[str, tuple[str, bool]] = {}
        self._files = 0

    def add(self, name: str) -> str:
        """The path of a further file, relative, with `/`. Raises RefusedError."""
        parts = self._parts(name)
        self._files += 1
        if self._files > self._limits.files:
            raise UploadRefusedError(f"more than {self._limits.files:,} files")
        for count in range(1, len(parts) + 1):
            self._enter("/".join(parts[:count]), is_file=count == len(parts))
        return "/".join(parts)

    def _parts(self, name: str) -> list[str]:
        shown = printable(name[:120])
        if not name.isprintable():
            raise UploadRefusedError(f"{shown}: a name with characters that cannot be printed")
        if "\\" in name or name.startswith("/") or _DRIVE.match(name):
            raise UploadRefusedError(f"{shown}: not a path below the folder (absolute, a drive, or with backslashes)")
        parts = [part for part in name.split("/") if part not in {"", "."}]
        if ".." in parts:
            raise UploadRefusedError(f"{shown}: a path that leaves the folder")
        if not parts:
            raise UploadRefusedError("a file without a name")
        if len(parts) > self._limits.depth:
            raise UploadRefusedError(f"{shown}: more than {self._limits.depth} folders within each other")
        sizes = [len(part.encode("utf-8", "surrogatepass")) for part in parts]
        if max(sizes) > _LONGEST_PART or sum(sizes) + len(sizes) > self._limits.name:
            raise UploadRefusedError(f"{shown}…: a name that is too long")
        return parts

    def _enter(self, path: str, *, is_file: bool) -> None:
        key = unicodedata.normalize("NFC", path).casefold()
        known = self._known.get(key)
        if known is None:
            self._known[key] = (path, is_file)
        elif known[0] != path:
            raise UploadRefusedError(f"{printable(path)} and {printable(known[0])}: the same name on some machines")
        elif known[1] or is_file:
            raise UploadRefusedError(f"{printable(path)}: there twice")
