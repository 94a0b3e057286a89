# SPDX-License-Identifier: Apache-2.0
"""Input that nobody should write: told by file and line, the rest analysed, never a traceback, bounded time and memory.

Each program runs in a process of its own, with bounded time and memory, beside a sound node that must be found anyway.
"""

from __future__ import annotations

import os
from pathlib import Path
from typing import Final, NamedTuple

import pytest
from sampling import sample

import rosward
from hostile.apart import apart
from rosward.pipeline import NothingToReadError

SECONDS: Final = 60
MEGABYTES: Final = 3_000

GOOD: Final = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Good(Node):
    def __init__(self):
        super().__init__('good')
        self.create_publisher(String, 'chatter', 10)


def main():
    rclpy.init()
    rclpy.spin(Good())


if __name__ == '__main__':
    main()
"""


class Outcome(NamedTuple):
    """What came out, with the findings as (code, file, line)."""

    findings: list[tuple[str, str, int]]
    messages: dict[str, str]
    nodes: dict[str, list[str]]
    complete: bool

    def codes(self, file: str = "bad.py") -> set[str]:
        """The codes of the findings in a file."""
        return {code for code, where, _ in self.findings if where == file}

    def lines(self, code: str, file: str = "bad.py") -> list[int]:
        """The lines of a file at which a code is told."""
        return [line for c, where, line in self.findings if (c, where) == (code, file)]


def run(folder: Path, *paths: Path, seconds: float = SECONDS) -> Outcome | None:
    """Extract in a process of its own; None where there is nothing to read."""
    ended = apart(lambda: _told(*(paths or (folder,))), seconds=seconds, megabytes=MEGABYTES)
    assert not ended.error, ended.error
    assert ended.megabytes < MEGABYTES
    told = ended.value
    if told is None:
        return None
    findings = [(code, file, line) for code, file, line, _ in told["findings"]]
    messages = {code: message for code, _, _, message in told["findings"]}
    for code, file, _ in findings:
        assert file or code == "RW007", "every finding about source names its file"
    return Outcome(findings, messages, told["nodes"], told["complete"])


def _told(*paths: Path) -> dict[str, object] | None:
    try:
        result = rosward.extract(*paths)
    except NothingToReadError:
        return None
    return {
        "complete": result.complete,
        "findings": [[f.code, f.place.file, f.place.line, f.message] for f in result.findings],
        "nodes": {n.fqn: [e.name for e in n.entities if not e.system] for n in result.network.nodes},
    }


def beside_good(folder: Path, text: str | bytes, name: str = "bad.py") -> Outcome:
    """The outcome of a bad file beside a good one; the good one is found whole."""
    (folder / "good.py").write_text(GOOD)
    (folder / name).write_bytes(text.encode() if isinstance(text, str) else text)
    outcome = run(folder)
    assert outcome is not None
    assert outcome.nodes["/good"] == ["/chatter"]
    return outcome


# Files that are no Python


@pytest.mark.parametrize(
    ("text", "code", "line"),
    [
        pytest.param("x = 1\ndef f(:\n    pass\n", "RW001", 2, id="syntax error"),
        pytest.param("x = 1\nprint 'hello'\n", "RW006", 2, id="Python 2 print"),
        pytest.param("try:\n    pass\nexcept ValueError, e:\n    pass\n", "RW006", 3, id="Python 2 except"),
        pytest.param("if True:\n\tx = 1\n        y = 2\n", "RW001", 3, id="tabs and spaces mixed"),
        pytest.param("x = 1\ny = '\0'\n", "RW001", 2, id="NUL byte"),
        pytest.param("x = '''\nnever closed\n", "RW001", 1, id="open string"),
        pytest.param("def f():\npass\n", "RW001", 2, id="no indentation"),
        pytest.param("\u202ex = 1\n", "RW001", 1, id="text direction"),
        pytest.param(b"\xff\xfex\x00=\x001\x00\n\x00", "RW001", 1, id="UTF-16"),
        pytest.param(bytes(range(256)) * 4, "RW001", 1, id="binary"),
        pytest.param("<<<<<<< HEAD\nx = 1\n=======\nx = 2\n>>>>>>> other\n", "RW001", 1, id="merge conflict"),
    ],
)
def test_a_file_that_python_refuses_is_told_by_line(tmp_path: Path, text: str | bytes, code: str, line: int) -> None:
    outcome = beside_good(tmp_path, text)
    assert outcome.lines(code) == [line]
    assert not outcome.complete


@pytest.mark.parametrize(
    "prefix",
    [pytest.param(b"\xef\xbb\xbf", id="BOM"), pytest.param(b"# coding: latin-1\n# \xe4\n", id="latin-1 declared")],
)
def test_encodings_that_python_reads_are_read(tmp_path: Path, prefix: bytes) -> None:
    outcome = beside_good(tmp_path, prefix + GOOD.replace("'good'", "'bad'").encode())
    assert outcome.nodes["/bad"] == ["/chatter"]
    assert not outcome.findings


def test_tabs_are_read(tmp_path: Path) -> None:
    outcome = beside_good(tmp_path, GOOD.replace("    ", "\t").replace("'good'", "'bad'"))
    assert outcome.nodes["/bad"] == ["/chatter"]


def test_latin_1_without_declaration_is_read_and_told(tmp_path: Path) -> None:
    outcome = beside_good(tmp_path, b"# caf\xe9\n" + GOOD.replace("'good'", "'bad'").encode())
    assert outcome.lines("RW004") == [1]
    assert outcome.nodes["/bad"] == ["/chatter"]


def test_a_file_of_20_megabytes_is_not_read(tmp_path: Path) -> None:
    outcome = beside_good(tmp_path, b"x = [1, 2, 3]\n" * 1_500_000)
    assert outcome.codes() == {"RW003"}


@pytest.mark.parametrize(
    "text",
    sample(
        [
            pytest.param("[" * 5_000 + "]" * 5_000, id="5,000 lists"),
            pytest.param("(" * 5_000 + "1" + ",)" * 5_000, id="5,000 tuples"),
            pytest.param("x = " + "-" * 50_000 + "1", id="50,000 signs"),
            pytest.param("x = " + "not " * 50_000 + "1", id="50,000 nots"),
            pytest.param("x" + ".x" * 50_000, id="50,000 attributes"),
            pytest.param("x" + "[0]" * 50_000, id="50,000 subscripts"),
            pytest.param("x = " + "lambda: " * 5_000 + "1", id="5,000 lambdas"),
            pytest.param("".join(" " * n + "if x:\n" for n in range(95)) + " " * 95 + "pass\n", id="95 ifs"),
            pytest.param("if x: pass\n" + "elif x: pass\n" * 1_500, id="1,500 elifs"),
        ],
        3,
    ),
)
def test_deep_nesting_is_read_or_told(tmp_path: Path, text: str) -> None:
    outcome = beside_good(tmp_path, "import rclpy\nx = object()\n" + text + "\n")
    assert outcome.codes() <= {"RW001", "RW005", "RW201"}


# Programs that never end or grow without end


def node_behind(text: str) -> str:
    """A program that makes node /end behind the text."""
    return f"import rclpy\n{text}\nrclpy.init()\nend = rclpy.create_node('end')\nrclpy.spin(end)\n"


@pytest.mark.parametrize(
    "text",
    sample(
        [
            pytest.param("x = " + " + ".join(["'a'"] * 20_000), id="20,000 terms"),
            pytest.param("x = ''" + " + str(1)" * 20_000, id="20,000 unknown terms", marks=pytest.mark.slow),
            pytest.param("x = 'a' * 10**9", id="a string of a gigabyte"),
            pytest.param("x = 10 ** 10 ** 10", id="a large number"),
            pytest.param("x = 1 << 10**10", id="a far shift"),
            pytest.param("x = f'{1:>1000000000}'", id="a wide format"),
            pytest.param("x = '%1000000000d' % 1", id="a wide percent format"),
            pytest.param("x = 'a'.ljust(10**9)", id="ljust"),
            pytest.param("x = bytes(10**10)", id="bytes"),
            pytest.param("x = [0] * 10**9", id="a long list"),
            pytest.param("x = list(range(10**9))", id="a long range"),
            pytest.param("x = '{' + ', '.join(f'{i}: {i}' for i in range(10)) + '}'", id="text of a dict"),
            pytest.param(
                "x = {" + ", ".join(f"'k{i}': {i}" for i in range(30_000)) + "}",
                id="a dict of 30,000",
                marks=pytest.mark.slow,
            ),
            pytest.param(
                "x = [" + ", ".join(map(str, range(30_000))) + "]", id="a list of 30,000", marks=pytest.mark.slow
            ),
            pytest.param("x = 'ab'\nfor _ in range(60):\n    x = x + x", id="doubling"),
            pytest.param("x = 'ab'\nfor _ in range(60):\n    x = f'{x}{x}'", id="doubling f-string"),
            pytest.param("x = 'ab'\nfor _ in range(60):\n    x = x.replace('a', x)", id="doubling by replace"),
            pytest.param("x = [1]\nfor _ in range(60):\n    x = x + x", id="doubling list"),
            pytest.param("x = (1,)\nfor _ in range(60):\n    x = x + x", id="doubling tuple"),
            pytest.param("x = ()\nfor _ in range(250):\n    x = (x, x)", id="nested tuples"),
            pytest.param("x = {}\nfor _ in range(250):\n    x = {'a': x, 'b': x}", id="nested dicts"),
            pytest.param("x = ''\nwhile input():\n    x = x + x", id="growing while unknown"),
            pytest.param("x = []\nwhile input():\n    x = [x, x]", id="nesting while unknown"),
            pytest.param("x = 3\nfor _ in range(200):\n    x = x * x", id="squares"),
            pytest.param("import re\nx = re.match('(a+)+$', 'a' * 40 + 'b')", id="slow expression"),
            pytest.param("import json\nx = json.loads('[' * 50000 + ']' * 50000)", id="deep JSON"),
            pytest.param("import itertools\nx = list(itertools.product(range(100), repeat=9))", id="product"),
            pytest.param("import itertools\nfor x in itertools.count():\n    if input(): break", id="count"),
            pytest.param(
                "def g():\n    while True: yield 1\nfor x in g():\n    if input(): break", id="endless generator"
            ),
            pytest.param("class A: pass\na = A()\na.a = a\nx = a.a.a.a\nl = [1]; l.append(l); x = str(l)", id="cycles"),
            pytest.param("def f(x): return f\nx = f" + "(1)" * 3_000, id="3,000 calls in a row"),
        ],
        3,
    ),
)
def test_large_values_are_bounded(tmp_path: Path, text: str) -> None:
    """The program goes on behind them."""
    outcome = beside_good(tmp_path, node_behind(text))
    assert "/end" in outcome.nodes
    assert outcome.codes() <= {"RW203"}


def nested_functions(depth: int) -> str:
    lines = [f"{'  ' * n}def f{n}():" for n in range(depth)]
    lines.append("  " * depth + "rclpy.init()")
    lines += [f"{'  ' * (n + 1)}f{n + 1}()" for n in range(depth - 2, -1, -1)]
    return "import rclpy\n" + "\n".join(lines) + "\nf0()\nend = rclpy.create_node('end')\nrclpy.spin(end)\n"


def test_functions_nested_as_deep_as_python_allows(tmp_path: Path) -> None:
    """More than 99 levels of indentation are a syntax error of Python's own."""
    assert "/end" in beside_good(tmp_path, nested_functions(98)).nodes
    outcome = beside_good(tmp_path, nested_functions(120), "deeper.py")
    assert outcome.codes("deeper.py") in ({"RW001"}, {"RW005"})


