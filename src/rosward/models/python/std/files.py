# SPDX-License-Identifier: Apache-2.0
"""Files of the analysed packages, read as data: whether they are there, what is in them, what is in a folder.

with open(os.path.join(get_package_share_directory('demo'), 'topics.txt')) as f:
    topic = f.read()                     the text, if a package of that name is among the sources and has the file
open('/etc/robot.yaml').read()           unknown because of "content of a file: /etc/robot.yaml"
"""

from __future__ import annotations

import fnmatch
from typing import Final

from rosward.domain.choice import lift, options
from rosward.domain.compound import Tuple
from rosward.domain.text import concat, make, origins_of, parts_of, readable
from rosward.domain.unknown import Cause
from rosward.domain.values import EMPTY, FALSE, NONE, TRUE, Const, Unknown, Value
from rosward.models.file_paths import is_beside, location_of
from rosward.models.native import NativeCall, NativeFunction
from rosward.models.python.plain import FILE_HINT, text_of
from rosward.models.python.std.paths import as_text

_READING: Final = frozenset({"r", "rt", "tr", "rb", "br"})
_WRITING: Final = frozenset({"w", "wt", "tw", "w+", "w+t", "wb", "bw", "w+b", "wb+"})
"""How `open` begins a file anew."""
_MAGIC: Final = frozenset("*?[")


def _path(call: NativeCall, name: str) -> Value:
    """The argument that is a path, as text; a file descriptor is unknown."""
    value = call.arg(0, name, EMPTY) or EMPTY
    known = [o for o in options(value) if not (isinstance(o, Const) and not isinstance(o.value, str))]
    return as_text(call, value) if len(known) == len(options(value)) else call.machine.unknown(Cause.FILE, "", "str")


def _text(call: NativeCall, path: Value) -> Const | None:
    """The text of the file at a path, if it is one of the sources."""
    launch = call.machine.log.launch
    written = launch.written(path) if launch is not None else None
    if written is not None:
        known = isinstance(written, Const) and isinstance(written.value, str) and written.value
        return (
            Const(written.value, written.origins | origins_of(path)) if isinstance(written, Const) and known else None
        )
    where = location_of(path)
    text = call.machine.files.read(*where) if where is not None else None
    return None if text is None else Const(text, origins_of(path))


def _open(call: NativeCall) -> Value:
    """A file: of one that is not among the sources, or not read as text, whatever is read is unknown because of its content."""
    mode = text_of(call.arg(1, "mode", Const("r")))
    paths = _path(call, "file")
    one_of = call.machine.log.launch is not None and mode not in _READING and len(options(paths)) > 1
    if one_of:  # nobody knows into which of them
        unknown = call.machine.unknown(Cause.FILE, readable(paths), "str")
        call.machine.call_native("_rosward.launch.write_file", (paths, unknown))
        return call.machine.unknown(Cause.FILE, readable(paths), FILE_HINT)

    def one(path: Value) -> Value:
        text = _text(call, path) if mode in _READING else None
        opened = call.machine.load_module("_opened")
        if (
            call.machine.log.launch is not None
            and mode not in _READING
            and (isinstance(path, Const) or location_of(path))
        ):
            if mode in _WRITING:
                return call.machine.call(call.machine.load_attr(opened, "WrittenFile"), (path,))
            unknown = call.machine.unknown(Cause.FILE, readable(path), "str")
            call.machine.call_native("_rosward.launch.write_file", (path, unknown))
        if text is None:
            return call.machine.unknown(Cause.FILE, readable(path), FILE_HINT)
        if mode is not None and "b" in mode:
            data = Const(str(text.value).encode("utf-8", "surrogateescape"), text.origins)
            return call.machine.call(call.machine.load_attr(opened, "BinaryFile"), (data, path))
        return call.machine.call(call.machine.load_attr(opened, "TextFile"), (text, path))

    return lift(one, paths)


def _read_text(call: NativeCall) -> Value:
    """pathlib._read_text(path)."""
    return lift(lambda p: _text(call, p) or call.machine.unknown(Cause.FILE, readable(p), "str"), _path(call, "path"))


