# SPDX-License-Identifier: Apache-2.0
"""What the IR of a program looks like: `lowering.md` shows it. `--update-cases` writes it anew."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Final

import pytest

from rosward.frontends.python.module import lower_module
from rosward.ir.check import check
from rosward.ir.text import code_text

FILE: Final = Path(__file__).with_name("lowering.md")
CASE: Final = re.compile(
    r"(^## (?P<name>[^\n]+)\n.*?^```python\n(?P<source>.*?)^```\n\n```ir\n)(?P<expected>.*?)^```$",
    re.DOTALL | re.MULTILINE,
)
CASES: Final = {match["name"]: match for match in CASE.finditer(FILE.read_text(encoding="utf-8"))}


def printed(source: str) -> str:
    code = lower_module(source, "program.py").code
    assert check(code) == []
    return code_text(code)


@pytest.mark.parametrize("name", CASES)
def test_printed(name: str, request: pytest.FixtureRequest) -> None:
    case = CASES[name]
    found = printed(case["source"])
    if request.config.getoption("--update-cases", default=False):
        text = FILE.read_text(encoding="utf-8")
        FILE.write_text(text.replace(case[0], f"{case[1]}{found}```"), encoding="utf-8")
        return
    assert found == case["expected"]


def test_positions_can_be_printed() -> None:
    """With positions, each operation shows its line and column."""
    text = code_text(lower_module("x = 1\n\ny = f(x)\n", "a.py").code, positions=True)
    assert "   3:5    %2 = call %0(%1)" in text
