# SPDX-License-Identifier: Apache-2.0
"""Which commands does a CMakeLists.txt consist of?

    install(PROGRAMS "a b.py" ${X}  # comment
            DESTINATION lib)
    ->  Command("install", (Argument("PROGRAMS"), Argument("a b.py", quoted=True), Argument("${X}"), …), line=1)

Only the text: comments, quotes, brackets and nesting. What the commands mean is told by `interpreter.py`.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Final

from rosward.records import NamedTuple

if TYPE_CHECKING:
    from collections.abc import Iterator

_TOKEN: Final = re.compile(
    r"""
      (?P<space>\s+)
    | (?P<comment>\#[^\n]*)
    | "(?P<quoted>(?:[^"\\]|\\.)*)"
    | (?P<open>\()
    | (?P<close>\))
    | (?P<word>(?:[^\s()\#"\\]|\\.)(?:[^\s()\#"\\]|\\.|"[^"\n]*")*)
    """,
    re.VERBOSE | re.DOTALL,
)
_BRACKET: Final = re.compile(r"(\#?)\[(=*)\[")
_NAME: Final = re.compile(r"[A-Za-z_]\w*")


class CMakeArgument(NamedTuple):
    """One argument as written; in a `literal` (bracket) one nothing is replaced, a `quoted` one is not split."""

    text: str
    quoted: bool = False
    literal: bool = False


class Command(NamedTuple):
    """One command; its name is in lower case, since CMake does not tell cases apart."""

    name: str
    arguments: tuple[CMakeArgument, ...]
    line: int


def parse_cmake(text: str) -> tuple[list[Command], tuple[str, int] | None]:
    """The commands of `text`, as far as they can be read, and what is wrong after them, and in which line."""
    commands: list[Command] = []
    name: str | None = None
    arguments: list[CMakeArgument] = []
    depth = start = 0
    line = 1
    for kind, content, line in _tokens(text):
        if kind == "wrong":
            return commands, (content, line)
        if depth == 0:
            if kind == "open" and name is not None:
                depth, arguments = 1, []
            elif kind == "word" and name is None and _NAME.fullmatch(content):
                name, start = content.lower(), line
            else:
                return commands, (f"CMake expects a command, not {content[:40]!r}.", line)
        elif kind == "open":
            depth += 1
            arguments.append(CMakeArgument("("))
        elif kind == "close":
            depth -= 1
            if depth:
                arguments.append(CMakeArgument(")"))
            elif name is not None:
                commands.append(Command(name, tuple(arguments), start))
                name = None
        else:
            arguments.append(CMakeArgument(content, quoted=kind != "word", literal=kind == "bracket"))
    if depth:
        return commands, ("This command is not closed.", start)
    if name is not None:
        return commands, (f"CMake expects a command, not {name[:40]!r}.", line)
    return commands, None


def _tokens(text: str) -> Iterator[tuple[str, str, int]]:
    """Kind, content and line of each token that matters; `wrong` with a message where the text cannot be read."""
    position, line = 0, 1
    unclosed: set[str] = set()  # ends of brackets that do not occur any more: looked for once, not at each bracket
    while position < len(text):
        opening = _BRACKET.match(text, position)
        closing = f"]{opening[2]}]" if opening else ""
        if opening and closing not in unclosed:
            end = text.find(closing, opening.end())
            if end >= 0:
                if not opening[1]:
                    yield "bracket", text[opening.end() : end].removeprefix("\n"), line
                line += text.count("\n", position, end)
                position = end + len(closing)
                continue
            unclosed.add(closing)
        match = _TOKEN.match(text, position)
        if match is None:
            what = "an unterminated string" if text[position] == '"' else f"the character {text[position]!r}"
            yield "wrong", f"CMake cannot read {what}.", line
            return
        kind = match.lastgroup or ""
        if kind not in {"space", "comment"}:
            yield kind, match[kind].replace("\\\n", "") if kind == "quoted" else match[kind], line
        line += match[0].count("\n")
        position = match.end()
