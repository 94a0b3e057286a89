# SPDX-License-Identifier: Apache-2.0
"""What do `keys`, `values` and `items` of a dict give? A view, which shows what the dict holds whenever it is asked.

names = table.keys(); table['late'] = 1; list(names)      'late' is among them
"""

from __future__ import annotations

from typing import Final

from rosward.domain.certain import text_of
from rosward.domain.choice import join_all
from rosward.domain.compound import Tuple
from rosward.domain.heap import Obj
from rosward.domain.series import Series
from rosward.domain.values import Const, Ref, Value
from rosward.models.native import Items, Machine, NativeCall, NativeFunction
from rosward.models.python.comparing.compare import VIEWED
from rosward.models.python.containers.dicts import keys, pairs, receiver, values
from rosward.models.python.containers.lists import VIEW, write_series
from rosward.models.python.plain import all_of, listed, native, unknown_from


def _listing(call: NativeCall) -> Value:
    """keys, values and items: a list of what they show; `renewed` looks again."""
    ref = receiver(call)
    if ref is None:
        return unknown_from(call.machine, call.name, "list", *call.args)
    name = call.name.rpartition(".")[2]
    made = listed(call.machine, call.name, *_shown(call.machine, ref, name))
    viewed = {VIEWED: Tuple((ref, Const(name)))}
    call.machine.update(made, call.machine.obj(made).replace(payload=VIEW, attrs=viewed))
    return made


def _shown(machine: Machine, ref: Ref, name: str) -> Items:
    obj = machine.obj(ref)
    items = keys(machine, obj) if name == "keys" else values(obj) if name == "values" else pairs(machine, obj)
    return items if obj.rest is None else Items((), join_all(all_of(items)))  # nobody knows where unknown keys stand


def renewed(machine: Machine, ref: Ref) -> Obj:
    """What a list holds, after a look at the dict where it is a view of one."""
    obj = machine.obj(ref)
    viewed = obj.attrs.get(VIEWED) if obj.payload == VIEW and not obj.many else None
    if not isinstance(viewed, Tuple) or not isinstance(viewed.items[0], Ref):
        return obj
    known, rest = _shown(machine, viewed.items[0], str(text_of(viewed.items[1])))
    series = obj.series()
    if (series.head, series.behind_head()) != (known, rest):
        write_series(machine, ref, Series(known, rest))
    return machine.obj(ref)


NATIVES: Final[dict[str, NativeFunction]] = {
    "dict.keys": native(_listing, 1),
    "dict.values": native(_listing, 1),
    "dict.items": native(_listing, 1),
}
