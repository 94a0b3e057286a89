# SPDX-License-Identifier: Apache-2.0
"""How a value becomes text: `str()`, `repr()`, f-strings, `str.format`.

    f'robot_{i:02d}'            Text('robot_', digits) for an unknown i
    '{}/{name}'.format(ns, name='x')

A piece of text may be an unknown int: `text.concat` makes a hole of digits of it.
"""

from __future__ import annotations

import re
import string
from collections.abc import Callable
from typing import Final, final

from rosward.domain.choice import lift
from rosward.domain.compound import Range, Tuple
from rosward.domain.text import concat, make, parts_of
from rosward.domain.unknown import Cause
from rosward.domain.values import EMPTY, UNBOUND, Class, Const, Hole, Ref, Text, Unknown, Value
from rosward.models.native import Machine, NativeCall, NativeFunction
from rosward.models.python import exceptions
from rosward.models.python.contents import contents
from rosward.models.python.exceptions import is_exception_object
from rosward.models.python.plain import (
    Raised,
    from_python,
    int_of,
    native,
    operation,
    origins,
    run,
    spread,
    text_of,
    unknown_from,
    with_origins,
)
from rosward.models.python.strings import text_parts
from rosward.models.python.strings.text_choices import bounded

MAX_DEPTH: Final = 4
_WIDE: Final = re.compile(r"\d{5}")
_ZERO_PADDED: Final = re.compile(r"(0\d+)?d?")
_PADDED: Final = re.compile(r"(?:.?[<>=^])?\d*s?", re.DOTALL)
_FIRST: Final = re.compile(r"[^.\[]*")
_ACCESS: Final = re.compile(r"\.([^.\[]+)|\[([^\]]+)\]")


def joined(machine: Machine, pieces: list[Value]) -> Value:
    """The concatenation of pieces, for each combination of their alternatives, where these are few."""

    def one(*values: Value) -> Value:
        text = concat(values)
        return from_python(machine, text.value, text.origins, "text") if isinstance(text, Const) else text

    return spread(one, *bounded(machine, pieces))


def too_wide(spec: str) -> bool:
    """Whether a format spec asks for a text longer than we keep."""
    return _WIDE.search(spec) is not None


# str and repr


def piece(machine: Machine, value: Value) -> Value:
    """str(value), as a piece of text."""
    return spread(lambda v: _piece(machine, v), value)


def _piece(machine: Machine, value: Value) -> Value:
    if isinstance(value, Const):
        return (
            value if isinstance(value.value, str) else from_python(machine, run(str, value.value), value.origins, "str")
        )
    if isinstance(value, Text):
        return value
    if isinstance(value, Unknown):
        return value if value.hint in ("str", "int") else Unknown(value.reasons, "str")
    if isinstance(value, Ref) and machine.obj(value).kind == "instance":
        if is_exception_object(machine, value) and not defines(machine, value, "__str__"):
            return exceptions.message(machine, value)
        return _by_method(machine, value, ("__str__", "__repr__"))
    return represent(machine, value)


def _by_method(machine: Machine, value: Ref, names: tuple[str, ...], *args: Value) -> Value:
    """What the first of some special methods says; else what the builtin type of the class does."""
    held = contents(machine, value)
    if held is not None and not any(defines(machine, value, name) for name in names):
        return piece(machine, held) if names[0] == "__str__" else represent(machine, held)
    for name in names:
        if defines(machine, value, name):
            text = machine.call(machine.load_attr(value, name), args)
            return (
                text
                if text is UNBOUND or text_of(text) is not None
                else spread(lambda t: make(parts_of(t), origins(t)), text)
            )
    cls = machine.obj(value).cls
    return machine.unknown(
        Cause.OPERATION, f"text of {cls.name}" if isinstance(cls, Class) else "text of an object", "str"
    )


def defines(machine: Machine, value: Ref, name: str) -> bool:
    """Whether a class that is known has a special method of that name."""
    cls = machine.obj(value).cls
    bases = cls.mro if isinstance(cls, Class) else ()
    return any(name in machine.obj(Ref(b.address)).attrs for b in bases if isinstance(b, Class))


