# SPDX-License-Identifier: Apache-2.0
"""Which languages does the engine run? One record each; `Code.language` says which one a body is written in.

A further language is a folder beside `python/` with its record (`machine.Language`), one entry here, and one in `frontends/registry.py`.
"""

from __future__ import annotations

from typing import Final

from rosward.engine.python.language import PYTHON

__all__ = ["LANGUAGES"]

LANGUAGES: Final = (PYTHON,)
"""The first is the one that models and natives are written in."""
