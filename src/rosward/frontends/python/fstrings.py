# SPDX-License-Identifier: Apache-2.0
"""How does a Python before 3.12 read the f-strings of PEP 701?

    f"{names["left"]}"    quotes of the same kind, backslashes, comments and line ends in a field

Each literal, with the literals beside it, gives its place to a name of the same length, so lines and columns stay; the rest is parsed as it
is, and the name becomes the f-string again: its parts are found here, its expressions are parsed by themselves, and may hold others.
"""

from __future__ import annotations

import ast
import re
from bisect import bisect_right
from collections.abc import Callable
from typing import Final

from rosward.records import NamedTuple

__all__ = ["parse_with_fstrings"]

_START: Final = re.compile(r"(?:(?<!\w)([rRbBuUfF]{1,2}))?('''|\"\"\"|'|\")")
_MEANS: Final = re.compile(r"(?:(?<!\w)[rRbBuUfF]{1,2})?['\"]|[#()\[\]{}]")
"""The next of what begins a literal, a comment or a bracket, or ends one."""

_BETWEEN: Final = re.compile(r"(?:[ \t\f]|\\\n|\n|#[^\n]*)*")
_ON_ONE_LINE: Final = re.compile(r"(?:[ \t\f]|\\\n)*")
_NAME: Final = "_fstring"
_ESCAPED: Final = re.compile(r'(\\.)|"', re.DOTALL)
_MOST_NESTED: Final = 40

Parse = Callable[[str], ast.Expression]


class _WrongError(Exception):
    """The text is no f-string of any Python."""


class _Field(NamedTuple):
    """`{expression!r:spec}`; `shown` is the text that `=` puts before it."""

    start: int
    text: str
    shown: str
    conversion: int
    spec: tuple[_Part, ...] | None


class _Literal(NamedTuple):
    """What stands between fields, as it is written."""

    text: str


_Part = _Literal | _Field


class _String(NamedTuple):
    """A string literal from `start` to `end`; one that is no f-string has no parts."""

    start: int
    end: int
    prefix: str
    parts: tuple[_Part, ...] | None


def parse_with_fstrings(text: str, parse: Callable[[str], ast.Module], depth: int = 0) -> ast.Module | None:
    """The tree of a text; None where it has no f-string, or is wrong all the same. `parse` raises SyntaxError."""
    if depth > _MOST_NESTED:
        return None
    try:
        runs = _runs(text)
        if not runs:
            return None
        names = {f"{_NAME}{number}": run for number, run in enumerate(runs)}
        tree = parse(_with_names(text, names))
        builder = _Builder(text, names, parse, depth)
        changed = builder.visit(tree)
    except (_WrongError, SyntaxError, ValueError, RecursionError, MemoryError):
        return None
    assert isinstance(changed, ast.Module)
    return changed if not builder.waiting else None


def _with_names(text: str, names: dict[str, list[_String]]) -> str:
    """The text with a name in the place of each run; what does not fit into one line is put into brackets."""
    pieces, at = [], 0
    for name, run in names.items():
        start, end = run[0].start, run[-1].end
        lines = text[start:end].split("\n")
        if len(lines) == 1:
            place = name.ljust(_width(lines[0]))
        else:
            place = f"({name}" + "\n" * (len(lines) - 1) + ")".rjust(_width(lines[-1]))
        pieces += [text[at:start], place]
        at = end
    return "".join([*pieces, text[at:]])


def _width(text: str) -> int:
    """Columns are counted in bytes."""
    return len(text.encode("utf-8", "surrogatepass"))


def _runs(text: str) -> list[list[_String]]:
    """The literals that stand beside each other, where one of them is an f-string."""
    found: list[list[_String]] = []
    run: list[_String] = []
    at, depth = 0, 0
    while (means := _MEANS.search(text, at)) is not None:
        at = means.start()
        character = text[at]
        match = _START.match(text, at)
        if match is not None:
            string = _string(text, match)
            run.append(string)
            at = string.end
            behind = (_BETWEEN if depth else _ON_ONE_LINE).match(text, at)
            following = behind.end() if behind is not None else at
            if _START.match(text, following) is not None:
                at = following
                continue
            if any(each.parts is not None for each in run):
                found.append(run)
            run = []
        elif character == "#":
            at = _line_end(text, at)
        else:
            depth += (character in "([{") - (character in ")]}")
            at += 1
    return found


def _line_end(text: str, at: int) -> int:
    end = text.find("\n", at)
    return len(text) if end < 0 else end


def _string(text: str, match: re.Match[str]) -> _String:
    prefix, quote = (match[1] or "").lower(), match[2]
    at = match.end()
    if "f" in prefix:
        parts, end = _parts(text, at, quote, raw="r" in prefix)
        return _String(match.start(), end, prefix, parts)
    while not text.startswith(quote, at):
        if at >= len(text) or (text[at] == "\n" and len(quote) == 1):
            raise _WrongError
        at += 2 if text[at] == "\\" else 1
    return _String(match.start(), at + len(quote), prefix, None)


