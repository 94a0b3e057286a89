# SPDX-License-Identifier: Apache-2.0
"""What might stand in a file that somebody broke, by accident or on purpose? Real files, and changes to them.

    change(random, b"<launch><node pkg='a'/></launch>", others)  ->  b"<launch><node pkg='a'/></laun"

A change flips, takes away, doubles or swaps bytes or lines, puts another word in the place of one, cuts the end off, or joins the head of
one file with the tail of another. The words are those that the readers care about, so that many a change is still read.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path
from random import Random
from typing import Final, NamedTuple

from casefile import read_cases

PROJECT: Final = Path(__file__).parents[2]
LONGEST: Final = 60_000
"""Bytes of a seed: what is longer says nothing more, and costs time."""

_WORDS: Final = {
    "py": (
        "None", "True", "0", "-1", "10**9", "1e400", "''", "'/'", "'~/x'", "'{node}'", "[]", "{}", "()", "lambda: x", "x", "self", "*x",
        "**x", "yield", "await x", "return", "while True:", "for x in x:", "try:", "except:", "finally:", "with x:", "class x:", "def x():",
        "if x:", "else:", "raise", "del x", "global x", "nonlocal x", "import x", "from . import x", "from x import *", "+", "%", "*", "//",
        "<<", "if", "in", "not", "is", "(", ")", "[", "]", "{", "}", ":", ",", "=", ":=", "@x", "f'{x}'", "'%s' %", "\\", "#", "'''", "super()",
        "__init__", "match x:", "case _:", "type(x)", "getattr", "setattr", "x.x", "exec", "eval", "open", "rclpy", "Node", "x[x]", "x[::2]",
        "async def x():", "LaunchConfiguration('x')", "OpaqueFunction(function=x)", "IncludeLaunchDescription(x)", "generate_launch_description",
    ),
    "xml": (
        "<", ">", "/>", "</", "<node", "<include", "<group>", "</group>", "<arg", "<let", "<param", "<remap", "<launch>", "</launch>", "&lt;",
        "&x;", "&#0;", "&#xFFFFFFFF;", "<!--", "-->", "<![CDATA[", "]]>", "<!DOCTYPE x>", "<?xml version='1.0' encoding='utf-16'?>", "$(var x)",
        "$(", "$(eval '1+1')", "$(find-pkg-share x)", "$(env x y)", "$(dirname)",
        "if=\"x\"", "name=", "value=\"[1,2\"", "exec=", "pkg=", "\"",
        "'", "=", "xmlns:x=\"x\"", "<for each=\"1;2\">", "<executable cmd=\"x\"/>", "<name>", "<depend>", "condition=\"$x == 1\"", "<export>",
    ),
    "yaml": (
        ":", "-", "- ", "&x", "*x", "<<: *x", "!!str", "!!python/object:os.system", "!x", "|", ">", "? ", "{", "}", "[", "]", ",", "'", "\"", "#",
        "---", "...", "%YAML 1.2", "~", "null", "true", "0x10", "0o7", "1_0", "1e999", ".nan", "-.inf", "2001-01-01", "12:30:45", "\t",
        "ros__parameters:", "/**:", "launch:", "node:", "include:", "$(var x)", "$(", "nodes:", "when:", "publishers:", "same_as:", "name:", "type:",
    ),
    "cfg": (
        "[", "]", "=", ":", "[options]", "[options.entry_points]", "[tool.setuptools]", "console_scripts =", "x = x:x", "%(x)s", "${x}", "$ENV{x}",
        "include(", "add_subdirectory(", "function(", "endfunction()", "foreach(x RANGE 9999)", "endforeach()", "macro(x)", "endmacro()",
        "if(", "endif()",
        "install(PROGRAMS", "DESTINATION", "(", ")", "\"", "'''", "[==[", "]==]", "#", ";", "\\", "file(GLOB x *)", "set(x ${x}${x})", "x()", "[[x]]",
        "{", "}", ",", "2001-01-01", "---", "string", "float64[<=3]", "int32 X=1", "math(EXPR x 1+1)", "while(1)", "endwhile()", "return()",
    ),
}  # fmt: skip
_TOKEN: Final = re.compile(rb"\w+|[^\w\s]+|\s+")
_BYTES: Final = (0, 9, 10, 13, 27, 32, 34, 39, 60, 92, 127, 128, 0xC3, 0xE2, 0xED, 0xF0, 0xFE, 0xFF)


class Seed(NamedTuple):
    """A real file: the name says how it is read, `words` which words may come into it."""

    name: str
    text: bytes
    words: str


def family(name: str) -> str:
    """The words for a file of this name."""
    ending = name.rpartition(".")[2]
    if ending in ("py", "pyi"):
        return "py"
    return {"xml": "xml", "launch": "xml", "yaml": "yaml", "yml": "yaml"}.get(ending, "cfg")


def seeds() -> list[Seed]:
    """The programs of `tests/cases`, the files of `examples`, declarations and stubs of the package."""
    found = [
        Seed(f"program/{case.file.stem}/{name}", text.encode(), family(name))
        for document in sorted((PROJECT / "tests" / "cases").glob("*.md"))
        for case in read_cases(document)
        for name, text in case.files.items()
    ]
    models = PROJECT / "src" / "rosward" / "models"
    for folder, pattern in ((PROJECT / "examples", "*.*"), (models / "nodes", "*.yaml"), (models / "stubs", "*.pyi")):
        for path in sorted(folder.rglob(pattern)):
            if path.is_file() and path.suffix != ".md" and path.stat().st_size <= LONGEST:
                found.append(Seed(path.relative_to(PROJECT).as_posix(), path.read_bytes(), family(path.name)))
    return found


def change(random: Random, seed: Seed, others: list[Seed]) -> bytes:
    """The text of `seed` after one to four changes; `others` are files of the same kind, to splice with."""
    text = seed.text
    for _ in range(random.choice((1, 1, 1, 2, 2, 4))):
        text = random.choice(_CHANGES)(random, text, seed.words, others)
    return text[: 2 * LONGEST]


_Change = Callable[[Random, bytes, str, list[Seed]], bytes]


def _flip(random: Random, text: bytes, _: str, __: list[Seed]) -> bytes:
    if not text:
        return b"\0"
    at = random.randrange(len(text))
    return text[:at] + bytes([random.choice((*_BYTES, text[at] ^ (1 << random.randrange(8))))]) + text[at + 1 :]


def _lines(random: Random, text: bytes, _: str, __: list[Seed]) -> bytes:
    lines = text.splitlines(keepends=True) or [b""]
    one, other = random.randrange(len(lines)), random.randrange(len(lines))
    match random.randrange(5):
        case 0:
            lines[one], lines[other] = lines[other], lines[one]
        case 1:
            lines.insert(other, lines[one])
        case 2:
            del lines[min(one, other) : min(one, other) + random.randrange(1, 4)]
        case 3:
            lines[one] = b" " * random.randrange(9) + lines[one].lstrip()
        case _:
            lines[one:one] = lines[min(one, other) : min(one, other) + 12] * random.randrange(1, 4)
    return b"".join(lines)


def _word(random: Random, text: bytes, words: str, _: list[Seed]) -> bytes:
    tokens: list[bytes] = _TOKEN.findall(text) or [b""]
    at = random.randrange(len(tokens))
    new = random.choice((random.choice(tokens), random.choice(_WORDS[words]).encode()))
    tokens[at] = random.choice((new, tokens[at] + b" " + new, b""))
    return b"".join(tokens)


def _swap(random: Random, text: bytes, _: str, __: list[Seed]) -> bytes:
    tokens: list[bytes] = _TOKEN.findall(text) or [b""]
    one, other = random.randrange(len(tokens)), random.randrange(len(tokens))
    tokens[one], tokens[other] = tokens[other], tokens[one]
    return b"".join(tokens)


def _cut(random: Random, text: bytes, _: str, __: list[Seed]) -> bytes:
    return text[: random.randrange(len(text) + 1)]


def _splice(random: Random, text: bytes, _: str, others: list[Seed]) -> bytes:
    tail = random.choice(others).text
    return text[: random.randrange(len(text) + 1)] + tail[random.randrange(len(tail) + 1) :]


def _repeat(random: Random, text: bytes, _: str, __: list[Seed]) -> bytes:
    """A piece many times over: nesting, long lines, long lists."""
    at = random.randrange(len(text) + 1)
    piece = text[at : at + random.randrange(1, 12)]
    return text[:at] + piece * random.choice((2, 30, 300)) + text[at:]


_CHANGES: Final[tuple[_Change, ...]] = (_flip, _lines, _lines, _word, _word, _word, _swap, _cut, _splice, _repeat)
