# SPDX-License-Identifier: Apache-2.0
"""A shell's line in words and in what stands between its commands.

a 'b c' $D; e   # f      (a, 'b c', $D)  ;  (e)
a > log <<EOF && b       (a)  &&  (b), without what is read and written; so are the lines before EOF, unless a shell reads them
"""

from __future__ import annotations

import re
import shlex
from collections.abc import Sequence
from itertools import groupby
from typing import Final

from rosward.domain.text import make, origins_of, parts_of
from rosward.domain.unknown import Cause, Reason
from rosward.domain.values import Hole, Value
from rosward.location import Place
from rosward.records import NamedTuple


class Variable(NamedTuple):
    """`$name`, or `${name:-default}`; `apart` where no quotes keep its words together."""

    name: str
    default: str | None
    apart: bool


Piece = str | Hole | Variable
Word = tuple[Piece, ...]


class Line(NamedTuple):
    """The commands, each with what stands before it, and the lines of which only the output stands in this one."""

    commands: list[tuple[str, list[Word]]]
    inner: list[Value]


_VARIABLE: Final = re.compile(r"\$(?:\{(\w+)(?::?-([^}]*))?\}|([A-Za-z_]\w*))")
_DOCUMENT: Final = re.compile(r"<<-?[ \t]*(['\"]?)([\w.-]+)\1")
_FED: Final = re.compile(r"(?:^|[\s;&|(/])(?:ba|da|z)?sh(?:\s+-\w+)*\s*$")
"""What stands before a document that a shell reads."""
_OPERATORS: Final = re.compile(r"[();<>|&]+")
_REDIRECTION: Final = re.compile(r"(?:&(?=>))?[<>]+[&|]?")
_HOLE: Final = "\0"
_SHOWN: Final = 200
_DEEP: Final = 8
"""Documents within documents are read so far."""


def read_line(line: Value, place: Place, depth: int = 0) -> Line:
    """A line as a shell reads it; `depth`: that of a document in so many others."""
    return _Reader(line, place, depth).read()


