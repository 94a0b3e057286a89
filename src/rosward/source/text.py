# SPDX-License-Identifier: Apache-2.0
"""Which text does a source file hold, as Python itself would read it?

    b"# coding: latin-1\\nx = '\\xe9'"  ->  SourceText(..., text="# coding: latin-1\\nx = 'é'", finding=None)

Bytes become text by the byte order mark, else the declaration of PEP 263, else UTF-8. Where that fails, Python would
refuse the file; a reader still wants to know what is in it, so it is read as UTF-8 or Latin-1 and the doubt is told
(RW004). Nothing here raises for what a file system can hold, and nothing blocks: a FIFO, a socket or a device is
never opened.
"""

from __future__ import annotations

import contextlib
import io
import os
import tokenize
from typing import TYPE_CHECKING, Final

from rosward.findings import Finding
from rosward.location import Place
from rosward.records import NamedTuple
from rosward.source import disk, limits

if TYPE_CHECKING:
    from pathlib import Path


_SLOW_CODECS: Final = frozenset({"idna", "punycode"})  # quadratic in the length of the text


class SourceText(NamedTuple):
    """The text of one file: `file` as places name it, line ends as `\\n`, and the doubt about its encoding, if any."""

    file: str
    text: str
    encoding: str
    finding: Finding | None = None


def place_name(path: str | Path, root: str | Path) -> str:
    """`path` relative to `root`, with `/`, and free of what cannot be printed (undecodable bytes, controls)."""
    text = os.fspath(path)
    base = os.fspath(root)
    prefix = base if base.endswith(os.sep) else base + os.sep
    if text.startswith(prefix):
        text = text[len(prefix) :]
    else:
        with contextlib.suppress(ValueError):  # another drive, or a NUL in the name
            text = os.path.relpath(text, base)
    return readable_path(text)


def readable_path(text: str) -> str:
    """A path with `/`, and free of what cannot be printed."""
    if os.sep != "/":
        text = text.replace(os.sep, "/")
    if text.isascii() and text.isprintable():
        return text
    readable = text.encode("utf-8", "surrogateescape").decode("utf-8", "backslashreplace")
    return "".join(c if c.isprintable() else c.encode("unicode_escape").decode("ascii") for c in readable)


def read_source(path: Path, root: Path, limit: int = limits.PYTHON_FILE) -> SourceText | Finding:
    """The text of the Python file `path`, or the finding that says why there is none."""
    file = place_name(path, root)
    data = read_bytes(path, file, limit)
    return data if isinstance(data, Finding) else decode(data, file)


def read_bytes(path: str | Path, file: str, limit: int) -> bytes | Finding:
    """The bytes of the regular file `path` (called `file` in findings), at most `limit` of them."""
    found = disk.read(path, limit)
    if isinstance(found, disk.Unread):
        return Finding("RW003" if found.too_large else "RW002", found.why, Place(file))
    return found


def decode(data: bytes, file: str) -> SourceText | Finding:
    """The text that the bytes of the Python file `file` stand for."""
    nul = data.find(b"\0")
    if nul >= 0:
        line = data.count(b"\n", 0, nul) + 1
        column = nul - data.rfind(b"\n", 0, nul)
        hint = " It looks like UTF-16: save it as UTF-8." if data[:2] in {b"\xff\xfe", b"\xfe\xff"} else ""
        return Finding(
            "RW001", f"The source contains a NUL byte, which Python rejects.{hint}", Place(file, line, column)
        )
    encoding, problem = _declared(data)
    if problem is None:
        try:
            return SourceText(file, _lines(data.decode(encoding)), encoding)
        except UnicodeDecodeError as error:
            problem = _decoding_problem(encoding, error, data)
        except (LookupError, ValueError):
            problem = f"The declared encoding {encoding!r} is not a text encoding for source files.", 1
    text, used = _fallback(data)
    return SourceText(
        file, _lines(text), used, Finding("RW004", f"{problem[0]} It was read as {used}.", Place(file, problem[1]))
    )


def _declared(data: bytes) -> tuple[str, tuple[str, int] | None]:
    """The encoding that Python would use, or what is wrong with the declaration, and in which line."""
    try:
        encoding, _ = tokenize.detect_encoding(io.BytesIO(data).readline)
    except (SyntaxError, LookupError, ValueError) as error:
        reason = f"Python rejects this file: {error}."
        return "utf-8", (reason, 1 if "encoding problem" in reason or "unknown encoding" in reason else _bad_line(data))
    if encoding in _SLOW_CODECS or not _reads_ascii(encoding):
        return encoding, (f"The declared encoding {encoding!r} is not a text encoding for source files.", 1)
    return encoding, None


def _reads_ascii(encoding: str) -> bool:
    """Whether ASCII stands for itself, so that the declaration could be read at all."""
    try:
        return b"coding".decode(encoding) == "coding"
    except (LookupError, ValueError):
        return False


def _decoding_problem(encoding: str, error: UnicodeDecodeError, data: bytes) -> tuple[str, int]:
    if encoding == "utf-8":
        message = "The file is not UTF-8 and declares no other encoding."
    else:
        message = f"The file is not in the encoding {encoding!r} that it declares."
    return message, data.count(b"\n", 0, error.start) + 1


def _bad_line(data: bytes) -> int:
    """The line of the first byte that is no UTF-8."""
    try:
        data.decode("utf-8")
    except UnicodeDecodeError as error:
        return data.count(b"\n", 0, error.start) + 1
    return 1


def _fallback(data: bytes) -> tuple[str, str]:
    try:
        return data.decode("utf-8-sig"), "utf-8"
    except UnicodeDecodeError:
        return data.decode("latin-1"), "latin-1"


def _lines(text: str) -> str:
    """The text with one kind of line end, as Python's tokenizer sees it."""
    return text.replace("\r\n", "\n").replace("\r", "\n") if "\r" in text else text
