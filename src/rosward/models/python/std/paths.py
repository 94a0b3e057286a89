# SPDX-License-Identifier: Apache-2.0
"""`os.path`, and the text behind `pathlib`, on texts of which a part may be unknown.

os.path.join(share, 'config', 'a.yaml')         Text(hole, '/config/a.yaml')
os.path.basename(Text(hole, '/config/a.yaml'))  Const('a.yaml')
os.path.join('/robot', unknown)                 Text('/robot/', hole) or, since it may be absolute, unknown
"""

from __future__ import annotations

import posixpath
import re
from collections.abc import Callable, Iterable
from functools import reduce
from typing import Final

from rosward.domain.choice import join, join_all, lift, lift2, options
from rosward.domain.compound import Tuple
from rosward.domain.text import concat, make, origins_of, parts_of
from rosward.domain.unknown import Cause, derived
from rosward.domain.values import EMPTY, NONE, Const, Hole, Text, Unknown, Value
from rosward.models.native import NativeCall, NativeFunction
from rosward.models.python.contents import text_data
from rosward.models.python.plain import text_of
from rosward.models.python.std.support import is_since, joined_elements, unknown_from
from rosward.ros.distro import Distro

_SLASH: Final = Const("/")


def _is_text(value: Value) -> bool:
    return isinstance(value, Text) or text_of(value) is not None or (isinstance(value, Unknown) and value.hint == "str")


def as_text(call: NativeCall, value: Value) -> Value:
    """The text of a str or of an object with `__fspath__`."""

    def one(option: Value) -> Value:
        option = text_data(call.machine, option)
        if _is_text(option):
            return option
        if isinstance(option, Unknown):
            return Unknown(option.reasons, "str")
        if isinstance(option, Const):
            if isinstance(option.value, bytes):
                return unknown_from(call, "str", (option,))
            return call.machine.die(
                "TypeError", f"expected str, bytes or os.PathLike object, not {type(option.value).__name__}"
            )
        found = call.machine.call(call.machine.load_attr(option, "__fspath__"), ())
        return lift(lambda f: f if _is_text(f) else unknown_from(call, "str", (f,)), found)

    return lift(one, value)


def join_two(left: Value, right: Value) -> Value:
    """posixpath.join of two texts; a second one of unknown beginning may be absolute, and replace the first."""
    parts = parts_of(right)
    first = parts[0]
    if isinstance(first, str):
        if first.startswith("/"):
            return right
        return _below(left, right)
    below = _below(left, right)
    return below if first.shape or text_of(left) == "" else join(below, right)


def _below(left: Value, right: Value) -> Value:
    last = parts_of(left)[-1]
    if isinstance(last, str) and (last == "" or last.endswith("/")):
        return concat((left, right))
    return concat((left, _SLASH, right))


def split_last(value: Value) -> tuple[Value, Value]:
    """(head, tail) at the last slash, the head with its slash; where a hole may hold that slash, it is in both."""
    parts = parts_of(value)
    origins = origins_of(value)
    for index in range(len(parts) - 1, -1, -1):
        part = parts[index]
        if isinstance(part, str):
            if "/" in part:
                head, slash, tail = part.rpartition("/")
                return make((*parts[:index], head + slash), origins), make((tail, *parts[index + 1 :]), origins)
        elif not part.shape:
            return make(parts[: index + 1], origins), make(parts[index:], origins)
    return Const("", origins), value


def dirname(value: Value) -> Value:
    """posixpath.dirname."""
    plain = text_of(value)
    if plain is not None:
        return Const(posixpath.dirname(plain), origins_of(value))
    parts = parts_of(value)
    if len(parts) == 1 and isinstance(parts[0], Hole) and not parts[0].shape:
        return _above(parts[0])
    head = split_last(value)[0]
    parts = parts_of(head)
    last = parts[-1]
    if isinstance(last, str) and last.strip("/"):
        return make((*parts[:-1], last.rstrip("/")), origins_of(head))
    if last == "/" and len(parts) > 1:
        return make(parts[:-1], origins_of(head))
    return head


def _parents(value: Value) -> Value:
    """The folders above a path, the nearest first: the last is `/` or `.`; so many as anyone asks for, where a part of it is not known."""
    plain = text_of(value)
    found: list[Value] = []
    while len(found) < (_ABOVE if plain is None else len(plain)) and (above := normal(dirname(value))) != value:
        found.append(above)
        value = above
    return Tuple(tuple(found))


_ABOVE: Final = 6


