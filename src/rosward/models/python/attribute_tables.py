# SPDX-License-Identifier: Apache-2.0
"""What does an object hold whose `__dict__` was given to it? What that dict holds: several objects may share it.

self.__dict__ = self._shared      each object with this dict has the attributes that any of them sets
self.__dict__ = self              of a class that inherits from dict: its entries are its attributes
"""

from __future__ import annotations

from typing import Final

from rosward.domain.choice import join, join_all, options
from rosward.domain.heap import Obj
from rosward.domain.unknown import Cause
from rosward.domain.values import UNBOUND, Const, Ref, Value
from rosward.models.native import Machine
from rosward.models.python.containers.dicts import look_up, take
from rosward.models.python.contents import bare

TABLE: Final = "__dict__"
"""The attribute under which an object keeps a dict that it was given; an object without one keeps its attributes itself."""


def own_attribute(machine: Machine, obj: Obj, name: str) -> tuple[Value | None, bool]:
    """What an object itself holds under a name (None or UNBOUND: nothing), and whether it surely does."""
    held = obj.attrs.get(name)
    table = obj.attrs.get(TABLE)
    if table is None or not name.isidentifier() or name == TABLE:
        return held, not obj.many and name not in obj.partial
    found: list[Value] = []
    sure = not obj.many and TABLE not in obj.partial
    for option in options(bare(machine, table)):
        if isinstance(option, Ref) and machine.obj(option).kind == "dict":
            entry = look_up(machine, machine.obj(option), Const(name))
            found.append(entry.value)
            sure = sure and entry.missing is False
        else:
            found.append(machine.unknown(Cause.OPERATION, TABLE))
            sure = False
    value = join_all(found)
    return (value if held is None else join(held, value)), sure


def give_table(machine: Machine, ref: Ref, table: Value) -> None:
    """`object.__dict__ = table`: from now on its attributes are what the table holds."""
    obj = machine.obj(ref)
    for option in options(bare(machine, table)):
        record = machine.obj(option) if isinstance(option, Ref) else None
        if record is None or record.kind != "dict" or not isinstance(option, Ref):
            continue
        owner = record.payload
        if owner == ref:
            return  # its own, again
        if isinstance(owner, Ref):  # the `__dict__` of another object: both have it now
            machine.update(option, record.replace(payload=None))
            give_table(machine, owner, option)
    if obj.many:
        machine.update(ref, obj.with_attr(TABLE, table).replace(partial=obj.partial | {TABLE}))
        return
    kept = {n: v for n, v in obj.attrs.items() if not n.isidentifier() or n.startswith("_rosward")}
    machine.update(ref, obj.replace(attrs={**kept, TABLE: table}, partial=frozenset()))


def store_in_table(machine: Machine, obj: Obj, name: str, value: Value, *, weak: bool) -> bool:
    """Whether an attribute that is set goes into a dict that the object was given, and then it is there."""
    table = obj.attrs.get(TABLE)
    if table is None or not name.isidentifier() or name == TABLE:
        return False
    several = options(bare(machine, table))
    old, _ = own_attribute(machine, obj, name)
    if (weak or obj.many or len(several) > 1) and old is not None and old is not UNBOUND:
        value = join(old, value)
    for option in several:
        if isinstance(option, Ref) and machine.obj(option).kind == "dict":
            machine.store_item(option, Const(name), value)
    return not obj.many and TABLE not in obj.partial


def remove_from_table(machine: Machine, obj: Obj, name: str) -> bool:
    """Whether an attribute that is deleted was kept in a dict that the object was given; then it is gone."""
    table = obj.attrs.get(TABLE)
    several = options(bare(machine, table)) if table is not None and name != TABLE else ()
    for option in several:
        if isinstance(option, Ref) and machine.obj(option).kind == "dict" and len(several) == 1:
            take(machine, option, Const(name))
    return bool(several)
