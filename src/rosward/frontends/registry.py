# SPDX-License-Identifier: Apache-2.0
"""Which front end reads a file?

front_end_of("src/talker.py").language  ->  "python"          front_end_of("scripts/talker").language  ->  "python"
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

from rosward.frontends.front_end import FrontEnd
from rosward.frontends.python.module import lower_module
from rosward.ir import program

__all__ = ["FRONT_ENDS", "PYTHON", "front_end_of"]

PYTHON: Final = FrontEnd(program.PYTHON, (".py", ".pyi"), lower_module)
FRONT_ENDS: Final = (PYTHON,)
"""One for each language. A further language is one entry here, and one in `engine/languages.py`."""


def front_end_of(file: str, front_ends: Sequence[FrontEnd] = FRONT_ENDS) -> FrontEnd:
    """The front end of a file, by its suffix; a file of any other suffix, or none, is a script of Python."""
    return next((each for each in front_ends if file.endswith(each.suffixes)), PYTHON)
