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
    {
        "||",
        "&&",
        "<<",
        ">>",
        "*",
        "/",
        "%",
        "==",
        "!=",
        "<=",
        ">=",
        "<",
        ">",
        "=",
        ".",
        "->",
        "::",
        "?",
        ":",
        "|",
        "^",
        "{",
    }
)
_BINDING: Final = frozenset({"+", "-", "*", "/", "%", "<<", ">>", "<", ">", "<=", ">=", "==", "!=", "&", "^", "|"})
_LOOSE: Final = frozenset({"?", ":", "=", "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=", "<<=", ">>="})
_ANY: Final = _BINDING | _LOOSE | {"&&", "||", "and", "or"}
_NOT_BEHIND: Final = {"||": _LOOSE, "&&": _LOOSE | {"||", "or"}}
"""What stands in no operand of these."""
_WHOLE: Final = ("=", "?", ":", "(", "[", "{", ",", ";", "return")
"""Behind these an expression begins that goes to the next comma, or bracket."""
_NUMBER: Final = re.compile(r"[\d.][\w.']*")
_NO_END: Final = _NO_BEGINNING | {"+", "-", "&", "!", "~"}
_PARAMETERS: Final = frozenset({"]", "catch"})
"""Before parentheses in which something is declared."""
_MOST: Final = 2_000
"""So many tokens are compared."""


def merged(branches: Sequence[str], before: str, after: str, *, complete: bool) -> str | None:
    """One text that is each of the branches, between what stands `before` and `after` them; with `complete`, one of them is taken.

    None where there is none.
    """
    written = [trimmed(tokens(branch)) for branch in branches]
    if not all(written) or any(len(each) > _MOST for each in written):
        return None
    if len(written) == 1 and not complete:
        return _optional(written[0], _next(after))
    return _one_of(written, before, _next(after)) if len(written) > 1 and complete else None


def _next(after: str) -> str:
    """The token with which a text begins."""
    found = trimmed(tokens(after.lstrip()[:200]))
    return found[0] if found else ""


def _one_of(written: Sequence[list[str]], before: str, after: str) -> str | None:
    """The parts in which the branches differ, as whole expressions, between what they have in common."""
    first = written[0]
    least = min(map(len, written))
    same = next((n for n in range(least) if any(each[n] != first[n] for each in written)), least)
    last = next((n for n in range(least) if any(each[-1 - n] != first[-1 - n] for each in written)), least)
    reach = [len(each) - min(last, least - same) for each in written]
    start = same + 1
    while start:
        start = _start(first, min(same, start - 1))
        found = _between(written, start, reach, before if start == 0 else "(", after)
        if found is not None:
            return found if _is_within(f"{before} {''.join(first[:start])}") else None
    return None


def _between(written: Sequence[list[str]], start: int, reach: Sequence[int], before: str, after: str) -> str | None:
    """The text where what differs begins at `start`, and goes to `reach` at least."""
    first = written[0]
    ends = [_end(each, start, least) for each, least in zip(written, reach, strict=True)]
    if any(each[end:] != first[ends[0] :] for each, end in zip(written, ends, strict=True)):
        return None
    parts = [trimmed(each[start:end]) for each, end in zip(written, ends, strict=True)]
    last = [token for token in first[:start] if token != " "][-2:]
    if (last[-1:] == ["("] and last[0] in _PARAMETERS) or not all(map(_is_expression, parts)):
        return None
    if ends[0] < len(first):
        after = first[ends[0]]
    banned = _banned(before, after)
    if any(not banned.isdisjoint(_operators(part)) for part in parts) or _differ_as_numbers(parts):
        return None
    either = ", ".join("".join(part) for part in parts)
    return f"{''.join(first[:start])}{EITHER}({either}){''.join(first[ends[0] :])}"


def _banned(before: str, after: str) -> frozenset[str]:
    """Which operators may stand in no operand that is put there: with them, what is around it would take a part of it alone."""
    text = before.rstrip()
    behind = next((_NOT_BEHIND[sign] for sign in _NOT_BEHIND if text.endswith(sign)), _ANY)
    if text.endswith(_WHOLE) and not text.endswith(("==", "!=", "<=", ">=")):
        behind = frozenset()
    return behind | (frozenset() if after in _ENDS else _ANY)


_ENDS: Final = frozenset({",", ";", ")", "]", "}"})


def _operators(part: Sequence[str]) -> set[str]:
    """The operators with two operands that stand in no brackets."""
    found: set[str] = set()
    depth = 0
    for number, token in enumerate(part):
        depth += (token in _OPENING) - (token in _CLOSING)
        if number and not depth and token in _ANY:
            found.add(token)
    return found


def _differ_as_numbers(parts: Sequence[Sequence[str]]) -> bool:
    """Whether they are numbers of different types, or not all of them are: overloads are chosen by these."""
    kinds: set[object] = set()
    for part in parts:
        words = [token for token in part if token not in {" ", "-", "+"}]
        number = words[0] if len(words) == 1 and _NUMBER.fullmatch(words[0]) else ""
        kinds.add(("." in number, number.lstrip("0123456789.'xXabcdefABCDEF")) if number else None)
    return len(kinds) > 1


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


def _optional(written: list[str], after: str) -> str | None:
    """What may stand there or not: another operand of a condition, or more branches of one."""
    neutral = _NEUTRAL.get(written[0])
    if neutral is None:
        return _more_branches(written)
    part = trimmed(written[1:])
    if not _is_expression(part) or not _NOT_BEHIND[written[0]].isdisjoint(_operators(part)):
        return None
    is_end = after in _ENDS or after == written[0] or (after == "||" and written[0] == "&&")
    return f"{written[0]} {EITHER}({''.join(part)}, {neutral})" if is_end else None


def _more_branches(written: list[str]) -> str | None:
    """`} else if (a) { … } else if (b) { …`, or `else if (a) { … }`, with conditions that may not hold."""
    level = -1 if written[0] == "}" else 0
    made: list[str] = []
    depth = n = 0
    while n < len(written):
        token = written[n]
        if (n or level) and not (token == "else" and not level and not depth):
            depth += (token in _OPENING) - (token in _CLOSING)
            made.append(token)
            n += 1
            if depth < level:
                return None
            if depth > level or token != "}" or (not level and n == len(written)):
                continue
        words = [t for t in written[n : n + 7] if t != " "][:3]
        if words != ["else", "if", "("]:
            return None
        start = written.index("(", n) + 1
        end = _end(written, start, len(written))
        following = next((t for t in written[end + 1 :] if t != " "), "")
        if not _is_expression(written[start:end]) or (not level and following != "{"):
            return None
        made += [" else if (", EITHER, "(", *written[start:end], ", false)", ")"]
        n = end + 1
    return "".join(made) if made and not depth else None