CALL_TREE: Final = (
    "\n".join(f"def f{n}(x):\n    f{n + 1}(x + [1])\n    f{n + 1}(x + [2])" for n in range(25))
    + "\ndef f25(x):\n    seen.append(x)\nseen = []\nf0([])"
)


@pytest.mark.parametrize(
    "text",
    [
        pytest.param("while True:\n    pass", id="infinite loop"),
        pytest.param("x = 0\nwhile True:\n    x = x + 1", id="infinite loop that counts"),
        pytest.param("def f(n):\n    return f(n + 1)\nf(0)", id="endless recursion"),
        pytest.param("def f(n):\n    return f(n + 1) + f(n + 2) + f(n + 3)\nf(0)", id="endless tree recursion"),
        pytest.param("def f(n):\n    g(n)\ndef g(n):\n    f(n)\nf(0)", id="endless mutual recursion"),
    ],
)
def test_what_never_returns_ends_the_analysis_of_its_process_only(tmp_path: Path, text: str) -> None:
    """Nothing behind it ever runs, and it is not claimed to."""
    assert "/end" not in beside_good(tmp_path, node_behind(text)).nodes


@pytest.mark.parametrize(
    "text",
    [
        pytest.param("def f(n):\n    if n: f(n - 1)\nf(10000)", id="recursion 10,000 deep"),
        pytest.param("def f(n):\n    if n > 0: return f(n - 1) + f(n - 2)\n    return 1\nf(60)", id="Fibonacci"),
        pytest.param("def f(x):\n    if x: return [f(x[1:])]\nf(input())", id="recursion over an unknown"),
        pytest.param(CALL_TREE, id="exponential call tree", marks=pytest.mark.slow),
        pytest.param(
            "for a in range(300):\n  for b in range(300):\n    for c in range(300): pass", id="27,000,000 turns"
        ),
    ],
)
def test_long_ways_are_followed_or_their_end_is_told(tmp_path: Path, text: str) -> None:
    """Node /end is found, or the finding says in the file and line where the analysis stopped."""
    outcome = beside_good(tmp_path, node_behind(text))
    assert "/end" in outcome.nodes or min(outcome.lines("RW201"), default=0) > 0


