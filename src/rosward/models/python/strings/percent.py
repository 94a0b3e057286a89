# SPDX-License-Identifier: Apache-2.0
"""The `%` operator of texts.

'robot_%02d/%s' % (i, 'cmd')        Text('robot_', digits, '/cmd') for an unknown i
"""

from __future__ import annotations

import operator
import re
from typing import Final

from rosward.domain.choice import lift
from rosward.domain.compound import Tuple
from rosward.domain.text import concat, make, parts_of
from rosward.domain.values import UNBOUND, Const, Hole, Ref, Text, Unknown, Value
from rosward.models.native import Machine
from rosward.models.python.comparing.equal_objects import member_value
from rosward.models.python.plain import (
    NOT_PLAIN,
    Raised,
    from_python,
    int_of,
    operation,
    origins,
    plain,
    run,
    spread,
    text_of,
    unknown_from,
    with_origins,
)
from rosward.models.python.strings import text_parts
from rosward.models.python.strings.formatting import joined, piece, represent, too_wide
from rosward.records import NamedTuple

_FIELD: Final = re.compile(
    r"%(?:\((?P<key>[^()]*)\))?(?P<flags>[#0\- +]*)(?P<width>\*|\d+)?(?P<precision>\.(?:\*|\d*))?[hlL]?(?P<type>.)",
    re.DOTALL,
)
_WHOLE: Final = ("d", "i", "u")


class _Field(NamedTuple):
    """One conversion, with its width and precision filled in (None: not known)."""

    flags: str
    width: str | None
    precision: str | None
    type: str

    @property
    def spec(self) -> str | None:
        if self.width is None or self.precision is None:
            return None
        return f"%{self.flags}{self.width}{self.precision}{self.type}"


@operation
def percent(machine: Machine, template: Value, args: Value) -> Value:
    """template % args."""
    return spread(lambda t, a: percent_one(machine, t, a), template, args)


def percent_one(machine: Machine, template: Value, args: Value) -> Value:
    """The same for single alternatives; what the program raises is raised as `Raised`."""
    text = text_of(template)
    if text is None:
        first = parts_of(template)[0]
        known = first.partition("%")[0] if isinstance(first, str) else ""
        hole = Hole(unknown_from(machine, "%", "str", template, args).reasons)
        return make((known, hole), origins(template, args))
    if "*" not in text and not too_wide(text) and plain(args) is not NOT_PLAIN:
        return from_python(machine, run(operator.mod, text, plain(args)), origins(template, args), "%")
    filled = joined(machine, _pieces(machine, text, args))
    return filled if filled is UNBOUND else with_origins(lift(lambda t: concat((t,)), filled), origins(template))


def _pieces(machine: Machine, text: str, args: Value) -> list[Value]:
    """The known text and the converted arguments, in order."""
    pieces: list[Value] = []
    values = list(args.items) if isinstance(args, Tuple) else [args]
    at = 0
    while (start := text.find("%", at)) >= 0:
        pieces.append(Const(text[at:start]))
        match = _FIELD.match(text, start)
        if match is None:
            raise Raised("ValueError", "incomplete format")
        at = match.end()
        if match["type"] == "%":
            pieces.append(Const("%"))
            continue
        value = machine.load_item(args, Const(match["key"])) if match["key"] is not None else None
        field = _field(match, values, args)
        if value is None:
            value = _next(values, args)
        pieces.append(spread(lambda v, f=field: _convert(machine, v, f), value))
    pieces.append(Const(text[at:]))
    if isinstance(args, Tuple) and values:
        raise Raised("TypeError", "not all arguments converted during string formatting")
    return pieces


def _next(values: list[Value], args: Value) -> Value:
    """The next argument; an unknown argument may be a tuple of any number."""
    if isinstance(args, Unknown):
        return Unknown(args.reasons)
    if not values:
        raise Raised("TypeError", "not enough arguments for format string")
    return values.pop(0)


def _field(match: re.Match[str], values: list[Value], args: Value) -> _Field:
    width, precision = match["width"] or "", match["precision"] or ""
    return _Field(
        match["flags"],
        _star(values, args, "") if width == "*" else width,
        _star(values, args, ".") if precision == ".*" else precision,
        match["type"],
    )


def _star(values: list[Value], args: Value, before: str) -> str | None:
    number = int_of(_next(values, args))
    return None if number is None else f"{before}{number}"


def _convert(machine: Machine, value: Value, field: _Field) -> Value:
    spec = field.spec
    if spec is None or too_wide(spec):
        return unknown_from(machine, "%", "str", value)
    if isinstance(value, Ref) and field.type not in ("s", "r"):
        value = member_value(machine, value, "__float__" if field.type in "eEfFgG" else "__eq__") or value
    if isinstance(value, Const):
        return from_python(machine, run(operator.mod, spec, (value.value,)), value.origins, "%")
    if field.type in ("s", "r"):
        text = piece(machine, value) if field.type == "s" else represent(machine, value)
        return spread(lambda t: _aligned(t, field), text)
    if field.type in _WHOLE and isinstance(value, Text):
        raise Raised("TypeError", f"%{field.type} format: a real number is required, not str")
    digits = (
        field.type in _WHOLE
        and not field.precision
        and (not field.width or field.flags == "0")
        and " " not in field.flags
    )
    whole = digits and "+" not in field.flags and isinstance(value, (Unknown, Ref))
    return Unknown(unknown_from(machine, "%", "int", value).reasons, "int" if whole else "str")


def _aligned(text: Value, field: _Field) -> Value:
    """A text with its width and precision."""
    if not field.width and not field.precision:
        return text
    if isinstance(text, Const):
        return Const(str(run(operator.mod, f"%{field.flags}{field.width}{field.precision}s", text.value)), text.origins)
    parts = parts_of(text)
    fill = text_parts.anything(parts)
    return make((fill,) if field.precision else (fill, *parts, fill), origins(text))
