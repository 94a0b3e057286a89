# SPDX-License-Identifier: Apache-2.0
"""How far does what begins at a place reach, and which literals stand in it? Without a parser, as the text may be half written.

    self.pub = self.create_publisher(        place: line 1, column 12
        String, "chatter", 10)               reaches to the end of line 2; its literals: "chatter" at line 2

Calls of Python and C++ by their brackets, elements of XML by their tags, items of YAML by their indentation. Lines and columns count from 0 here.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Final, NamedTuple

from rosward.location import Place

__all__ = ["LONGEST_LINE", "Extent", "Literal", "column_of", "extent", "literals"]

_MOST_LINES: Final = 400
LONGEST_LINE: Final = 2_000
"""Characters of a line in which somebody may have written something by hand; what is longer is not looked into."""
_TOKEN: Final = re.compile(
    r"(?P<long>\"\"\"|''')|(?P<text>[A-Za-z]{0,2}\"(?:\\.|[^\"\\])*\"|[A-Za-z]{0,2}'(?:\\.|[^'\\])*')"
    r"|(?P<comment>#|//)|(?P<open>[(\[{])|(?P<close>[)\]}])|(?P<more>->|::|[.<>&*:,=;+-])|(?P<word>\w+)|(?P<space>\s+)|(?P<other>.)"
)
_TAG: Final = re.compile(
    r"<(?P<close>/?)(?P<name>[A-Za-z_][\w.:-]*)(?P<rest>(?:\"[^\"]*\"|'[^']*'|[^<>\"'])*?)(?P<empty>/?)>"
)
_XML_TEXT: Final = re.compile(r"([\w.:-]+)\s*=\s*(\"([^\"]*)\"|'([^']*)')")
_YAML_TEXT: Final = re.compile(
    r"\"((?:\\.|[^\"\\])*)\"|'((?:''|[^'])*)'"
    r"|(?:(?<=[:\-,\[{] )|(?<=[\[{]))([^\s#\[\]{},\"'&*!|>%@`-](?:(?!:\s)[^#,\[\]{}\n\"'])*?)(?=\s*(?:[,\]}]|#|$))"
)


class Extent(NamedTuple):
    """From a position to another one, which is no part of it."""

    line: int
    column: int
    end_line: int
    end_column: int

    def holds(self, line: int, column: int) -> bool:
        """Whether a position is in it; its end counts, as a cursor stands between characters."""
        return (self.line, self.column) <= (line, column) <= (self.end_line, self.end_column)


class Literal(NamedTuple):
    """A text that is written out: where its content stands (without quotes), and what it says. `name`: the attribute, in XML."""

    line: int
    column: int
    end: int
    text: str
    name: str = ""


def extent(lines: Sequence[str], file: str, line: int, column: int) -> Extent:
    """What begins at a position of a file."""
    if not 0 <= line < len(lines):
        return Extent(line, 0, line, 0)
    column = min(column, len(lines[line]))
    if file.endswith((".xml", ".launch")):
        return _element(lines, line, column)
    if file.endswith((".yaml", ".yml")):
        return _item(lines, line)
    return _call(lines, line, column)


def column_of(lines: Sequence[str], file: str, place: Place) -> int:
    """The column of a place in characters, from 0: parsers of programs count the bytes of UTF-8."""
    text = lines[place.line - 1] if 0 < place.line <= len(lines) else ""
    column = max(0, place.column - 1)
    if text.isascii() or file.endswith((".xml", ".launch", ".yaml", ".yml")):
        return min(column, len(text))
    return len(text.encode("utf-8", "surrogatepass")[:column].decode("utf-8", "ignore"))


def _call(lines: Sequence[str], line: int, column: int) -> Extent:
    depth, seen, at = 0, False, column
    end = (line, len(lines[line]))
    long = ""
    for number in range(line, min(len(lines), line + _MOST_LINES)):
        text = lines[number]
        if len(text) > LONGEST_LINE:
            break
        while at < len(text):
            if long:
                close = text.find(long, at)
                if close < 0:
                    break
                at, long = close + 3, ""
                continue
            token = _TOKEN.match(text, at)
            if token is None:
                break
            kind = token.lastgroup
            if kind == "comment":
                break
            if kind == "long":
                long = token.group()
            elif kind == "open":
                depth += 1
            elif kind == "close":
                depth -= 1
                if depth < 0:
                    return Extent(line, column, *end)
                if depth == 0:
                    seen, end = True, (number, token.end())
            elif depth == 0 and seen and kind != "space" and token.group() not in (".", "->", "::"):
                if kind != "word" or text[: token.start()].rstrip()[-1:] not in (".", ">", ":"):
                    return Extent(line, column, *end)
            at = token.end()
        if depth == 0 and not long and (seen or number > line + 1) and not _goes_on(lines, number):
            return Extent(line, column, *end)
        at = 0
    return Extent(line, column, *(end if seen else (line, len(lines[line]))))


def _goes_on(lines: Sequence[str], number: int) -> bool:
    return number + 1 < len(lines) and lines[number + 1].lstrip().startswith((".", "->"))


def _element(lines: Sequence[str], line: int, column: int) -> Extent:
    part = [text if len(text) <= LONGEST_LINE else "" for text in lines[line : line + _MOST_LINES]]
    text = "\n".join(part)
    start = text.find("<", max(0, column - 1))
    depth = 0
    for tag in _TAG.finditer(text, max(start, 0)):
        if tag["close"]:
            depth -= 1
        elif not tag["empty"]:
            depth += 1
        if depth <= 0:
            return Extent(line, column, *_position(part, line, tag.end()))
    return Extent(line, column, line, len(lines[line]))


def _position(part: Sequence[str], line: int, offset: int) -> tuple[int, int]:
    for number, text in enumerate(part):
        if offset <= len(text):
            return line + number, offset
        offset -= len(text) + 1
    return line + len(part) - 1, len(part[-1])


def _item(lines: Sequence[str], line: int) -> Extent:
    indent = len(lines[line]) - len(lines[line].lstrip())
    last = line
    for number in range(line + 1, min(len(lines), line + _MOST_LINES)):
        text = lines[number].lstrip()
        if text and not text.startswith("#"):
            if len(lines[number]) - len(text) <= indent:
                break
            last = number
    return Extent(line, indent, last, len(lines[last]))


def literals(lines: Sequence[str], file: str, where: Extent) -> list[Literal]:
    """The literals in an extent, in order."""
    if file.endswith((".xml", ".launch")):
        return _in_lines(lines, where, _of_xml)
    if file.endswith((".yaml", ".yml")):
        return _in_lines(lines, where, _of_yaml)
    return _in_lines(lines, where, _of_code)


def _in_lines(lines: Sequence[str], where: Extent, of_line: object) -> list[Literal]:
    found: list[Literal] = []
    for number in range(where.line, min(where.end_line + 1, len(lines))):
        if len(lines[number]) > LONGEST_LINE:
            continue
        for each in of_line(lines[number], number):  # type: ignore[operator]
            if where.holds(number, each.column) and where.holds(number, each.end):
                found.append(each)
    return found


def _of_code(text: str, number: int) -> list[Literal]:
    found: list[Literal] = []
    at = 0
    while at < len(text):
        token = _TOKEN.match(text, at)
        if token is None or token.lastgroup == "comment":
            break
        at = token.end()
        if token.lastgroup == "text":
            word = token.group()
            quote = min(i for i in (word.find('"'), word.find("'")) if i >= 0)
            inner = word[quote + 1 : -1]
            if "\\" not in inner and word[:quote].lower() in ("", "u", "r"):
                found.append(Literal(number, token.start() + quote + 1, token.end() - 1, inner))
    return found


def _of_xml(text: str, number: int) -> list[Literal]:
    found: list[Literal] = []
    for each in _XML_TEXT.finditer(text):
        group = 3 if each.group(3) is not None else 4
        if "&" not in each.group(group):
            found.append(Literal(number, each.start(group), each.end(group), each.group(group), each.group(1)))
    return found


def _of_yaml(text: str, number: int) -> list[Literal]:
    found: list[Literal] = []
    for each in _YAML_TEXT.finditer(text):
        group = next(g for g in (1, 2, 3) if each.group(g) is not None)
        inner = each.group(group)
        if "\\" not in inner and "''" not in inner:
            found.append(Literal(number, each.start(group), each.end(group), inner))
    return found
