# SPDX-License-Identifier: Apache-2.0
"""What a test says of the parameters of nodes: that one is there, or that one is not what it is by default.

has_name = len(name) > 0                    name = declare_parameter('name', '').value
if has_name: create_publisher(…, name)      what somebody gives instead: with the default, the program does not come here
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from rosward.domain.choice import join_all, options
from rosward.domain.text import origins_of
from rosward.domain.unknown import COMPARED, OTHERS, Cause, Reason
from rosward.domain.values import TRUE, Choice, Const, Ref, Unknown, Value
from rosward.models.python.containers import dicts
from rosward.models.ros.parameter_table import EXCLUDED, HAS, put_entry, table_of, tables

if TYPE_CHECKING:
    from rosward.models.native import Machine


def tell(machine: Machine, test: Value, asked: Sequence[int], registers: list[Value], *, sense: bool) -> None:
    """A test came out as `sense`: what that says about parameters holds from here on. `asked`: the registers that it asks about."""
    if isinstance(test, Choice):
        _follow(machine, test, sense=sense)
    if not isinstance(test, Const) or test.origins:
        _exclude(machine, test, asked, registers, sense=sense)


def _follow(machine: Machine, value: Value, *, sense: bool) -> None:
    """What the alternatives of a test say that are so, of which parameters are there."""
    kept = [o for o in options(value) if isinstance(o, Const) and bool(o.value) is sense]
    found = [o for option in kept for o in origins_of(option) if o.kind.startswith(HAS)]
    if len(found) != 1 or len(kept) != 1:
        return
    node, key = Ref(int(found[0].kind.removeprefix(HAS))), Const(found[0].name)
    table = table_of(machine, node)
    if table is not None and not machine.obj(node).many and not machine.obj(table).many:
        record = machine.obj(table)
        if key in record.maybe:
            machine.update(table, record.replace(maybe=record.maybe - {key}))


def _exclude(machine: Machine, test: Value, asked: Sequence[int], registers: list[Value], *, sense: bool) -> None:
    """A test that was computed of a default comes out otherwise than with it: somebody gives the parameter another value there.

    `if len(topic) > 0:` of a topic that is '' by default. What is asked directly is narrowed where it stands.
    """
    labels = {_ruled_out(o, sense=sense) for o in options(test) if isinstance(o, Const)}
    label = labels.pop() if len(labels) == 1 else None
    if label is None:
        return
    key = Const(label)
    held = [(table, found) for table in tables(machine) if (found := machine.obj(table).entries.get(key)) is not None]
    if len(held) > 1:
        return  # of which node it was read is not known
    values = [registers[number] for number in asked]
    for number, value in enumerate(registers):  # what was read of it, and elements of a list that it is
        if (value.__class__ is Const or value.__class__ is Choice) and number not in asked:
            registers[number] = _without_default(machine, value, label)
    sure = all(isinstance(o, Const) or _is_excluded(o, label) for o in options(test))
    if sure and len(held) == 1 and held[0][1] not in values:
        left = _without_default(machine, held[0][1], label)
        if left is not held[0][1]:
            put_entry(machine, held[0][0], key, left)
        elif isinstance(left, Ref):
            for excluded in tables(machine, EXCLUDED):
                dicts.store(machine, excluded, key, TRUE)


def _without_default(machine: Machine, value: Value, label: str) -> Value:
    """A value where the parameter is not what it is by default: what was a text or number because of that is another one."""
    found = options(value)
    left = [o for o in found if isinstance(o, Const) and _may_be_named(o) and _open_parameter(o) == label]
    if not left:
        return value
    kept = [o for o in found if o not in left]
    told = any(_is_excluded(o, label) for o in kept)
    return join_all(kept if told else (*kept, *(_another(machine, label, o) for o in left)))


def _may_be_named(value: Const) -> bool:
    """Whether a value may be a part of a name, or count what is named."""
    return isinstance(value.value, (str, int, float)) and not isinstance(value.value, bool)


def narrow(machine: Machine, before: Value, after: Value) -> None:
    """The value that was read of a parameter turned out to be another one: so it is where it is read again.

    The origin of a default names its parameter, not the node: where two nodes have such a one, it is not known whose was read.
    """
    labels = {o.name for option in options(before) for o in origins_of(option) if o.kind == "parameter"}
    if len(labels) != 1:
        return
    key = Const(labels.pop())
    held = [table for table in tables(machine) if machine.obj(table).entries.get(key) == before]
    if len(held) == 1:
        put_entry(machine, held[0], key, after)


def in_place(machine: Machine, value: Value) -> Value:
    """A value where what it was computed of is no longer the default of its parameter, as a test found out."""
    if isinstance(value, Choice):
        for label in {label for o in value.options if (label := _open_parameter(o)) is not None}:
            if _is_excluded(_held_once(machine, Const(label))):
                value = _without_default(machine, value, label)
        return value
    label = _open_parameter(value)
    if label is None:
        return value
    held = _held_once(machine, Const(label))
    if isinstance(held, Ref):  # what is in a list stays; of which one a test says something is not asked
        return _without_default(machine, value, label) if _is_surely_excluded(machine, label) else value
    return held if held is not None and _is_excluded(held) else value


def _held_once(machine: Machine, key: Const) -> Value | None:
    """What the one table that has a parameter says of it; None where several have it. Asked at each read of a default, of many nodes, too."""
    where, found = None, None
    for effect in machine.nodes_at(None):
        table = table_of(machine, Ref(effect.address))
        value = None if table is None or table == where else machine.obj(table).entries.get(key)
        if value is None:
            continue
        if found is not None:
            return None
        where, found = table, value
    return found


def _is_surely_excluded(machine: Machine, label: str) -> bool:
    found = [machine.obj(table) for table in tables(machine, EXCLUDED)]
    return any(Const(label) in each.entries and Const(label) not in each.maybe for each in found)


def _is_excluded(value: Value | None, label: str = "") -> bool:
    """Whether it is what somebody gives in place of a default; with a `label`, of that parameter, as far as it has to do with it."""
    if not isinstance(value, Unknown) or not value.reasons or not all(r.cause in OTHERS for r in value.reasons):
        return False
    return not label or any(r.subject == label for r in value.reasons)


def _ruled_out(value: Const, *, sense: bool) -> str | None:
    """The parameter that surely does not have its default where a test of this value comes out as `sense`."""
    told = [o.name for o in value.origins if o.kind == COMPARED]
    if told:  # an earlier test came out otherwise than with the default: `a or b`
        return told[0] if len(told) == 1 else None
    return _open_parameter(value) if bool(value.value) is not sense else None


def _open_parameter(value: Value) -> str | None:
    """The one parameter of whose default a known value was computed, where nothing else decides it."""
    if not isinstance(value, Const) or any(o.kind == COMPARED for o in value.origins):
        return None
    open_ = [o for o in value.origins if not o.settled]
    return open_[0].name if len(open_) == 1 and open_[0].kind == "parameter" else None


def _another(machine: Machine, label: str, default: Const) -> Value:
    return Unknown((Reason(Cause.OTHER, label, machine.place),), default.value.__class__.__name__)
