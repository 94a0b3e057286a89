# SPDX-License-Identifier: Apache-2.0
"""`string.Template`: what a template becomes, field by field.

Template('/$robot/cmd').substitute(robot=unknown)      Text('/', hole, '/cmd')
"""

from __future__ import annotations

import string
from typing import Final

from rosward.domain.choice import join, lift
from rosward.domain.text import concat
from rosward.domain.values import UNBOUND, Const, Value
from rosward.models.native import Machine, NativeCall, NativeFunction
from rosward.models.python.plain import Raised, native, origins, spread, text_of, unknown_from, with_origins
from rosward.models.python.strings.formatting import joined, piece


def _substitute(call: NativeCall) -> Value:
    """string._substitute(template, mapping, safe): each field in its place, whatever is known of it."""
    return spread(lambda template: _filled(call.machine, template, *call.args[1:]), call.args[0])


def _filled(machine: Machine, template: Value, mapping: Value, safe: Value) -> Value:
    text = text_of(template)
    if text is None:
        return unknown_from(machine, "string.Template", "str", template, mapping)
    pieces: list[Value] = []
    at = 0
    for match in string.Template.pattern.finditer(text):
        pieces.append(Const(text[at : match.start()]))
        at = match.end()
        name = match["named"] or match["braced"]
        if match["escaped"] is not None:
            pieces.append(Const(string.Template.delimiter))
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


def _field(machine: Machine, mapping: Value, name: str, written: str, safe: Value) -> Value:
    """What stands for one field; `safe_substitute` leaves it as it is written where it has no value."""
    there = machine.truth(machine.compare("in", Const(name), mapping)) if machine.truth(safe) else True
    if there is False:
        return Const(written)
    value = machine.load_item(mapping, Const(name))
    text = UNBOUND if value is UNBOUND else piece(machine, value)
    return text if there else join(text, Const(written))


NATIVES: Final[dict[str, NativeFunction]] = {"string._substitute": native(_substitute, 3)}
