# SPDX-License-Identifier: Apache-2.0
"""With what does a constructor initialise bases and fields?

Lamp() : Node("lamp"), names_{"a"}, Mixins(args)... {}      Initialise: Node paren, names_ brace, Mixins a pack
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from rosward.frontends.cpp.lower.body import Body
from rosward.frontends.cpp.lower.folds import expanded
from rosward.frontends.cpp.lower.initialisers import Given, given
from rosward.frontends.cpp.lower.names import name as lower_name
from rosward.frontends.cpp.lower.survey import word
from rosward.ir.cpp import Initialise, MemberInit

if TYPE_CHECKING:
    from tree_sitter import Node


def initialise(body: Body, node: Node, listed: Node | None) -> None:
    """The beginning of a constructor."""
    found = [
        _member(body, child) for child in (listed.named_children if listed is not None else ()) if _is_member(child)
    ]
    place = body.place(listed if listed is not None else node)
    body.emit(Initialise(*place, tuple(found)))
    body.free_register = body.floor


def _is_member(node: Node) -> bool:
    return node.type == "field_initializer" and len(node.named_children) > 1


def _member(body: Body, node: Node) -> MemberInit:
    named, what = node.named_children[0], node.named_children[-1]
    type_ = 0

    pack = any(child.type == "..." for child in node.children)

    def of_type() -> None:
        nonlocal type_
        type_ = expanded(body, named) if pack else lower_name(body, named, "value")

    made = Given((), "paren")

    def arguments() -> None:
        nonlocal made
        made = given(body, what)

    type_body = body.block(of_type)
    block = body.block(arguments)
    plain = word(named) if named.type in ("field_identifier", "identifier") else ""
    return MemberInit(plain, type_body, type_, block, made.arguments, made.form, pack)
