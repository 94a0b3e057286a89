# SPDX-License-Identifier: Apache-2.0
"""How does a process of a program in C++ start? Its names are linked, then `main` runs with the words of the command line, or a component is made."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Final

from rosward.domain.compound import Tuple
from rosward.domain.text import make
from rosward.domain.unknown import Cause, Reason
from rosward.domain.values import Const, Hole
from rosward.engine.cpp.program import start_component, start_main
from rosward.findings import Finding
from rosward.frontends.cpp.model_headers import PREFIX, modelled
from rosward.frontends.cpp.symbols import CppSymbols
from rosward.location import Place

if TYPE_CHECKING:
    from rosward.effects.configuration import Configuration
    from rosward.effects.entry import Entry
    from rosward.engine.interpreter import Interpreter

_HOST: Final = "rclcpp_components::host"
"""The model of what makes a component, with the words for its own node, and whether it sees those of the process as well."""


def start(machine: Interpreter, entry: Entry, configuration: Configuration | None) -> None:
    """Run the program of an entry."""
    place = Place(entry.file)
    symbols = machine.library.sources.program(entry.program)
    if symbols is None:
        return
    if entry.classes:
        own = None if configuration is None else configuration.component
        given = (Tuple(own or ()), Const(own is None))
        if not start_component(machine, symbols, entry.classes[0], entry.host or _HOST, given, place):
            message = f"The class {entry.classes[0]} is not among the sources of {entry.label}."
            machine.log.findings.add(Finding("RW019", message, place))
        return
    is_of_ros = not isinstance(symbols, CppSymbols) or _speaks_of_ros(symbols)
    if symbols.main is not None and not is_of_ros:
        return
    folder = Hole((Reason(Cause.FILE, "folder of the executable", place),))
    name = entry.executable or entry.file.rpartition("/")[2].rpartition(".")[0]
    program = make((folder, f"/{name}"))
    if configuration is not None:
        words = machine.new_list((program, *configuration.words))
    else:
        words = machine.new_list((program,), machine.unknown(Cause.ARGUMENT, "argv", "str"))
    if not start_main(machine, symbols, words, place):
        message = f"{entry.label} has no function main among the sources."
        machine.log.findings.add(Finding("RW019" if is_of_ros else "RW009", message, place))


def _speaks_of_ros(symbols: CppSymbols) -> bool:
    """Whether a source or header of a program says the name of a library that makes nodes or entities; else nothing that it runs does.

    What it includes says less: of a library in the workspace that there is a model of, the headers are no part of it.
    """
    said = re.compile(rf"\b(?:rcl\w*|{'|'.join(map(re.escape, sorted(modelled())))})\b")
    return any(said.search(f.parsed.prepared.text) for f in symbols.files if not f.text.startswith(PREFIX))
