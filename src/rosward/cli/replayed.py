# SPDX-License-Identifier: Apache-2.0
"""Did this command say the same before, and would it say it again? Then it is said again, and next to nothing is loaded.

    replayed_or(["extract", "ws"], run)        what `run` gives, from an earlier run where nothing has changed that it saw

A run is kept with all that it saw of the disk (`source/disk.py`): what it printed, the files that it wrote, and its exit status. It counts for the
same words in the same folder, on the same kind of terminal, with the same variables, for this program (`cache/version.py`).
"""

from __future__ import annotations

import hashlib
import os
import sys

from rosward.cache.store import Store
from rosward.cache.version import version_key
from rosward.cli import kept
from rosward.outputs.whole_files import write_bytes
from rosward.source.same import unsure

TYPE_CHECKING = False  # not from typing: this decides what else is loaded
if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence
    from typing import Any, Final, TextIO


__all__ = ["replayed_or"]

_KIND: Final = "run"
_VARIABLES: Final = (
    "COLORTERM", "COLUMNS", "FORCE_COLOR", "HOME", "LINES", "NO_COLOR", "PATH", "TERM", "TTY_COMPATIBLE", "TTY_INTERACTIVE",
)  # fmt: skip
"""What a run may ask of the shell, beside what `--env-from-shell` names."""

_NOT_KEPT: Final = ("--no-ca", "--env-f")
"""How the words begin by which a run is not kept: those that do not want it, and those that ask the shell."""

_READING: Final = ("list", "read", "head")
"""How the looks begin that a mark saves."""

_MOST: Final = 32 * 1024**2
_LOOK: Final = 4
_FILE: Final = 3


class _Said:
    """What a run said. `looks`: how, path, what was seen, mark; one after the other. `files`: folder, name, content."""

    __slots__ = ("errors", "files", "looks", "printed", "status")

    def __init__(
        self, status: int, looks: list[str], files: list[tuple[str, str, bytes]], printed: str, errors: str
    ) -> None:
        self.status = status
        self.looks = looks
        self.files = files
        self.printed = printed
        self.errors = errors


def replayed_or(words: Sequence[str], run: Callable[[Sequence[str]], int]) -> int:
    """The exit status of a run, or of one that was the same."""
    folder = kept.results_folder()
    if folder is None or any(word.startswith(_NOT_KEPT) for word in words):
        return run(words)
    store, question = Store(folder), _question(words)
    marked: list[_Said] = []
    said = store.kept(_KIND, question, lambda answer: _accepted(question, answer, marked))
    if said is not None:
        for again in marked:  # next time, it need not be read
            store.keep(_KIND, question, _written(question, again))
        if _say(said):
            return said.status
    return _kept(store, question, words, run)


def _question(words: Sequence[str]) -> bytes:
    told = [
        version_key(),
        sys.getfilesystemencoding(),
        os.getcwd(),  # noqa: PTH109
        *(f"{name}={os.environ.get(name)}" for name in _VARIABLES),
    ]
    for stream in (sys.stdout, sys.stderr):
        told.append(f"{stream.isatty()} {getattr(stream, 'encoding', '')}")
    if sys.stdout.isatty():
        try:
            told.append(str(os.get_terminal_size()))
        except OSError:
            told.append("")
    return "\0".join((*told, *words)).encode("utf-8", "surrogatepass")


# Saying it again


def _accepted(question: bytes, answer: bytes, marked: list[_Said]) -> _Said | None:
    """What was said, where all that was seen is still so. `marked` gets the same with newer marks, if something had to be read."""
    try:
        said = _read(question, answer)
        if said is None:
            return None
        values = iter(said.looks)
        looks = list(zip(values, values, values, values, strict=True))
    except (IndexError, ValueError):
        return None
    left = unsure(looks)
    if left is None:
        return None
    if left:
        from rosward.source.disk import holds, watching

        with watching() as trace:
            if not holds(left):
                return None
        newer = _looks({(how, path): told for how, path, told, _ in looks}, trace.marks)
        kept_marks = [
            mark if (how, path) not in left else newer[_LOOK * i + 3] for i, (how, path, _, mark) in enumerate(looks)
        ]
        if kept_marks != said.looks[3::_LOOK]:
            newer[3::_LOOK] = kept_marks
            marked.append(_Said(said.status, newer, said.files, said.printed, said.errors))
    return said


