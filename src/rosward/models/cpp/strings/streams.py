# SPDX-License-Identifier: Apache-2.0
"""What is in a stream?

std::ostringstream os; os << "axis" << 3; os.str()      'axis3'

A stream of a file, and the streams of the process, take what they are given; what they give is not known.
"""

from __future__ import annotations

from typing import Final

from rosward.domain.choice import join, join_all, options
from rosward.domain.compound import External, Partial
from rosward.domain.heap import Obj
from rosward.domain.series import Series
from rosward.domain.text import concat, make, parts_of
from rosward.domain.unknown import Cause
from rosward.domain.values import EMPTY, FALSE, NONE, TRUE, Const, Hole, Ref, Unknown, Value
from rosward.models.cpp.arity import with_least
from rosward.models.cpp.strings.formatting import Flags, shown
from rosward.models.cpp.values.characters import text_behind
from rosward.models.cpp.values.slots import read, read_field
from rosward.models.cpp.values.types import Shape, name_of, shape_of
from rosward.models.native import Machine, NativeCall, NativeFunction
from rosward.models.python.plain import from_python, int_of, text_of, unknown_from

__all__ = [
    "GOOD",
    "ITERATOR",
    "LEFT",
    "NATIVES",
    "OVER",
    "TEXT",
    "WRITTEN",
    "content",
    "held_in",
    "insert",
    "is_good",
    "is_input",
    "is_of_file",
    "is_output",
    "is_stream",
    "name_of_library",
    "put_in",
    "words_of",
]

TEXT: Final = "text"
LEFT: Final = "unread"
GOOD: Final = "good"
OVER: Final = "over"
WRITTEN: Final = "written"
_OUTPUTS: Final = frozenset(("std.cout", "std.cerr", "std.clog", "std.wcout"))
_MANIPULATORS: Final[dict[str, dict[str, Value]]] = {
    "hex": {"base": Const(16)},
    "oct": {"base": Const(8)},
    "dec": {"base": Const(10)},
    "fixed": {"floats": Const("fixed")},
    "scientific": {"floats": Const("scientific")},
    "defaultfloat": {"floats": EMPTY},
    "boolalpha": {"words": TRUE},
    "noboolalpha": {"words": FALSE},
    "left": {"left": TRUE},
    "right": {"left": FALSE},
    "internal": {"left": FALSE},
    "uppercase": {"upper": TRUE},
    "nouppercase": {"upper": FALSE},
    "showbase": {"show_base": TRUE},
    "noshowbase": {"show_base": FALSE},
}
_ENDS: Final = {"endl": "\n", "ends": "\0"}
_SETTERS: Final = {"setw": "width", "setfill": "fill", "setprecision": "precision", "setbase": "base"}


def is_output(machine: Machine, value: Value) -> bool:
    """Whether `value << x` puts x into a stream."""
    return any(is_stream(machine, option) or name_of_library(option) in _OUTPUTS for option in options(value))


def is_input(machine: Machine, value: Value) -> bool:
    """Whether `value >> x` takes something out of a stream."""
    return any(is_stream(machine, option) or name_of_library(option) == "std.cin" for option in options(value))


def name_of_library(value: Value) -> str:
    """The name of something of a library."""
    return value.name if isinstance(value, External) else ""


def is_stream(machine: Machine, value: Value) -> bool:
    """Whether a value is a stream that the program made."""
    return isinstance(value, Ref) and shape_of(machine.obj(value).cls) is Shape.STREAM


def is_of_file(machine: Machine, ref: Ref) -> bool:
    """Whether a stream is that of a file."""
    return "fstream" in name_of(machine.obj(ref).cls)


def is_good(machine: Machine, ref: Ref) -> bool | None:
    """Whether a stream has not failed yet."""
    return machine.truth(machine.obj(ref).attrs.get(GOOD, TRUE))


# Putting in


