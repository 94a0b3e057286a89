# SPDX-License-Identifier: Apache-2.0
"""The IR of real code is well formed: of the running Python's own library, a sample by default.

`ROSWARD_ALL_SOURCES=1` takes all of it; `ROSWARD_SOURCES=/some/folder` takes another folder.
"""

from __future__ import annotations

import os
import tokenize
from collections.abc import Iterator
from pathlib import Path
from typing import Final

import pytest
from sampling import sample

from rosward.frontends.front_end import FrontendError
from rosward.frontends.python.module import lower_module
from rosward.ir.check import check
from rosward.ir.text import code_text

FOLDER: Final = Path(os.environ.get("ROSWARD_SOURCES", Path(os.__file__).parent))
EVERYTHING: Final = "ROSWARD_ALL_SOURCES" in os.environ
SAMPLE: Final = (
    *(
        "argparse.py",
        "ast.py",
        "asyncio/base_events.py",
        "asyncio/tasks.py",
        "collections/__init__.py",
        "contextlib.py",
    ),
    *("dataclasses.py", "enum.py", "functools.py", "inspect.py", "logging/__init__.py", "pathlib.py", "pickle.py"),
    *("subprocess.py", "typing.py", "unittest/mock.py", "xml/etree/ElementTree.py", "turtle.py", "decimal.py"),
)


def _sources() -> Iterator[str]:
    if EVERYTHING or "ROSWARD_SOURCES" in os.environ:
        yield from (str(path.relative_to(FOLDER)) for path in sorted(FOLDER.rglob("*.py")))
    else:
        yield from (name for name in SAMPLE if (FOLDER / name).exists())


@pytest.mark.parametrize("name", sample(list(_sources()), 3))
def test_well_formed(name: str) -> None:
    try:
        with tokenize.open(FOLDER / name) as file:
            text = file.read()
        module = lower_module(text, name)
    except (FrontendError, SyntaxError, UnicodeDecodeError):
        pytest.skip("not a file that Python reads")
    assert check(module.code) == []
    assert "intrinsic unsupported" not in code_text(module.code)
