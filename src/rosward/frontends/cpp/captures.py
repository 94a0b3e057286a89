# SPDX-License-Identifier: Apache-2.0
"""What does a lambda capture, said so that the grammar knows it, in the same width?

[node, own{std::move(name)}](int x) {}     [node, own=std::move(name) ](int x) {}
[&all(this->all)] {}                       [&all=this->all ] {}
{[&key = key](int i) {}}                   {[&key      ](int i) {}}
[this] [[nodiscard]] () {}                 [this]               () {}
"""

from __future__ import annotations

import re
from typing import Final

from rosward.frontends.cpp.tokens import blank

_INTRODUCED: Final = re.compile(
    r"(?:(?<![\w)\]\[\s])|\b(?:return|co_return|co_yield|co_await|throw|case)\b)\s*\[(?!\[)"
)
"""Where a lambda may begin: behind a name or a bracket, it would be an element of something."""
_FOLLOWS: Final = re.compile(r"\]\s*(?:[({<]|\[\[|->|(?:mutable|constexpr|consteval|static|noexcept|requires)\b)")
_MADE: Final = re.compile(r"(?:\s*(?:&\s*)?(?:\.\.\.\s*)?[A-Za-z_]\w*)(?=\s*([({]))\s*")
"""A variable of the lambda with what it is made of in brackets."""
_OTHER: Final = re.compile(r"[^][(){},;]*")
_CLOSING: Final = {"(": ")", "{": "}", "[": "]"}
_MOST: Final = 2_000
"""So long is what a lambda captures, at most."""
_UNCLOSED: Final = 100
_SAME: Final = re.compile(r"(?<=[\[,])(\s*&\s*)(\w+)(\s*=\s*\2\s*)(?=[,\]])")
"""A reference to a variable of the same name: in braces the grammar takes `[&key = key]` for a designator."""
_ATTRIBUTED: Final = re.compile(r"(?<=\])(\s*\[\[[^\[\]]{0,200}\]\])(?=\s*[({])")
"""What is said of the function of a lambda, before its parameters."""


def with_plain_captures(text: str) -> str:
    """The text with captures that the grammar reads; what is in literals must not look like one."""
    plain: dict[int, str] = {}
    unclosed = 0
    for found in _INTRODUCED.finditer(text):
        changes, end = _captures(text, found.end())
        unclosed += end < 0
        if unclosed > _UNCLOSED:
            break
        if changes and _FOLLOWS.match(text, end):
            for opened, closed in changes:
                plain[opened], plain[closed] = "=", " "
    text = _with_characters(text, plain) if plain else text
    text = _ATTRIBUTED.sub(lambda each: blank(each[0]), text)
    return _SAME.sub(lambda each: f"{each[1]}{each[2]}{blank(each[3])}", text)


def _with_characters(text: str, others: dict[int, str]) -> str:
    """The text with other characters at some positions."""
    pieces: list[str] = []
    position = 0
    for at in sorted(others):
        pieces += (text[position:at], others[at])
        position = at + 1
    return "".join([*pieces, text[position:]])


def _captures(text: str, start: int) -> tuple[list[tuple[int, int]], int]:
    """The brackets around what variables are made of, in a list of captures that begins at `start`, and where that ends;
    -1 where it does not."""
    changes: list[tuple[int, int]] = []
    at, most = start, min(len(text), start + _MOST)
    while at < most:
        made = _MADE.match(text, at)
        if made is not None:
            closed = _closing(text, made.end(), most)
            if closed < 0:
                return [], -1
            changes.append((made.end(), closed))
            at = closed + 1
        at = _end_of_capture(text, at, most)
        if at < most and text[at] != ",":
            return (changes if text[at] == "]" else []), at
        at += 1
    return [], -1


def _closing(text: str, opened: int, most: int) -> int:
    """Where the bracket at `opened` closes; -1 where it does not, or a statement ends before: that is no list of captures."""
    waiting = [_CLOSING[text[opened]]]
    at = opened + 1
    while at < most:
        character = text[at]
        if character in _CLOSING:
            waiting.append(_CLOSING[character])
        elif character in ")}]":
            if waiting.pop() != character:
                return -1
            if not waiting:
                return at
        at += 1
    return -1


def _end_of_capture(text: str, at: int, most: int) -> int:
    """The comma or bracket behind a capture; what stands in brackets is left out."""
    while at < most:
        found = _OTHER.match(text, at, most)
        at = found.end() if found is not None else at
        if at >= most or text[at] not in _CLOSING:
            return at
        at = _closing(text, at, most) + 1
        if not at:
            return most
    return at