def insert(machine: Machine, stream: Value, value: Value) -> Value:
    """stream << value; gives the stream."""
    held = read(machine, stream)
    several = len(options(held)) > 1
    for option in options(held):
        if isinstance(option, Ref) and is_stream(machine, option):
            _insert(machine, option, text_behind(machine, read(machine, value)), weak=several)
    return held


def _insert(machine: Machine, ref: Ref, value: Value, *, weak: bool) -> None:
    changes = _manipulated(machine, value)
    if changes is None:
        flags = _flags(machine, ref)
        text = Const("\0") if value == NONE else shown(machine, value, flags)
        _append(machine, ref, text, weak=weak)
        changes = {"width": Const(0)} if flags.width else {}
    elif isinstance(value, External) and value.name.rpartition(".")[2] in _ENDS:
        _append(machine, ref, Const(_ENDS[value.name.rpartition(".")[2]]), weak=weak)
    for name, changed in changes.items():
        put_in(machine, ref, name, changed, weak=weak)


def _manipulated(machine: Machine, value: Value) -> dict[str, Value] | None:
    """What a manipulator changes in a stream; None for what is none."""
    if isinstance(value, External):
        name = value.name.removeprefix("std.").removeprefix("ios.").removeprefix("ios_base.")
        return _MANIPULATORS.get(name, {} if name in _ENDS or name in ("flush", "ws") else None)
    if isinstance(value, Partial) and isinstance(value.function, External):
        name = _SETTERS.get(value.function.name.removeprefix("std."), "")
        return {name: read(machine, value.arguments[0])} if name and value.arguments else None
    return None


def _flags(machine: Machine, ref: Ref) -> Flags:
    attrs = machine.obj(ref).attrs
    known = {}
    for name in Flags._fields:
        held = attrs.get(name)
        if isinstance(held, Const):
            known[name] = held.value
    return Flags(**known)  # type: ignore[arg-type]  # they are set by name, each of its type


def _append(machine: Machine, ref: Ref, text: Value, *, weak: bool = False) -> None:
    beneath = held_in(machine, ref, OVER)
    if isinstance(beneath, Unknown):  # nobody knows where it is written
        for name in (TEXT, LEFT):
            put_in(machine, ref, name, unknown_from(machine, "<<", "str", beneath, text))
        return
    over = text_of(beneath)
    if over:
        _write_over(machine, ref, over, text, weak=weak)
        return
    for name in (TEXT, LEFT):
        put_in(machine, ref, name, concat((held_in(machine, ref, name), text)), weak=weak)


def _write_over(machine: Machine, ref: Ref, over: str, text: Value, *, weak: bool) -> None:
    """A stream that was made of a text without `ate` is written from its beginning."""
    written = concat((held_in(machine, ref, WRITTEN), text))
    plain = text_of(written)
    result = (
        unknown_from(machine, "<<", "str", written)
        if plain is None
        else from_python(machine, plain + over[len(plain) :])
    )
    put_in(machine, ref, WRITTEN, written, weak=weak)
    nothing_read = held_in(machine, ref, LEFT) == held_in(machine, ref, TEXT)
    left = result if nothing_read else unknown_from(machine, "<<", "str", result)
    for name, value in ((TEXT, result), (LEFT, left)):
        put_in(machine, ref, name, value, weak=weak)


def held_in(machine: Machine, ref: Ref, name: str) -> Value:
    """A text that a stream holds."""
    return machine.obj(ref).attrs.get(name, EMPTY)


def put_in(machine: Machine, ref: Ref, name: str, value: Value, *, weak: bool = False) -> None:
    """Something of a stream becomes another; `weak` where that may not happen."""
    obj = machine.obj(ref)
    old = obj.attrs.get(name)
    machine.update(ref, obj.with_attr(name, join(old, value) if weak and old is not None else value))