def represent(machine: Machine, value: Value, depth: int = MAX_DEPTH) -> Value:
    """repr(value)."""
    return spread(lambda v: _represent(machine, v, depth), value)


def _represent(machine: Machine, value: Value, depth: int) -> Value:
    if isinstance(value, Const):
        return from_python(machine, run(repr, value.value), value.origins, "repr")
    if isinstance(value, Unknown) and value.hint == "int":
        return value
    if isinstance(value, Range):
        ends: tuple[Value, ...] = value.fields() if int_of(value.step) != 1 else (value.start, value.stop)
        return joined(machine, [Const("range("), *_separated([piece(machine, e) for e in ends]), Const(")")])
    if depth and isinstance(value, Tuple):
        end = ",)" if len(value.items) == 1 else ")"
        return joined(
            machine, [Const("("), *_separated([represent(machine, v, depth - 1) for v in value.items]), Const(end)]
        )
    if depth and isinstance(value, Ref):
        return _object(machine, value, depth - 1)
    return unknown_from(machine, "repr", "str", value)


def _object(machine: Machine, value: Ref, depth: int) -> Value:
    obj = machine.obj(value)
    if obj.kind == "instance":
        if is_exception_object(machine, value) and not defines(machine, value, "__repr__"):
            return exceptions.described(machine, value)
        return _by_method(machine, value, ("__repr__",))
    if obj.kind == "list" and obj.items is not None and not obj.many:
        pieces = [represent(machine, v, depth) for v in obj.items]
        return joined(machine, [Const("["), *_separated(pieces), Const("]")])
    if obj.kind == "dict" and obj.rest is None and not obj.maybe and not obj.many:
        pieces = [
            joined(machine, [represent(machine, k, depth), Const(": "), represent(machine, v, depth)])
            for k, v in obj.entries.items()
        ]
        return joined(machine, [Const("{"), *_separated(pieces), Const("}")])
    return unknown_from(machine, "repr", "str", *(obj.items or ()), *obj.entries.values(), obj.rest)


def _separated(pieces: list[Value]) -> list[Value]:
    return [p for piece in pieces for p in (Const(", "), piece)][1:]


# Formats


def formatted(machine: Machine, value: Value, conversion: str, spec: Value) -> Value:
    """One field of an f-string or of `str.format`, as a piece of text."""
    if conversion == "s":
        value = piece(machine, value)
    elif conversion == "r":
        value = represent(machine, value)
    elif conversion == "a":
        value = spread(lambda v: _ascii(machine, v), represent(machine, value))
    elif conversion:
        raise Raised("ValueError", f"Unknown conversion specifier {conversion!r}")
    return spread(lambda v, s: _formatted(machine, v, s), value, spec)


def _ascii(machine: Machine, value: Value) -> Value:
    text = text_of(value)
    if text is None:
        return unknown_from(machine, "ascii", "str", value)
    return Const(text.encode("ascii", "backslashreplace").decode(), origins(value))


def _formatted(machine: Machine, value: Value, spec: Value) -> Value:
    known = text_of(spec)
    if known is None or too_wide(known):
        return with_origins(unknown_from(machine, "format", "str", value, spec), origins(spec))
    if isinstance(value, Const):
        return from_python(machine, run(format, value.value, known), origins(value, spec), "format")
    if isinstance(value, Text):
        return with_origins(_padded(value, known), origins(spec))
    if isinstance(value, Unknown):
        return _unknown_piece(value, known)
    if isinstance(value, Ref) and defines(machine, value, "__format__"):
        return _by_method(machine, value, ("__format__",), spec)
    held = contents(machine, value) if isinstance(value, Ref) and known else None
    if held is not None:
        return spread(lambda one: _formatted(machine, one, spec), held)
    return _piece(machine, value) if not known else unknown_from(machine, "format", "str", value)


def _padded(value: Text, spec: str) -> Value:
    if spec in ("", "s"):
        return value
    fill = text_parts.anything(value.parts)
    return make((fill, *value.parts, fill) if _PADDED.fullmatch(spec) else (fill,), value.origins)


