# SPDX-License-Identifier: Apache-2.0
"""Comparisons of values of builtin types: equality, order, membership; decided only where every possible value agrees.

Text('/robot_', hole) == '/base'        False
'a' in ['a', unknown]                   True
mode == 'sim'                           True or False with the origins of `mode`, where that is but a default
"""

from __future__ import annotations

import operator
from collections.abc import Callable
from typing import Final

from rosward.domain.choice import options
from rosward.domain.compound import BoundMethod, External, Native, Partial, Range, Slice, Tuple
from rosward.domain.enumerated import Whole, same_number
from rosward.domain.heap import Shuffled
from rosward.domain.series import Series
from rosward.domain.slots import Enumerated
from rosward.domain.text import matches, parts_of
from rosward.domain.unknown import Origins
from rosward.domain.values import NONE, Class, Const, Function, Ref, Text, Unknown, Value
from rosward.effects.shell import ORIGIN
from rosward.models.interfaces import NO_INTERFACE, is_known_interface, same_interface
from rosward.models.native import Machine
from rosward.models.python.comparing.equal_objects import has_equality, member_value, row_of
from rosward.models.python.comparing.kinds import names_kind
from rosward.models.python.plain import (
    LOOSE_HINTS,
    NOT_PLAIN,
    Raised,
    int_of,
    operation,
    origins,
    plain,
    range_of,
    run,
    spread,
    text_of,
    unknown_from,
)

MAX_DEPTH: Final = 6
MAX_COMPARED: Final = 2_000
_COMPARED_A_STEP: Final = 2
_ORDER: Final[dict[str, Callable[..., object]]] = {
    "<": operator.lt, "<=": operator.le, ">": operator.gt, ">=": operator.ge,
}  # fmt: skip
_NUMBERS: Final = ("bool", "int", "float", "complex")
_IDENTITY: Final = ("is", "is-not")
_NEGATED: Final = ("!=", "is-not", "not-in")


VIEWED: Final = "_rosward_viewed"
"""What a view of a dict shows: the dict, and which of keys, values and items."""
KEYS: Final = Const("keys")
VALUES: Final = Const("values")


@operation
def compare(machine: Machine, op: str, left: Value, right: Value) -> Value:
    """left op right."""
    return spread(lambda a, b: _compare(machine, op, a, b), left, right)


def _compare(machine: Machine, op: str, left: Value, right: Value) -> Value:
    source = origins(left, right)
    if op in ("in", "not-in"):
        decided, more = contains(machine, right, left)
        source |= more
    elif op not in _IDENTITY and (_is_view(machine, left) or _is_view(machine, right)):
        decided = _views(machine, op, left, right)
    elif op in ("==", "!="):
        decided = equal(machine, left, right)
    elif op in _IDENTITY:
        decided = same(machine, left, right)
    else:
        decided = _ordered(machine, op, left, right)
    if decided is None:
        return unknown_from(machine, op, "bool", left, right)
    return Const(decided is not (op in _NEGATED), source)


def _is_view(machine: Machine, value: Value) -> bool:
    return isinstance(value, Ref) and VIEWED in machine.obj(value).attrs


def _views(machine: Machine, op: str, left: Value, right: Value) -> bool | None:
    """A view of keys or of items compared with another one, or with a set: as sets."""
    sets = [_plain_set(machine, v) for v in (left, right)]
    if None in sets:
        return None
    return bool(run(operator.eq if op in ("==", "!=") else _ORDER[op], *sets))


def _plain_set(machine: Machine, value: Value) -> frozenset[object] | None:
    """The Python set that a set or view surely is."""
    obj = machine.obj(value) if isinstance(value, Ref) else None
    shown = obj.attrs.get(VIEWED) if obj is not None else None
    items = obj.items if obj is not None and obj.kind == "set" else None
    if isinstance(shown, Tuple) and isinstance(shown.items[0], Ref) and shown.items[1] != VALUES:
        table = machine.obj(shown.items[0])
        if table.rest is None and not table.maybe:
            pairs = shown.items[1] != KEYS
            items = tuple(Tuple((k, v)) if pairs else k for k, v in table.entries.items())
    found = None if items is None else [plain(i) for i in items]
    return None if found is None or any(i is NOT_PLAIN for i in found) else run(frozenset, found)


