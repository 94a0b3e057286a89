# SPDX-License-Identifier: Apache-2.0
"""What stands for the branches of a condition that nobody knows, where these are no whole statements?

#if VERSION >= 52
  if (!off || mode == 3) {                   if (__rosward_either(!off || mode == 3, !off)) {
#else
  if (!off) {
#endif

sub_{
#ifdef INTERFACES                            sub_{__rosward_either(Required{*this}, this), "image"}
  Required{*this},
#else
  this,
#endif
  "image"}

  || late                                    || __rosward_either(late, false)
} else if (late) {…                          } else if (__rosward_either(late, false)) {…
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Final

from rosward.frontends.cpp.macros import EITHER
from rosward.frontends.cpp.tokens import LITERAL, tokens, trimmed

__all__ = ["merged"]

_OPENING: Final = {"(": ")", "[": "]", "{": "}"}
_CLOSING: Final = frozenset(_OPENING.values())
_NEUTRAL: Final = {"||": "false", "&&": "true"}
_STARTS: Final = frozenset({"return", "=", ",", "(", "{", "[", ":"})
"""What stands before an expression that is whole."""
_NO_BEGINNING: Final = frozenset(
    {"||", "&&", "<<", ">>", "*", "/", "%", "==", "!=", "<=", ">=", "<", ">", "=", ".", "->", "::", "?", ":", "|", "^"}
)
_NO_END: Final = _NO_BEGINNING | {"+", "-", "&", "!", "~"}
_PARAMETERS: Final = frozenset({"]", "catch"})
"""Before parentheses in which something is declared."""
_MOST: Final = 2_000
"""So many tokens are compared."""


def merged(branches: Sequence[str], before: str, *, complete: bool) -> str | None:
    """One text that is each of the branches, behind what stands `before`; with `complete`, one of them is taken. None where there is none."""
    written = [trimmed(tokens(branch)) for branch in branches]
    if not all(written) or any(len(each) > _MOST for each in written):
        return None
    if len(written) == 1 and not complete:
        return _optional(written[0])
    return _one_of(written, before) if len(written) > 1 and complete else None


def _one_of(written: Sequence[list[str]], before: str) -> str | None:
    """The parts in which the branches differ, as whole expressions, between what they have in common."""
    first = written[0]
    least = min(map(len, written))
    same = next((n for n in range(least) if any(each[n] != first[n] for each in written)), least)
    last = next((n for n in range(least) if any(each[-1 - n] != first[-1 - n] for each in written)), least)
    reach = [len(each) - min(last, least - same) for each in written]
    start = same + 1
    while start:
        start = _start(first, min(same, start - 1))
        found = _between(written, start, reach)
        if found is not None:
            return found if _is_within(f"{before} {''.join(first[:start])}") else None
    return None


def _between(written: Sequence[list[str]], start: int, reach: Sequence[int]) -> str | None:
    """The text where what differs begins at `start`, and goes to `reach` at least."""
    first = written[0]
    ends = [_end(each, start, least) for each, least in zip(written, reach, strict=True)]
    if any(each[end:] != first[ends[0] :] for each, end in zip(written, ends, strict=True)):
        return None
    parts = [trimmed(each[start:end]) for each, end in zip(written, ends, strict=True)]
    before = [token for token in first[:start] if token != " "][-2:]
    if (before[-1:] == ["("] and before[0] in _PARAMETERS) or not all(map(_is_expression, parts)):
        return None
    either = ", ".join("".join(part) for part in parts)
    return f"{''.join(first[:start])}{EITHER}({either}){''.join(first[ends[0] :])}"


def _is_within(before: str) -> bool:
    """Whether what begins behind a text is an expression: no member that is initialised, no enumerator, and nothing that is declared."""
    text = _LITERAL.sub('""', before).rstrip()
    if text.endswith(_LEADING) or _RETURN.search(text):
        return True
    depth = 0
    for at in range(len(text) - 1, -1, -1):
        depth += (text[at] in ")]}") - (text[at] in "([{")
        if depth < 0:
            around = re.split(r"[;{}]", text[:at])[-1].rstrip()
            return text[at] != "{" or (bool(_BRACED.search(around)) and not _BLOCK.search(around))
    return False


_LITERAL: Final = re.compile(LITERAL)
_LEADING: Final = ("=", "?", "&&", "||", "<<", "+", "-", "*", "/", "(", "[")
_RETURN: Final = re.compile(r"\breturn$")
_BRACED: Final = re.compile(r"[\w>=,(]$")
"""What stands before braces that hold values."""
_BLOCK: Final = re.compile(r"\b(?:enum|class|struct|union|namespace|extern|else|do|try)\b")


def _start(written: Sequence[str], same: int) -> int:
    """Where the expression begins in which token `same` is."""
    depth = 0
    for n in range(same - 1, -1, -1):
        if written[n] in _CLOSING:
            depth += 1
        elif written[n] in _OPENING and depth:
            depth -= 1
        elif not depth and written[n] in _STARTS:
            return n + 1
    return 0


def _end(written: Sequence[str], start: int, least: int) -> int:
    """Where the expression ends that begins at `start` and goes to `least` at least."""
    depth = 0
    for n in range(start, len(written)):
        token = written[n]
        if token in _OPENING:
            depth += 1
        elif token in _CLOSING:
            depth -= 1
            if depth < 0:
                return n
        elif not depth and n >= least and token in (",", ";"):
            return n
    return len(written)


def _is_expression(part: Sequence[str]) -> bool:
    """Whether tokens are one operand of a call: all brackets closed, no statement, and no comma between them."""
    part = [" ", *part]
    if len(part) == 1 or part[1] in _NO_BEGINNING | {"const"} or part[-1] in _NO_END:
        return False
    around: list[str] = []
    for token in part:
        if token in _OPENING:
            around.append(_OPENING[token])
        elif token in _CLOSING:
            if not around or around.pop() != token:
                return False
        elif token == ";" or (token == "," and not around):
            return False
    return not around and not any(map(_declares, part, part[1:], part[2:], part[3:]))


def _declares(one: str, two: str, three: str, four: str) -> bool:
    """Whether four tokens in a row are the end of a type and a name."""
    if three != " " or not four.isidentifier() or four in _WORDS:
        return False
    return (two.isidentifier() and two not in _WORDS) or (two == ">" and one != " ")


_WORDS: Final = frozenset(
    {
        "new",
        "and",
        "or",
        "not",
        "const",
        "sizeof",
        "template",
        "typename",
        "throw",
        "unsigned",
        "long",
        "return",
        "not_eq",
        "constexpr",
        "co_await",
        "for",
        "if",
        "else",
    }
)


def _optional(written: list[str]) -> str | None:
    """What may stand there or not: another operand of a condition, or more branches of one."""
    neutral = _NEUTRAL.get(written[0])
    if neutral is not None:
        part = trimmed(written[1:])
        return f"{written[0]} {EITHER}({''.join(part)}, {neutral})" if _is_expression(part) else None
    return _more_branches(written)


def _more_branches(written: list[str]) -> str | None:
    """`} else if (a) { … } else if (b) { …`, with conditions that may not hold."""
    made: list[str] = []
    depth = n = 0
    while n < len(written):
        token = written[n]
        depth += (token in _OPENING) - (token in _CLOSING)
        made.append(token)
        n += 1
        if depth < -1:
            return None
        if depth >= 0 or token != "}":
            continue
        words = [t for t in written[n : n + 6] if t != " "][:3]
        if words != ["else", "if", "("]:
            return None
        start = written.index("(", n) + 1
        end = _end(written, start, len(written))
        if not _is_expression(written[start:end]):
            return None
        made += [" else if (", EITHER, "(", *written[start:end], ", false)", ")"]
        n = end + 1
    return "".join(made) if made and not depth else None