def _above(folder: Hole) -> Value:
    """The folder above an unknown one: that of share/demo is share, in the install folder of the package; that of a module is one of the sources."""
    causes = {(reason.cause, reason.subject) for reason in folder.reasons}
    if len(causes) == 1 and folder.reasons[0].cause is Cause.BESIDE and folder.reasons[0].subject != ".":
        above = posixpath.dirname(folder.reasons[0].subject) or "."
        return Unknown(tuple(reason._replace(subject=above) for reason in folder.reasons), "str")
    if len(causes) == 1 and folder.reasons[0].cause is Cause.SHARE:
        prefix = tuple(reason._replace(cause=Cause.PREFIX) for reason in folder.reasons)
        return make((Hole(prefix), "/share"))
    return Unknown(derived(folder.reasons), "str")


def basename(value: Value) -> Value:
    """posixpath.basename."""
    tail = split_last(value)[1]
    return Unknown(derived(tail.reasons), "str") if isinstance(tail, Unknown) else tail


def splitext(value: Value) -> tuple[Value, Value]:
    """posixpath.splitext."""
    parts = parts_of(value)
    last, origins = parts[-1], origins_of(value)
    if isinstance(last, str):
        root, extension = posixpath.splitext(last if len(parts) == 1 else "x" + last)
        if extension or len(parts) == 1 or "/" in last:
            return make((*parts[:-1], root if len(parts) == 1 else root[1:]), origins), Const(extension, origins)
    hole = next(p for p in reversed(parts) if isinstance(p, Hole))
    reasons = derived(hole.reasons)
    return make((*(p for p in parts[:1] if isinstance(p, str)), Hole(reasons)), origins), Unknown(reasons, "str")


_SLASHES: Final = re.compile("/{2,}")


def _root(text: str) -> str:
    """What an absolute path begins with: two slashes are kept, more are one."""
    return "//" if text.startswith("//") and not text.startswith("///") else text[: text.startswith("/")]


def normal(value: Value) -> Value:
    """The text of `pathlib.PurePath`: no double slashes but two in front, no `.` components, no slash at the end."""
    plain = text_of(value)
    if plain is None:
        parts = parts_of(value)
        first, last = parts[0], parts[-1]
        kept = (*parts[:-1], last.rstrip("/") if isinstance(last, str) else last)
        root = _root(first)[1:] if isinstance(first, str) else ""
        single = [_SLASHES.sub("/", p) if isinstance(p, str) else p for p in kept]
        return make((root, *single), origins_of(value))
    root = _root(plain)
    text = root + "/".join(p for p in plain.split("/") if p not in ("", "."))
    return Const(text or ".", origins_of(value))


def _first(call: NativeCall, names: Iterable[str] = ("path", "p", "s", "filename")) -> Value | None:
    if call.args:
        return as_text(call, call.args[0])
    found = next((call.keywords[n] for n in names if n in call.keywords), None)
    return None if found is None else as_text(call, found)


def _on_text(function: Callable[[Value], Value]) -> NativeFunction:
    def apply(call: NativeCall) -> Value:
        value = _first(call)
        return call.machine.unknown(Cause.CALL, call.name, "str") if value is None else lift(function, value)

    return apply


def _join(call: NativeCall) -> Value:
    """os.path.join."""
    if not call.args:
        return call.machine.unknown(Cause.CALL, call.name, "str")
    result = as_text(call, call.args[0])
    for value in call.args[1:]:
        result = lift2(join_two, result, as_text(call, value))
    return result


def _join_parts(call: NativeCall) -> Value:
    """pathlib._join(parts): the text of a path made of several; the current directory where there are none."""
    parts = call.args[0]
    known = call.machine.iterate(parts)
    if known.rest is not None:
        return unknown_from(call, "str", (parts, known.rest))
    result: Value = EMPTY
    for value in known.known:
        result = lift2(join_two, result, as_text(call, lift(lambda part: _as_part(call, part), value)))
    return lift(normal, result)


def _as_part(call: NativeCall, part: Value) -> Value:
    """Up to Python 3.11, of humble and iron, what is derived from str is in a path as `str` writes it: `Side.LEFT` of a `(str, Enum)`."""
    text = text_data(call.machine, part)
    if text is part or not _is_text(text) or (since := is_since(call.machine, Distro.JAZZY)):
        return part
    shown = call.machine.call_native("builtins.str", (part,))
    return shown if since is False else join(text, shown)


def _absolute(call: NativeCall) -> Value:
    def one(value: Value) -> Value:
        first = parts_of(value)[0]
        if isinstance(first, Hole):
            return value
        plain = text_of(value)
        if first.startswith("/"):
            return value if plain is None else Const(posixpath.normpath(plain), origins_of(value))
        below = value if plain is None else Const(posixpath.normpath(plain) if plain else ".", origins_of(value))
        directory = call.machine.unknown(Cause.LIVE, "current directory", "str")
        return directory if text_of(below) == "." else concat((directory, _SLASH, below))

    value = _first(call)
    return call.machine.unknown(Cause.CALL, call.name, "str") if value is None else lift(one, value)


def _normpath(value: Value) -> Value:
    plain = text_of(value)
    return normal(value) if plain is None else Const(posixpath.normpath(plain), origins_of(value))


