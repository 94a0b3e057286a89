# SPDX-License-Identifier: Apache-2.0
"""Which findings does a source file ask to ignore?

    self.create_publisher(String, topic, 10)  # rosward: ignore[RW102]      RW102 on this line
    # rosward: ignore                                                       everything on this and the next line
    <!-- rosward: ignore[RW311] -->                                         the same in XML; `#` in YAML, `//` and `/* */` in C++

Only comments count, not what looks like one within a string, a CDATA section or a scalar. A comment that stands alone on its line also
speaks for the line below.
"""

from __future__ import annotations

import io
import re
from collections.abc import Iterator
from typing import Final

from rosward.records import NamedTuple
from rosward.source import limits

__all__ = ["IgnoreComment", "ignore_comments"]

_WORD: Final = "rosward:"
_DIRECTIVE: Final = re.compile(r"rosward:\s*ignore(?![\w-])(?P<open>\s*\[(?P<codes>[^\]]*)(?P<close>\])?)?")
_IN_HASH: Final = re.compile(r"#\s*(?=rosward:)")
_BRACKET: Final = re.compile(r"[\[\]{}]")
_HASH: Final = re.compile(r"(?:^|(?<=\s))#")
_XML_OPENERS: Final = re.compile(r"<!--|<!\[CDATA\[")
_XML_CLOSERS: Final = {"<!--": "-->", "<![CDATA[": "]]>"}
_CPP: Final = frozenset(
    {
        ".cpp",
        ".cc",
        ".cxx",
        ".c++",
        ".C",
        ".cp",
        ".c",
        ".hpp",
        ".hh",
        ".hxx",
        ".h++",
        ".H",
        ".h",
        ".ipp",
        ".tpp",
        ".inl",
        ".inc",
    }
)
_OF_CPP: Final = re.compile(
    r"//(?P<line>[^\n]*)|/\*(?P<block>.*?)(?:\*/|\Z)|R\"(?P<mark>[^()\\\s]{0,16})\(.*?(?:\)(?P=mark)\"|\Z)|\"(?:\\.|[^\"\\\n])*\"?|'(?:\\.|[^'\\\n]){1,10}'",
    re.DOTALL,
)
_REST_OF_LINE: Final = re.compile(r"[ \t\r]*(?:\n|\Z)")


class IgnoreComment(NamedTuple):
    """A comment at a line and column that asks to ignore the findings of `codes` (None: all) on some lines."""

    line: int
    column: int
    lines: tuple[int, ...]
    codes: tuple[str, ...] | None

    def means(self, code: str) -> bool:
        """Whether findings of that code are to be ignored."""
        return self.codes is None or code in self.codes


class _Comment(NamedTuple):
    """A comment: where it starts and ends, what it says, and whether nothing else stands on its lines."""

    line: int
    column: int
    end: int
    text: str
    alone: bool


def ignore_comments(text: str, suffix: str) -> list[IgnoreComment]:
    """The comments of a file whose name ends in `suffix` (`.xml`, `.launch`, `.yaml`, `.yml`, one of C++; else it is Python)."""
    if _WORD not in text:
        return []
    if suffix in {".xml", ".launch"}:
        comments = _of_xml(text)
    elif suffix in {".yaml", ".yml"}:
        comments = _of_yaml(text)
    elif suffix in _CPP:
        comments = _of_cpp(text)
    else:
        comments = _of_python(text)
    found = []
    for comment in comments:
        directive = _DIRECTIVE.match(comment.text)
        if directive is not None:
            lines = {comment.line, comment.end} | ({comment.end + 1} if comment.alone else set())
            found.append(IgnoreComment(comment.line, comment.column, tuple(sorted(lines)), _codes(directive)))
    return found


def _codes(directive: re.Match[str]) -> tuple[str, ...] | None:
    """The codes in brackets. Brackets that hold none, or that nothing closes, mean none: a slip must not ignore everything."""
    if directive["open"] is None:
        return None
    if directive["close"] is None:
        return ()
    return tuple(dict.fromkeys(code.strip() for code in directive["codes"].split(",") if code.strip()))