def _new(call: NativeCall) -> Value:
    """A stream of a type: of a text, or of a file."""
    machine, type_ = call.machine, call.args[0]
    first = text_behind(machine, read(machine, call.args[1])) if len(call.args) > 1 else EMPTY
    obj = Obj("instance", External(name_of(type_)), {TEXT: EMPTY, LEFT: EMPTY})
    made = machine.allocate(obj, name_of(type_))
    if is_of_file(machine, made):
        put_in(machine, made, "path", first)
        put_in(machine, made, GOOD, machine.unknown(Cause.FILE, text_of(first) or "", "bool"))
    else:
        text = make(parts_of(first)) if not isinstance(first, External) else EMPTY
        put_in(machine, made, LEFT, text)
        put_in(machine, made, TEXT, text)
        appends = any(name_of_library(read(machine, a)).endswith(".ate") for a in call.args[2:])
        if not appends:
            put_in(machine, made, OVER, text)
    return made


def _str(call: NativeCall) -> Value:
    """stream.str(), stream.str(text)."""
    machine = call.machine
    found: list[Value] = []
    for option in options(read(machine, call.args[0])):
        if not isinstance(option, Ref):
            found.append(unknown_from(machine, "str", "str", option))
        elif len(call.args) > 1:
            text = read(machine, call.args[1])
            for name in (TEXT, LEFT, OVER):
                put_in(machine, option, name, text)
            put_in(machine, option, WRITTEN, EMPTY)
            found.append(NONE)
        else:
            found.append(read_field(machine, option, TEXT))
    return join_all(found)


def _clear(call: NativeCall) -> Value:
    held = read(call.machine, call.args[0])
    if isinstance(held, Ref) and not is_of_file(call.machine, held):
        put_in(call.machine, held, GOOD, TRUE)
    return NONE


def _state(call: NativeCall) -> Value:
    """good(), fail(), eof(), is_open(): whether it has failed, as far as that is known."""
    machine, name = call.machine, call.name.rpartition(".")[2]
    held = read(machine, call.args[0])
    if not isinstance(held, Ref) or is_of_file(machine, held):
        return machine.unknown(Cause.FILE, call.name, "bool")
    good = is_good(machine, held)
    if name == "eof":
        left = held_in(machine, held, LEFT)
        return Const(left == EMPTY) if isinstance(left, Const) else unknown_from(machine, name, "bool", left)
    if good is None:
        return unknown_from(machine, name, "bool", held)
    return Const(good if name in ("good", "is_open") else not good)


def _put(call: NativeCall) -> Value:
    """put, write: what is written goes into the stream."""
    machine = call.machine
    held = read(machine, call.args[0])
    value = read(machine, call.args[1])
    count = int_of(read(machine, call.args[2])) if len(call.args) > 2 else None
    text = text_of(value)
    if count is not None and text is not None:
        value = Const(text[:count])
    if isinstance(held, Ref) and is_stream(machine, held):
        _append(
            machine,
            held,
            value if text is not None else make((Hole(unknown_from(machine, "write", "str", value).reasons),)),
        )
    return held


def _setting(call: NativeCall) -> Value:
    """width(n), fill(c), precision(n)."""
    held = read(call.machine, call.args[0])
    name = call.name.rpartition(".")[2]
    if isinstance(held, Ref) and len(call.args) > 1:
        put_in(call.machine, held, name, read(call.machine, call.args[1]))
    return call.machine.unknown(Cause.OPERATION, name, "int")


def _flag(call: NativeCall) -> Value:
    """setf(std::ios::fixed)."""
    held = read(call.machine, call.args[0])
    for value in call.args[1:2]:
        changes = _manipulated(call.machine, read(call.machine, value))
        if isinstance(held, Ref):
            for name, changed in (changes or {}).items():
                put_in(call.machine, held, name, changed)
    return NONE


def _manipulator(call: NativeCall) -> Value:
    """std::setw(n) and the like: what to do with the stream that it is put into."""
    return Partial(External(call.name), tuple(read(call.machine, a) for a in call.args[:1]), ())


