# SPDX-License-Identifier: Apache-2.0
"""Which calls in C++ would create an entity, and no process reaches them? `unreached.py` tells the same of Python.

RW205 where it surely is not run; RW204 in a class that a library may make.

void Lamp::calibrate() { pub_ = create_publisher<String>("calibration", 10); }      nothing calls it
PLUGINLIB_EXPORT_CLASS(demo::Planner, nav2_core::GlobalPlanner)                     whoever loads plugins makes a Planner
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING

from rosward.analysis.seen import Seen
from rosward.engine.declared import MODEL_PREFIX
from rosward.findings import Finding, Findings
from rosward.ir.cpp import InvokeMember, MakeLambda, Name
from rosward.ir.op import Op, walk
from rosward.ir.program import Code, OpKey
from rosward.source.location import Place

if TYPE_CHECKING:
    from rosward.frontends.cpp.symbol import CppSymbol
    from rosward.frontends.cpp.symbols import CppSymbols


def unreached_linked(
    seen: Sequence[Seen], programs: Iterable[CppSymbols], creating: frozenset[str], *, everywhere: bool
) -> list[Finding]:
    """One finding for each such call in the files of programs that were run; without `everywhere`, only in files of which some code was run."""
    entered = {key for each in seen for key in each.entered}
    reached = {key for each in seen for key in each.reached}
    units = {key.rpartition("#")[0] for key in entered}
    wanted = re.compile(rb"\b(?:" + "|".join(map(re.escape, sorted(creating))).encode() + rb")\b")
    found = Findings()
    known: set[str] = set()
    for program in programs:
        for file in program.files:
            if file.text in known or file.text.startswith(MODEL_PREFIX) or not (everywhere or file.text in units):
                continue
            known.add(file.text)
            plugins = {each.arguments[0] for each in file.parsed.prepared.registrations if each.arguments}
            for symbol in file.functions(wanted):
                whole = next((s for s in program.at(symbol.scope, symbol.name) if s.key == symbol.key), symbol)
                found.update(_of_function(whole, plugins, entered, reached, creating))
    return list(found)


def _of_function(
    symbol: CppSymbol, plugins: set[str], entered: set[str], reached: set[OpKey], creating: frozenset[str]
) -> Iterator[Finding]:
    code = symbol.code
    if code is None:
        return
    shown = "::".join((*filter(None, symbol.scope), symbol.name))
    for body, name, op in _creations(code, creating):
        place = Place(body.file, op.line, op.column)
        if code.key in entered:
            if (body.key, op.number) not in reached:
                message = f"no execution reaches this {name}, as far as the values are known: it is not in the result"
                yield Finding("RW205", message, place)
        elif "::".join(filter(None, symbol.scope)) in plugins:
            yield Finding(
                "RW204", f"{shown} is of a plugin, which may be loaded: its {name} is not in the result", place
            )
        else:
            yield Finding("RW205", f"{shown} is never called: its {name} is not in the result", place)


def _creations(code: Code, creating: frozenset[str]) -> Iterator[tuple[Code, str, Op]]:
    """The calls of what creates an entity, in a body and in the lambdas in it."""
    waiting = [code]
    while waiting:
        body = waiting.pop()
        for op in walk(body.ops):
            if isinstance(op, MakeLambda):
                waiting.append(op.code)
            elif isinstance(op, InvokeMember) and op.name in creating:
                yield body, op.name, op
            elif isinstance(op, Name) and op.parts[-1].name in creating:
                yield body, op.parts[-1].name, op
