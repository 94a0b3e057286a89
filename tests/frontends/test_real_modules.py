# SPDX-License-Identifier: Apache-2.0
"""Modules of Python's own library, run from their IR, answer as the real ones do."""

from __future__ import annotations

import importlib
import sys
import threading
import tokenize
from collections.abc import Callable
from typing import Any

import pytest

from frontends.machine import run
from rosward.frontends.python.module import lower_module

TEXT = "The quick  brown fox\n  jumps over the lazy dog. " * 4
DATA = {"a": [1, 2.5, None, True, {"b": '\u00e9"', "c": []}]}

Ask = Callable[[Callable[[str], Any]], Any]

QUESTIONS: dict[str, Ask] = {
    "textwrap": lambda m: [m("fill")(TEXT, 30), m("dedent")("  a\n   b"), m("shorten")(TEXT, 40)],
    "posixpath": lambda m: [m("normpath")("/a/../b//c/./d"), m("relpath")("/a/b", "/a/c"), m("splitext")("a/b.c.d")],
    "fnmatch": lambda m: [m("translate")("a*[!b-d]?.py"), m("filter")(["a.py", "b.c"], "*.py")],
    "shlex": lambda m: [m("split")("a 'b c' d\\ e # f", comments=True), m("quote")("a'b")],
    "difflib": lambda m: [
        *m("unified_diff")(list("abcd"), list("axcde")),
        m("get_close_matches")("appel", ["ape", "apple"]),
    ],
    "fractions": lambda m: [
        str(m("Fraction")(3, 4) + m("Fraction")("1/3")),
        str(m("Fraction")(0.1).limit_denominator(9)),
    ],
    "json.encoder": lambda m: m("JSONEncoder")(sort_keys=True, indent=2).encode(DATA),
    "json.decoder": lambda m: m("JSONDecoder")().decode('{"a": [1, 2.5, null, {"b": "x\\u0041"}]}'),
    "statistics": lambda m: [m("mean")([1, 2, 3, 4.5]), m("median")([3, 1, 2]), m("stdev")([1, 2, 3, 4])],
    "copy": lambda m: [m("deepcopy")(DATA), m("copy")([1])],
    "base64": lambda m: [m("b64encode")(b"abc"), m("a85encode")(b"hello world"), m("b85encode")(b"hi")],
    "html": lambda m: [m("escape")("<a&'"), m("unescape")("&lt;&amp;&#65;&eacute;")],
    "string": lambda m: m("Formatter")().format("{0:>5}|{a!r:{w}}", 1, a="x", w=6),
}


def _in_deep_thread(work: Callable[[], None]) -> None:
    limit, size = sys.getrecursionlimit(), threading.stack_size(256 << 20)
    sys.setrecursionlimit(50_000)
    try:
        thread = threading.Thread(target=work)
        thread.start()
        thread.join()
    finally:
        sys.setrecursionlimit(limit)
        threading.stack_size(size)


@pytest.mark.parametrize("name", QUESTIONS)
def test_same_answers(name: str) -> None:
    real = importlib.import_module(name)
    assert real.__file__ is not None
    with tokenize.open(real.__file__) as file:
        module = lower_module(file.read(), real.__file__)
    found: list[Any] = []

    def work() -> None:
        variables = run(module, __name__=name, __file__=real.__file__)
        found.append(QUESTIONS[name](variables.__getitem__))

    _in_deep_thread(work)
    assert found == [QUESTIONS[name](lambda member: getattr(real, member))]