# Folders


def test_imports_in_a_circle(tmp_path: Path) -> None:
    (tmp_path / "a.py").write_text("import b\nfrom b import make\ndef main():\n    make()\nNAME = 'a'\n")
    (tmp_path / "b.py").write_text(
        "import a, rclpy\ndef make():\n    rclpy.init()\n    rclpy.spin(rclpy.create_node(a.NAME))\n"
    )
    outcome = beside_good(tmp_path, "import a\nif __name__ == '__main__':\n    a.main()\n")
    assert "/a" in outcome.nodes


def test_node_classes_in_files_that_import_each_other_only(tmp_path: Path) -> None:
    """Nothing starts them, and nothing else than they imports them: they are instantiated all the same."""
    for name, other in ("ab", "ba"):
        text = GOOD.partition("def main")[0].replace("'good'", f"'{name}'")
        (tmp_path / f"{name}.py").write_text(f"import {other}\n{text}")
    outcome = run(tmp_path)
    assert outcome is not None
    assert set(outcome.nodes) == {"/a", "/b"}


def test_a_module_that_imports_itself(tmp_path: Path) -> None:
    assert "/end" in beside_good(tmp_path, node_behind("import bad\nfrom bad import x\nx = 1")).nodes


def test_a_link_that_leads_nowhere_is_told(tmp_path: Path) -> None:
    """As any file that cannot be opened."""
    (tmp_path / "bad.py").symlink_to(tmp_path / "missing.py")
    (tmp_path / "good.py").write_text(GOOD)
    outcome = run(tmp_path)
    assert outcome is not None
    assert outcome.codes() == {"RW002"}
    assert "/good" in outcome.nodes
    assert not outcome.complete


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() == 0, reason="root reads everything")
def test_a_file_without_permission_is_told(tmp_path: Path) -> None:
    (tmp_path / "good.py").write_text(GOOD)
    (tmp_path / "bad.py").write_text(GOOD)
    (tmp_path / "bad.py").chmod(0)
    outcome = run(tmp_path)
    assert outcome is not None
    assert outcome.codes() == {"RW002"}


