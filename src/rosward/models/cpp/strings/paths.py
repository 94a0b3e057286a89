# SPDX-License-Identifier: Apache-2.0
"""What does `std::filesystem` say of paths and files? A path is its text; what is in the file system is not known.

path("/a") / "b.yaml"       '/a/b.yaml'             path("/a/b.yaml").stem()        'b'
exists(path)                not known, but for what is installed from the sources
"""

from __future__ import annotations

import posixpath
from collections.abc import Callable
from typing import Final

from rosward.domain.choice import lift, options
from rosward.domain.compound import External
from rosward.domain.series import Series
from rosward.domain.slots import TypeOf
from rosward.domain.text import concat, origins_of
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, Const, Value
from rosward.ir.core import CharText
from rosward.models.cpp.arity import with_least
from rosward.models.cpp.values.conversions import new_container
from rosward.models.cpp.values.copies import write
from rosward.models.cpp.values.slots import read
from rosward.models.file_paths import location_of
from rosward.models.native import Machine, NativeCall, NativeFunction
from rosward.models.python.plain import spread, text_of, unknown_from
from rosward.models.python.std import paths as python

__all__ = ["NATIVES", "slash"]


def slash(machine: Machine, left: Value, right: Value) -> Value:
    """left / right, of which one is a path."""
    del machine
    if text_of(right) == "":
        plain = text_of(left)
        return left if plain is None or plain.endswith("/") or not plain else Const(f"{plain}/", origins_of(left))
    return python.join_two(left, right)


def _normal(value: Value) -> Value:
    plain = text_of(value)
    return (
        python.normal(value) if plain is None else Const(posixpath.normpath(plain) if plain else "", origins_of(value))
    )


def _without_extension(value: Value) -> Value:
    return python.splitext(value)[0]


_TEXTS: Final = TypeOf("std.vector", (External("std.string"),))
_PARTS: Final[dict[str, Callable[[Value], Value]]] = {
    "parent_path": python.dirname,
    "filename": python.basename,
    "stem": lambda value: _without_extension(python.basename(value)),
    "extension": lambda value: python.splitext(python.basename(value))[1],
    "lexically_normal": _normal,
    **dict.fromkeys(("string", "c_str", "native", "generic_string", "u8string", "make_preferred"), lambda value: value),
}


def _part(call: NativeCall) -> Value:
    return lift(_PARTS[call.name.rpartition(".")[2]], read(call.machine, call.args[0]))


def _replace_extension(call: NativeCall) -> Value:
    machine, slot = call.machine, call.args[0]
    wanted = read(machine, call.args[1]) if len(call.args) > 1 else Const("")

    def one(value: Value, extension: Value) -> Value:
        text = text_of(extension)
        dot = Const("." if text is None or (text and not text.startswith(".")) else "")
        if text is None:
            return unknown_from(machine, "replace_extension", "str", value, extension)
        return concat((_without_extension(value), dot, extension))

    changed = spread(one, read(machine, slot), wanted)
    write(machine, slot, changed)
    return changed


def _replace_filename(call: NativeCall) -> Value:
    machine, slot = call.machine, call.args[0]
    changed = spread(
        lambda value, name: slash(machine, python.dirname(value), name),
        read(machine, slot),
        read(machine, call.args[1]),
    )
    write(machine, slot, changed)
    return changed


def _is_absolute(call: NativeCall) -> Value:
    def one(value: Value) -> Value:
        text = text_of(value)
        answer = unknown_from(call.machine, "is_absolute", "bool", value) if text is None else None
        return answer or Const(str(text).startswith("/") is (call.name.endswith("absolute")))

    return lift(one, read(call.machine, call.args[0]))


def _exists(call: NativeCall) -> Value:
    """Whether there is such a file: surely where it is among the sources that are installed."""
    machine, name = call.machine, call.name.rpartition(".")[2]

    def one(value: Value) -> Value:
        location = location_of(value)
        if location is not None:
            is_file = machine.files.is_file(*location)
            is_folder = machine.files.is_folder(*location)
            if is_file or is_folder:
                return Const({"is_regular_file": is_file, "is_directory": is_folder}.get(name, True))
        return machine.unknown(Cause.FILE, text_of(value) or "", "bool")

    return lift(one, read(machine, call.args[0]))


