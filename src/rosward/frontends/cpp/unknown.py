# SPDX-License-Identifier: Apache-2.0
"""Which words of a text are macros that nobody defined, and hide a declaration from the parser?

    class DEMO_PUBLIC Driver : public Base      ->  class             Driver : public Base
    DEMO_EXPORT explicit Driver(int x);         ->              explicit Driver(int x);
    DECLARE_PARAMETERS(Driver)                  ->  blank, and told: nobody knows what it declares
    int count_ DEMO_GUARDED_BY(mutex_) = 0;     ->  int count_                         = 0;

They are blanked, so that what stands around them stays where it is.
"""

from __future__ import annotations

import re
from typing import Final

from rosward.frontends.cpp.tokens import behind_bracket, blank
from rosward.records import NamedTuple

_VISIBILITY: Final = re.compile(
    r"\b[A-Z][A-Z0-9_]*_(?:PUBLIC|EXPORT|EXPORTS|LOCAL|API|IMPORT|HIDDEN|PUBLIC_TYPE|NO_EXPORT|DEPRECATED|INLINE|NODISCARD)\b(?!\s*(?:[(.,;=:)+\"<>|&*!?\-/%\]}]|\[(?!\[)))"
)
_CLASS: Final = re.compile(
    r"\b(?:class|struct|union)[ \t]+(?:\[\[[^\]\n]*\]\][ \t]*)?([A-Z][A-Z0-9_]{2,})(?=[ \t]+(?!final\b)[A-Za-z_])"
)
_BEFORE: Final = re.compile(
    r"^[ \t]*([A-Z][A-Z0-9_]{3,})(?=[ \t\n]+(?:explicit|virtual|static|inline|constexpr|void|bool|int|double|auto|class|template|std::)\b)",
    re.MULTILINE,
)
_CALL: Final = re.compile(r"^[ \t]*([A-Z][A-Z0-9_]{3,})[ \t]*\(", re.MULTILINE)
_THREADS: Final = re.compile(
    r"(?:(?<=[\w\]}])\s+(?:[A-Z][A-Z0-9]*_)*(?:GUARDED_BY|ACQUIRED_BEFORE|ACQUIRED_AFTER)"
    r"|(?:(?<=\))|(?<=const)|(?<=noexcept)|(?<=override)|(?<=final))\s+(?:[A-Z][A-Z0-9]*_)*"
    r"(?:REQUIRES|REQUIRES_SHARED|EXCLUDES|ASSERT_CAPABILITY|RETURN_CAPABILITY|LOCKS_REQUIRED|LOCKS_EXCLUDED|LOCK_RETURNED))\s*\("
)
"""What says to the compiler which mutex protects something; nothing runs because of it."""
_MARKS: Final = ("GUARDED_BY", "ACQUIRED_", "REQUIRE", "EXCLUDE", "CAPABILITY", "LOCK_RETURNED")
_CALL_LIMIT: Final = 20_000  # characters
_UNCLOSED: Final = 100
_GOES_ON: Final = re.compile(r"\s*[;{.\-+*/?:&|,)=<>\[\]]")
_DECLARED: Final = re.compile(r"\s*(?:[;={,]|[A-Z_]+\s*\()")
_ENDED: Final = re.compile(r"[;{}:]\s*\Z|\A\s*\Z")


class Blanked(NamedTuple):
    """A call of a macro that nobody defined, alone on its line."""

    name: str
    line: int


def without_unknown(text: str) -> tuple[str, list[Blanked]]:
    """The text with such words blanked, and the calls among them."""
    told: list[Blanked] = []
    if not any(
        mark in text
        for mark in ("_PUBLIC", "_EXPORT", "_LOCAL", "_API", "_IMPORT", "_HIDDEN", "_DEPRECATED", "_INLINE", "_NO")
    ):
        changed = text
    else:
        changed = _VISIBILITY.sub(_blank, text)
    changed = _without_attributes(_CLASS.sub(_blank_first, changed))
    changed = _BEFORE.sub(_blank_first, changed)
    pieces: list[str] = []
    position = unclosed = 0
    for call in _CALL.finditer(changed):
        if call.start() < position or not _ENDED.search(changed[max(position, call.start() - 200) : call.start()]):
            continue
        end = behind_bracket(changed, call.end(), _CALL_LIMIT)
        unclosed += end < 0
        if unclosed > _UNCLOSED:
            break
        if end < 0 or _GOES_ON.match(changed, end):
            continue
        told.append(Blanked(call[1], changed.count("\n", 0, call.start()) + 1))
        pieces += [changed[position : call.start()], blank(changed[call.start() : end])]
        position = end
    return "".join([*pieces, changed[position:]]), told


def _without_attributes(text: str) -> str:
    """The text without what stands between a declaration and its end to say which mutex protects it."""
    pieces: list[str] = []
    position = 0
    for found in _THREADS.finditer(text) if any(mark in text for mark in _MARKS) else ():
        end = behind_bracket(text, found.end(), _CALL_LIMIT) if found.start() >= position else -1
        if end >= 0 and _DECLARED.match(text, end):
            pieces += [text[position : found.start()], blank(text[found.start() : end])]
            position = end
    return "".join([*pieces, text[position:]])


def _blank(found: re.Match[str]) -> str:
    return blank(found[0])


def _blank_first(found: re.Match[str]) -> str:
    return found[0].replace(found[1], " " * len(found[1]), 1)
