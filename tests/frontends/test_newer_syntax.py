# SPDX-License-Identifier: Apache-2.0
"""Promise: syntax of a newer Python is read by an older one, with every line and column where it stands."""

from __future__ import annotations

import ast
import sys

import pytest

from rosward.frontends.front_end import FrontendError
from rosward.frontends.python.module import lower_module
from rosward.frontends.python.newer import older

NEWER = [
    ("type Pair = tuple[int, int]\nx = 1\n", "(    Pair)= tuple[int, int]"),
    ("type Pair[T] = list[T]\n", "= list[T]"),
    ("if a: type X=int\n", "(    X)=int"),
    ("def first[T](items: list[T]) -> T:\n    return items[0]\n", "def first   (items"),
    ("async def first[T: (int, str), *Ts, **P](x): ...\n", "async def first"),
    ("def first[T = int](x): ...\n", "def first         (x): ..."),
    ("class Box[T](Base): ...\n", "class Box   (Base): ..."),
    ("class Box[\n    T,\n](Base): ...\n", "(Base): ..."),
    ("try: pass\nexcept OSError, ValueError:\n    pass\n", "except(OSError, ValueError):"),
    ("try: pass\nexcept a.E, b.F: pass\n", "except(a.E, b.F):"),
]


@pytest.mark.parametrize(("text", "part"), NEWER)
def test_newer_forms_become_older_ones(text: str, part: str) -> None:
    """Each form is one that every supported Python parses, and what follows it stays in its column."""
    found = older(text)
    assert found is not None
    assert part in found
    ast.parse(found)
    assert lower_module(text, "f.py").lines == text.count("\n")
    assert len(found.splitlines()) == len(text.splitlines())


@pytest.mark.parametrize(
    "text",
    [
        "type = 3\n",
        "type(x)\n",
        "type\n",
        "x = type\n",
        "print(type, x)\n",
        "d[type] = 1\n",
        "except_ = 1\n",
        "def f(x): return x[0]\n",
        "'type X = int'\n",
        "# def f[T](x)\n",
        "try: pass\nexcept (A, B): pass\n",
        "try: pass\nexcept A as e: pass\n",
    ],
)
def test_what_is_old_stays(text: str) -> None:
    """Nothing else is rewritten."""
    assert older(text) is None


@pytest.mark.skipif(sys.version_info >= (3, 14), reason="this Python reads it")
def test_what_cannot_be_read_says_what_it_needs() -> None:
    with pytest.raises(FrontendError, match=r"template strings need Python 3\.14"):
        lower_module("x = 1\ny = t'{x}'\n", "f.py")


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("try: pass\nexcept ValueError, e:\n    pass\n", "python2"),
        ("def f[T(x): pass\n", "syntax"),
        ("type X = = 1\n", "syntax"),
        ("class C[: pass\n", "syntax"),
        ("print 'type'\n", "python2"),
        ("type X", "syntax"),
        ("def", "syntax"),
        ("except", "syntax"),
    ],
)
def test_what_no_python_reads_is_told(text: str, kind: str) -> None:
    """A text that is wrong stays an error, at its own place."""
    with pytest.raises(FrontendError) as error:
        lower_module(text, "f.py")
    assert error.value.kind == kind
