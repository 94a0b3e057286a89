# SPDX-License-Identifier: Apache-2.0
"""What else a random program is made of: each file has one kind of construct, and says which expressions and statements it writes.

A further construct is a function of the form `Way` or `Statement`, in the WAYS or STATEMENTS of its file.
"""

from __future__ import annotations

from typing import Final

from ..draft import Statement, Way
from . import arguments, builtin_subclasses, exceptions, implicit, kinds, managers, overridden, packages, suspended

_ALL: Final = (arguments, builtin_subclasses, exceptions, implicit, kinds, managers, overridden, packages, suspended)

FURTHER_WAYS: Final[tuple[Way, ...]] = tuple(way for each in _ALL for way in each.WAYS)
FURTHER_STATEMENTS: Final[tuple[Statement, ...]] = tuple(way for each in _ALL for way in each.STATEMENTS)
