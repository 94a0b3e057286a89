# SPDX-License-Identifier: Apache-2.0
"""Promise: every special method of Python stands in docs/special-methods.md, with what is done where Python calls it."""

from __future__ import annotations

import re
import types
from pathlib import Path
from typing import Final

import pytest

from rosward.engine.python.implicit import FOLLOWED
from rosward.engine.python.own_methods import AT_MAKING

PAGE: Final = Path(__file__).parents[2] / "docs" / "special-methods.md"
WAYS: Final = ("followed", "any time", "making", "name")

CLASSES: Final = (
    object, type, int, float, complex, bool, str, bytes, bytearray, list, tuple, dict, set, frozenset, range, slice, memoryview,
    property, classmethod, staticmethod, super, enumerate, zip, map, filter, reversed, BaseException, type(None), type(NotImplemented),
    types.FunctionType, types.MethodType, types.GeneratorType, types.CoroutineType, types.AsyncGeneratorType, types.SimpleNamespace,
)  # fmt: skip
"""The classes whose methods Python itself calls."""

WRITTEN: Final = frozenset(
    {
        "__await__", "__aiter__", "__anext__", "__aenter__", "__aexit__", "__bytes__", "__ceil__", "__class_getitem__",
        "__complex__", "__copy__", "__deepcopy__", "__del__", "__delete__", "__enter__", "__exit__", "__floor__", "__fspath__",
        "__getattr__", "__getnewargs_ex__", "__get__", "__imatmul__", "__imod__", "__ipow__", "__index__", "__instancecheck__",
        "__itruediv__", "__ifloordiv__", "__length_hint__", "__match_args__", "__matmul__", "__missing__", "__mro_entries__",
        "__prepare__", "__replace__", "__reversed__", "__rmatmul__", "__round__", "__set__", "__set_name__", "__setstate__",
        "__slots__", "__subclasscheck__", "__trunc__", "__buffer__", "__release_buffer__", "__ilshift__", "__irshift__",
        "__iand__", "__ior__", "__ixor__", "__iadd__", "__isub__", "__imul__",
    }
)  # fmt: skip
"""What the language reference names besides: methods that a program may write and no class of Python has."""

DATA: Final = frozenset({"__slots__", "__match_args__", "__doc__", "__module__", "__annotations__", "__dict__"})
"""Names of the data model that are not called."""

OF_FUNCTIONS: Final = frozenset(
    {
        "__closure__", "__code__", "__defaults__", "__kwdefaults__", "__globals__", "__builtins__", "__func__", "__self__",
        "__wrapped__", "__isabstractmethod__", "__thisclass__", "__self_class__", "__cause__", "__context__",
        "__suppress_context__", "__traceback__", "__objclass__", "__loader__", "__spec__", "__annotate__", "__classcell__",
        "__static_attributes__", "__firstlineno__", "__getformat__", "__notes__", "__alloc__",
    }
)  # fmt: skip
"""What functions and exceptions hold: no method."""


def _table() -> dict[str, str]:
    """The way of each special method."""
    found: dict[str, str] = {}
    for line in PAGE.read_text(encoding="utf-8").splitlines():
        cells = [c.strip() for c in line.strip("|").replace("\\|", "/").split(" | ")]
        if line.startswith("| `__") and len(cells) == 3 and " of a " not in cells[0]:
            found.update(dict.fromkeys(re.findall(r"`(__\w+__)`", cells[0]), cells[2]))
    return found


def _special() -> set[str]:
    names = {n for cls in CLASSES for n in dir(cls) if re.fullmatch(r"__\w+__", n)}
    return (names | WRITTEN) - OF_FUNCTIONS


@pytest.mark.parametrize("name", sorted(_special()))
def test_every_special_method_stands_in_the_table(name: str) -> None:
    """A method that a newer Python adds fails here until somebody says what is done."""
    assert _table().get(name) in WAYS


def test_the_table_says_what_the_engine_does() -> None:
    """The ways of the page are those of the engine."""
    table = _table()
    assert {n for n, way in table.items() if way == "followed"} == FOLLOWED - AT_MAKING
    assert {n for n, way in table.items() if way == "making"} == AT_MAKING
    assert {n for n, way in table.items() if way == "name"} >= DATA
