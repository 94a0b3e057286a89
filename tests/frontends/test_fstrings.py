# SPDX-License-Identifier: Apache-2.0
"""Promise: the f-strings of PEP 701 (Python 3.12) are read by older Pythons, and mean what Python says that they mean.

The values stand here as Python 3.12 and 3.13 give them; where such a Python runs the tests, its own compiler is the judge.
"""

from __future__ import annotations

import ast
import sys
from pathlib import Path

import pytest

import rosward
from rosward.frontends.front_end import FrontendError
from rosward.frontends.python.fstrings import parse_with_fstrings
from rosward.frontends.python.module import lower_module

BEFORE = "d = {'k': 'v', 'n': {'m': [1, 2]}}\nx = 'X'\nn = 3.14159\nw = 8\n"
READ = [
    ('f"{d["k"]}"', "v"),
    ("f'{d['k']}'", "v"),
    ('f"{d["n"]["m"][1]}/{x}"', "2/X"),
    ('f"a{"b" + f"{x}{"c" + f"{w}"}"}d"', "abXc8d"),
    ('f"{"\\n".join(["a", "b"])}"', "a\nb"),
    ("f\"{'\\t'.join('ab')}\"", "a\tb"),
    ('f"{x # the name\n}"', "X"),
    ('f"{\n  d["k"]  # { not a field }\n  + x\n}tail"', "vXtail"),
    ('f"""{d["k"]}\n{x}"""', "v\nX"),
    ('f"""{"""a"""}"b"""', 'a"b'),
    ('f"{n:{w}.{"2"}f}|"', "    3.14|"),
    ('f"{x!r:>{w}}{d["k"]!s}"', "     'X'v"),
    ('f"{d["k"]=}"', "d[\"k\"]='v'"),
    ('f"{ x = }{d["k"]}"', " x = 'X'v"),
    ('f"{d["k"]=!s}"', 'd["k"]=v'),
    ('f"{d["k"] == "v"}{d["k"] != x}"', "TrueTrue"),
    ('f"{(lambda s: s + "!")(x)}"', "X!"),
    ('f"{(y := d["k"])}{y}"', "vv"),
    ('f"{{{d["k"]}}}"', "{v}"),
    ('fr"\\d{d["k"]}"', "\\dv"),
    ('f"\\N{LATIN SMALL LETTER A}{d["k"]}\\x41"', "avA"),
    ('f"\\t{d["k"]}\\\\"', "\tv\\"),
    ('f"\'{d["k"]}\'"', "'v'"),
    ('"a" f"{d["k"]}" \'b\'', "avb"),
    ('("a"  # one\n f"{d["k"]}"\n "b{}")', "avb{}"),
    ("f\"{d[\"k\"]}\" f'{d['k']}'", "vv"),
    ('f"{[f"{i}{"-"}" for i in range(2)]}"', "['0-', '1-']"),
    ('f"{ {"a": 1}["a"] }"', "1"),
    ('f"{d["k"]:}"', "v"),
    ('f"{x:{"<"}{w}}|"', "X       |"),
    ('f"é{d["k"]}ü"', "évü"),
    ('f"{"a" "b"}{"c" f"{x}"}"', "abcX"),
    ('[f"{d["k"]}", f"{d["n"]["m"][0]}"][1]', "1"),
    ('x if"a"else f"{d["k"]}"', "X"),
    ('f"{d["k"]if"a"else""}"', "v"),
]


@pytest.mark.parametrize(("text", "value"), READ, ids=[text for text, _ in READ])
def test_it_means_what_python_says(text: str, value: str) -> None:
    program = f"{BEFORE}found = (\n  {text})\nafter = 1\n"
    tree = parse_with_fstrings(program, _older)
    if tree is None:  # an older Python reads it as it is
        tree = ast.parse(program)
    assert found(tree) == value
    assert tree.body[-1].lineno == program.count("\n")
    assert lower_module(program, "f.py").lines == program.count("\n")
    if sys.version_info >= (3, 12):
        assert found(ast.parse(program)) == value


def _older(text: str) -> ast.Module:
    return ast.parse(text)


def found(tree: ast.Module) -> object:
    names: dict[str, object] = {}
    exec(compile(ast.fix_missing_locations(tree), "f.py", "exec"), names)
    return names["found"]


WRONG = [
    'f"{}"',
    'f"{d["k"}"',
    'f"{d["k"]"',
    'f"{d["k"]}',
    'f"{d["k"]!x}"',
    'f"{d["k"]}}"',
    'f"{d["k"] +}"',
    'f"{d["k"]}" = 1',
    'f"{d["k"]:{x}"',
    'f"a\nb{d["k"]}"',
    'del f"{d["k"]}"',
    "f'{d['k'] # }'",
]


@pytest.mark.parametrize("text", WRONG)
def test_what_no_python_reads_stays_wrong(text: str) -> None:
    with pytest.raises(FrontendError):
        lower_module(f"{BEFORE}{text}\n", "f.py")
    with pytest.raises(SyntaxError):
        ast.parse(f"{BEFORE}{text}\n")


def test_places_stay() -> None:
    """What stands in a field, and behind it, is told where it is."""
    tree = parse_with_fstrings('a = f"é{d["k"](one)}" + two\nb = f"""\n{d["k"] + three}"""\n', _older)
    assert tree is not None
    places = {n.id: (n.lineno, n.col_offset) for n in ast.walk(tree) if isinstance(n, ast.Name)}
    assert places["one"] == (1, 16)
    assert places["two"] == (1, 25)
    assert places["three"] == (3, 10)


def test_a_program_gives_the_same_names(tmp_path: Path) -> None:
    (tmp_path / "n.py").write_text(
        "import rclpy\nfrom std_msgs.msg import String\nnames = {'left': 'arm'}\nrclpy.init()\n"
        'node = rclpy.create_node(f"{names["left"]}_node")\n'
        'node.create_publisher(String, f"/{names["left"]}/{f"{names["left"]}{"s"}"}", 1)\n'
        'node.create_publisher(String, f"{"/".join(["a", "b"])}{\n  "c"  # { no field }\n}", 1)\n'
    )
    result = rosward.extract(tmp_path)
    assert [n.fqn for n in result.network.nodes] == ["/arm_node"]
    assert {e.name for n in result.network.nodes for e in n.entities if not e.system} == {"/arm/arms", "/a/bc"}
    assert not result.findings


def test_any_nesting_ends() -> None:
    text = "x"
    for _ in range(60):
        text = f'f"{{{text}}}"'
    assert parse_with_fstrings(f"y = {text}\n", _older) is None
    lower = 'f"{' * 5000
    assert parse_with_fstrings(lower, _older) is None
