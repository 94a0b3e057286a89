# SPDX-License-Identifier: Apache-2.0
"""Operators, truth and iteration of values of builtin types (special methods of instances are the engine's).

'a' + unknown               Text('a', hole)
['a'] + names               a new list
2 ** 10 ** 9                unknown: beyond the limit
"""

from __future__ import annotations

import functools
import operator
from collections.abc import Callable
from typing import Final

from rosward.domain.choice import join, options
from rosward.domain.compound import External, Native, Range, Tuple
from rosward.domain.series import Series, concatenated, joined
from rosward.domain.text import concat, make, parts_of
from rosward.domain.unknown import Cause, Origins
from rosward.domain.values import Choice, Class, Const, Ref, Text, Unknown, Value
from rosward.models.native import Items, Machine
from rosward.models.python.comparing.compare import compare, contains, equal, kind_of
from rosward.models.python.containers import dicts
from rosward.models.python.containers.any_order import once, places
from rosward.models.python.containers.list_alternatives import elements_apart, keep_told
from rosward.models.python.containers.sets import FROZEN, combine, distinct
from rosward.models.python.containers.views import renewed
from rosward.models.python.operators.items import load_item, store_item
from rosward.models.python.plain import (
    MAX_ITEMS,
    Fresh,
    Raised,
    affordable,
    from_python,
    int_of,
    join_items,
    operation,
    origins,
    range_of,
    run,
    spread,
    spread_fresh,
    text_of,
    truth_const,
    unknown_from,
    with_origins,
)
from rosward.models.python.strings import text_choices
from rosward.models.python.strings.formatting import too_wide
from rosward.models.python.strings.percent import percent, percent_one

__all__ = [
    "binary",
    "compare",
    "contains",
    "equal",
    "iterate",
    "load_item",
    "percent",
    "series",
    "store_item",
    "truth",
    "unary",
]

MAX_RANGE: Final = 1_000
MAX_REPEAT: Final = 1_000
_PYTHON: Final[dict[str, Callable[..., object]]] = {
    "+": operator.add, "-": operator.sub, "*": operator.mul, "/": operator.truediv,
    "//": operator.floordiv, "%": operator.mod,
    "**": operator.pow, "<<": operator.lshift, ">>": operator.rshift,
    "&": operator.and_, "|": operator.or_, "^": operator.xor,
    "@": operator.matmul,
}  # fmt: skip
_UNARY: Final[dict[str, Callable[..., object]]] = {"-": operator.neg, "+": operator.pos, "~": operator.invert}
_WHOLE: Final = ("int", "bool")
_NUMBERS: Final = frozenset({*_WHOLE, "float"})
_SEQUENCES: Final = ("str", "bytes", "list", "tuple")
_BUILTIN: Final = frozenset({*_SEQUENCES, "dict", "set", "int", "float", "NoneType"})
"""Types of which it is known which operators take them."""


@operation
def binary(machine: Machine, op: str, left: Value, right: Value) -> Value:
    """left op right."""
    if op == "+" and Choice in (left.__class__, right.__class__) and _are_texts(left) and _are_texts(right):
        left, right = text_choices.bounded(machine, (left, right))
    result = spread_fresh(machine, ("operator", op), lambda a, b: _binary(machine, op, a, b), left, right)
    if op == "+" and isinstance(result, Ref):
        keep_told(machine, result, (elements_apart(machine, left), elements_apart(machine, right)))
    return result


def _are_texts(value: Value) -> bool:
    """Whether each alternative is a text, known or not."""
    return all(
        isinstance(o, Text) or text_of(o) is not None or (isinstance(o, Unknown) and o.hint == "str")
        for o in options(value)
    )


def _binary(machine: Machine, op: str, left: Value, right: Value) -> Value | Fresh:
    if op == "%" and (isinstance(left, Text) or text_of(left) is not None):
        return percent_one(machine, left, right)
    if isinstance(left, Const) and isinstance(right, Const):
        return _constants(machine, op, left, right)
    kinds = (kind_of(machine, left), kind_of(machine, right))
    if op == "%" and kinds[0] in ("str", "bytes"):
        return unknown_from(machine, op, kinds[0], left, right)
    if op == "+" and "str" in kinds:
        return _texts(machine, left, right, kinds)
    if op == "*" and (kinds[0] in _SEQUENCES or kinds[1] in _SEQUENCES):
        sequence, times = (left, right) if kinds[0] in _SEQUENCES else (right, left)
        return _repeated(machine, sequence, times)
    if op == "+" and (kind := _sequence_kind(left, right, kinds)):
        return _sequences(machine, left, right, kind)
    if op in "|&-^" and isinstance(left, Ref) and isinstance(right, Ref) and {*kinds} <= {"set", "dict", "list"}:
        return _collections(machine, op, left, right, kinds)
    if kinds[0] in _BUILTIN and kinds[1] in _BUILTIN and _surely_wrong(left, right, kinds):
        raise Raised("TypeError", f"unsupported operand type(s) for {op}: '{kinds[0]}' and '{kinds[1]}'")
    return unknown_from(machine, op, _hint(op, kinds), left, right)