def _expanduser(call: NativeCall) -> Value:
    def one(value: Value) -> Value:
        parts = parts_of(value)
        first = parts[0]
        if not (isinstance(first, str) and first.startswith("~")):
            return value
        home = call.machine.unknown(Cause.ENVIRONMENT, "HOME", "str")
        slash = first.find("/")
        return home if slash < 0 else concat((home, make((first[slash:], *parts[1:]), origins_of(value))))

    value = _first(call)
    return call.machine.unknown(Cause.CALL, call.name, "str") if value is None else lift(one, value)


_VARIABLE: Final = re.compile(r"\$(?:(\w+)|\{([^}]*)\})", re.ASCII)


def _expandvars(call: NativeCall) -> Value:
    machine = call.machine

    def variable(name: str, written: str) -> Value:
        found = machine.call(
            machine.load_attr(machine.load_attr(machine.load_module("os"), "environ"), "get"), (Const(name),)
        )
        return join_all(o for o in options(found) if o != NONE) if found != NONE else Const(written)

    def one(value: Value) -> Value:
        if not any(isinstance(p, str) and "$" in p for p in parts_of(value)):
            return value
        pieces: list[Value] = [Const("", origins_of(value))]
        for part in parts_of(value):
            if not isinstance(part, str):
                pieces.append(make((part,)))
                continue
            end = 0
            for found in _VARIABLE.finditer(part):
                pieces += [Const(part[end : found.start()]), variable(found[1] or found[2], found[0])]
                end = found.end()
            pieces.append(Const(part[end:]))
        return reduce(lambda left, right: lift2(lambda a, b: concat((a, b)), left, right), pieces)

    value = _first(call)
    return call.machine.unknown(Cause.CALL, call.name, "str") if value is None else lift(one, value)


def _pair(function: Callable[[Value], tuple[Value, Value]]) -> NativeFunction:
    def apply(call: NativeCall) -> Value:
        value = _first(call)
        if value is None:
            return call.machine.unknown(Cause.CALL, call.name, "tuple")
        return lift(lambda v: Tuple(function(v)), value)

    return apply


def _split(value: Value) -> tuple[Value, Value]:
    return dirname(value), basename(value)


def _isabs(call: NativeCall) -> Value:
    def one(value: Value) -> Value:
        first = parts_of(value)[0]
        return Const(first.startswith("/")) if isinstance(first, str) else unknown_from(call, "bool", (value,))

    value = _first(call)
    return call.machine.unknown(Cause.CALL, call.name, "bool") if value is None else lift(one, value)


def _file(hint: str) -> NativeFunction:
    def ask(call: NativeCall) -> Value:
        value = _first(call)
        return call.machine.unknown(Cause.FILE, (text_of(value) if value is not None else None) or "", hint)

    return ask


def _relpath(call: NativeCall) -> Value:
    values = [as_text(call, v) for v in call.args]
    plain = [text_of(v) for v in values]
    if len(plain) == 2 and all(p is not None and p.startswith("/") for p in plain):
        return Const(posixpath.relpath(str(plain[0]), str(plain[1])))
    return unknown_from(call, "str", values)


def _common(call: NativeCall) -> Value:
    return unknown_from(call, "str", (joined_elements(call, call.args[0]),) if call.args else ())


def _fspath(call: NativeCall) -> Value:
    return join_all(as_text(call, v) for v in call.args[:1])


NATIVES: Final[dict[str, NativeFunction]] = {
    "os.path.join": _join,
    "os.path.dirname": _on_text(dirname),
    "os.path.basename": _on_text(basename),
    "os.path.split": _pair(_split),
    "os.path.splitext": _pair(splitext),
    "os.path.normpath": _on_text(_normpath),
    "os.path.normcase": _on_text(lambda value: value),
    "os.path.abspath": _absolute,
    "os.path.realpath": _absolute,
    "os.path.expanduser": _expanduser,
    "os.path.expandvars": _expandvars,
    "os.path.relpath": _relpath,
    "os.path.commonpath": _common,
    "os.path.commonprefix": _common,
    "os.path.isabs": _isabs,
    **{f"os.path.{name}": _file("bool") for name in ("islink", "ismount", "samefile")},
    "os.path.getsize": _file("int"),
    **{f"os.path.{name}": _file("float") for name in ("getmtime", "getctime", "getatime")},
    "os.fspath": _fspath,
    "pathlib._join": _join_parts,
    "pathlib._dirname": _on_text(dirname),
    "pathlib._parents": _on_text(_parents),
    "pathlib._basename": _on_text(lambda value: EMPTY if text_of(value) == "." else basename(value)),
    "pathlib._splitext": _pair(splitext),
    "pathlib._absolute": _absolute,
    "pathlib._expanduser": _expanduser,
}
