# SPDX-License-Identifier: Apache-2.0
"""How can a Python that is older than a file read it?

    type Pair = tuple[int, int]      (    Pair)= tuple[int, int]        PEP 695, Python 3.12
    def first[T](x: T) -> T: …       def first   (x: T) -> T: …         PEP 695, its defaults (PEP 696) too
    class Box[T](Base): …            class Box   (Base): …
    except OSError, ValueError:      except(OSError, ValueError):       PEP 758, Python 3.14

The forms are rewritten token by token into older ones of the same length, so lines and columns stay. That is done only where Python's own
parser refuses the text: what it reads, it reads itself. Type parameters mean nothing for what a program does.
"""

from __future__ import annotations

import io
import token
import tokenize
from collections.abc import Sequence
from typing import Final

_OPEN: Final = ("(", "[", "{")
_CLOSED: Final = (")", "]", "}")
_SPACE: Final = frozenset({token.NEWLINE, token.INDENT, token.DEDENT, token.ENCODING, tokenize.NL, token.COMMENT})

Token = tokenize.TokenInfo


def older(text: str) -> str | None:
    """The text in forms that older Pythons know; None where there is nothing to rewrite."""
    try:
        tokens = [t for t in tokenize.generate_tokens(io.StringIO(text).readline) if t.type != tokenize.NL]
    except (tokenize.TokenError, SyntaxError, RecursionError):
        return None
    lines = [list(line) for line in io.StringIO(text)]
    changed = False
    for index, each in enumerate(tokens):
        if each.type != token.NAME:
            continue
        begins = _begins(tokens, index)
        if each.string in ("def", "class") and _text(tokens, index + 2) == "[":
            end = _closing(tokens, index + 2)
            changed = (end is not None and _blank(lines, tokens[index + 2].start, tokens[end].end)) or changed
        elif begins and each.string == "type" and tokens[index + 1].type == token.NAME:
            changed = _alias(lines, tokens, index) or changed
        elif begins and each.string == "except":
            changed = _exceptions(lines, tokens, index) or changed
    return "".join("".join(line) for line in lines) if changed else None


def _begins(tokens: Sequence[Token], index: int) -> bool:
    """Whether a statement begins here."""
    return index == 0 or tokens[index - 1].type in _SPACE or tokens[index - 1].string in (";", ":")


def _text(tokens: Sequence[Token], index: int) -> str:
    return tokens[index].string if index < len(tokens) else ""


def _closing(tokens: Sequence[Token], index: int) -> int | None:
    """The bracket that closes the one at `index`."""
    depth = 0
    for number in range(index, len(tokens)):
        string = tokens[number].string
        if tokens[number].type == token.OP and string in _OPEN:
            depth += 1
        elif tokens[number].type == token.OP and string in _CLOSED:
            depth -= 1
            if not depth:
                return number
    return None


def _blank(lines: list[list[str]], start: tuple[int, int], end: tuple[int, int]) -> bool:
    """Put spaces in the place of a piece of text; line ends within brackets are joined by a backslash."""
    for line in range(start[0], end[0] + 1):
        row = lines[line - 1]
        first = start[1] if line == start[0] else 0
        last = end[1] if line == end[0] else len(row) - 1
        row[first:last] = " " * (last - first)
        if line != end[0]:
            row[last:last] = "\\"
    return True


def _alias(lines: list[list[str]], tokens: Sequence[Token], index: int) -> bool:
    """`type X[T] = value` as `(    X   )= value`."""
    behind = index + 2
    if _text(tokens, behind) == "[":
        end = _closing(tokens, behind)
        if end is None:
            return False
        behind = end + 1
    if _text(tokens, behind) != "=":
        return False
    if behind > index + 2:
        _blank(lines, tokens[index + 2].start, tokens[behind - 1].end)
    (line, column), (last, equals) = tokens[index].start, tokens[behind].start
    row = lines[last - 1]
    if row[equals - 1] == " ":
        row[equals - 1] = ")"
    else:
        row[equals:equals] = ")"
    lines[line - 1][column : column + 4] = "(   "
    return True


def _exceptions(lines: list[list[str]], tokens: Sequence[Token], index: int) -> bool:
    """`except A, B:` as `except(A, B):`. Names in small letters are those of Python 2's `except A, error:`."""
    end = index + 1
    names = True
    while _text(tokens, end) not in (":", ""):
        each = tokens[end]
        names = names and (each.type == token.NAME or each.string in (",", "."))
        end += 1
    inside = tokens[index + 1 : end]
    last = [t.string for n, t in enumerate(inside) if n + 1 == len(inside) or inside[n + 1].string == ","]
    if not names or len(last) < 2 or any(t.string == "as" for t in inside):
        return False
    if not all(name[:1].isupper() for name in last if name != ","):
        return False
    line, column = tokens[end].start
    lines[line - 1][column:column] = ")"
    line, column = tokens[index].end
    lines[line - 1][column] = "("
    return True