def _unknown_path(call: NativeCall) -> Value:
    return call.machine.unknown(Cause.FILE, call.name.rpartition(".")[2], "str")


def _same(call: NativeCall) -> Value:
    return read(call.machine, call.args[0])


def _characters(call: NativeCall) -> Value:
    """What reads like a literal from now on: no string, but a pointer to characters."""

    def one(value: Value) -> Value:
        text = text_of(value)
        return value if text is None or not isinstance(value, Const) else Const(CharText(text), value.origins)

    return lift(one, read(call.machine, call.args[0]))


def _asked(hint: str) -> NativeFunction:
    """A question to the file system, or a change of it, whose answer is not known."""

    def ask(call: NativeCall) -> Value:
        return call.machine.unknown(Cause.FILE, call.name.rpartition(".")[2], hint)

    return ask


def _listing(call: NativeCall) -> Value:
    """directory_iterator(path): the files of a folder that is installed from the sources, in some order."""
    machine = call.machine
    args = call.args[1:] if call.name.endswith(".new") else call.args
    found: list[Value] = []
    for path in options(read(machine, args[0])) if args else ():
        location = location_of(path)
        names = machine.files.listing(*location) if location is not None else None
        if names is None or "recursive" in call.name:
            return machine.unknown(Cause.FILE, call.name.rpartition(".")[2], "list")
        found.extend(concat((path, Const(f"/{name}"))) for name in names)
    return new_container(machine, _TEXTS, Series(tuple(found)), "files")


def _nothing(call: NativeCall) -> Value:
    del call
    return NONE


_FUNCTIONS: Final[dict[str, NativeFunction]] = {
    **dict.fromkeys(("exists", "is_regular_file", "is_directory"), _exists),
    **dict.fromkeys(("current_path", "temp_directory_path", "read_symlink"), _unknown_path),
    **dict.fromkeys(("absolute", "canonical", "weakly_canonical", "relative", "proximate"), _asked("str")),
    **dict.fromkeys(("remove", "create_directory", "create_directories", "is_empty", "is_symlink"), _asked("bool")),
    **dict.fromkeys(("remove_all", "file_size", "hard_link_count"), _asked("int")),
    **dict.fromkeys(("copy", "rename", "copy_file", "permissions", "resize_file"), _nothing),
    **{f"{name}directory_iterator{new}": _listing for name in ("", "recursive_") for new in ("", ".new")},
    "u8path": _same,
}
_SPACES: Final = ("std.filesystem", "std.experimental.filesystem", "rcpputils.fs", "boost.filesystem")

_LEAST: Final = {
    **dict.fromkeys(
        (
            "exists",
            "is_regular_file",
            "is_directory",
            "u8path",
        ),
        1,
    ),
}
NATIVES: Final[dict[str, NativeFunction]] = {
    **{f"std.string.{name}": _part for name in _PARTS if name != "c_str"},
    "std.string.c_str": _characters,
    "std.string.path": _same,
    "std.string.replace_extension": _replace_extension,
    "std.string.replace_filename": _replace_filename,
    "std.string.is_absolute": _is_absolute,
    "std.string.is_relative": _is_absolute,
    "std.string.has_extension": lambda call: _has(call, "extension"),
    "std.string.has_filename": lambda call: _has(call, "filename"),
    "std.string.has_parent_path": lambda call: _has(call, "parent_path"),
    "std.string.exists": _exists,
    "std.string.is_regular_file": _exists,
    "std.string.is_directory": _exists,
    **{
        f"{space}.{name}": function for space in _SPACES for name, function in with_least(_FUNCTIONS, 0, _LEAST).items()
    },
}


def _has(call: NativeCall, part: str) -> Value:
    def one(value: Value) -> Value:
        text = text_of(_PARTS[part](value))
        return unknown_from(call.machine, "has", "bool", value) if text is None else Const(bool(text))

    return lift(one, read(call.machine, call.args[0]))
