# SPDX-License-Identifier: Apache-2.0
"""Which parameters has a node: surely, surely not, or maybe?

    Node('n', automatically_declare_parameters_from_overrides=True)     started by nobody knows whom: it may have any
    self.declare_parameter('rate', 10)                                  rate, surely: declared again, it raises
    Node('n', allow_undeclared_parameters=True)                         none; any other once `ros2 param set` can have come

The table is a dict on the heap: names, values, and what stands under names that are not known. Names of which a part is known have a dict of
their own: what is declared as `*.depth` is not what stands under `*.topic`.
"""

from __future__ import annotations

from types import MappingProxyType
from typing import TYPE_CHECKING, Final

from rosward.domain.certain import text_of
from rosward.domain.choice import join, join_all, options
from rosward.domain.compound import Native
from rosward.domain.heap import Obj
from rosward.domain.text import origins_of, readable
from rosward.domain.unknown import OUTSIDE, Cause, Origin, Reason
from rosward.domain.values import FALSE, NONE, TRUE, UNBOUND, Const, Hole, Ref, Text, Unknown, Value
from rosward.ir.program import CPP, PYTHON
from rosward.models.failures import fail
from rosward.models.python.comparing.compare import equal
from rosward.models.python.containers import dicts
from rosward.models.python.plain import EXCEPTION_HINT

if TYPE_CHECKING:
    from rosward.models.native import Machine

_TABLE: Final = "__parameters__"
_PATTERNS: Final = "__parameter_patterns__"
EXCLUDED: Final = "__excluded_defaults__"
"""The parameters of which a test says that they do not have their default."""
_MOST_PATTERNS: Final = 100
_ANYTHING: Final = Hole(())
UNDECLARED: Final = "__undeclared__"
"""Attribute of a node: whether it takes parameters that it never declared."""
REFUSES: Final = "__refuses__"
"""Attribute of a node: whether something may refuse a new value (a callback, a descriptor)."""
_EXCEPTIONS: Final = MappingProxyType({PYTHON: "rclpy.exceptions", CPP: "rclcpp.exceptions"})
"""The module or namespace that has the exceptions of the client library, by language."""


def table_of(machine: Machine, node: Value, which: str = _TABLE) -> Ref | None:
    """The table of an object that surely is a node."""
    if not isinstance(node, Ref):
        return None
    found = machine.part(node, which).attrs.get(which)
    return found if isinstance(found, Ref) else None


def _patterns_of(machine: Machine, node: Value) -> Obj | None:
    """The table of names that are known in part."""
    found = table_of(machine, node, _PATTERNS)
    return None if found is None else machine.obj(found)


def flag(machine: Machine, node: Value, name: str) -> bool:
    """Whether a flag of a node may be set."""
    if not isinstance(node, Ref):
        return True
    value = machine.part(node, name).attrs.get(name, FALSE)
    return not all(machine.truth(v) is False for v in options(value))


def is_declared(machine: Machine, node: Value, name: Value) -> bool | None:
    """Whether a node has a parameter; None where it may."""
    table = table_of(machine, node)
    if table is None:
        return None
    if any(not origin.settled for each in options(name) for origin in origins_of(each)):
        return None  # somebody may set another name
    missing = dicts.look_up(machine, machine.obj(table), name).missing
    if missing and _of_patterns(machine, node, name):
        return None
    if missing and flag(machine, node, UNDECLARED) and may_be_set(machine):
        return None
    return None if missing is None else not missing


def may_be_set(machine: Machine) -> bool:
    """Whether the services of the node can have been called: it was spun."""
    return machine.in_callback or machine.schedule_book.was_run


def put(machine: Machine, node: Value, name: Value, value: Value, *, sure: bool = True) -> None:
    """A node has a parameter of this name and value from here on; not `sure`: it may have."""
    table = table_of(machine, node)
    if table is None:
        return
    apart = [o for o in options(name) if isinstance(o, Text) and _put_pattern(machine, node, table, o, value)]
    others = [o for o in options(name) if o not in apart]
    if others:
        dicts.store(machine, table, join_all(others), value, weak=not sure or bool(apart))


def _put_pattern(machine: Machine, node: Value, table: Ref, name: Text, value: Value) -> bool:
    """A node may have a parameter of a name of which a part is known; False where there are too many of those."""
    patterns = table_of(machine, node, _PATTERNS)
    if patterns is None:
        return False
    held, key = machine.obj(patterns), Text(tuple(p if isinstance(p, str) else _ANYTHING for p in name.parts))
    if key not in held.entries and len(held.entries) >= _MOST_PATTERNS:
        return False
    old = held.entries.get(key, UNBOUND)
    machine.update(patterns, held.replace(entries={**held.entries, key: join(old, value)}))
    record = machine.obj(table)
    machine.update(table, record.replace(entries=dicts.with_possible(machine, record.entries, name, value)))
    return True


def _of_patterns(machine: Machine, node: Value, name: Value) -> list[Value]:
    """What stands under the names, known in part, that a name may be."""
    patterns = _patterns_of(machine, node)
    entries = {} if patterns is None else patterns.entries
    return [v for k, v in entries.items() if any(equal(machine, k, o) is not False for o in options(name))]


def has_others(machine: Machine, node: Value) -> bool:
    """Whether a node may have parameters whose names are not known."""
    table = table_of(machine, node)
    if table is None or machine.obj(table).rest is not None:
        return True
    patterns = _patterns_of(machine, node)
    return patterns is not None and bool(patterns.entries)