def test_links_in_a_circle_are_followed_once(tmp_path: Path) -> None:
    inner = tmp_path / "one" / "two"
    inner.mkdir(parents=True)
    (inner / "back").symlink_to(tmp_path, target_is_directory=True)
    (inner / "self.py").symlink_to(inner / "self.py")
    (tmp_path / "good.py").write_text(GOOD)
    outcome = run(tmp_path)
    assert outcome is not None
    assert list(outcome.nodes) == ["/good"]
    assert outcome.codes("one/two/self.py") == {"RW002"}


def test_a_folder_with_the_name_of_a_file(tmp_path: Path) -> None:
    (tmp_path / "bad.py").mkdir()
    (tmp_path / "bad.py" / "inner.py").write_text(GOOD.replace("'good'", "'inner'"))
    (tmp_path / "good.py").write_text(GOOD)
    outcome = run(tmp_path)
    assert outcome is not None
    assert set(outcome.nodes) == {"/good", "/inner"}
    assert outcome.codes() <= {"RW002"}


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no named pipes here")
def test_a_pipe_is_never_opened(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "bad.py")
    (tmp_path / "good.py").write_text(GOOD)
    outcome = run(tmp_path)
    assert outcome is not None
    assert outcome.codes() == {"RW002"}


def test_names_of_files_that_are_no_text(tmp_path: Path) -> None:
    for name in (b"sp ace.py", "ümläut.py".encode(), b"new\nline.py", b"\xff.py"):
        with open(os.fsencode(tmp_path) + b"/" + name, "w", encoding="utf-8") as file:  # noqa: PTH123
            file.write(GOOD)
    outcome = run(tmp_path)
    assert outcome is not None
    assert outcome.nodes["/good"] == ["/chatter"]


