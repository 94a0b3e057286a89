# SPDX-License-Identifier: Apache-2.0
"""The casts that are written like calls of templates: `static_cast<T>(x)`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final, Literal

from rosward.frontends.cpp.lower.types import REFERENCES, has

if TYPE_CHECKING:
    from collections.abc import Mapping

    from tree_sitter import Node

__all__ = ["CASTS", "Cast", "by_value"]

Cast = Literal["value", "static", "dynamic", "const"]
CASTS: Final[Mapping[str, Cast]] = {
    "static_cast": "static",
    "dynamic_cast": "dynamic",
    "const_cast": "const",
    "reinterpret_cast": "const",
}


def by_value(type_: Node, kind: Cast) -> Cast:
    """The kind of a cast: `static_cast<T>(x)` makes a value, `static_cast<T &>(x)` does not."""
    shape = type_.child_by_field_name("declarator") if type_.type == "type_descriptor" else None
    return "value" if kind == "static" and not has(shape, REFERENCES) else kind
