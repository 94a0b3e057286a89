# SPDX-License-Identifier: Apache-2.0
"""What do the program's own changes of `sys.path` and `sys.modules` make of an import?

sys.path.insert(0, os.path.dirname(__file__) + '/lib'); import topics     lib/topics.py, also where another topics.py lies nearer
sys.path.append(unknown); import topics                                   the nearest; told, where an unknown folder may hold another one
sys.modules['board'] = fake; import board                                 fake

What `sys.path` holds at first is not known, and is what the rules of the run say (`source/imports.py`): any number of folders between those
that the program puts before and behind. `sys.modules` holds each module of the sources from the moment at which it begins to run.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.domain.choice import options
from rosward.domain.text import origins_of
from rosward.domain.unknown import Cause
from rosward.domain.values import UNBOUND, Const, Hole, ModuleValue, Ref, Text, Unknown, Value
from rosward.engine.sources.found import FoundModule
from rosward.models.file_paths import location_of
from rosward.models.python.containers import dicts
from rosward.records import NamedTuple
from rosward.source.left_out import named_few

if TYPE_CHECKING:
    from collections.abc import Iterable

    from rosward.engine.machine import Engine

_SYS: Final = FoundModule("sys", "sys", "", True)

_ALTERNATIVES: Final = 4
"""How many files of one name are followed that may be meant: a library that is there for each platform is none of the program's own."""


class _Reached(NamedTuple):
    """What folders of `sys.path` give: the module that is surely found, those that may be found before it, whether a folder is not known."""

    sure: FoundModule | None = None
    possible: tuple[FoundModule, ...] = ()
    open: bool = False

    @property
    def all(self) -> tuple[FoundModule, ...]:
        """All that may be found."""
        return self.possible if self.sure is None else (*self.possible, self.sure)


def register(machine: Engine, name: str, module: ModuleValue) -> None:
    """A module of the sources begins to run: it is in `sys.modules`."""
    table = _variable(machine, "modules")
    if isinstance(table, Ref):
        dicts.store(machine, table, Const(name), module)


def registered(machine: Engine, name: str) -> Value | None:
    """What an import of that name finds in `sys.modules`, where that may be another module than the one that the rules of the run find."""
    table = _variable(machine, "modules")
    if not isinstance(table, Ref):
        return None
    record = machine.at(table.address)
    key = Const(name)
    value = record.entries.get(key)
    if value is None:
        return None
    ordinary = isinstance(value, ModuleValue) and value.name == name
    return None if key in record.maybe or (ordinary and not _changed(machine)) else value


def imported(machine: Engine, name: str, found: FoundModule, address: int) -> int:
    """Where the module of a file that was run before is kept: apart from the old one, where the program took that out of `sys.modules`."""
    table = _variable(machine, "modules")
    if not isinstance(table, Ref):
        return address
    value = machine.at(table.address).entries.get(Const(name))
    if isinstance(value, ModuleValue):
        return value.address if value.file == found.file else address
    return address if value is not None else machine.place_key(("module", found.key, "again"))


def on_path(
    machine: Engine, name: str, importer: ModuleValue | None, otherwise: FoundModule | None
) -> tuple[FoundModule | None, ...]:
    """The modules that a name may mean that `importer` imports, where the rules of the run find `otherwise`."""
    path = _variable(machine, "path")
    if not _changed(machine) or not isinstance(path, Ref):
        return (otherwise,)
    series = machine.at(path.address).series()
    reached = _searched(machine, series.head, name)
    if reached.sure is None and series.middle is not None:
        added = [_in_folder(machine, option, name) for option in options(series.middle) if not _was_there(option)]
        among = tuple(found for each in added for found in each.all)
        behind = _Reached(otherwise)
        if otherwise is None or otherwise.guess:
            behind = _searched(machine, series.tail, name)
        unknown = reached.open or behind.open or any(each.open for each in added)
        reached = _Reached(behind.sure or otherwise, (*reached.possible, *among, *behind.possible), unknown)
    sure = reached.sure
    itself = importer.file if importer is not None else ""  # a module that stands in for one of its own name
    others = {f.file: f for f in reached.possible if f.file != itself and (sure is None or f.file != sure.file)}
    if sure is None and len(others) == 1:
        return tuple(others.values())
    files = sorted({*others, *([sure.file] if sure is not None and sure.file else ())})
    if len(others) > _ALTERNATIVES:
        said = f"{name} may be any of {len(files)} files ({named_few(files)}); none of them is analysed"
        machine.report("RW203", f"sys.path contains an unknown folder: {said}")
        surest = sure or otherwise
        return (None if surest is None or surest.guess else surest,)
    if others and reached.open:
        machine.report("RW203", f"sys.path contains an unknown folder: {name} may be {' or '.join(files)}")
    return (*others.values(), *((sure,) if sure is not None or not others else ()))


def _searched(machine: Engine, entries: Iterable[Value], name: str) -> _Reached:
    """What folders give that are searched one after another."""
    before: tuple[FoundModule, ...] = ()
    unknown = False
    for entry in entries:
        reached = [_in_folder(machine, option, name) for option in options(entry)]
        unknown = unknown or any(each.open for each in reached)
        if reached[0].sure is not None and all(each.sure == reached[0].sure for each in reached):
            return _Reached(reached[0].sure, (*before, *(f for each in reached for f in each.possible)), unknown)
        before = (*before, *(found for each in reached for found in each.all))
    return _Reached(None, before, unknown)


def _was_there(entry: Value) -> bool:
    """Whether an entry of `sys.path` is one that was there before the program changed it."""
    return isinstance(entry, Unknown) and all(r.cause is Cause.LIVE and r.subject == "sys.path" for r in entry.reasons)


def _in_folder(machine: Engine, entry: Value, name: str) -> _Reached:
    """What one folder gives."""
    sources = machine.library.sources
    location = location_of(entry)
    if location is not None and not location.package:
        default = any(not origin.settled for origin in origins_of(entry))  # somebody may give another folder
        named = tuple(found for _, found in sources.named(name)) if default else ()
        return _Reached(sources.in_folder(location.relative, name), named, default)
    last = _last(entry) if location is None else location.relative.rpartition("/")[2]
    possible = tuple(
        found
        for folder, found in sources.named(name)
        if (not last or folder.rpartition("/")[2] == last)
        and (location is None or sources.is_of(found.file, location.package))
    )
    return _Reached(None, possible, True)


def _last(entry: Value) -> str:
    """The name of the folder itself, as far as it is known: 'lib' of '../lib'."""
    text = ""
    if isinstance(entry, Const) and isinstance(entry.value, str):
        text = f"/{entry.value}"
    elif isinstance(entry, Text) and not isinstance(entry.parts[-1], Hole):
        text = entry.parts[-1]
    _, slash, last = text.rstrip("/").rpartition("/")
    return last if slash and last not in (".", "..") else ""


def _changed(machine: Engine) -> bool:
    """Whether the program has changed `sys.path`."""
    module = machine.library.load_model(_SYS)
    path = machine.at(module.address).attrs["path"]
    before = machine.library.at(module.address).attrs["path"]
    if path is not before or not isinstance(path, Ref):
        return True
    return machine.at(path.address) is not machine.library.at(path.address)


def _variable(machine: Engine, name: str) -> Value:
    """A variable of `sys`."""
    return machine.at(machine.library.load_model(_SYS).address).attrs.get(name, UNBOUND)
