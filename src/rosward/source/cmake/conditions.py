# SPDX-License-Identifier: Apache-2.0
"""Does the condition of an `if` hold?

    if(BUILD_DRIVER AND NOT WIN32)      with option(BUILD_DRIVER "…" ON)     ->  True
    if(CMAKE_BUILD_TYPE STREQUAL "x")   nobody knows                        ->  None

The grammar is CMake's: primaries, then NOT, then AND, then OR, with parentheses. What is not understood is not known.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from typing import Final, Protocol, final

from rosward.records import NamedTuple
from rosward.source.cmake.lists import SET_OPERATION
from rosward.source.cmake.text import CMakeArgument
from rosward.source.cmake.variables import HOLE, Variables

_FALSE: Final = frozenset({"", "0", "OFF", "NO", "FALSE", "N", "IGNORE", "NOTFOUND"})
_TRUE: Final = frozenset({"1", "ON", "YES", "TRUE", "Y"})
_NUMBER: Final = re.compile(r"-?\d+(?:\.\d+)?")
_LIMIT: Final = 2_000  # tokens
_DEPTH: Final = 30


def truth(text: str) -> bool | None:
    """Whether a constant is true; None where it is no constant."""
    upper = text.upper()
    if upper in _TRUE:
        return True
    if upper in _FALSE or upper.endswith("-NOTFOUND"):
        return False
    return float(text) != 0 if _NUMBER.fullmatch(text) else None


class Surroundings(Protocol):
    """What conditions ask beside variables."""

    def has_command(self, name: str) -> bool | None:
        """Whether a command of that name is there."""

    def has_target(self, name: str) -> bool | None:
        """Whether a target of that name is there."""

    def has_path(self, path: str) -> bool | None:
        """Whether there is a file or folder."""

    def has_environment(self, name: str) -> bool | None:
        """Whether an environment variable is set."""


class _Word(NamedTuple):
    text: str
    quoted: bool


def holds(arguments: Sequence[CMakeArgument], variables: Variables, around: Surroundings) -> bool | None:
    """Whether the condition holds; None where nobody can say."""
    words: list[_Word] = []
    for argument in arguments:
        if argument.quoted or argument.literal:
            words.append(_Word(argument.text if argument.literal else variables.substitute(argument.text), quoted=True))
        else:
            words += [_Word(text, quoted=False) for text in variables.expand([argument])]
    if not words:
        return False
    if len(words) > _LIMIT:
        return None
    parser = _Condition(words, variables, around)
    result = parser.disjunction(0)
    return result if parser.at_end() else None


@final
class _Condition:
    """A condition in the course of being read; a recursive descent of bounded depth."""

    def __init__(self, words: list[_Word], variables: Variables, around: Surroundings) -> None:
        self._words = words
        self._variables = variables
        self._around = around
        self._position = 0

    def at_end(self) -> bool:
        return self._position >= len(self._words)

    def _is(self, text: str) -> bool:
        if not self.at_end():
            word = self._words[self._position]
            if not word.quoted and word.text == text:
                self._position += 1
                return True
        return False

    def disjunction(self, depth: int) -> bool | None:
        result = self._conjunction(depth)
        while self._is("OR"):
            other = self._conjunction(depth)
            result = True if result or other else None if result is None or other is None else False
        return result

    def _conjunction(self, depth: int) -> bool | None:
        result = self._negation(depth)
        while self._is("AND"):
            other = self._negation(depth)
            result = False if result is False or other is False else None if result is None or other is None else True
        return result

    def _negation(self, depth: int) -> bool | None:
        negated = False
        while self._is("NOT"):
            negated = not negated
        result = self._primary(depth)
        return result if result is None else result is not negated

    def _primary(self, depth: int) -> bool | None:
        if self.at_end() or depth > _DEPTH:
            return None
        if self._is("("):
            result = self.disjunction(depth + 1)
            return result if self._is(")") else None
        word = self._words[self._position]
        self._position += 1
        if not word.quoted and word.text in _QUESTIONS and not self.at_end() and self._next_is_operand():
            operand = self._words[self._position].text
            self._position += 1
            return None if HOLE in operand else _QUESTIONS[word.text](operand, self._variables, self._around)
        if not self.at_end():
            operator = self._words[self._position]
            if not operator.quoted and operator.text in _COMPARISONS and self._position + 1 < len(self._words):
                right = self._words[self._position + 1]
                self._position += 2
                return self._compare(word, operator.text, right)
        return self._truth(word)

    def _next_is_operand(self) -> bool:
        following = self._words[self._position]
        return following.quoted or following.text not in {"AND", "OR", ")", *_COMPARISONS}

    def _truth(self, word: _Word) -> bool | None:
        if HOLE in word.text:
            return None
        constant = truth(word.text)
        if constant is not None:
            return constant
        if word.quoted:
            return False
        value = self._variables.get(word.text)
        if HOLE in value:
            return None
        constant = truth(value)
        return bool(value) if constant is None else constant

    def _compare(self, left: _Word, operator: str, right: _Word) -> bool | None:
        first, second = self._operand(left), self._operand(right)
        if operator == "IN_LIST":
            first, second = self._operand(left), self._variables.get(right.text)
            if HOLE in first:
                return None
            found = first in second.split(";")
            return None if not found and HOLE in second else found
        if HOLE in first or HOLE in second:
            return None
        return _COMPARISONS[operator](first, second)

    def _operand(self, word: _Word) -> str:
        if not word.quoted and self._variables.is_set(word.text):
            return self._variables.get(word.text)
        return word.text


def _number(left: str, right: str, test: Callable[[float, float], bool]) -> bool:
    return bool(_NUMBER.fullmatch(left) and _NUMBER.fullmatch(right)) and test(float(left), float(right))


def _version(left: str, right: str, test: Callable[[list[int], list[int]], bool]) -> bool:
    first, second = ([int(p[:9]) for p in re.findall(r"\d+", text)[:8]] for text in (left, right))
    longest = max(len(first), len(second))
    return test(first + [0] * (longest - len(first)), second + [0] * (longest - len(second)))


def _simple_match(text: str, pattern: str) -> bool | None:
    """MATCHES, for patterns without repetition: anything else could take for ever."""
    if len(text) > 1_000 or len(pattern) > 200 or re.search(r"[*+{\\]|\(\?", pattern) or SET_OPERATION.search(pattern):
        return None
    try:
        return re.search(pattern, text) is not None
    except re.error:
        return None


_COMPARISONS: Final[Mapping[str, Callable[[str, str], bool | None]]] = {
    "STREQUAL": lambda a, b: a == b,
    "STRLESS": lambda a, b: a < b,
    "STRGREATER": lambda a, b: a > b,
    "PATH_EQUAL": lambda a, b: a == b,
    "EQUAL": lambda a, b: _number(a, b, lambda x, y: x == y),
    "LESS": lambda a, b: _number(a, b, lambda x, y: x < y),
    "GREATER": lambda a, b: _number(a, b, lambda x, y: x > y),
    "LESS_EQUAL": lambda a, b: _number(a, b, lambda x, y: x <= y),
    "GREATER_EQUAL": lambda a, b: _number(a, b, lambda x, y: x >= y),
    "VERSION_EQUAL": lambda a, b: _version(a, b, lambda x, y: x == y),
    "VERSION_LESS": lambda a, b: _version(a, b, lambda x, y: x < y),
    "VERSION_GREATER": lambda a, b: _version(a, b, lambda x, y: x > y),
    "VERSION_LESS_EQUAL": lambda a, b: _version(a, b, lambda x, y: x <= y),
    "VERSION_GREATER_EQUAL": lambda a, b: _version(a, b, lambda x, y: x >= y),
    "MATCHES": _simple_match,
    "IS_NEWER_THAN": lambda _a, _b: None,
    "IN_LIST": lambda _a, _b: None,  # answered where the variable is known
}


def _defined(name: str, variables: Variables, around: Surroundings) -> bool | None:
    if name.startswith("ENV{") and name.endswith("}"):
        return around.has_environment(name[4:-1])
    return None if HOLE in variables.get(name) else variables.is_set(name)


_QUESTIONS: Final[Mapping[str, Callable[[str, Variables, Surroundings], bool | None]]] = {
    "DEFINED": _defined,
    "TARGET": lambda name, _variables, around: around.has_target(name),
    "COMMAND": lambda name, _variables, around: around.has_command(name),
    "EXISTS": lambda path, _variables, around: around.has_path(path),
    "IS_DIRECTORY": lambda path, _variables, around: around.has_path(path),
    "IS_ABSOLUTE": lambda path, _variables, _around: path.startswith("/"),
    "POLICY": lambda _name, _variables, _around: True,
    "TEST": lambda _name, _variables, _around: False,
}