def test_nothing_to_read(tmp_path: Path) -> None:
    assert run(tmp_path) is None


def test_no_ros_code_at_all(tmp_path: Path) -> None:
    (tmp_path / "plain.py").write_text("print('hello')\n")
    (tmp_path / "empty.py").write_text("")
    outcome = run(tmp_path)
    assert outcome is not None
    assert [code for code, _, _ in outcome.findings] == ["RW007"]
    assert not outcome.nodes


# Names that mean harm


@pytest.mark.parametrize("name", ["../../x", "a b", "", "1a", "a" * 300, "a\n", "a/b", "<script>", "{node}"])
def test_a_node_name_that_rcl_rejects_is_told_and_nothing_else(tmp_path: Path, name: str) -> None:
    outcome = beside_good(tmp_path, f"import rclpy\nrclpy.init()\nn = rclpy.create_node({name!r})\nrclpy.spin(n)\n")
    assert outcome.lines("RW103") == [3]
    assert list(outcome.nodes) == ["/good"]


@pytest.mark.parametrize("name", ["<script>", "../x", "a//b", "a b", "", "é", "'\"&--", "*", "a/", "~xy", "{nobody}"])
def test_a_topic_name_that_rcl_rejects_is_told_and_in_no_result(tmp_path: Path, name: str) -> None:
    made = f"n.create_publisher(String, {name!r}, 10)"
    text = f"from std_msgs.msg import String\nimport rclpy\nrclpy.init()\nn = rclpy.create_node('n')\n{made}\n"
    outcome = beside_good(tmp_path, text)
    assert outcome.lines("RW103") == [5]
    assert outcome.nodes["/n"] == []
