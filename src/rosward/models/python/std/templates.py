# SPDX-License-Identifier: Apache-2.0
"""`string.Template`: what a template becomes, field by field.

Template('/$robot/cmd').substitute(robot=unknown)      Text('/', hole, '/cmd')
"""

from __future__ import annotations

import re
import string
from collections.abc import Sequence
from typing import Final

from rosward.domain.choice import join, lift
from rosward.domain.text import concat
from rosward.domain.values import UNBOUND, Const, Unknown, Value
from rosward.models.native import Machine, NativeCall, NativeFunction
from rosward.models.python.plain import Raised, native, origins, spread, text_of, unknown_from, with_origins
from rosward.models.python.std.support import NotKnown, apply_plain, to_plain
from rosward.models.python.std.texts import compiled
from rosward.models.python.strings.formatting import joined, piece


def _substitute(call: NativeCall) -> Value:
    """string._substitute(template, mapping, safe, *form): each field in its place, whatever is known of it."""
    template, mapping, safe, *form = call.args
    return spread(lambda each: _filled(call, each, mapping, safe, form), template)


def _rule(call: NativeCall, form: Sequence[Value], text: str) -> tuple[re.Pattern[str], str]:
    """The pattern of a class of templates, and what stands before its fields; raises `NotKnown`."""
    plain = [to_plain(call.machine, value)[0] for value in form]
    written = dict(zip(("delimiter", "idpattern", "braceidpattern", "flags", "pattern"), plain, strict=True))
    if written == _USUAL:
        return string.Template.pattern, "$"
    delimiter, flags = written["delimiter"], written["flags"]
    if not isinstance(delimiter, str) or not isinstance(flags, int):
        raise NotKnown
    if written["pattern"] is None:
        name = written["idpattern"]
        inner = name if written["braceidpattern"] is None else written["braceidpattern"]
        mark = re.escape(delimiter)
        source = f"{mark}(?:(?P<escaped>{mark})|(?P<named>{name})|{{(?P<braced>{inner})}}|(?P<invalid>))"
    else:
        source = str(written["pattern"])
    pattern = compiled(call, source, flags | re.VERBOSE, text)
    if not {"escaped", "named", "braced", "invalid"} <= pattern.groupindex.keys():
        raise NotKnown
    return pattern, delimiter


_USUAL: Final = {
    "delimiter": "$",
    "idpattern": "(?a:[_a-z][_a-z0-9]*)",
    "braceidpattern": None,
    "flags": 2,
    "pattern": None,
}


def _filled(call: NativeCall, template: Value, mapping: Value, safe: Value, form: Sequence[Value]) -> Value:
    machine, text = call.machine, text_of(template)
    try:
        if text is None:
            raise NotKnown
        pattern, delimiter = _rule(call, form, text)
    except NotKnown:
        return unknown_from(machine, "string.Template", "str", template, mapping)
    pieces: list[Value] = []
    at = 0
    for match in pattern.finditer(text):
        pieces.append(Const(text[at : match.start()]))
        at = match.end()
        name = match["named"] or match["braced"]
        if match["escaped"] is not None:
            pieces.append(Const(delimiter))
        elif name:
            pieces.append(_field(machine, mapping, name, match.group(), safe))
        elif machine.truth(safe):
            pieces.append(Const(match.group()))
        else:
            raise Raised("ValueError", "Invalid placeholder in string")
    if UNBOUND in pieces:
        return UNBOUND
    filled = joined(machine, [*pieces, Const(text[at:])])
    return with_origins(lift(lambda t: concat((t,)), filled), origins(template))


def _fields(call: NativeCall) -> Value:
    """string._fields(template, *form): the names of the fields, each once."""
    text = text_of(call.args[0])
    try:
        if text is None:
            raise NotKnown
        pattern, _ = _rule(call, call.args[1:], text)
    except NotKnown:
        return call.machine.new_list((), unknown_from(call.machine, "string.Template", "str", *call.args))
    names = (match["named"] or match["braced"] for match in pattern.finditer(text))
    return call.machine.new_list([Const(name) for name in dict.fromkeys(names) if name])


def _parsed(call: NativeCall) -> Value:
    """string._parsed(format_string): text, name, format and conversion of each field."""

    def run(text: object) -> object:
        if not isinstance(text, str):
            raise NotKnown
        return list(string.Formatter().parse(text))

    found = apply_plain(call, run, call.args, "list")
    return (
        call.machine.new_list((), unknown_from(call.machine, call.name, "", found))
        if found.__class__ is Unknown
        else found
    )


def _field(machine: Machine, mapping: Value, name: str, written: str, safe: Value) -> Value:
    """What stands for one field; `safe_substitute` leaves it as it is written where it has no value."""
    there = machine.truth(machine.compare("in", Const(name), mapping)) if machine.truth(safe) else True
    if there is False:
        return Const(written)
    value = machine.load_item(mapping, Const(name))
    text = UNBOUND if value is UNBOUND else piece(machine, value)
    return text if there else join(text, Const(written))


NATIVES: Final[dict[str, NativeFunction]] = {
    "string._substitute": native(_substitute, 8),
    "string._fields": native(_fields, 6),
    "string._parsed": _parsed,
}