def put_any(machine: Machine, node: Value, subject: str) -> None:
    """A node may have any parameters from here on, of any values."""
    name = machine.unknown(Cause.PARAMETER, subject, "str")
    put(machine, node, name, Unknown(name.reasons), sure=False)


def take(machine: Machine, node: Value, name: Value, *, sure: bool = True) -> None:
    """A parameter is gone from here on; not `sure`: it may be."""
    table = table_of(machine, node)
    if table is None:
        return
    if sure:
        dicts.take(machine, table, name)
        return
    obj = machine.obj(table)
    key = dicts.key_of(name)
    doubtful = obj.entries if key is None else [k for k in obj.entries if k == key]
    machine.update(table, obj.replace(maybe=obj.maybe | set(doubtful)))


def value_of(machine: Machine, node: Value, name: Value) -> Value | None:
    """The join of the values that a parameter may have; None where the table has none."""
    table = table_of(machine, node)
    if table is None:
        return None
    found = dicts.look_up(machine, machine.obj(table), name)
    known = [o for o in options(found.value) if found.missing is not True]
    if found.missing is not False:
        known += _of_patterns(machine, node, name)
    return join_all(_stated_once(known, text_of(name))) if known else None


def _stated_once(values: list[Value], label: str) -> list[Value]:
    """What a parameter may be, where a default stands among it that anybody may have changed: that says it already."""
    changeable = any(o[:2] == ("parameter", label) and not o.settled for v in values for o in origins_of(v))
    if not changeable:
        return values
    return [v for v in values if not (isinstance(v, Unknown) and all(_is_outside(r) for r in v.reasons))]


def _is_outside(reason: Reason) -> bool:
    return reason.cause is Cause.PARAMETER and reason.subject == OUTSIDE


def tables(machine: Machine, which: str = _TABLE) -> list[Ref]:
    """The tables of all nodes, as far as each is of one node alone."""
    nodes = dict.fromkeys(Ref(effect.address) for effect in machine.nodes_at(None))
    return list(dict.fromkeys(table for node in nodes if (table := table_of(machine, node, which)) is not None))


def put_entry(machine: Machine, table: Ref, key: Const, value: Value) -> None:
    """A parameter has this value from here on, in the table of a node, where that is no more than one."""
    record = machine.obj(table)
    if not record.many:
        machine.update(table, record.replace(entries={**record.entries, key: value}))


HAS: Final = "parameter that is there, of "
"""The kind of the origin of an answer: that a parameter is there, of the node at this address."""


def may_have(machine: Machine, node: Value, label: str) -> Value:
    """The answer to whether a parameter is declared that may be: where it is yes, its origin says which one is there, and of which node.

    What is only known as one of those that anybody may have given gets an entry of its own for that: one that may be absent.
    """
    if not isinstance(node, Ref):
        return join_all((TRUE, FALSE))
    table, key = table_of(machine, node), Const(label)
    value = None if table is None or key in machine.obj(table).entries else value_of(machine, node, key)
    if value is not None:
        put(machine, node, key, value, sure=False)
    return join_all((Const(True, frozenset((Origin(f"{HAS}{node.address}", label),))), FALSE))


def not_declared(machine: Machine, name: Value, method: str) -> Value:
    """`method` raises, since the parameter is not declared."""
    message = f"parameter {readable(name)!r} is not declared here: {method} raises ParameterNotDeclaredException"
    return raise_(machine, "ParameterNotDeclaredException", message, name)


def may_lack_value(machine: Machine, value: Value, label: str) -> None:
    """`get_parameter` raises where nobody has given a parameter a value that has no default: whoever catches that is reached."""
    reasons = [r for option in options(value) if isinstance(option, Unknown) for r in option.reasons]
    if any(r.cause is Cause.PARAMETER and r.subject == label for r in reasons):
        may_raise(machine, label)


def may_raise(machine: Machine, label: str) -> None:
    """The client library raises, or not, since it is not known what becomes of a parameter: whoever catches that is reached."""
    machine.throw(machine.unknown(Cause.PARAMETER, label, EXCEPTION_HINT))


def raise_(machine: Machine, exception: str, message: str, *args: Value) -> Value:
    """An exception of the client library is raised."""
    cls = machine.load_attr(machine.load_module(_EXCEPTIONS[machine.language_name]), exception)
    return fail(machine, cls, message, args)


def is_unset(value: Value) -> bool | None:
    """Whether a parameter has no value; None where it may have none."""
    if value == NONE:
        return True
    return None if any(v == NONE or isinstance(v, Unknown) for v in options(value)) else False


def new_table(machine: Machine, node: Ref, undeclared: Value | None) -> None:
    """A new node has no parameters."""
    patterns = machine.allocate(Obj("dict", Native("builtins.dict")), _PATTERNS)
    excluded = machine.allocate(Obj("dict", Native("builtins.dict")), EXCLUDED)
    obj = machine.obj(node).with_attr(_TABLE, machine.new_dict({})).with_attr(_PATTERNS, patterns)
    obj = obj.with_attr(EXCLUDED, excluded)
    machine.update(node, obj.with_attr(UNDECLARED, undeclared or FALSE))


def may_name(machine: Machine, node: Value, name: Value) -> bool:
    """Whether a parameter of this name may be among those whose names are known."""
    table, key = table_of(machine, node), dicts.key_of(name)
    return table is None or key is None or key in machine.obj(table).entries


def labels(machine: Machine, node: Value) -> list[Const]:
    """The names that a node has or may have, as far as they are known."""
    table = table_of(machine, node)
    return [k for k in machine.obj(table).entries if isinstance(k, Const)] if table is not None else []