def _is_there(*, files: bool, folders: bool) -> NativeFunction:
    """Surely so, or not known: what the sources do not have may be made when it is built, or when it runs."""

    def ask(call: NativeCall) -> Value:
        def one(path: Value) -> Value:
            where = location_of(path)
            if where is not None and not is_beside(path):  # beside a module lies only what the build puts there
                if files and call.machine.files.is_file(*where):
                    return TRUE
                if folders and call.machine.files.is_folder(*where):
                    return TRUE
            return call.machine.unknown(Cause.FILE, text_of(path) or "", "bool")

        return lift(one, _path(call, next(iter(call.keywords), "path")))

    return ask


def _names(call: NativeCall, path: Value) -> tuple[str, ...] | None:
    where = location_of(path)
    return call.machine.files.listing(*where) if where is not None else None


def _listdir(call: NativeCall) -> Value:
    """The names in a folder of the sources; their order is that of the file system, and any one will do."""

    def one(path: Value) -> Value:
        names = _names(call, path)
        if names is None:
            return _perhaps(call, path, [Const(name) for name in _beside(call, path)])
        return call.machine.new_list([Const(name) for name in names])

    return lift(one, _path(call, "path"))


def _glob(call: NativeCall) -> Value:
    """The paths that fit a pattern whose last part alone has wildcards."""
    return lift(lambda path: _fitting(call, path, hidden=False), _path(call, "pathname"))


def _path_glob(call: NativeCall) -> Value:
    """pathlib._glob(path): the same, where wildcards stand for a dot, too."""
    return lift(lambda path: _fitting(call, path, hidden=True), _path(call, "path"))


def _fitting(call: NativeCall, path: Value, *, hidden: bool) -> Value:
    parts = parts_of(path)
    last = parts[-1]
    head, slash, wanted = last.rpartition("/") if isinstance(last, str) else ("", "", "")
    if not slash or not _MAGIC.isdisjoint(head) or wanted == "**" or len(parts) != 2 or call.keywords:
        return _unknown_list(call, path)
    folder = make((*parts[:-1], head), origins_of(path))
    names = _names(call, folder)
    fitting = [
        concat((folder, Const(f"/{name}")))
        for name in (_beside(call, folder) if names is None else names)
        if fnmatch.fnmatchcase(name, wanted) and (hidden or wanted[:1] == "." or name[:1] != ".")
    ]
    return _perhaps(call, path, fitting) if names is None else call.machine.new_list(fitting)


def _modules(call: NativeCall) -> Value:
    """pkgutil._modules(folder, prefix): pairs of the name of a module and whether it is a package; None where the folder is not known."""
    files = call.machine.files

    def one(path: Value) -> Value:
        where = location_of(path)
        if where is None or where.package:
            return NONE
        names = files.modules(where.relative)
        found: list[Value] = []
        for name in names:
            inside = f"{where.relative}/{name}" if where.relative else name
            if not name.endswith(".py") and "__init__.py" in files.modules(inside):
                found.append(Tuple((Const(name), TRUE)))
            elif name.endswith(".py") and name != "__init__.py":
                found.append(Tuple((Const(name.removesuffix(".py")), FALSE)))
        return Tuple(tuple(found)) if names else NONE

    return lift(one, call.args[0])


def _beside(call: NativeCall, path: Value) -> tuple[str, ...]:
    """What lies in Python in a folder of the sources; the build, or whoever installs it, may put more there."""
    where = location_of(path)
    return call.machine.files.modules(where.relative) if where is not None and not where.package else ()


def _unknown_list(call: NativeCall, path: Value) -> Value:
    return _perhaps(call, path, [])


def _perhaps(call: NativeCall, path: Value, known: list[Value]) -> Value:
    """What is known to be there, and anything else."""
    subject = text_of(path) or (call.name if isinstance(path, Unknown) else readable(path))
    return call.machine.new_list(known, call.machine.unknown(Cause.FILE, subject, "str"))


NATIVES: Final[dict[str, NativeFunction]] = {
    "builtins.open": _open,
    "io.open": _open,
    "pathlib._read_text": _read_text,
    "os.path.exists": _is_there(files=True, folders=True),
    "os.path.lexists": _is_there(files=True, folders=True),
    "os.path.isfile": _is_there(files=True, folders=False),
    "os.path.isdir": _is_there(files=False, folders=True),
    "os.listdir": _listdir,
    "pkgutil._modules": _modules,
    "pathlib._glob": _path_glob,
    "glob.glob": _glob,
    "glob.iglob": _glob,
}
