# SPDX-License-Identifier: Apache-2.0
"""How does what a browser sends become a folder of sources?

    files named 'ws/src/demo/talker.py', …     FOLDER/tree/ws/src/demo/talker.py, …
    one file 'ws.zip'                          FOLDER/upload.zip, which the process that analyses unpacks (`unpacking.py`)

The body is counted while it comes, and refused when it is too large. Files are only written, below a folder that is made for them.
"""

from __future__ import annotations

import asyncio
import json
import os
from pathlib import Path
from typing import Final

from starlette.datastructures import FormData, UploadFile
from starlette.exceptions import HTTPException
from starlette.requests import Request
from starlette.types import Message

from rosward.records import NamedTuple
from rosward.safe import printable
from rosward.server.limits import Limits
from rosward.server.places import LeftOut, Places, UploadRefusedError, why_left_out, write_left_out
from rosward.server.settings import Settings, read_settings

__all__ = ["Uploaded", "read_upload"]

_BLOCK: Final = 256 * 1024
_MOST_FIELDS: Final = 4
_MOST_NAMES: Final = 1_000


class Uploaded(NamedTuple):
    """What came: what to call it, whether it is a zip, and the settings."""

    title: str
    zipped: bool
    settings: Settings


async def read_upload(request: Request, folder: Path, limits: Limits) -> Uploaded:
    """Take the files of a form into a folder that is there and has nothing of this name in it. Raises UploadRefusedError."""
    declared = request.headers.get("content-length", "")
    if declared.isdigit() and int(declared) > limits.upload:
        raise _too_large(limits)
    form = await _form(request, limits)
    try:
        return await _keep(form, folder, limits)
    finally:
        await form.close()


async def _form(request: Request, limits: Limits) -> FormData:
    count = 0

    async def receive() -> Message:
        nonlocal count
        try:
            message = await asyncio.wait_for(request.receive(), limits.silence)
        except asyncio.TimeoutError as error:
            raise UploadRefusedError(f"nothing was sent for {limits.silence:g} seconds") from error
        count += len(message.get("body", b""))
        if count > limits.upload:
            raise _too_large(limits)
        return message

    try:
        return await Request(request.scope, receive).form(max_files=limits.files, max_fields=_MOST_FIELDS)
    except HTTPException as error:
        raise UploadRefusedError(printable(error.detail)) from error


async def _keep(form: FormData, folder: Path, limits: Limits) -> Uploaded:
    files = [(part.filename or "", part) for part in form.getlist("file") if isinstance(part, UploadFile)]
    settings = read_settings(_json(form.get("settings"), {}))
    if not files:
        raise UploadRefusedError("no file was sent")
    if len(files) == 1 and files[0][0].lower().endswith(".zip"):
        name = Places(limits).add(files[0][0])
        await _write(files[0][1], folder / "upload.zip", limits.upload)
        return Uploaded(name, zipped=True, settings=settings)
    if any(name.lower().endswith(".zip") for name, _ in files):
        raise UploadRefusedError("upload a zip on its own, one at a time")
    left_out = _not_sent(form.get("left_out"))
    places = Places(limits)
    for path, part in [(places.add(name), part) for name, part in files]:
        why = why_left_out(path) or (f"larger than {limits.file:,} bytes" if (part.size or 0) > limits.file else "")
        if why:
            left_out.append(LeftOut(path, why))
        else:
            await _write(part, folder / "tree" / path, limits.file)
    (folder / "tree").mkdir(exist_ok=True)
    write_left_out(folder / "left_out.json", left_out)
    return Uploaded(_title([name for name, _ in files]), zipped=False, settings=settings)


async def _write(part: UploadFile, path: Path, most: int) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    flags = os.O_WRONLY | os.O_CREAT | os.O_EXCL | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_BINARY", 0)
    count = 0
    with os.fdopen(os.open(path, flags, 0o600), "wb") as target:
        while block := await part.read(_BLOCK):
            count += len(block)
            if count > most:
                raise UploadRefusedError(f"{path.name}: too large")
            target.write(block)


def _title(names: list[str]) -> str:
    """The folder that all files are in, else the only file, else how many there are."""
    folders = {name.partition("/")[0] for name in names}
    if len(folders) == 1:
        return folders.pop()
    return f"{len(names)} files"


def _not_sent(field: object) -> list[LeftOut]:
    """What the page did not send, by its names, for the user to know."""
    names = _json(field, [])
    if not isinstance(names, list):
        return []
    return [LeftOut(printable(name[:500]), "not sent") for name in names[:_MOST_NAMES] if isinstance(name, str)]


def _json(field: object, otherwise: object) -> object:
    if not isinstance(field, str) or not field:
        return otherwise
    try:
        return json.loads(field)
    except (ValueError, RecursionError) as error:
        raise UploadRefusedError("a field is not valid JSON") from error


def _too_large(limits: Limits) -> UploadRefusedError:
    return UploadRefusedError(
        f"more than {limits.upload // 2**20} MB: leave out data and images, or open the folder on this machine instead"
    )
