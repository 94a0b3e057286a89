# SPDX-License-Identifier: Apache-2.0
"""Which objects of libraries that are not known may be nodes, where a program starts the client library and makes no node itself?

    rclpy.init()
    navigator = TurtleBot4Navigator()    without its code, nothing is known of a node: RW208
    node = acme.make_node()              so it is of a function with such a name

Where the program makes a node, it is taken that no library makes another one (docs/limits.md).
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Final

from rosward.domain.compound import External
from rosward.models.readers import makes_no_node
from rosward.source.standard_library import STANDARD_LIBRARY

if TYPE_CHECKING:
    from rosward.engine.machine import Engine


_MAKES: Final = re.compile(r"(?:\w*_)?nodes?(?:_\w*)?|(?:main|run|spin|start)(?:_\w*)?")
"""How functions are named that make or run nodes."""


def note(machine: Engine, callee: External) -> None:
    """Something of a library without a model is called: a class, or a function by its name, may make a node."""
    if callee.name not in machine.log.outside and _may_make_node(callee):
        machine.log.outside[callee.name] = None


def _may_make_node(callee: External) -> bool:
    return _may_be_node(callee) or (_MAKES.fullmatch(callee.name.rpartition(".")[2]) is not None and _is_open(callee))


def _may_be_node(callee: External) -> bool:
    last = callee.name.rpartition(".")[2]
    return (
        "." in callee.name
        and last[:1].isupper()
        and not last.endswith(("Error", "Exception", "Warning"))
        and _is_open(callee)
    )


def _is_open(callee: External) -> bool:
    return callee.name.partition(".")[0] not in STANDARD_LIBRARY and not makes_no_node(callee)


def tell(machine: Engine) -> None:
    """Whoever may make a node besides the program itself is told, in case that it makes none."""
    log = machine.log
    names = dict(log.outside)
    for cls in log.classes:
        if cls.place in machine.trace.instantiated:
            names.update((b.name, None) for b in cls.mro if isinstance(b, External) and _may_be_node(b))
    log.tell_outside(list(names))