def _of_hash(line: int, column: int, text: str, before: str) -> Iterator[_Comment]:
    """A comment that begins with `#`; another tool may have its own directive before ours."""
    start = _IN_HASH.search(text)
    if start is not None:
        yield _Comment(line, column + start.start() + 1, line, text[start.end() :], not before.strip())


def _of_python(text: str) -> Iterator[_Comment]:
    import tokenize  # only where a file has such a word

    lines = text.split("\n")
    try:
        for token in tokenize.generate_tokens(io.StringIO(text).readline):
            if token.type == tokenize.COMMENT and _WORD in token.string:
                row, column = token.start
                yield from _of_hash(row, column, token.string, lines[row - 1][:column])
    except (tokenize.TokenError, SyntaxError, RecursionError, ValueError):
        return  # RW001 tells; what was read until here holds


def _of_xml(text: str) -> Iterator[_Comment]:
    """One pass: what nothing closes ends it, for such a file is no XML."""
    line, line_start, before = 1, 0, 0
    opener = _XML_OPENERS.search(text)
    while opener is not None:
        closer = _XML_CLOSERS[opener.group()]
        close = text.find(closer, opener.end())
        if close < 0:
            return
        start, end = opener.start(), close + len(closer)
        line += text.count("\n", before, start)
        line_start = max(line_start, text.rfind("\n", before, start) + 1)
        content = text[opener.end() : close]
        height = content.count("\n")
        if closer == "-->" and _WORD in content:
            first = before <= line_start and not text[line_start:start].strip()
            alone = first and _REST_OF_LINE.match(text, end) is not None
            yield _Comment(line, start - line_start + 1, line + height, content.strip(), alone)
        line += height
        if height:
            line_start = opener.end() + content.rfind("\n") + 1
        before = end
        opener = _XML_OPENERS.search(text, end)


def _of_cpp(text: str) -> Iterator[_Comment]:
    line, before = 1, 0
    for match in _OF_CPP.finditer(text):
        said = match["line"] if match["line"] is not None else match["block"]
        if said is None or _WORD not in said:
            continue
        line += text.count("\n", before, match.start())
        before = match.start()
        column = before - (text.rfind("\n", 0, before) + 1) + 1
        alone = not text[before - column + 1 : before].strip() and _REST_OF_LINE.match(text, match.end()) is not None
        yield _Comment(line, column, line + match[0].count("\n"), said.strip(), alone)


def _of_yaml(text: str) -> Iterator[_Comment]:
    if len(text) > limits.COMMENT_YAML_TEXT or _depth(text) > limits.YAML_DEPTH:
        return
    inside = _scalar_spans(text)
    for number, line in enumerate(text.split("\n"), 1):
        if _WORD not in line:
            continue
        spans = iter(inside.get(number, ()))
        span = next(spans, None)
        for match in _HASH.finditer(line):
            while span is not None and span[1] <= match.start():
                span = next(spans, None)
            if span is None or match.start() < span[0]:
                yield from _of_hash(number, match.start(), line[match.start() :], line[: match.start()])
                break


def _depth(text: str) -> int:
    """How deep brackets are nested, at most: the scanner looks at each open one for each token."""
    depth = deepest = 0
    for bracket in _BRACKET.finditer(text):
        depth = depth + 1 if bracket.group() in "[{" else max(depth - 1, 0)
        deepest = max(deepest, depth)
    return deepest


def _scalar_spans(text: str) -> dict[int, list[tuple[int, int]]]:
    """For each line, the columns that belong to a scalar. Where the text is no YAML, all lines from there on belong to one."""
    import yaml  # as above

    found: dict[int, list[tuple[int, int]]] = {}
    last, longest = 1, len(text) + 1
    try:
        for token in yaml.scan(text, Loader=yaml.SafeLoader):
            last = token.end_mark.line + 1
            if isinstance(token, yaml.ScalarToken):
                first = token.start_mark.line + 1
                for line in range(first, last + 1):
                    start = token.start_mark.column if line == first else 0
                    end = token.end_mark.column if line == last else longest
                    if end > start:
                        found.setdefault(line, []).append((start, end))
    except (yaml.YAMLError, RecursionError, ValueError):
        for line in range(last, text.count("\n") + 2):
            found[line] = [(0, longest)]
    return found
