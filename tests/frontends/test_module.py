# SPDX-License-Identifier: Apache-2.0
"""What `lower_module` tells about a file, and what it says of files that it can't read."""

from __future__ import annotations

import sys
import threading
import warnings

import pytest
from sampling import sample

from rosward.frontends.front_end import FrontendError
from rosward.frontends.python.module import lower_module
from rosward.ir import ops
from rosward.ir.check import check
from rosward.ir.program import Code, Module


def lower(text: str) -> Module:
    return lower_module(text, "a.py")


def inner(code: Code) -> list[Code]:
    """The bodies made at the top of `code`."""
    return [op.code for op in code.ops if isinstance(op, (ops.MakeFunction, ops.MakeClass))]


@pytest.mark.parametrize(
    ("text", "kind", "line"),
    [
        ("x = (\n", "syntax", 1),
        ("x = 1\n  y = 2\n", "syntax", 2),
        ("\nprint 'a'\n", "python2", 2),
        ("try: pass\nexcept KeyError, e: pass\n", "python2", 2),
        ("x = `1`\n", "python2", 1),
        ("exec 'a'\n", "python2", 1),
        ("if 1 <> 2: pass\n", "python2", 1),
        ("x = 0777\n", "python2", 1),
        ("x = 10L\n", "python2", 1),
        ("raise KeyError, 'a'\n", "python2", 1),
        ("x = ur'a'\n", "python2", 1),
        ("x = 1\ny = '\0'\n", "null", 2),
        ("(" * 1000 + ")" * 1000, "depth", 1),
        ("-" * 200_000 + "1", "depth", 1),
        ("\n".join(" " * depth + "if x:" for depth in range(120)), "depth", 101),
        ("x = '\ud800'", "syntax", 1),
        ("def f():\n    nonlocal x\n", "syntax", 2),
        ("return 1", "syntax", 1),
        ("class A:\n    yield 1", "syntax", 2),
        ("if x:\n    break", "syntax", 2),
        ("for x in y:\n    def f():\n        continue", "syntax", 3),
        ("def f():\n    await x", "syntax", 2),
        ("def f():\n    async with x: pass", "syntax", 2),
        ("*a, *b = x", "syntax", 1),
        ("*a = x", "syntax", 1),
    ],
)
def test_unreadable(text: str, kind: str, line: int) -> None:
    with pytest.raises(FrontendError) as caught:
        lower(text)
    assert (caught.value.kind, caught.value.line) == (kind, line)
    assert caught.value.column >= 1
    assert caught.value.message


def test_warnings_are_silent() -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        lower(r"x = '\d'; y = 1 is 2; assert (x, y)")


def test_byte_order_mark() -> None:
    lower("\ufeffx = 1\n")


def test_imports() -> None:
    """All imports of a file, wherever they stand, relative ones with their dots."""
    module = lower(
        "import a, b.c as d\nfrom e import f as g, h\nfrom . import i\nfrom .. import *\n"
        "def q():\n    from .j.k import l\n    class A:\n        import m.n\n    return lambda: 1\n"
    )
    expected = {"a", "b.c", "e", "e.f", "e.h", ".", ".i", "..", ".j.k", ".j.k.l", "m.n"}
    assert module.imports == expected


@pytest.mark.parametrize(
    ("text", "has_main"),
    [
        ("if __name__ == '__main__': f()", True),
        ("if '__main__' == __name__: f()", True),
        ("if x and __name__ == '__main__' and y: f()", True),
        ("if x: pass\nelif __name__ == '__main__': f()", True),
        ("try:\n    if __name__ == '__main__': f()\nfinally: pass", True),
        ("if __name__ != '__main__': f()", False),
        ("def f():\n    if __name__ == '__main__': f()", False),
        ("x = '__main__'", False),
    ],
)
def test_has_main(text: str, has_main: bool) -> None:
    assert lower(text).has_main is has_main


@pytest.mark.parametrize(("text", "lines"), [("", 0), ("x", 1), ("x\n", 1), ("x\ny", 2)])
def test_lines(text: str, lines: int) -> None:
    assert lower(text).lines == lines


