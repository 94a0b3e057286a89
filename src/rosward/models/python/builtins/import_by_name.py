# SPDX-License-Identifier: Apache-2.0
"""Imports by a name or a path that the program computes: followed where it is known, told (RW203) where it is not.

importlib.import_module('.lidar', package=__package__)     demo.drivers.lidar, where the package is demo.drivers
__import__('demo.lidar')                                   demo: without `fromlist` the uppermost package
spec_from_file_location('lib', SHARE + '/launch/lib.py')   the module of that file, apart from the one that an import by name finds
"""

from __future__ import annotations

from typing import Final

from rosward.domain.certain import text_of
from rosward.domain.choice import join_all, options
from rosward.domain.text import readable
from rosward.domain.unknown import Cause
from rosward.domain.values import FALSE, NONE, UNBOUND, Const, Value
from rosward.models.file_paths import location_of
from rosward.models.native import NativeCall, NativeFunction


def _text(value: Value) -> str | None:
    return value.value if isinstance(value, Const) and isinstance(value.value, str) else None


def _not_known(call: NativeCall) -> Value:
    call.machine.report("RW203", "the name of the module imported here is unknown")
    call.machine.die("ModuleNotFoundError", "the name of a module")
    return call.machine.unknown(Cause.CALL, call.name)


def _absolute(name: Value, package: Value) -> str | None:
    """The whole name of a module as `importlib` reads it; None where it is not known, or where Python refuses it."""
    text = _text(name)
    if text is None or not text.startswith("."):
        return text or None
    parts = (_text(package) or "").split(".")
    level = len(text) - len(text.lstrip("."))
    if level > len(parts) or not all(parts):
        return None
    return ".".join([*parts[: len(parts) - level + 1], *([text[level:]] if text[level:] else [])])


def _import_module(call: NativeCall) -> Value:
    """`importlib.import_module(name, package=None)`."""
    found: list[Value] = []
    package = call.arg(1, "package", NONE) or NONE
    for name in options(call.arg(0, "name", UNBOUND) or UNBOUND):
        for base in options(package):
            whole = _absolute(name, base)
            found.append(_not_known(call) if whole is None else call.machine.load_module(whole, asked=True))
    return join_all(found)


def _import(call: NativeCall) -> Value:
    """`__import__(name, globals=None, locals=None, fromlist=(), level=0)`; `globals` is taken for that of the calling module."""
    machine = call.machine
    level = call.arg(4, "level", Const(0))
    if not isinstance(level, Const) or not isinstance(level.value, int) or level.value < 0:
        return _not_known(call)
    names = call.arg(3, "fromlist", FALSE) or FALSE
    wanted = call.machine.truth(names)
    found: list[Value] = []
    for option in options(call.arg(0, "name", UNBOUND) or UNBOUND):
        name = _text(option)
        if name is None or wanted is None or not (name or level.value):
            found.append(_not_known(call))
            continue
        module = machine.load_module(name, level.value, asked=True)
        if module is not UNBOUND and wanted:
            for each in call.machine.iterate(names).known:  # submodules that are asked for are imported
                if (text := _text(each)) is not None and text != "*":
                    machine.load_attr(module, text)
        elif module is not UNBOUND and "." in name:
            module = _not_known(call) if level.value else machine.load_module(name.partition(".")[0])
        found.append(module)
    return join_all(found)


def _at_path(call: NativeCall) -> Value:
    """`importlib.machinery._module_at(name, path)`: the module of a file of the sources, loaded by its path."""
    name, paths = call.exactly(2)
    found = [_of_file(call, text_of(name, "module"), path) for path in options(paths)]
    return join_all(found)


def _of_file(call: NativeCall, name: str, path: Value) -> Value:
    location = location_of(path)
    file = call.machine.files.name_of(*location) if location is not None else None
    module = None if file is None else call.machine.load_file(file, name)
    if module is not None:
        return module
    call.machine.report("RW203", f"the module at {readable(path)} runs code that is not analysed")
    return call.machine.unknown(Cause.MODULE, name)


def _entry_points(call: NativeCall) -> Value:
    """`importlib.metadata.entry_points(…)`: what packages have registered, and what is loaded by it."""
    call.machine.report("RW203", "what the entry points of installed packages load is not analysed")
    return call.machine.unknown(Cause.CALL, call.name)


def _reload(call: NativeCall) -> Value:
    """`importlib.reload(module)`: the module, as it is."""
    call.machine.report("RW203", "importlib.reload is not analysed: changes to the module since its import are kept")
    return call.exactly(1)[0]


NATIVES: Final[dict[str, NativeFunction]] = {
    "importlib.import_module": _import_module,
    "importlib.reload": _reload,
    "importlib.machinery._module_at": _at_path,
    "builtins.__import__": _import,
    "importlib.metadata.entry_points": _entry_points,
    "importlib_metadata.entry_points": _entry_points,
    "pkg_resources.iter_entry_points": _entry_points,
}
