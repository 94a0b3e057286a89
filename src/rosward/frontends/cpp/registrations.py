# SPDX-License-Identifier: Apache-2.0
"""Which classes does a file register, for others to make by name?

RCLCPP_COMPONENTS_REGISTER_NODE(demo::Driver)     ->   a registration of demo::Driver, and nothing in the text
"""

from __future__ import annotations

import re
from typing import Final

from rosward.frontends.cpp.known import REGISTERING
from rosward.frontends.cpp.prepared import Registration
from rosward.frontends.cpp.tokens import behind_bracket

_REGISTER: Final = re.compile(rf"\b({'|'.join(sorted(REGISTERING))})\s*\(")
_LENGTH: Final = 2_000  # characters
_UNCLOSED: Final = 100


def registrations(text: str) -> tuple[str, list[Registration]]:
    """The text without the macros that register a class, and what they register."""
    found: list[Registration] = []
    pieces: list[str] = []
    position = unclosed = 0
    for match in _REGISTER.finditer(text):
        if match.start() < position:
            continue
        end = behind_bracket(text, match.end(), _LENGTH)
        if end < 0:
            unclosed += 1
            if unclosed > _UNCLOSED:
                break
            continue
        arguments = tuple(part.strip() for part in text[match.end() : end - 1].split(","))
        found.append(Registration(match[1], arguments, text.count("\n", 0, match.start()) + 1))
        pieces += [text[position : match.start()], "\n" * text.count("\n", match.start(), end)]
        position = end
    return "".join([*pieces, text[position:]]), found