def _sequence_kind(left: Value, right: Value, kinds: tuple[str, str]) -> str:
    """Of which kind a concatenation is; what is added to a list, and of no known type, is one too."""
    known = {kind for kind, value in zip(kinds, (left, right), strict=True) if kind or not isinstance(value, Unknown)}
    return known.pop() if len(known) == 1 and known <= {"list", "tuple"} else ""


def _surely_wrong(left: Value, right: Value, kinds: tuple[str, str]) -> bool:
    """Whether the types are known for sure, and no operator takes both."""
    return kinds[0] != kinds[1] and not isinstance(left, Unknown) and not isinstance(right, Unknown)


def _hint(op: str, kinds: tuple[str, str]) -> str:
    """The type of a result of which only the types of the operands are known."""
    if kinds[0] not in _NUMBERS or kinds[1] not in _NUMBERS:
        return kinds[0] if kinds[0] == kinds[1] and op == "+" and kinds[0] in _SEQUENCES else ""
    if op == "/" or "float" in kinds:
        return "float"
    return "" if op == "**" else "int"


def _constants(machine: Machine, op: str, left: Const, right: Const) -> Value:
    a, b = left.value, right.value
    wide = isinstance(a, bytes) and op == "%" and (b"*" in a or too_wide(a.decode("latin-1")))
    if wide or not affordable(machine, op, (a, b)):
        return machine.unknown(
            Cause.LIMIT, op, a.__class__.__name__ if not isinstance(b, (str, bytes)) else b.__class__.__name__
        )
    return from_python(machine, run(_PYTHON[op], a, b), origins(left, right), op)


def _texts(machine: Machine, left: Value, right: Value, kinds: tuple[str, str]) -> Value:
    """left + right where one of them is a text."""
    other, kind = (right, kinds[1]) if kinds[0] == "str" else (left, kinds[0])
    if kind == "str" or (kind == "" and isinstance(other, Unknown)):
        return concat((left, right))
    if isinstance(other, Unknown) or kind in ("", "instance"):
        return unknown_from(machine, "+", "str" if kind else "", left, right)
    raise Raised("TypeError", f'can only concatenate str (not "{kind}") to str')


def _repeated(machine: Machine, sequence: Value, times: Value) -> Value | Fresh:
    number, kind = int_of(times), kind_of(machine, sequence)
    if isinstance(times, Const) and number is None:
        raise Raised("TypeError", f"can't multiply sequence by non-int of type '{times.value.__class__.__name__}'")
    if isinstance(sequence, Text) and number is not None and number <= 64:
        return make(parts_of(sequence) * number, origins(sequence, times))
    if kind in ("str", "bytes") or isinstance(sequence, Unknown):
        return unknown_from(machine, "*", kind, sequence, times)
    found = series(machine, sequence)
    if number is None or max(1, found.least) * number > MAX_REPEAT:
        return _new_sequence(kind, found.loose())
    return _new_sequence(kind, concatenated([found] * number))


def _sequences(machine: Machine, left: Value, right: Value, kind: str) -> Value | Fresh:
    if isinstance(left, Unknown) and isinstance(right, Unknown):
        return unknown_from(machine, "+", kind, left, right)
    return _new_sequence(kind, concatenated((series(machine, left), series(machine, right))))


def _new_sequence(kind: str, found: Series) -> Value | Fresh:
    exact = kind == "tuple" and found.exact and len(found.head) <= MAX_ITEMS
    return Tuple(found.head) if exact else Fresh("list", kind, found)


def _collections(machine: Machine, op: str, left: Ref, right: Ref, kinds: tuple[str, str]) -> Value | Fresh:
    """Sets (and the keys and items of dicts, which we hold as lists), and dict | dict."""
    if op == "|" and kinds == ("dict", "dict"):
        made = dicts.copy(machine, left)
        dicts.merge(machine, made, right)
        return made
    if "dict" in kinds or kinds == ("list", "list"):
        return unknown_from(machine, op, "", left, right)
    items = combine(machine, op, iterate(machine, left), iterate(machine, right))
    return Fresh("set", "frozenset" if machine.obj(left).cls == FROZEN else "set", Series(*distinct(machine, items)))


@operation
def unary(machine: Machine, op: str, value: Value) -> Value:
    """op value."""
    return spread(lambda v: _unary(machine, op, v), value)


def _unary(machine: Machine, op: str, value: Value) -> Value:
    if op == "not":
        answer = truth_const(machine, value, "not")
        return Const(not answer.value, answer.origins) if isinstance(answer, Const) else answer
    if isinstance(value, Const):
        return from_python(machine, run(_UNARY[op], value.value), value.origins, op)
    if isinstance(value, (Text, Tuple)):
        raise Raised("TypeError", f"bad operand type for unary {op}")
    hint = kind_of(machine, value)
    return unknown_from(machine, op, hint if hint in ("int", "float") else "", value)