def _unknown_piece(value: Unknown, spec: str) -> Unknown:
    """An unknown number with a plain spec is some digits."""
    whole = value.hint == "int" or spec.endswith("d")
    return Unknown(value.reasons, "int" if whole and _ZERO_PADDED.fullmatch(spec) else "str")


@operation
def format_value(machine: Machine, value: Value, conversion: str = "", spec: Value | None = None) -> Value:
    """One field of an f-string: a piece to concatenate (an unknown int stands for digits)."""
    return formatted(machine, value, conversion, EMPTY if spec is None else spec)


def to_str(machine: Machine, value: Value) -> Value:
    """str(value)."""
    return spread(lambda v: make(parts_of(v), origins(v)), piece(machine, value))


# str.format


@final
class _Fields:
    """The arguments of one `str.format`, and which of them comes next."""

    __slots__ = ("args", "following", "lookup", "machine")

    def __init__(self, machine: Machine, args: tuple[Value, ...], lookup: Callable[[str], Value]) -> None:
        self.machine = machine
        self.args = args
        self.lookup = lookup
        self.following = 0

    def fill(self, template: str, depth: int = 2) -> list[Value]:
        """The pieces of a template."""
        if depth == 0:
            raise Raised("ValueError", "Max string recursion exceeded")
        pieces: list[Value] = []
        fields: list[tuple[str, str | None, str | None, str | None]] = run(list, string.Formatter().parse(template))
        for literal, field, spec, conversion in fields:
            pieces.append(Const(literal))
            if field is not None:
                value = self._value(field)
                wanted = joined(self.machine, self.fill(spec, depth - 1)) if spec else EMPTY
                pieces.append(formatted(self.machine, value, conversion or "", wanted))
        return pieces

    def _value(self, field: str) -> Value:
        name = _FIRST.match(field)
        first = name.group() if name else ""
        value = self._first(first)
        at = len(first)
        while at < len(field):
            access = _ACCESS.match(field, at)
            if access is None:
                raise Raised("ValueError", "Empty attribute in format string")
            attribute, item = access.groups()
            if attribute is not None:
                value = self.machine.load_attr(value, attribute)
            else:
                value = self.machine.load_item(value, Const(int(item) if item.isdecimal() else item))
            at = access.end()
        return value

    def _first(self, name: str) -> Value:
        if name and not name.isdecimal():
            return self.lookup(name)
        if name and self.following > 0:
            raise Raised("ValueError", "cannot switch from automatic field numbering to manual field specification")
        if not name and self.following < 0:
            raise Raised("ValueError", "cannot switch from manual field specification to automatic field numbering")
        number = int(name) if name else self.following
        self.following = -1 if name else self.following + 1
        if number >= len(self.args):
            raise Raised("IndexError", f"Replacement index {number} out of range for positional args tuple")
        return self.args[number]


def _fill(machine: Machine, template: Value, args: tuple[Value, ...], lookup: Callable[[str], Value]) -> Value:
    text = text_of(template)
    if text is not None:
        filled = joined(machine, _Fields(machine, args, lookup).fill(text))
        return filled if filled is UNBOUND else with_origins(lift(_whole, filled), origins(template))
    reasons = unknown_from(machine, "str.format", "str", template).reasons
    first = parts_of(template)[0]
    known = re.split(r"[{}]", first, maxsplit=1)[0] if isinstance(first, str) else ""
    return make((known, Hole(reasons)), origins(template))


def _whole(value: Value) -> Value:
    return make(parts_of(value), origins(value))


def _format(call: NativeCall) -> Value:
    """template.format(*args, **keywords)."""

    def lookup(name: str) -> Value:
        if name not in call.keywords:
            raise Raised("KeyError", repr(name))
        return call.keywords[name]

    return spread(lambda t: _fill(call.machine, t, call.args[1:], lookup), call.args[0])


def _format_map(call: NativeCall) -> Value:
    """template.format_map(mapping)."""
    mapping = call.args[1]
    return spread(
        lambda t: _fill(call.machine, t, (), lambda n: call.machine.load_item(mapping, Const(n))), call.args[0]
    )


FORMAT_NATIVES: Final[dict[str, NativeFunction]] = {
    "str.format": native(_format, 1),
    "str.format_map": native(_format_map, 2),
}
