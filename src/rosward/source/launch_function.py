# SPDX-License-Identifier: Apache-2.0
"""Does a Python file make, or take from elsewhere, the function that launch asks for a description?

def generate_launch_description(): …                        yes
from demo.common import generate_launch_description         yes
globals()["generate_launch_description"] = made             yes, it may be set under its name
TEMPLATE = 'def generate_launch_description(): …'           no: this writes launch files
"""

from __future__ import annotations

import ast
import warnings
from typing import Final

__all__ = ["makes_launch"]

_FUNCTION: Final = "generate_launch_description"


def makes_launch(data: bytes) -> bool:
    """Whether it does, or may do; what cannot be read here is told where it is run."""
    if _FUNCTION.encode() not in data:
        return False
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            tree = ast.parse(data)
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return True
    return any(_gives(node) for node in ast.walk(tree))


def _gives(node: ast.AST) -> bool:
    """Whether a piece of code names the function: the text of a name counts, a longer one does not."""
    match node:
        case ast.FunctionDef(name=name) | ast.AsyncFunctionDef(name=name) | ast.ClassDef(name=name):
            return name == _FUNCTION
        case ast.alias(name=name, asname=given):
            return (given or name) == _FUNCTION
        case ast.Name(id=name) | ast.Constant(value=name):
            return name == _FUNCTION
    return False
