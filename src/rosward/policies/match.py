# SPDX-License-Identifier: Apache-2.0
"""Which names does a pattern of DDS permissions match, does one pattern cover another, can both match one name?

    Pattern("rt/robot_*/cmd").matches("rt/robot_1/arm/cmd")     True: * also matches /
    Pattern("rt/robot_*").covers(Pattern("rt/robot_*/cmd"))     True
    Pattern("rt/*/cmd").meets(Pattern("rt/robot_*"))            True

It is `fnmatch` as Fast DDS and Cyclone DDS have it: `*`, `?`, `[a-z]`, `[!a-z]`, no escapes, nothing special about `/`.
A pattern is an automaton in line; a set of its states is an integer, so that no pattern makes matching slow.
"""

from __future__ import annotations

import string
from typing import Final, final

from rosward.records import NamedTuple

__all__ = ["LONGEST_NAME", "Pattern", "is_pattern"]

LONGEST_NAME: Final = 512
"""A name on DDS has 255 characters at most."""

_ROS: Final = frozenset(string.ascii_letters + string.digits + "_/")
_MOST_PAIRS: Final = 5_000


class _Token(NamedTuple):
    """One place of a pattern: any text, or one character of a set (or not of it)."""

    star: bool
    characters: frozenset[str] = frozenset()
    negated: bool = False

    def takes(self, character: str) -> bool:
        return (character in self.characters) is not self.negated


_STAR: Final = _Token(star=True)
_ANY: Final = _Token(star=False, negated=True)


def is_pattern(text: str) -> bool:
    """Whether anything in the text may stand for more than itself."""
    return any(c in text for c in "*?[")


@final
class Pattern:
    """A pattern, ready to be compared."""

    __slots__ = ("_moves", "_stars", "_tokens", "prefix", "text", "wild")

    def __init__(self, text: str) -> None:
        self.text = text
        self.wild = is_pattern(text)
        self._tokens = _tokens(text) if self.wild else tuple(_Token(False, frozenset(c)) for c in text)
        cut = min((i for i in map(text.find, "*?[") if i >= 0), default=len(text))
        self.prefix = text[:cut]
        self._stars = sum(1 << i for i, token in enumerate(self._tokens) if token.star)
        self._moves: dict[str, int] = {}

    def matches(self, name: str) -> bool:
        """Whether DDS would say so of this name."""
        if not self.wild:
            return name == self.text
        if not name.startswith(self.prefix):
            return False
        states = self._start()
        for character in name:
            states = self._step(states, character)
            if not states:
                return False
        return self._ends(states)

    def covers(self, other: Pattern) -> bool:
        """Whether it matches each name that the other matches; no where that is too much work to tell."""
        if self.text == other.text:
            return True
        if not other.wild:
            return self.matches(other.text)
        if not other.prefix.startswith(self.prefix):
            return False
        letters = self._letters(other)
        todo = [(other._start(), self._start())]
        seen = set(todo)
        for theirs, ours in todo:
            if other._ends(theirs) and not self._ends(ours):
                return False
            for letter in letters:
                pair = other._step(theirs, letter), self._step(ours, letter)
                if pair[0] and pair not in seen:
                    if len(seen) >= _MOST_PAIRS:
                        return False
                    seen.add(pair)
                    todo.append(pair)
        return True

    def meets(self, other: Pattern) -> bool:
        """Whether some name is matched by both."""
        if not other.wild:
            return self.matches(other.text)
        if not self.wild:
            return other.matches(self.text)
        short = min(len(self.prefix), len(other.prefix))
        return self.prefix[:short] == other.prefix[:short] and self._meet(other)

    def _meet(self, other: Pattern) -> bool:
        """Row by row from the end: whether what is left of both can be the same text."""
        letters = self._letters(other)
        ours = [frozenset(c for c in letters if not t.star and t.takes(c)) for t in self._tokens]
        theirs = [frozenset(c for c in letters if not t.star and t.takes(c)) for t in other._tokens]
        size = len(theirs)
        below = [all(t.star for t in other._tokens[j:]) for j in range(size + 1)]
        for i in range(len(ours) - 1, -1, -1):
            star = self._tokens[i].star
            row = [False] * (size + 1)
            row[size] = star and below[size]
            for j in range(size - 1, -1, -1):
                if star or other._tokens[j].star:
                    row[j] = below[j] or row[j + 1]
                else:
                    row[j] = below[j + 1] and not ours[i].isdisjoint(theirs[j])
            below = row
        return below[0]

    def _letters(self, other: Pattern) -> list[str]:
        """One character for each way in which characters of names differ for the two."""
        named = frozenset(c for p in (self, other) for t in p._tokens for c in t.characters)
        kinds = {(self._move(c), other._move(c)): c for c in sorted(_ROS | named)}
        return list(kinds.values())

    def _start(self) -> int:
        return 1 | ((1 & self._stars) << 1)

    def _step(self, states: int, character: str) -> int:
        states = (states & self._stars) | ((states & self._move(character)) << 1)
        return states | ((states & self._stars) << 1)

    def _ends(self, states: int) -> bool:
        return bool(states >> len(self._tokens) & 1)

    def _move(self, character: str) -> int:
        known = self._moves.get(character)
        if known is None:
            known = sum(1 << i for i, t in enumerate(self._tokens) if not t.star and t.takes(character))
            self._moves[character] = known
        return known


def _tokens(text: str) -> tuple[_Token, ...]:
    tokens: list[_Token] = []
    at = 0
    while at < len(text):
        character = text[at]
        at += 1
        if character == "*":
            if not tokens or not tokens[-1].star:
                tokens.append(_STAR)
        elif character == "?":
            tokens.append(_ANY)
        elif character == "[" and (end := text.find("]", at + (2 if text[at : at + 1] in ("!", "^") else 1))) > 0:
            tokens.append(_bracket(text[at:end]))
            at = end + 1
        else:
            tokens.append(_Token(False, frozenset(character)))
    return tuple(tokens)


def _bracket(inside: str) -> _Token:
    negated = inside[0] in "!^"
    inside = inside[1:] if negated else inside
    characters: set[str] = set()
    at = 0
    while at < len(inside):
        if at + 2 < len(inside) and inside[at + 1] == "-":
            last = min(ord(inside[at + 2]), 0x7F)
            characters.update(map(chr, range(ord(inside[at]), last + 1)))
            at += 3
        else:
            characters.add(inside[at])
            at += 1
    return _Token(False, frozenset(characters), negated)
