# SPDX-License-Identifier: Apache-2.0
"""What does lowering get of a declaration?"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from rosward.frontends.cpp.outline import Declared
from rosward.frontends.cpp.parse import Parsed
from rosward.records import NamedTuple

if TYPE_CHECKING:
    from tree_sitter import Node

    from rosward.ir.symbols import Symbol


class DefaultArgument(NamedTuple):
    """The default of a parameter: it may stand in another file than the body."""

    parsed: Parsed
    node: Node


class Written(NamedTuple):
    """A declaration with the file that it stands in.

    `unit` names the text for good: what the file becomes under other macros has another. `own` are the parameters of the template that the
    declaration itself is, without those of the class around it. `leading`: the function has `this`. `defaults` has one for each parameter.
    `local` gives the symbol of a class or enum that a body declares.
    """

    parsed: Parsed
    declared: Declared
    unit: str
    own: Node | None
    leading: int
    defaults: tuple[DefaultArgument | None, ...]
    local: Callable[[Node], Symbol | None]