def _ordered(machine: Machine, op: str, left: Value, right: Value) -> bool | None:
    if isinstance(left, Tuple) and isinstance(right, Tuple):
        return _in_turn(machine, op, left.items, right.items)
    if isinstance(left, Ref) and isinstance(right, Ref):
        sets = _plain_set(machine, left), _plain_set(machine, right)
        if None not in sets:
            return bool(run(_ORDER[op], *sets))
    a, b = comparable(machine, left), comparable(machine, right)
    if a is NOT_PLAIN or b is NOT_PLAIN:
        return None
    return bool(run(_ORDER[op], a, b))


def _in_turn(machine: Machine, op: str, left: tuple[Value, ...], right: tuple[Value, ...]) -> bool | None:
    """Two tuples: the first elements that differ decide, else which one is longer. What stands behind need not be known."""
    for a, b in zip(left, right, strict=False):
        alike = equal(machine, a, b)
        if alike is None:
            return None
        if not alike:
            return _ordered(machine, op, a, b)
    return bool(run(_ORDER[op], len(left), len(right)))


def comparable(machine: Machine, value: Value, depth: int = MAX_DEPTH) -> object:
    """The Python object that a value surely is, lists included, to be compared; else NOT_PLAIN."""
    if isinstance(value, Ref):
        held = member_value(machine, value)
        if held is not None:
            return held.value
        obj = machine.obj(value)
        if obj.kind != "list" or obj.items is None or not depth:
            return NOT_PLAIN
        items = [comparable(machine, v, depth - 1) for v in obj.items]
        return NOT_PLAIN if any(i is NOT_PLAIN for i in items) else items
    return plain(value)


_TUPLE: Final = Native("builtins.tuple")
_NAMES: Final[dict[type, str]] = {Text: "str", Tuple: "tuple", Range: "range", Slice: "slice"}


def kind_of(machine: Machine, value: Value) -> str:
    """The name of the builtin type of a value, '' where it is of none or not known."""
    if value.__class__ is Unknown:
        return "" if value.hint in LOOSE_HINTS else value.hint
    if value.__class__ is Const:
        return "int" if isinstance(value.value, (Enumerated, Whole)) else value.value.__class__.__name__
    if value.__class__ is Ref:
        obj = machine.obj(value)
        return obj.kind if obj.cls != _TUPLE else "tuple"
    return _NAMES.get(value.__class__, "")


def same(machine: Machine, left: Value, right: Value) -> bool | None:
    """left is right; None where that is not known."""
    if isinstance(left, Const) and isinstance(right, Const):
        alike = left.value.__class__ is right.value.__class__ and left.value == right.value
        return alike if not alike or left.value is None or isinstance(left.value, bool) else None
    if isinstance(left, Ref) and isinstance(right, Ref):
        return (None if machine.obj(left).many else True) if left == right else False
    answer = equal(machine, left, right)
    return answer if answer is not True or not isinstance(left, (Text, Tuple, BoundMethod)) else None


def equal(machine: Machine, left: Value, right: Value, depth: int = MAX_DEPTH) -> bool | None:
    """left == right; None where that is not known."""
    lefts, rights = options(left), options(right)
    if len(lefts) > 1 or len(rights) > 1:
        answers = {equal(machine, a, b, depth) for a in lefts for b in rights}
        return answers.pop() if len(answers) == 1 else None
    if isinstance(left, Const) and isinstance(right, Const):
        if left.origins or right.origins:
            _compared_defaults(machine, left, right)
        return same_number(left.value, right.value)
    if isinstance(left, Unknown) or isinstance(right, Unknown):
        if _is_variable(left) or _is_variable(right):
            differs = machine.log.variables.equal(left, right) is False
            return False if differs else _of_unknown(kind_of(machine, left), kind_of(machine, right))
        return _of_unknown(kind_of(machine, left), kind_of(machine, right))
    if isinstance(left, (Text, Const)) and isinstance(right, (Text, Const)):
        return _texts(left, right)
    if isinstance(left, Tuple) and isinstance(right, Tuple):
        return _sequences(machine, left.items, right.items, depth)
    if isinstance(left, Ref) or isinstance(right, Ref):
        return _objects(machine, left, right, depth)
    if isinstance(left, BoundMethod) and isinstance(right, BoundMethod):
        return _methods(machine, left, right)
    if isinstance(left, (External, Partial, BoundMethod, Range)) or isinstance(
        right, (External, Partial, BoundMethod, Range)
    ):
        return True if left == right and not isinstance(left, (Partial, Range)) else _never(machine, left, right)
    return None if names_kind(left, right) else left == right