class _Reader:
    """One reading of a line, character by character; a hole is one of them."""

    def __init__(self, line: Value, place: Place, depth: int) -> None:
        parts = parts_of(line)
        self.text = "".join(_HOLE if isinstance(p, Hole) else p.replace(_HOLE, "") for p in parts)
        self.holes = [p for p in parts if isinstance(p, Hole)]
        self.passed = 0
        self.line, self.place, self.depth = line, place, depth
        self.found = Line([("", [])], [])
        self.word: list[Piece] | None = None
        self.file = False
        self.documents: list[tuple[str, bool]] = []
        self.closing = _closing(self.text) if "$(" in self.text else {}

    def read(self) -> Line:
        number, quoted = 0, ""
        while number < len(self.text):
            char = self.text[number]
            if char == "\\" and quoted != "'":
                number = self._escaped(number, quoted)
            elif char in "'\"" and quoted in ("", char):
                quoted = "" if quoted else char
                self._put("")
                number += 1
            elif char in "$`" and quoted != "'" and (end := self._expansion(number, quoted)):
                number = end
            elif char == _HOLE:
                self._put(self._hole())
                number += 1
            elif quoted:
                self._put(char)
                number += 1
            else:
                number = self._plain(number)
        self._end_word()
        return self.found

    def _plain(self, number: int) -> int:
        """A character outside quotes."""
        char = self.text[number]
        if char == "\n":
            self._between(";")
            return self._behind_documents(number + 1)
        if char.isspace():
            self._end_word()
        elif char == "#" and self.word is None:
            end = self.text.find("\n", number)
            return self._skip(number, len(self.text) if end < 0 else end)
        elif char in "<>" or self.text.startswith("&>", number):
            return self._redirection(number)
        elif char in "();|&":
            match = _OPERATORS.match(self.text, number)
            found = "" if match is None else _REDIRECTION.split(match[0])[0]
            self._between(found)
            return number + len(found)
        else:
            self._put(char)
        return number + 1

    def _escaped(self, number: int, quoted: str) -> int:
        behind = self.text[number + 1 : number + 2]
        if behind == _HOLE:
            self._put("\\" if quoted else "")
            return number + 1
        if behind != "\n":
            self._put("\\" + behind if quoted and behind not in '"\\$`' else behind)
        return number + 2

    def _redirection(self, number: int) -> int:
        """The number before it is no word of the command, nor is the file behind it."""
        if self.word and all(p.__class__ is str for p in self.word) and "".join(map(str, self.word)).isdigit():
            self.word = None
        self._end_word()
        document = None if self.text.startswith("<<<", number) else _DOCUMENT.match(self.text, number)
        if document is not None:
            self.documents.append((document[2], _FED.search(self.text[max(0, number - _SHOWN) : number]) is not None))
            return document.end()
        match = _REDIRECTION.match(self.text, number)
        self.file = True
        return number + 1 if match is None else match.end()

    def _behind_documents(self, number: int) -> int:
        """Where the line goes on behind the documents that begin here; what a shell reads is part of it."""
        for name, fed in self.documents:
            match = re.compile(rf"^\t*{re.escape(name)}[ \t]*$", re.MULTILINE).search(self.text, number)
            end, behind = (len(self.text),) * 2 if match is None else match.span()
            if fed and self.depth < _DEEP:
                body = make(self._parts(number, end), origins_of(self.line))
                self.found.commands.extend(read_line(body, self.place, self.depth + 1).commands)
                self._between(";")
            number = self._skip(number, behind)
        self.documents.clear()
        return number

    def _expansion(self, number: int, quoted: str) -> int:
        """Where a variable, or a command in a line, ends; 0 where none begins."""
        match = _VARIABLE.match(self.text, number)
        if match is not None:
            self._put(Variable(match[1] or match[3], match[2], not quoted))
            return self._skip(number, match.end())
        begin = number + 1 + (self.text[number] == "$")
        if self.text[number] == "`":
            end = self.text.find("`", begin)
        else:
            end = self.closing.get(number + 1, -1) if self.text.startswith("$(", number) else -1
        if end < 0:
            return 0
        self.found.inner.append(make(self._parts(begin, end), origins_of(self.line)))
        self._put(Hole((Reason(Cause.CALL, self.text[number : end + 1].replace(_HOLE, "*")[:_SHOWN], self.place),)))
        return self._skip(number, end + 1)

    def _parts(self, begin: int, end: int) -> list[str | Hole]:
        """What stands there, while it has not been passed."""
        pieces = self.text[begin:end].split(_HOLE)
        holes = self.holes[self.passed : self.passed + len(pieces) - 1]
        return [p for n, piece in enumerate(pieces) for p in (holes[n - 1] if n else "", piece)]

    def _hole(self) -> Hole:
        self.passed += 1
        return self.holes[self.passed - 1]

    def _skip(self, begin: int, end: int) -> int:
        self.passed += self.text.count(_HOLE, begin, end)
        return end

    def _put(self, piece: Piece) -> None:
        if self.word is None:
            self.word = []
        self.word.append(piece)

    def _end_word(self) -> None:
        if self.word is not None and not self.file:
            self.found.commands[-1][1].append(_merged(self.word))
        self.file = self.file and self.word is None
        self.word = None

    def _between(self, operator: str) -> None:
        self._end_word()
        self.file = False
        self.found.commands.append((operator, []))


def _merged(word: list[Piece]) -> Word:
    """The pieces with the characters of a run put together."""
    runs = ((kind is str, list(pieces)) for kind, pieces in groupby(word, type))
    return tuple(p for plain, run in runs for p in (("".join(map(str, run)),) if plain else run))


def _closing(text: str) -> dict[int, int]:
    """Where each bracket is closed."""
    found: dict[int, int] = {}
    opened: list[int] = []
    for number, char in enumerate(text):
        if char == "(":
            opened.append(number)
        elif char == ")" and opened:
            found[opened.pop()] = number
    return found


def split(text: Value) -> tuple[Value, ...]:
    """The words of a text as a shell splits it, holes within words."""
    holes: list[Hole] = []
    plain = ""
    for part in parts_of(text):
        if isinstance(part, Hole):
            plain += f"\0{len(holes)}\0"
            holes.append(part)
        else:
            plain += part.replace("\0", "")
    try:
        words = shlex.split(plain)
    except ValueError:
        words = plain.split()
    return tuple(make(_restored(word, holes), origins_of(text)) for word in words)


def _restored(word: str, holes: Sequence[Hole]) -> list[str | Hole]:
    return [holes[int(piece)] if n % 2 else piece for n, piece in enumerate(word.split("\0"))]