# Truth


def truth(machine: Machine, value: Value) -> bool | None:
    """The truth of a value; None where both are possible, and for what was computed from a mere default."""
    if value.__class__ is not Choice:
        return _truth(machine, value)
    answers = {_truth(machine, option) for option in value.options}
    return answers.pop() if len(answers) == 1 else None


def _truth(machine: Machine, value: Value) -> bool | None:
    if isinstance(value, Const):
        return None if is_default(value.origins) else bool(value.value)
    if isinstance(value, Text):
        return None if is_default(value.origins) else True
    if isinstance(value, Tuple):
        return bool(value.items)
    if isinstance(value, Range):
        numbers = range_of(value) if value.step != Const(0) else None
        return None if numbers is None or is_default(origins(value)) else bool(numbers)
    if isinstance(value, Ref):
        return _object_truth(machine, value)
    return None if isinstance(value, (Unknown, External)) else True


def is_default(source: Origins) -> bool:
    """Whether a value stems from a default that someone may change."""
    return bool(source) and any(not o.settled for o in source)


def _object_truth(machine: Machine, ref: Ref) -> bool | None:
    obj = machine.obj(ref)
    if obj.kind in ("list", "set") and obj.items is not None:
        return bool(obj.items)
    if obj.kind in ("list", "set"):
        return (True if obj.ends is not None else None) if obj.rest is not None else False
    if obj.kind == "dict":
        if any(k not in obj.maybe for k in obj.entries):
            return True
        return None if obj.entries or obj.rest is not None else False
    if obj.kind == "instance":
        known = isinstance(obj.cls, Class) and all(isinstance(b, (Class, Native)) for b in obj.cls.mro)
        return True if known else None
    return True


# Iteration


def iterate(machine: Machine, value: Value) -> Items:
    """What iterating over a value of builtin type yields; nothing where that raises."""
    several: list[Items] = []
    failure: Raised | None = None
    for option in options(value):
        try:
            several.append(_iterate(machine, option))
        except Raised as raised:  # noqa: PERF203 - one alternative that fails must not end the others
            failure = failure or raised
    if not several:
        if failure is not None:
            machine.die(failure.error, failure.message)
        return Items(())
    return join_items(several)


def _iterate(machine: Machine, value: Value) -> Items:
    if isinstance(value, Tuple):
        return Items(value.items)
    if isinstance(value, Ref):
        return _iterate_object(machine, value)
    if isinstance(value, Range):
        return _iterate_range(machine, value)
    if isinstance(value, Const):
        if not isinstance(value.value, (str, bytes)):
            raise Raised("TypeError", f"'{value.value.__class__.__name__}' object is not iterable")
        if len(value.value) > MAX_RANGE:
            return Items((), unknown_from(machine, "iteration", "str" if isinstance(value.value, str) else "int"))
        return Items(tuple(Const(c, value.origins) for c in value.value))
    if isinstance(value, Text):
        return Items((), with_origins(unknown_from(machine, "iteration", "str", value), value.origins))
    if isinstance(value, Unknown):
        return Items((), Unknown(value.reasons, "str" if value.hint == "str" else ""))
    return Items((), unknown_from(machine, "iteration", "", value))


def _iterate_object(machine: Machine, ref: Ref) -> Items:
    obj = renewed(machine, ref)
    if obj.kind in ("list", "set"):
        series = once(obj)
        return Items(series.head, series.behind_head())
    if obj.kind == "dict":
        return dicts.keys(machine, obj)
    return Items((), unknown_from(machine, "iteration", "", ref))


def series(machine: Machine, value: Value) -> Series:
    """What iterating over a value yields, as far as the order is known."""
    found: list[Series] = []
    for option in options(value):
        if isinstance(option, Tuple):
            found.append(Series(option.items))
        elif isinstance(option, Ref) and machine.obj(option).kind in ("list", "set"):
            found.append(places(renewed(machine, option)))
        elif isinstance(option, Ref) and machine.obj(option).rest is not None:
            return Series(*machine.iterate(value)).loose()  # where the unknown keys of a dict stand, nobody knows
        else:
            return Series(*machine.iterate(value))
    return functools.reduce(lambda a, b: joined(a, b, join), found)


def _iterate_range(machine: Machine, value: Range) -> Items:
    numbers = range_of(value)
    if numbers is None:
        return Items((), unknown_from(machine, "range", "int", *value.fields()))
    if len(numbers[: MAX_RANGE + 1]) > MAX_RANGE:
        return Items((), machine.unknown(Cause.LIMIT, "range", "int"))
    source = origins(value)
    return Items(tuple(Const(n, source) for n in numbers))
