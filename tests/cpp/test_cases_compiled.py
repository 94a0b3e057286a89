# SPDX-License-Identifier: Apache-2.0
"""Promise: the cases in C++ say what their programs create when they are compiled and run.

It takes minutes: `COMPILED_CASES=1` (.ci/run). Cases of packages are left out, and those with libraries that the double lacks.
"""

from __future__ import annotations

import os
import re
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Final

import pytest
from casefile import Case, read_cases

from .compiled import DOUBLE, CompileError, Ran, fits_beside_others, needs_compiler, run, run_many

_FILES: Final = sorted(Path(__file__).parents[1].joinpath("cases").glob("cpp_*.md"))
_OUTSIDE: Final = frozenset({"cpp_hostile"})
"""What no compiler should be asked for."""
_SOURCES: Final = (".cpp", ".cc", ".cxx")
_READ: Final = (*_SOURCES, ".hpp", ".h")
_UNIT: Final = 24
"""So many programs are compiled as one."""


def _cases() -> list[Case]:
    if os.environ.get("COMPILED_CASES") != "1":
        return []
    found = [case for file in _FILES if file.stem not in _OUTSIDE for case in read_cases(file)]
    return [c for c in found if all(name.endswith(_READ) for name in c.files) and not c.known and not c.options]


CASES: Final = _cases()


@cache
def _lacking(number: int) -> str:
    """A header that a case includes, and that neither it nor the double has."""
    case = CASES[number]
    return next((name for text in case.files.values() if (name := DOUBLE.lacks(text, own=case.files))), "")


@cache
def _as_one_file(number: int) -> str:
    """The source of a case with its own headers in place; '' where it does not mean the same in a namespace."""
    files = CASES[number].files
    sources = [name for name in files if name.endswith(_SOURCES)]
    if len(sources) != 1 or not all(map(fits_beside_others, files.values())):
        return ""
    text = files[sources[0]]
    for name in files:
        include = re.compile(rf'^#include "{re.escape(name)}"$', re.MULTILINE)
        if len(include.findall(text)) > 1:
            return ""
        text = include.sub(lambda _, own=files[name]: own.replace("#pragma once\n", ""), text)  # type: ignore[misc]
    return text


@cache
def _units() -> list[list[int]]:
    """The cases that are compiled as one: those that consist of one source, and mean the same in a namespace."""
    fitting = [number for number in range(len(CASES)) if _as_one_file(number) and not _lacking(number)]
    return [fitting[first : first + _UNIT] for first in range(0, len(fitting), _UNIT)]


@pytest.fixture(scope="module")
def ran_together(tmp_path_factory: pytest.TempPathFactory) -> Callable[[int], Ran | None]:
    """What a case did as part of its unit; None where it is in none, or where they cannot be compiled as one."""

    @cache
    def of_unit(first: int) -> dict[int, Ran]:
        unit = next(unit for unit in _units() if unit[0] == first)
        try:
            return dict(zip(unit, run_many(map(_as_one_file, unit), tmp_path_factory.mktemp("unit")), strict=True))
        except CompileError:
            return {}

    def of_case(number: int) -> Ran | None:
        unit = next((unit for unit in _units() if number in unit), None)
        return None if unit is None else of_unit(unit[0]).get(number)

    return of_case


@needs_compiler
@pytest.mark.parametrize("number", [pytest.param(number, id=case.name) for number, case in enumerate(CASES)])
def test_case(number: int, ran_together: Callable[[int], Ran | None], tmp_path: Path) -> None:
    case = CASES[number]
    if lacking := _lacking(number):
        pytest.skip(f"it includes a library that the double lacks: {lacking}")
    ran = ran_together(number) or _ran_alone(case, tmp_path)
    said = [line.split() for line in case.expected if not line.startswith(("finding", "show"))]
    created = [(kind, name, type_) for _, kind, name, type_ in ran.entities]
    own = [(kind, name, type_) for _, kind, name, type_ in ran.system]
    assert [made for made in created if not any(_covers(words, made) for words in said)] == []
    sure = [words for words in said if "conditional" not in words]
    missing = [words for words in sure if not any(_covers(words, made) for made in (*created, *own))]
    assert missing == [] or ran.status != 0  # an exception ended it


def _ran_alone(case: Case, folder: Path) -> Ran:
    for name, text in case.files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text, encoding="utf-8")
    sources = [folder / name for name in case.files if name.endswith(_SOURCES)]
    return run(DOUBLE.compile(sources, folder / "program", include=[folder]))


def _covers(words: list[str], made: tuple[str, str, str]) -> bool:
    kind, name, type_ = made
    if words[0] != kind or not re.fullmatch(".*".join(map(re.escape, words[1].split("*"))), name):
        return False
    return kind == "node" or words[2] in ("?", type_)
