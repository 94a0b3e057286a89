# SPDX-License-Identifier: Apache-2.0
"""Which files does a zip hold, and how do they get into a folder, and nowhere else, in bounded space?

    ws.zip: ws/src/demo/talker.py, ws/docs/photo.jpg, ws/link -> /etc
      ->  FOLDER/ws/src/demo/talker.py;  left out: photo.jpg (not text), link (a link)

All entries are judged by their names and sizes before one is written. Sizes are counted again while they are unpacked, since an archive
may lie. No link is ever made, and a file is only ever created, never opened. A zip within a zip stays closed.
"""

from __future__ import annotations

import os
import stat
import struct
import zipfile
import zlib
from collections.abc import Callable
from pathlib import Path
from typing import Final

from rosward.safe import printable
from rosward.server.limits import Limits
from rosward.server.places import LeftOut, Places, UploadRefusedError, why_left_out

__all__ = ["unpack"]

_END: Final = b"PK\x05\x06"
_LOCATOR_64: Final = b"PK\x06\x07"
_END_SIZE, _LOCATOR_SIZE, _LONGEST_COMMENT = 22, 20, 65_535
_ENTRY_SIZE: Final = 46
_BLOCK: Final = 64 * 1024
_SMALL: Final = 1024 * 1024
"""Bytes below which a file may be as empty as it likes: the ratio is that of a bomb only where it is large."""

_BROKEN: Final = (
    zipfile.BadZipFile, zipfile.LargeZipFile, zlib.error, struct.error, EOFError, OSError, ValueError, NotImplementedError, RuntimeError,
)  # fmt: skip


def unpack(archive: Path, folder: Path, limits: Limits, progress: Callable[[int, int], None]) -> list[LeftOut]:
    """Write the files of a zip below a folder that is there and empty; what was left out. Raises UploadRefusedError."""
    try:
        _check_directory(archive, limits)
        with zipfile.ZipFile(archive) as opened:
            return _unpack(opened, archive.stat().st_size, folder, limits, progress)
    except _BROKEN as error:
        raise UploadRefusedError(f"not a readable zip file: {printable(str(error))[:200]}") from error


def _check_directory(archive: Path, limits: Limits) -> None:
    """Refuse a list of entries that is too long, before it is read as a whole."""
    size = archive.stat().st_size
    with archive.open("rb") as file:
        file.seek(max(0, size - _END_SIZE - _LONGEST_COMMENT - _LOCATOR_SIZE))
        tail = file.read()
    end = tail.rfind(_END)
    if end < 0 or len(tail) - end < _END_SIZE:
        raise UploadRefusedError("not a readable zip file: its end is missing")
    if tail[max(0, end - _LOCATOR_SIZE) : end].startswith(_LOCATOR_64):
        raise UploadRefusedError("zip64 archives are not supported")
    entries, length = struct.unpack_from("<HL", tail, end + 10)
    if entries > 2 * limits.files or length > 2 * limits.files * (_ENTRY_SIZE + limits.name):
        raise UploadRefusedError(f"more than {limits.files:,} files")


def _unpack(
    opened: zipfile.ZipFile, size: int, folder: Path, limits: Limits, progress: Callable[[int, int], None]
) -> list[LeftOut]:
    entries = opened.infolist()
    if len(entries) > 2 * limits.files:
        raise UploadRefusedError(f"more than {limits.files:,} files")
    if sum(entry.compress_size for entry in entries) > size:
        raise UploadRefusedError("entries that overlap")
    places = Places(limits)
    left_out: list[LeftOut] = []
    chosen: list[tuple[zipfile.ZipInfo, str]] = []
    for entry in entries:
        name = entry.orig_filename  # `filename` ends at a NUL, and has / for what the system separates with
        why = why_left_out(name)
        if why:
            left_out += [LeftOut(printable(name[:500]), why)] if not name.endswith("/") else []
        elif not name.endswith("/"):
            path = places.add(name)
            why = _why_left_out(entry, path, limits)
            if why:
                left_out.append(LeftOut(path, why))
            else:
                chosen.append((entry, path))
        elif name != "./":
            Places(limits).add(name)  # it says nothing that the files in it do not, but it must not leave the folder
    if sum(entry.file_size for entry, _ in chosen) > limits.unpacked:
        raise UploadRefusedError(f"more than {limits.unpacked:,} bytes once it is unpacked")
    written = 0
    for number, (entry, path) in enumerate(chosen):
        progress(number, len(chosen))
        written += _write(opened, entry, folder / path, limits, limits.unpacked - written)
    return left_out


def _why_left_out(entry: zipfile.ZipInfo, path: str, limits: Limits) -> str:
    """Why an entry is not unpacked; empty where it is. Raises UploadRefusedError for what no honest archive has."""
    kind = stat.S_IFMT(entry.external_attr >> 16)
    if kind == stat.S_IFLNK:
        return "a link"
    if kind not in {0, stat.S_IFREG}:
        return "not a regular file"
    if entry.flag_bits & 0x1:
        raise UploadRefusedError(f"{path}: encrypted")
    if entry.compress_type not in {zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED}:
        raise UploadRefusedError(f"{path}: unsupported compression method")
    if entry.file_size > limits.file:
        return f"larger than {limits.file:,} bytes"
    if entry.file_size > _SMALL and entry.file_size > limits.ratio * max(1, entry.compress_size):
        raise UploadRefusedError(f"{path}: unpacks to more than {limits.ratio} times its size")
    return ""


def _write(opened: zipfile.ZipFile, entry: zipfile.ZipInfo, path: Path, limits: Limits, left: int) -> int:
    """Unpack one entry; the number of its bytes."""
    path.parent.mkdir(parents=True, exist_ok=True)
    count = 0
    flags = os.O_WRONLY | os.O_CREAT | os.O_EXCL | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_BINARY", 0)
    with opened.open(entry) as source, os.fdopen(os.open(path, flags, 0o600), "wb") as target:
        while block := source.read(_BLOCK):
            count += len(block)
            if count > min(left, limits.file):
                raise UploadRefusedError(f"{path.name}: larger than the archive states")
            target.write(block)
    return count
