# SPDX-License-Identifier: Apache-2.0
"""Which module does a relative import mean, and can it be made at all?

    from ..common import base   in demo/nodes/talker.py, imported as demo.nodes.talker   ->  demo.common
    from . import helper        in a script that is run as a file                        ->  ImportError
    from ... import helper      in demo/nodes/talker.py, imported as demo.nodes.talker   ->  ImportError: beyond the top

As in Python the `__package__` of the importing module decides, not the folder of its file. A file in a package may also be run by `python -m`:
there both is possible.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.domain.choice import options
from rosward.domain.values import NONE, Const, ModuleValue, Value
from rosward.records import NamedTuple

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

_NO_PARENT: Final = "attempted relative import with no known parent package"
_BEYOND: Final = "attempted relative import beyond top-level package"


class Relative(NamedTuple):
    """The absolute `name` that a relative import stands for ('' where it is not known), and why it is refused, or `may` be."""

    name: str
    refused: str = ""
    may: bool = False


def relative(machine: Engine, importer: ModuleValue, name: str, level: int) -> Relative:
    """What `level` dots and a name mean in a module."""
    package = machine.at(importer.address).attrs.get("__package__")
    names: list[str] = []
    refusals: list[str] = []
    others = False
    for option in options(package) if package is not None else ():
        if option == NONE or option == Const(""):
            refusals.append(_NO_PARENT)
        elif isinstance(option, Const) and isinstance(option.value, str):
            parts = option.value.split(".")
            if level > len(parts):
                refusals.append(_BEYOND)
            else:
                names.append(".".join([*parts[: len(parts) - level + 1], *([name] if name else [])]))
        else:
            others = True
    if refusals and not names and not others:
        caught = bool(machine.catchers)  # the program knows that it may be run as a script
        return Relative(
            "", refusals[0], may=not caught and not machine.library.sources.leads_out(importer.file, name, level)
        )
    return Relative(names[0] if len(names) == 1 and not others else "", may=bool(refusals))


def main_package(machine: Engine, file: str) -> tuple[Value, ...]:
    """The values that `__package__` may have in a file that is run: none where it is run by its path, that of its module by `python -m`."""
    package = machine.library.sources.python_package(file)
    return (NONE, Const(package)) if package else (NONE,)