def _quoted(call: NativeCall) -> Value:
    """std::quoted(text)."""
    text = read(call.machine, call.args[0])
    plain = text_of(text)
    escaped = text if plain is None else Const(plain.replace("\\", "\\\\").replace('"', '\\"'))
    return concat((Const('"'), escaped, Const('"')))


def content(machine: Machine, stream: Value) -> Value:
    """All that is still to be read from a stream."""
    held = read(machine, stream)
    if not isinstance(held, Ref) or not is_stream(machine, held):
        return unknown_from(machine, "stream", "str", held)
    if is_of_file(machine, held):
        return machine.unknown(Cause.FILE, text_of(held_in(machine, held, "path")) or "", "str")
    return held_in(machine, held, LEFT)


def _content(call: NativeCall) -> Value:
    """What comes from a stream by its buffer."""
    return content(call.machine, call.args[0])


def _rest(call: NativeCall) -> Value:
    """std::istreambuf_iterator<char>(stream): what a string is made of."""
    return Partial(External(ITERATOR), tuple(read(call.machine, arg) for arg in call.args[1:2]), ())


def words_of(machine: Machine, first: Value, text: bool) -> Series | None:
    """What iterators of a stream give (`std::istream_iterator<T>(stream)`), `text`: which are texts; None for what is none of these."""
    if not isinstance(first, Partial) or first.function != External(ITERATOR):
        return None
    stream = first.arguments[0] if first.arguments else NONE
    left = held_in(machine, stream, LEFT) if isinstance(stream, Ref) and is_stream(machine, stream) else NONE
    words = text_of(left) if text and isinstance(stream, Ref) and not is_of_file(machine, stream) else None
    if isinstance(stream, Ref) and is_stream(machine, stream):
        put_in(machine, stream, LEFT, EMPTY if words is not None else unknown_from(machine, ">>", "str", left))
    if words is None:
        return Series((), unknown_from(machine, ">>", "str" if text else "", left))
    return Series(tuple(from_python(machine, word) for word in words.split()))


def _asked(call: NativeCall) -> Value:
    return call.machine.unknown(Cause.INPUT, call.name)


ITERATOR: Final = "std.istreambuf_iterator"
_OF_PROCESS: Final = ("cout", "cerr", "clog", "cin")
_SILENT: Final = (
    "flush", "precision", "clear", "ignore", "rdbuf", "tie", "width", "fill", "setf", "unsetf", "put", "write", "sync_with_stdio",
)  # fmt: skip


def _ignored(call: NativeCall) -> Value:
    return read(call.machine, call.args[0])


_METHODS: Final[dict[str, NativeFunction]] = {
    "str": _str,
    "view": _str,
    "clear": _clear,
    **dict.fromkeys(("good", "fail", "bad", "eof", "is_open"), _state),
    **dict.fromkeys(("put", "write"), _put),
    **dict.fromkeys(("width", "fill", "precision"), _setting),
    "setf": _flag,
    "unsetf": _ignored,
    "rdbuf": _content,
    **dict.fromkeys(("flush", "close", "open", "exceptions", "imbue", "sync"), _ignored),
}

NATIVES: Final[dict[str, NativeFunction]] = {
    **{
        f"std.stringstream.{name}": function
        for name, function in with_least(_METHODS, 1, {"put": 2, "write": 2}).items()
    },
    **{
        f"std.{name}.new": _new
        for name in ("stringstream", "ostringstream", "istringstream", "ifstream", "ofstream", "fstream")
    },
    **{f"std.{name}": _manipulator for name in _SETTERS},
    "std.quoted": _quoted,
    **{f"std.{stream}.{name}": _ignored for stream in _OF_PROCESS for name in _SILENT},
    **{
        f"std.{stream}.{name}": _asked
        for stream in _OF_PROCESS
        for name in ("good", "fail", "bad", "eof", "get", "peek")
    },
    "std.istreambuf_iterator.new": _rest,
    "std.istream_iterator.new": _rest,
}