def test_annotations_are_kept_as_text() -> None:
    (code,) = inner(lower("def f(a: int, *b: 'Node', c: x.y[int] = 1, **d) -> None: ...").code)
    assert code.annotations == {"a": "int", "b": "'Node'", "c": "x.y[int]"}
    assert code.returns == "None"


def test_annotations_of_a_class() -> None:
    (code,) = inner(lower("class A:\n    a: int = 1\n    b: List[str]\n    c.d: int\n").code)
    texts = [op.value for op in code.ops if isinstance(op, ops.Const)]
    assert texts == [1, "a", "int", "b", "List[str]"]


@pytest.mark.parametrize(
    ("body", "is_stub"),
    [("...", True), ("'doc'\n    ...", True), ("pass", False), ("'doc'", False), ("...\n    return 1", False)],
)
def test_is_stub(body: str, is_stub: bool) -> None:
    (code,) = inner(lower(f"def f():\n    {body}\n").code)
    assert code.is_stub is is_stub


def test_kinds_of_functions() -> None:
    text = "def a(): yield\nasync def b(): pass\nasync def c(): yield\ndef d(): return lambda: (yield)\n"
    found = [(code.is_generator, code.is_coroutine) for code in inner(lower(text).code)]
    assert found == [(True, False), (False, True), (True, True), (False, False)]


def test_class_cell() -> None:
    """`super` makes `__class__` a free cell of the method and a cell of the class; elsewhere it means nothing."""
    module = lower("class A:\n    def f(self): super().f()\n    def g(self): pass\ndef h(): super()\n")
    cls, function = inner(module.code)
    assert cls.cells == ("__class__",)
    assert [code.free for code in inner(cls)] == [("__class__",), ()]
    assert function.free == ()


def test_names() -> None:
    module = lower("class A:\n    def f(self):\n        def g(): pass\n        class B: pass\n")
    (cls,) = inner(module.code)
    (method,) = inner(cls)
    assert [code.qualname for code in inner(method)] == ["A.f.<locals>.g", "A.f.<locals>.B"]
    assert (method.name, method.qualname, method.line, method.file) == ("f", "A.f", 2, "a.py")


def test_position_of_a_call() -> None:
    """A call stands where its expression begins, also when it goes over several lines."""
    module = lower("x = 1\ny = node.create_publisher(\n    String,\n    'chatter',\n)\n")
    assert [(op.line, op.column) for op in module.code.ops if isinstance(op, ops.Call)] == [(2, 5)]


DEEP = {
    "sum": "x = " + "+".join(["a"] * 5000),
    "attributes": "x = a" + ".b" * 5000,
    "calls": "x = a" + ".b(1)[2]" * 2000,
    "or": "x = " + " or ".join(["a"] * 5000),
    "comparison": "x = " + " < ".join(["a"] * 5000),
    "not": "x = " + "not " * 1000 + "a",
    "lists": "x = " + "[" * 150 + "]" * 150,
    "functions": "".join(" " * depth + f"def f{depth}(x{depth}):\n" for depth in range(99)) + " " * 99 + "return x0\n",
    "lambdas": "x = " + "lambda: " * 400 + "1",
    "elif": "if a: pass\n" + "elif a: pass\n" * 1000,
    "conditional": "x = " + "1 if a else " * 1000 + "2",
    "statements": "x = 1\n" * 20_000,
    "annotation": "def f(x: " + "|".join(["a"] * 1000) + "): ...",
}


@pytest.mark.parametrize("name", sample(DEEP, 3))
def test_deep(name: str) -> None:
    """Deep programs are read or refused, in a thread such as the analysis runs in; the process never dies."""
    found: list[object] = []

    def run() -> None:
        try:
            found.append(check(lower(DEEP[name]).code))
        except FrontendError as error:
            found.append(error.kind)

    limit, size = sys.getrecursionlimit(), threading.stack_size(256 << 20)
    sys.setrecursionlimit(100_000)
    try:
        thread = threading.Thread(target=run)
        thread.start()
        thread.join()
    finally:
        sys.setrecursionlimit(limit)
        threading.stack_size(size)
    assert found in ([[]], ["depth"])
    if sys.version_info[:2] != (3, 12):  # which parses nothing deeper than some thousand levels
        assert found == [[]]