def _say(said: _Said) -> bool:
    """Write and print it. False where it cannot be written: then somebody else tells why."""
    try:
        for folder, name, content in said.files:
            write_bytes(folder, name, content)
    except OSError:
        return False
    sys.stdout.write(said.printed)
    sys.stderr.write(said.errors)
    return True


# Keeping it


class _Copied:
    """A stream, of which it is kept what was written into it."""

    def __init__(self, stream: TextIO) -> None:
        self._stream = stream
        self.parts: list[str] = []

    def write(self, text: str) -> int:
        """As the stream does."""
        self.parts.append(text)
        return self._stream.write(text)

    def writelines(self, texts: Any) -> None:
        """As the stream does."""
        for text in texts:
            self.write(text)

    def __getattr__(self, name: str) -> Any:
        return getattr(self._stream, name)


def _kept(store: Store, question: bytes, words: Sequence[str], run: Callable[[Sequence[str]], int]) -> int:
    """Run it, and keep what it says if it would say it again."""
    from rosward.cli.status import COMPLETE, INCOMPLETE
    from rosward.source.disk import watching

    streams = sys.stdout, sys.stderr
    printed, errors = _Copied(sys.stdout), _Copied(sys.stderr)
    sys.stdout, sys.stderr = printed, errors
    try:
        with watching() as trace:
            status = run(words)
    finally:
        sys.stdout, sys.stderr = streams
    if status in (COMPLETE, INCOMPLETE) and not trace.torn:
        said = _Said(
            status, _looks(trace.seen, trace.marks), _last(trace.written), "".join(printed.parts), "".join(errors.parts)
        )
        answer = _written(question, said)
        if answer and len(answer) <= _MOST:
            store.keep(_KIND, question, answer)
    store.close()
    return status


def _looks(seen: Mapping[tuple[str, str], str], marks: Mapping[str, str]) -> list[str]:
    """What was seen, with the marks of what was read."""
    found: list[str] = []
    for (how, path), told in seen.items():
        found += (how, path, told, marks.get(path, "") if how.startswith(_READING) else "")
    return found


def _last(written: list[tuple[str, str, bytes]]) -> list[tuple[str, str, bytes]]:
    """Each file once, as it is at the end."""
    return [
        (folder, name, content) for (folder, name), content in {(f, n): content for f, n, content in written}.items()
    ]


def _digest(question: bytes) -> str:
    return hashlib.blake2b(question, digest_size=20).hexdigest()


def _written(question: bytes, said: _Said) -> bytes:
    """As bytes: a line with the length of the head, the head, and contents one after the other; b"" where it has no such form."""
    printed, errors = said.printed.encode("utf-8", "surrogatepass"), said.errors.encode("utf-8", "surrogatepass")
    numbers = [str(said.status), str(len(said.looks)), str(len(printed)), str(len(errors))]
    files = [each for folder, name, content in said.files for each in (folder, name, str(len(content)))]
    fields = [_digest(question), *numbers, *said.looks, *files]
    head = "\0".join(fields).encode("utf-8", "surrogatepass")
    if head.count(b"\0") != len(fields) - 1:
        return b""
    return b"".join((b"%d\n" % len(head), head, printed, errors, *(content for _, _, content in said.files)))


def _read(question: bytes, answer: bytes) -> _Said | None:
    """The same again; None where it answers another question. Raises ValueError or IndexError where it is no such form."""
    length, _, rest = answer.partition(b"\n")
    head, contents = rest[: int(length)], rest[int(length) :]
    digest, status, number, printed, errors, *fields = head.decode("utf-8", "surrogatepass").split("\0")
    if digest != _digest(question):
        return None
    looks, named = fields[: int(number)], fields[int(number) :]
    if len(looks) % _LOOK or len(named) % _FILE:
        raise ValueError(number)
    begin, parts = 0, []
    for size in (printed, errors, *named[2::_FILE]):
        parts.append(contents[begin : begin + int(size)])
        begin += int(size)
    if begin != len(contents):
        raise ValueError(begin)
    files = list(zip(named[::_FILE], named[1::_FILE], parts[2:], strict=True))
    return _Said(
        int(status), looks, files, parts[0].decode("utf-8", "surrogatepass"), parts[1].decode("utf-8", "surrogatepass")
    )