def _parts(text: str, at: int, quote: str, *, raw: bool, spec: bool = False) -> tuple[tuple[_Part, ...], int]:
    """The parts up to the quote, or up to the bracket that ends a format; and where they end."""
    parts: list[_Part] = []
    begin = at
    while at < len(text):
        if text.startswith(quote, at) or (spec and text[at] == "}"):
            parts.append(_Literal(text[begin:at]))
            return tuple(parts), at if spec else at + len(quote)
        if text.startswith("\\N{", at) and not raw:
            at = text.find("}", at) + 1 or len(text)
        elif text[at] == "\\":
            at += 1 if text[at + 1 : at + 2] in ("{", "}") else 2
        elif not spec and text[at : at + 2] in ("{{", "}}"):
            at += 2
        elif text[at] == "{":
            parts.append(_Literal(text[begin:at]))
            field, at = _field(text, at + 1, quote, raw=raw)
            parts.append(field)
            begin = at
        elif text[at] == "}" or (text[at] == "\n" and len(quote) == 1):
            raise _WrongError
        else:
            at += 1
    raise _WrongError


def _field(text: str, start: int, quote: str, *, raw: bool) -> tuple[_Field, int]:
    """The field that begins behind its bracket, and where it ends."""
    at, depth = start, 0
    while at < len(text):
        character = text[at]
        match = _START.match(text, at)
        if match is not None:
            at = _string(text, match).end
        elif character == "#":
            at = _line_end(text, at)
        elif not depth and (character in ":}" or (character == "!" and text[at + 1 : at + 2] != "=")):
            break
        elif character == "!":
            at += 2
        else:
            depth += (character in "([{") - (character in ")]}")
            at += 1
    inner, shown = text[start:at], ""
    debug = re.search(r"(?<![=<>!:])=\s*\Z", inner)
    if debug is not None:
        inner, shown = inner[: debug.start()], inner
    conversion = -1
    if text[at : at + 1] == "!":
        chosen = re.compile(r"!\s*([rsa])\s*").match(text, at)
        if chosen is None:
            raise _WrongError
        conversion, at = ord(chosen[1]), chosen.end()
    spec = None
    if text[at : at + 1] == ":":
        spec, at = _parts(text, at + 1, quote, raw=raw, spec=True)
    if text[at : at + 1] != "}" or not inner.strip():
        raise _WrongError
    if shown and conversion == -1 and spec is None:
        conversion = ord("r")
    return _Field(start, inner, shown, conversion, spec), at + 1


class _Builder(ast.NodeTransformer):
    """Puts the f-strings in the place of their names."""

    def __init__(
        self, text: str, names: dict[str, list[_String]], parse: Callable[[str], ast.Module], depth: int
    ) -> None:
        self.waiting = set(names)
        self._text = text
        self._lines = [0, *(match.end() for match in re.finditer("\n", text))]
        self._names = names
        self._parse = parse
        self._depth = depth

    def visit_Name(self, node: ast.Name) -> ast.AST:
        """One that stands for f-strings becomes them."""
        run = self._names.get(node.id)
        if run is None or not isinstance(node.ctx, ast.Load):
            return node
        self.waiting.discard(node.id)
        values: list[ast.expr] = []
        for string in run:
            if string.parts is None:
                values.append(self._literal(self._text[string.start : string.end]))
            else:
                values += self._values(string.parts, raw="r" in string.prefix)
        built = ast.copy_location(ast.JoinedStr(values), node)
        for each in ast.walk(built):
            if not hasattr(each, "lineno"):
                ast.copy_location(each, node)
        return built

    def _values(self, parts: tuple[_Part, ...], *, raw: bool, spec: bool = False) -> list[ast.expr]:
        values: list[ast.expr] = []
        for part in parts:
            if isinstance(part, _Field):
                if part.shown:
                    values.append(ast.Constant(part.shown))
                values.append(self._formatted(part, raw=raw))
            elif part.text:
                kept = part.text if spec else part.text.replace("{{", "{").replace("}}", "}")
                values.append(ast.Constant(kept) if raw else self._literal(f'"""{_ESCAPED.sub(_quoted, kept)}"""'))
        return values

    def _formatted(self, field: _Field, *, raw: bool) -> ast.expr:
        text = f"({field.text}\n)"
        try:
            tree = self._parse(text)
        except SyntaxError:
            found = parse_with_fstrings(text, self._parse, self._depth + 1)
            if found is None:
                raise
            tree = found
        if len(tree.body) != 1 or not isinstance(tree.body[0], ast.Expr):
            raise _WrongError
        value = tree.body[0].value
        line = bisect_right(self._lines, field.start) - 1
        column = _width(self._text[self._lines[line] : field.start]) - 1
        for each in ast.walk(value):
            if isinstance(each, (ast.expr, ast.keyword, ast.arg)):
                each.col_offset += column if each.lineno == 1 else 0
                each.end_col_offset = (each.end_col_offset or 0) + (column if each.end_lineno == 1 else 0)
                each.lineno += line
                each.end_lineno = (each.end_lineno or 1) + line
        spec = None if field.spec is None else ast.JoinedStr(self._values(field.spec, raw=raw, spec=True))
        return ast.FormattedValue(value, field.conversion, spec)

    @staticmethod
    def _literal(text: str) -> ast.Constant:
        value = ast.literal_eval(text)
        if not isinstance(value, str):
            raise _WrongError
        return ast.Constant(value)


def _quoted(match: re.Match[str]) -> str:
    return match[1] or '\\"'
