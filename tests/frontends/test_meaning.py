# SPDX-License-Identifier: Apache-2.0
"""Lowering keeps the meaning: a program run from its IR leaves the same `result` as under Python.

The programs stand in `programs.md`. The machine also asserts each `Assume`: a narrowing that doesn't hold on a path
fails here.
"""

from __future__ import annotations

import re
import sys
from pathlib import Path
from typing import Any, Final

import pytest

from frontends.machine import run
from rosward.frontends.python.module import lower_module
from rosward.ir.check import check
from rosward.ir.text import code_text

_PROGRAM: Final = re.compile(
    r"^## ([^\n]*?)(?: \(since 3\.(\d+)\))?\n\n```python\n(.*?)^```$", re.DOTALL | re.MULTILINE
)


def _programs() -> dict[str, str]:
    text = Path(__file__).with_name("programs.md").read_text(encoding="utf-8")
    return {name: source for name, since, source in _PROGRAM.findall(text) if sys.version_info >= (3, int(since or 0))}


PROGRAMS: Final = _programs()


def _same(source: str) -> None:
    module = lower_module(source, "program.py")
    assert check(module.code) == []
    expected: dict[str, Any] = {"__name__": "__main__"}
    exec(compile(source, "program.py", "exec"), expected)
    assert run(module)["result"] == expected["result"], code_text(module.code)


@pytest.mark.parametrize("name", PROGRAMS)
def test_same_result_as_python(name: str) -> None:
    _same(PROGRAMS[name])


def test_many_operands() -> None:
    """Long `and`, `or` and comparison chains, which are lowered differently beyond a bound, keep their meaning too."""
    ands, ors = " and ".join(["x"] * 100), " or ".join(["not x"] * 99 + ["x"])
    chain, broken = " < ".join(map(str, range(100))), " < ".join([*map(str, range(99)), "0", "1"])
    _same(f"x = 1\nresult = [{ands}, {ors}, {chain}, {broken}]")


def test_many_conditions() -> None:
    """The same for a long test of an `if`."""
    test = " and ".join(f"x != {number}" for number in range(100))
    _same(f"def f(x):\n    if {test}:\n        return 'in'\n    return 'out'\nresult = [f(-1), f(0), f(50), f(99)]")


def test_lowering_is_deterministic() -> None:
    """The same text gives the same IR."""
    source = "\n".join(PROGRAMS.values())
    assert code_text(lower_module(source, "a.py").code) == code_text(lower_module(source, "a.py").code)
