# SPDX-License-Identifier: Apache-2.0
"""What does a TOML file hold, whoever wrote it?

    '[project]\\nname = "demo"'    ->  {"project": {"name": "demo"}}
    'a.a.a.a.…'                   ->  ValueError: too many dots …

The reader of the standard library takes time with the square of the parts of a dotted key, so a small file can keep it busy for hours.
How much a file can ask of it is bounded from its lines before it is read. A key stands in one line, so dots that belong to no key are
counted with them at worst: honest files are far from the bound.
"""

from __future__ import annotations

import importlib
import sys
from typing import Any

from rosward.source import limits

__all__ = ["read_toml"]


def read_toml(text: str) -> dict[str, Any]:
    """The document. Raises ValueError."""
    if _cost(text) > limits.TOML_KEY_PARTS:
        raise ValueError("too many dots: its keys are too long")
    tomllib = importlib.import_module("tomllib" if sys.version_info >= (3, 11) else "tomli")
    try:
        document: dict[str, Any] = tomllib.loads(text)
    except RecursionError as error:
        raise ValueError("nested too deeply") from error
    return document


def _cost(text: str) -> int:
    """How often a part of a key is looked at, at most: each beginning of a dotted key is looked up below the table that it is in."""
    cost = table = 0
    for line in text.split("\n"):
        dots = line.count(".")
        if line.lstrip().startswith("["):  # the header of a table, or an array that looks like one
            table = max(table, dots)
        cost += dots * (table + dots) + table
    return cost