def _methods(machine: Machine, left: BoundMethod, right: BoundMethod) -> bool | None:
    """Two methods are equal if they are one function of one object."""
    if left.function != right.function:
        known = isinstance(left.function, (Function, Native)) and isinstance(right.function, (Function, Native))
        return False if known else None
    if isinstance(left.receiver, Class) and isinstance(right.receiver, Class):
        return left.receiver == right.receiver
    return same(machine, left.receiver, right.receiver)


def _is_variable(value: Value) -> bool:
    return isinstance(value, Unknown) and bool(value.variable)


def _compared_defaults(machine: Machine, left: Const, right: Const) -> None:
    """What a default of the environment is compared with is another value that it may have."""
    for one, other in ((left, right), (right, left)):
        if any(origin.kind == ORIGIN and not origin.settled for origin in one.origins):
            machine.log.variables.of_default(one.origins, other, machine.place)


def _never(machine: Machine, left: Value, right: Value) -> bool | None:
    """False where no such values are equal."""
    if isinstance(left, External) and isinstance(right, External):
        return same_interface(machine, left, right)
    for one, other in ((left, right), (right, left)):
        if isinstance(other, NO_INTERFACE) and is_known_interface(machine, one):
            return False
    apart = isinstance(left, (BoundMethod, Range)) and isinstance(right, (Const, Text, Tuple))
    apart = apart or (isinstance(right, (BoundMethod, Range)) and isinstance(left, (Const, Text, Tuple)))
    external = isinstance(left, External) and right == NONE
    return False if apart or external else None


def _of_unknown(left: str, right: str) -> bool | None:
    """Values of different builtin types are never equal."""
    if not left or not right or left == right or "instance" in (left, right) or "generator" in (left, right):
        return None
    return None if left in _NUMBERS and right in _NUMBERS else False


def _texts(left: Value, right: Value) -> bool | None:
    """Two texts, at least one with holes (or something that is no text)."""
    constant, other = (left, right) if isinstance(left, Const) else (right, left)
    if isinstance(constant, Const):
        text = text_of(constant)
        return None if text is not None and matches(other, text) else False
    for end in (0, -1):
        a, b = parts_of(left)[end], parts_of(right)[end]
        if isinstance(a, str) and isinstance(b, str):
            agree = (a.startswith(b) or b.startswith(a)) if end == 0 else (a.endswith(b) or b.endswith(a))
            if not agree:
                return False
    return None


