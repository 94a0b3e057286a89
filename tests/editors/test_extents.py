# SPDX-License-Identifier: Apache-2.0
"""How far something reaches, in text that may be half written, or hostile."""

from __future__ import annotations

import random

import pytest

from rosward.location import Place
from rosward.lsp.extents import LONGEST_LINE, Extent, column_of, extent, literals
from rosward.lsp.names import keys, parameter_of


def _text(file: str, text: str, begin: str) -> str:
    """What is said to begin where `begin` stands."""
    lines = text.split("\n")
    line = next(i for i, each in enumerate(lines) if begin in each)
    found = extent(lines, file, line, lines[line].index(begin))
    inside = lines[found.line : found.end_line + 1]
    inside[-1] = inside[-1][: found.end_column]
    inside[0] = inside[0][found.column :]
    return "\n".join(inside)


@pytest.mark.parametrize(
    ("file", "text", "found"),
    [
        ("a.py", "x = CALL(1, 'a)')  # more", "CALL(1, 'a)')"),
        ("a.py", "CALL(\n  1,  # a)\n  '''b)\n c)''',\n)\ny = 2", "CALL(\n  1,  # a)\n  '''b)\n c)''',\n)"),
        ("a.py", "CALL.get(1).make(2); other(3)", "CALL.get(1).make(2)"),
        ("a.py", "[CALL(1), CALL(2)]", "CALL(1)"),
        ("a.py", "CALL(1)\n  .make(2)\nz", "CALL(1)\n  .make(2)"),
        ("a.py", "x = CALL", "CALL"),
        ("a.py", "x = CALL(1,\n", "CALL(1,"),
        (
            "a.cpp",
            'CALL->make<A<B>>("a;)", [](const M & m) { f(m); });\ng();',
            'CALL->make<A<B>>("a;)", [](const M & m) { f(m); })',
        ),
        ("a.cpp", "CALL(1, // )\n  2);", "CALL(1, // )\n  2)"),
        ("a.xml", "<CALL a='1>'/><CALL b='2'/>", "<CALL a='1>'/>"),
        ("a.xml", "<CALL>\n <x/>\n <y>t</y>\n</CALL><z/>", "<CALL>\n <x/>\n <y>t</y>\n</CALL>"),
        ("a.yaml", "- CALL:\n    a: 1\n\n    b: 2\n- c: 3", "- CALL:\n    a: 1\n\n    b: 2"),
    ],
)
def test_what_begins_at_a_place(file: str, text: str, found: str) -> None:
    begin = "<CALL" if file.endswith(".xml") else "- CALL" if file.endswith(".yaml") else "CALL"
    assert _text(file, text, begin) == found


@pytest.mark.parametrize(
    ("file", "text", "found"),
    [
        ("a.py", "f('a', \"b c\", r'd', 'e\\n', f'{g}', b'h')  # 'i'", ["a", "b c", "d"]),
        ("a.cpp", 'f("a", "b\\n"); // "c"', ["a"]),
        ("a.xml", "<remap from='a' to=\"b\" c='&lt;'/>", ["a", "b"]),
        ("a.yaml", "a: b  # c", ["b"]),
        ("a.yaml", "- {from: 'a', to: \"b\"}", ["a", "b"]),
        ("a.yaml", "x: [/a, b/c]", ["/a", "b/c"]),
    ],
)
def test_the_literals_of_a_line(file: str, text: str, found: list[str]) -> None:
    inside = literals([text], file, Extent(0, 0, 0, len(text)))
    assert [each.text for each in inside] == found
    assert [text[each.column : each.end] for each in inside] == found


def test_lines_that_nobody_wrote_are_not_looked_into() -> None:
    for file in ("a.py", "a.cpp", "a.xml", "a.yaml"):
        long = ["a: 'b'" + " " * LONGEST_LINE + "x"]
        assert literals(long, file, Extent(0, 0, 0, len(long[0]))) == []
        extent(long, file, 0, 0)
    assert keys(["a" * LONGEST_LINE + ":"]) == []


def test_any_text_has_extents_within_it() -> None:
    chance = random.Random(11)
    pieces = [
        "(",
        ")",
        "[",
        "]",
        "{",
        "}",
        "'",
        '"',
        "'''",
        "\n",
        "a",
        ".",
        "->",
        "<a",
        ">",
        "/>",
        "</a>",
        "-",
        ": ",
        "#",
        "//",
        "\\",
        " ",
        "é🐞",
    ]
    for _ in range(400):
        lines = "".join(chance.choice(pieces) for _ in range(chance.randrange(60))).split("\n")
        line = chance.randrange(len(lines))
        column = chance.randrange(len(lines[line]) + 1)
        for file in ("a.py", "a.cpp", "a.xml", "a.yaml"):
            found = extent(lines, file, line, column)
            assert 0 <= found.end_line < len(lines)
            assert 0 <= found.end_column <= len(lines[found.end_line])
            for each in literals(lines, file, Extent(0, 0, len(lines) - 1, len(lines[-1]))):
                assert lines[each.line][each.column : each.end] == each.text
        keys(lines)


def test_columns_of_programs_count_bytes() -> None:
    lines = ["é🐞 = f()"]
    assert column_of(lines, "a.py", Place("a.py", 1, 1 + len("é🐞 = ".encode()))) == len("é🐞 = ")
    assert column_of(lines, "a.xml", Place("a.xml", 1, 4)) == 3
    assert column_of(lines, "a.py", Place("a.py", 9, 4)) == 0
    assert column_of(lines, "a.py", Place("a.py", 1, 1_000)) == len(lines[0])


def test_keys_of_parameter_files() -> None:
    lines = [
        "/robot:",
        "  arm:",
        "    ros__parameters:",
        "      pid: # three",
        "        rate: 5",
        "      'odd': 1",
        "other: 2",
    ]
    found = [(key.path[-1], parameter_of(key)) for key in keys(lines)]
    assert found == [
        ("/robot", None), ("arm", None), ("ros__parameters", None), ("pid", ("/robot/arm", "pid")),
        ("rate", ("/robot/arm", "pid.rate")), ("odd", ("/robot/arm", "odd")), ("other", None),
    ]  # fmt: skip
