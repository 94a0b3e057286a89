# SPDX-License-Identifier: Apache-2.0
"""Which calls in C++ would create an entity, and no process reaches them? `unreached.py` tells the same of Python.

RW205 where it surely is not run; RW204 in a class that a library may make.

void Lamp::calibrate() { pub_ = create_publisher<String>("calibration", 10); }      nothing calls it
PLUGINLIB_EXPORT_CLASS(demo::Planner, nav2_core::GlobalPlanner)                     whoever loads plugins makes a Planner
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence

from rosward.analysis.linked_functions import LinkedFunction
from rosward.analysis.seen import Seen
from rosward.findings import Finding, Findings
from rosward.ir.program import OpKey

__all__ = ["Functions", "unreached_linked"]

Functions = Callable[[str, Callable[[str], bool]], Mapping[str, Sequence[LinkedFunction]]]
"""The functions of a program, by its name, that would create an entity, by file: of those of its files that are wanted."""


def unreached_linked(
    seen: Sequence[Seen], programs: Mapping[str, bool], functions: Functions, *, everywhere: bool
) -> list[Finding]:
    """One finding for each such call in the files of programs; without `everywhere`, only in files of which some code was run.

    `programs`: those that were run, and libraries, each with whether others can load it at run time.
    """
    entered = {key for each in seen for key in each.entered}
    reached = {key for each in seen for key in each.reached}
    units = {key.rpartition("#")[0] for key in entered}
    found = Findings()
    known: set[str] = set()

    def is_wanted(file: str) -> bool:
        return file not in known and (everywhere or file in units)

    for program, loadable in programs.items():
        files = functions(program, is_wanted)
        known.update(files)
        for each in (function for inner in files.values() for function in inner):
            told = _of_function(each, entered, reached, loadable=loadable)
            found.update(f._replace(causes=(f"plugins of {program}",)) if f.code == "RW204" else f for f in told)
    return list(found)


def _of_function(
    function: LinkedFunction, entered: set[str], reached: set[OpKey], *, loadable: bool
) -> Iterator[Finding]:
    for body, number, name, place, made in function.creations:
        if function.key in entered:
            if not made and (body, number) not in reached:
                message = f"no execution reaches this {name}, as far as the values are known: it is not in the result"
                yield Finding("RW205", message, place)
        elif function.plugin:
            message = f"{function.shown} is of a plugin, which may be loaded: its {name} is not in the result"
            yield Finding("RW204", message, place)
        elif loadable:
            message = (
                f"{function.shown} is in a library of plugins, which may be loaded: its {name} is not in the result"
            )
            yield Finding("RW204", message, place)
        else:
            yield Finding("RW205", f"{function.shown} is never called: its {name} is not in the result", place)