def _sequences(machine: Machine, left: tuple[Value, ...], right: tuple[Value, ...], depth: int) -> bool | None:
    if len(left) != len(right):
        return False
    if not depth or len(left) > MAX_COMPARED:
        return None
    machine.spend(len(left) // _COMPARED_A_STEP)
    answers = [equal(machine, a, b, depth - 1) for a, b in zip(left, right, strict=True)]
    return False if False in answers else (None if None in answers else True)


def _objects(machine: Machine, left: Value, right: Value, depth: int) -> bool | None:
    """At least one object on the heap; the special methods of instances were tried before."""
    members = [member_value(machine, v) for v in (left, right)]
    if members != [None, None] and left != right:
        return equal(machine, members[0] or left, members[1] or right, depth)
    kinds = (kind_of(machine, left), kind_of(machine, right))
    if "instance" in kinds or "generator" in kinds or "" in kinds:
        rows = (row_of(machine, left), row_of(machine, right)) if "instance" in kinds else (None, None)
        if rows[0] is not None and rows[1] is not None:
            return _sequences(machine, rows[0].items, rows[1].items, depth)
        return _instances(machine, left, right)
    if kinds[0] != kinds[1]:
        return False
    a, b = (machine.obj(v) if isinstance(v, Ref) else None for v in (left, right))
    if a is None or b is None:
        return None
    if kinds[0] in ("list", "tuple"):
        return _series(machine, a.series(), b.series(), depth)
    if kinds[0] == "dict" and a.rest is None and b.rest is None and not a.maybe and not b.maybe:
        if set(a.entries) == set(b.entries):
            return _sequences(machine, tuple(a.entries.values()), tuple(b.entries[k] for k in a.entries), depth)
        return (
            None
            if any(not isinstance(k, Const) for k in (*a.entries, *b.entries))
            else _same_constants(a.entries, b.entries)
        )
    if kinds[0] == "set" and a.items is not None and b.items is not None:
        return _same_constants(a.items, b.items) if all(isinstance(k, Const) for k in (*a.items, *b.items)) else None
    return None


def _series(machine: Machine, left: Series, right: Series, depth: int) -> bool | None:
    """Two lists, of which one may have any number of elements in the middle."""
    if left.exact and right.exact:
        return _sequences(machine, left.head, right.head, depth)
    short = any(a.exact and len(a.head) < b.least for a, b in ((left, right), (right, left)))
    ends = [(left.head, right.head)]
    ends.append(((left.head if left.exact else left.tail)[::-1], (right.head if right.exact else right.tail)[::-1]))
    differ = any(
        equal(machine, a, b, depth - 1) is False for one, other in ends for a, b in zip(one, other, strict=False)
    )
    return False if short or differ else None


def _same_constants(
    left: tuple[Value, ...] | dict[Value, Value], right: tuple[Value, ...] | dict[Value, Value]
) -> bool | None:
    """Whether keys that are constants are the same; where keys of dicts are, the values decide."""
    a, b = ({k.value for k in keys if isinstance(k, Const)} for keys in (left, right))
    return False if a != b else (None if isinstance(left, dict) else True)


def _instances(machine: Machine, left: Value, right: Value) -> bool | None:
    if left == right:
        return None if isinstance(left, Ref) and machine.obj(left).many else True
    classes = [machine.obj(v).cls for v in (left, right) if isinstance(v, Ref) and machine.obj(v).kind == "instance"]
    plain_objects = all(
        isinstance(c, Class) and all(isinstance(b, Class) for b in c.mro) and not has_equality(machine, c)
        for c in classes
    )
    return (
        False
        if classes and plain_objects and not isinstance(left, External) and not isinstance(right, External)
        else None
    )


# Membership


def contains(machine: Machine, container: Value, item: Value) -> tuple[bool | None, Origins]:
    """item in container, and what that depends on beyond the two."""
    if isinstance(container, (Const, Text)):
        return _in_text(container, item), frozenset()
    if isinstance(container, Tuple):
        return _among(machine, container.items, None, item), frozenset()
    if isinstance(container, Range):
        numbers, number = range_of(container), int_of(item)
        if number is None or numbers is None:
            return (False if text_of(item) is not None or item == NONE else None), frozenset()
        return number in numbers, frozenset()
    if not isinstance(container, Ref):
        return None, frozenset()
    obj = machine.obj(container)
    shown = obj.attrs.get(VIEWED)
    if isinstance(shown, Tuple) and shown.items[1] == KEYS and isinstance(shown.items[0], Ref):
        obj = machine.obj(shown.items[0])
    if obj.kind in ("list", "set"):
        series = Series(obj.payload.items) if obj.payload.__class__ is Shuffled else obj.series()
        items = (*series.head, *series.tail)
        return _among(machine, items, series.middle, item), origins(*items)
    if obj.kind == "dict":
        sure = tuple(k for k in obj.entries if k not in obj.maybe)
        if _among(machine, sure, None, item) is True:
            return True, frozenset()
        rest = None if obj.rest is None else obj.rest_key or Unknown(())
        answer = _among(machine, tuple(obj.entries), rest, item)
        return (None if answer else answer), frozenset()
    return None, frozenset()


def _among(machine: Machine, items: tuple[Value, ...], rest: Value | None, item: Value) -> bool | None:
    if len(items) > MAX_COMPARED:
        return None
    machine.spend(len(items) // _COMPARED_A_STEP)
    answers = {equal(machine, item, other) for other in items}
    if True in answers:
        return True
    if rest is not None and equal(machine, item, rest) is not False:
        return None
    return None if None in answers else False


def _in_text(container: Value, item: Value) -> bool | None:
    if isinstance(container, Const) and not isinstance(container.value, str):
        if not isinstance(item, Const):
            return None
        return bool(run(operator.contains, container.value, item.value))
    if isinstance(item, (Const, Tuple)) and text_of(item) is None:
        raise Raised("TypeError", "'in <string>' requires string as left operand")
    if not isinstance(item, (Const, Text)):
        return None
    wanted = [p for p in parts_of(item) if isinstance(p, str)]
    if isinstance(container, Const):
        whole = str(container.value)
        found = all(p in whole for p in wanted)
        return found if isinstance(item, Const) or not found else None
    inside = isinstance(item, Const) and any(isinstance(p, str) and str(item.value) in p for p in parts_of(container))
    return True if inside else None
