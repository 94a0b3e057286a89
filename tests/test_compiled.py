# SPDX-License-Identifier: Apache-2.0
"""What is compiled where somebody asks for it (hatch_build.py)?"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from rosward.source.toml import read_toml

ROOT = Path(__file__).parent.parent
TARGET = read_toml((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["tool"]["hatch"]["build"]["targets"]
HOOK: dict[str, Any] = TARGET["wheel"]["hooks"]["custom"]


@pytest.mark.parametrize("module", HOOK["modules"])
def test_a_module_that_is_compiled_is_there(module: str) -> None:
    """A list of files goes stale where one is renamed; the wheel would not be built."""
    assert (ROOT / "src" / module).is_file()


def test_all_values_are_compiled_but_numbers_of_enumerators() -> None:
    """A class cannot be compiled if its base is not; mypyc compiles no subclass of `int`."""
    domain = {path.name for path in (ROOT / "src/rosward/domain").glob("*.py")} - {"__init__.py", "enumerated.py"}
    assert domain == {Path(module).name for module in HOOK["modules"] if module.startswith("rosward/domain/")}
