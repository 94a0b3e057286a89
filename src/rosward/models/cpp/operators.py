# SPDX-License-Identifier: Apache-2.0
"""What do the operators of C++ give for values that are no objects of classes of the program?

7 / 2           3                       name + '/' + 'x'        a text
c - '0'         a number                path / "x"              a text with one slash between
it != v.end()   whether it is there     p == nullptr            False, where p is a pointer

What is not known gives an unknown value of the right type.
"""

from __future__ import annotations

import math
import operator
from collections.abc import Callable
from functools import partial
from typing import Final

from rosward.domain.choice import join_all, options
from rosward.domain.compound import BoundMethod, External, Native, Partial, Tuple
from rosward.domain.slots import Overloads, Pointer, Slot, is_char_text
from rosward.domain.text import concat
from rosward.domain.values import FALSE, NONE, TRUE, Class, Const, Function, Ref, Text, Unknown, Value
from rosward.models.cpp.iteration.iterators import as_iterator, distance, in_pairs, iterator, moved, same_place
from rosward.models.cpp.strings import streams
from rosward.models.cpp.strings.paths import slash
from rosward.models.cpp.strings.stream_input import extract
from rosward.models.cpp.values import chrono
from rosward.models.cpp.values.characters import beside_text, is_text, number_of
from rosward.models.cpp.values.conversions import NULLOPT, is_empty_optional
from rosward.models.cpp.values.slots import key_of, read
from rosward.models.cpp.values.types import Shape, name_of, shape_of
from rosward.models.native import Machine
from rosward.models.python.comparing.compare import kind_of
from rosward.models.python.operators import operators as python
from rosward.models.python.plain import from_python, operation, origins, spread, text_of, unknown_from

__all__ = ["binary", "compare", "truth", "unary"]

_WRAP: Final = 2**64
_WIDEST: Final = 128
_CALLABLE: Final = (Function, BoundMethod, Partial, Overloads, Native)
_COMPARISONS: Final = frozenset(("==", "!=", "<", "<=", ">", ">=", "<=>"))
_MIRRORED: Final = {"<": ">", "<=": ">=", ">": "<", ">=": "<=", "==": "==", "!=": "!="}
_ORDER: Final[dict[str, Callable[..., bool]]] = {
    "==": operator.eq, "!=": operator.ne, "<": operator.lt, "<=": operator.le, ">": operator.gt, ">=": operator.ge,
}  # fmt: skip


# Arithmetic


def binary(machine: Machine, op: str, left: Value, right: Value) -> Value:
    """left op right."""
    if op in _COMPARISONS:
        return compare(machine, op, left, right)
    if op == "<<" and streams.is_output(machine, read(machine, left)):
        return streams.insert(machine, left, right)
    if op == ">>" and streams.is_input(machine, read(machine, left)):
        return extract(machine, left, right)
    if op == ",":  # the second, unless the first may be of a class that nobody knows
        firsts = options(read(machine, left))
        strange = [o for o in firsts if isinstance(o, (Unknown, External)) and not kind_of(machine, o)]
        return unknown_from(machine, ",", "", *strange) if strange else read(machine, right)
    return _computed(machine, op, read(machine, left), read(machine, right))


@operation
def _computed(machine: Machine, op: str, left: Value, right: Value) -> Value:
    if op == "+":
        left, right = beside_text(machine, left, right)
        if all(is_text(o) for v in (left, right) for o in options(v)):
            return python.binary(machine, "+", left, right)
    return spread(lambda a, b: _one(machine, op, a, b), left, right)


def _one(machine: Machine, op: str, left: Value, right: Value) -> Value:
    if op in ("&&", "and", "||", "or"):
        return _both(machine, op in ("&&", "and"), left, right)
    if chrono.is_time(machine, left) or chrono.is_time(machine, right):
        return chrono.binary(machine, op, left, right)
    left, right = _decayed(machine, left), _decayed(machine, right)
    if as_iterator(left) is not None or as_iterator(right) is not None:
        return _of_iterators(machine, op, left, right)
    if is_text(left) or is_text(right):
        return _of_texts(machine, op, left, right)
    if isinstance(left, Const) and isinstance(right, Const) and NONE not in (left, right):
        return _numbers(machine, op, left, right)
    return unknown_from(machine, op, _hint(machine, op, left, right), left, right)


def _decayed(machine: Machine, value: Value) -> Value:
    """An array as a pointer to its first element."""
    is_array = isinstance(value, Ref) and name_of(machine.obj(value).cls) == "array"
    return iterator(value, Const(0)) if is_array else value


def _both(machine: Machine, every: bool, left: Value, right: Value) -> Value:
    answers = (truth(machine, left), truth(machine, right))
    if (not every) in answers:
        return Const(not every)
    return unknown_from(machine, "&&", "bool", left, right) if None in answers else Const(every)


def _of_iterators(machine: Machine, op: str, left: Value, right: Value) -> Value:
    if op == "-" and as_iterator(left) is not None and as_iterator(right) is not None:
        return distance(machine, right, left)
    if op == "-" and as_iterator(left) is not None:
        return moved(machine, left, _one(machine, "-", Const(0), right))
    if op == "+":
        return moved(machine, left, right) if as_iterator(left) is not None else moved(machine, right, left)
    return unknown_from(machine, op, "", left, right)


def _of_texts(machine: Machine, op: str, left: Value, right: Value) -> Value:
    """A string, a pointer to characters or a single character, and another operand."""
    if op == "/":
        return slash(machine, left, right)
    if op == "+" and is_text(left) and is_text(right):
        return concat((left, right))
    points = is_char_text(left) or is_char_text(right)  # at characters: it moves, also where one is left
    a, b = number_of(left), number_of(right)
    if a is not None and b is not None and not points:
        return _numbers(machine, op, a, b)
    if op != "+":
        return unknown_from(machine, op, "int", left, right)
    value, other = (left, right) if is_text(left) else (right, left)
    if isinstance(other, External) or (isinstance(other, Unknown) and not other.hint):  # a text most likely
        return concat((left, right))
    return _moved(machine, value, other)


def _moved(machine: Machine, value: Value, other: Value) -> Value:
    """A text and a number: a pointer into characters moves by it."""
    text, number = text_of(value), other.value if isinstance(other, Const) else None
    if text is not None and isinstance(number, int) and 0 <= number <= len(text):
        return Const(type(text)(text[number:]), origins(value, other))
    return unknown_from(machine, "+", "str" if text is not None and len(text) != 1 else "", value, other)


def _numbers(machine: Machine, op: str, left: Const, right: Const) -> Value:
    a, b = left.value, right.value
    source = origins(left, right)
    if not isinstance(a, (bool, int, float)) or not isinstance(b, (bool, int, float)):
        return unknown_from(machine, op, "", left, right)
    result: float | int | None
    if isinstance(a, float) or isinstance(b, float):
        result = _of_floats(op, a, b)
    else:
        result = _of_wholes(op, int(a), int(b))
    if result is None:
        return unknown_from(
            machine, op, "float" if isinstance(a, float) or isinstance(b, float) else "int", left, right
        )
    if isinstance(result, int) and result >= _WRAP and (a >= _WRAP // 2 or b >= _WRAP // 2):
        result -= _WRAP  # `npos + 1` is 0
    return from_python(machine, result, source, op)


def _of_floats(op: str, a: float, b: float) -> float | None:
    """A number, or None where there is no such operator."""
    try:
        left, right = float(a), float(b)
    except OverflowError:
        return None
    if op == "/" and right == 0:
        return math.nan if left == 0 or math.isnan(left) else math.copysign(math.inf, left) * math.copysign(1, right)
    function = _FLOATS.get(op)
    return None if function is None else function(left, right)


def _of_wholes(op: str, a: int, b: int) -> int | None:
    """A number, or None where C++ leaves it open."""
    if op in ("/", "%"):
        if b == 0:
            return None
        quotient = abs(a) // abs(b) * (1 if (a < 0) == (b < 0) else -1)
        return quotient if op == "/" else a - quotient * b
    if op in ("<<", ">>"):
        if not 0 <= b < _WIDEST or abs(a) >= 2**_WIDEST:
            return None
        return a << b if op == "<<" else a >> b
    function = _WHOLE.get(op)
    return None if function is None else function(a, b)


_FLOATS: Final[dict[str, Callable[[float, float], float]]] = {
    "+": operator.add, "-": operator.sub, "*": operator.mul, "/": operator.truediv,
}  # fmt: skip
_WHOLE: Final[dict[str, Callable[[int, int], int]]] = {
    "+": operator.add, "-": operator.sub, "*": operator.mul, "&": operator.and_, "|": operator.or_, "^": operator.xor,
}  # fmt: skip


def _hint(machine: Machine, op: str, left: Value, right: Value) -> str:
    kinds = {kind_of(machine, left), kind_of(machine, right)}
    if not kinds <= {"int", "bool", "float"}:
        return "str" if kinds == {"str"} and op == "+" else ""
    return "float" if "float" in kinds else "int"


def unary(machine: Machine, op: str, value: Value) -> Value:
    """op value."""
    return spread(lambda v: _unary(machine, op, v), read(machine, value))


def _unary(machine: Machine, op: str, value: Value) -> Value:
    if op in ("!", "not"):
        decided = truth(machine, value)
        if isinstance(value, Const) and value != NONE:
            return Const(not (value.value != "\0" if isinstance(value.value, str) else value.value), value.origins)
        return unknown_from(machine, "!", "bool", value) if decided is None else Const(not decided)
    if chrono.is_time(machine, value):
        return chrono.unary(machine, op, value)
    number = number_of(value)
    if number is not None and isinstance(number.value, (bool, int, float)):
        plain = number.value
        if op == "+":
            return Const(+plain, number.origins)
        if op == "-":
            return Const(-plain, number.origins)
        if op in ("~", "compl") and not isinstance(plain, float):
            return Const(~int(plain), number.origins)
    hint = kind_of(machine, value)
    return unknown_from(machine, op, hint if hint in ("int", "float") else "", value)


# Comparisons


def compare(machine: Machine, op: str, left: Value, right: Value) -> Value:
    """left op right."""
    return _compared(machine, op, read(machine, left), read(machine, right))


@operation
def _compared(machine: Machine, op: str, left: Value, right: Value) -> Value:
    pairs = in_pairs(*beside_text(machine, left, right))
    return join_all(spread(partial(_compare, machine, op), a, b) for a, b in pairs)


def _compare(machine: Machine, op: str, left: Value, right: Value) -> Value:
    if op == "<=>":
        return _spaceship(machine, left, right)
    if chrono.is_time(machine, left) and chrono.is_time(machine, right):
        return chrono.compare(machine, op, left, right)
    for one, other, turned in ((left, right, op), (right, left, _MIRRORED[op])):
        if other == NULLOPT or (_is_optional(machine, one) and not _is_optional(machine, other)):
            return _with_optional(machine, turned, one, other)
    if isinstance(left, (Pointer, *_CALLABLE)) or isinstance(right, (Pointer, *_CALLABLE)):
        return _pointers(machine, op, left, right)
    a, b = number_of(left), number_of(right)
    both_texts = is_text(left) and is_text(right)
    if a is not None and b is not None and not both_texts:
        return _compared_numbers(op, a, b)
    if NONE in (left, right) and (is_text(left) or is_text(right)):
        return _known(machine, op, _null_text(left, right), left, right)
    if isinstance(left, Ref) and isinstance(right, Ref):
        return _objects(machine, op, left, right)
    return python.compare(machine, op, left, right)


def _known(machine: Machine, op: str, equal: bool | None, left: Value, right: Value) -> Value:
    """The answer to == or !=, by whether they are equal."""
    if equal is None or op not in ("==", "!="):
        return unknown_from(machine, op, "bool", left, right)
    return Const(equal is (op == "=="), origins(left, right))


def _null_text(left: Value, right: Value) -> bool | None:
    """A pointer to characters and nullptr: a text that is known is somewhere."""
    other = right if left == NONE else left
    return None if isinstance(other, Unknown) else False


def _compared_numbers(op: str, left: Const, right: Const) -> Value:
    a, b = left.value, right.value
    assert isinstance(a, (bool, int, float))
    assert isinstance(b, (bool, int, float))
    if isinstance(a, int) and isinstance(b, int):  # beside the largest `size_t`, -1 is that number
        a = a + _WRAP if a < 0 and b >= _WRAP // 2 else a
        b = b + _WRAP if b < 0 and a >= _WRAP // 2 else b
        a, b = int(a), int(b)  # an operator asks for no type
    return Const(_ORDER[op](a, b), origins(left, right))


def _spaceship(machine: Machine, left: Value, right: Value) -> Value:
    for op, result in (("<", -1), ("==", 0), (">", 1)):
        answer = _compare(machine, op, left, right)
        if answer == TRUE:
            return Const(result)
        if answer != FALSE:
            break
    return unknown_from(machine, "<=>", "int", left, right)


def _is_optional(machine: Machine, value: Value) -> bool:
    return isinstance(value, Ref) and shape_of(machine.obj(value).cls) is Shape.OPTIONAL


def _with_optional(machine: Machine, op: str, optional: Value, other: Value) -> Value:
    """An optional and a value, or `nullopt`: nothing is less than anything."""
    empty = is_empty_optional(machine, optional)
    if other == NULLOPT or (isinstance(other, Const) and other == NONE):
        if empty is None:
            return unknown_from(machine, op, "bool", optional)
        return Const({"==": empty, "!=": not empty, "<": False, ">": not empty, "<=": empty, ">=": True}[op])
    if empty is None:
        return unknown_from(machine, op, "bool", optional, other)
    if empty or not isinstance(optional, Ref):
        return Const(op in ("!=", "<", "<="))
    held = machine.obj(optional).series().at(0)
    return unknown_from(machine, op, "bool", optional) if held is None else machine.compare(op, held, other)


def _pointers(machine: Machine, op: str, left: Value, right: Value) -> Value:
    first, second = as_iterator(left), as_iterator(right)
    if first is not None and second is not None:
        if op in ("==", "!="):
            return _known(machine, op, same_place(machine, first, second), left, right)
        return machine.compare(op, distance(machine, right, left), Const(0))
    return _known(machine, op, _same_target(machine, left, right), left, right)


def _same_target(machine: Machine, left: Value, right: Value) -> bool | None:
    if NONE in (left, right):
        return left == right
    if isinstance(left, Pointer) and isinstance(right, Pointer):
        a, b = left.target, right.target
        if isinstance(a, Ref) and isinstance(b, Ref):
            return (None if machine.obj(a).many else True) if a == b else False
        if isinstance(a, Slot) and isinstance(b, Slot) and a.base != b.base:
            return None if isinstance(a.base, Slot) or isinstance(b.base, Slot) else False
        if isinstance(a, Slot) and isinstance(b, Slot) and a == b:
            many = isinstance(a.base, Ref) and machine.obj(a.base).many
            return None if many else True
    return None


def _objects(machine: Machine, op: str, left: Ref, right: Ref) -> Value:
    """Containers, pairs and tuples: element by element."""
    a, b = machine.obj(left), machine.obj(right)
    if isinstance(a.cls, Class) or isinstance(b.cls, Class) or a.kind not in ("list", "set", "instance", "dict"):
        return python.compare(machine, op, left, right)
    if a.kind == "dict" or b.kind == "dict":
        return python.compare(machine, op, left, right)
    if op in ("==", "!=") and a.kind == b.kind == "list":
        answer = _alike(machine, left, right)
        return _known(machine, op, answer, left, right)
    one, other = key_of(machine, left), key_of(machine, right)
    if isinstance(one, Tuple) and isinstance(other, Tuple):
        return python.compare(machine, op, one, other)
    return unknown_from(machine, op, "bool", left, right)


def _alike(machine: Machine, left: Ref, right: Ref) -> bool | None:
    """Whether two lists have the same elements, as `operator==` of these says."""
    if machine.obj(left).many or machine.obj(right).many:
        return None  # each stands for several, and may be inside of itself
    ours, theirs = machine.obj(left).series(), machine.obj(right).series()
    if not ours.exact or not theirs.exact:
        short = any(a.exact and len(a.head) < b.least for a, b in ((ours, theirs), (theirs, ours)))
        return False if short else None
    if len(ours.head) != len(theirs.head):
        return False
    machine.spend(len(ours.head) // 2)
    answers = {machine.truth(machine.compare("==", a, b)) for a, b in zip(ours.head, theirs.head, strict=True)}
    return False if False in answers else None if None in answers else True


# Truth


def truth(machine: Machine, value: Value) -> bool | None:
    """Whether a value counts as true in a condition; None where it is not known."""
    answers = {_truth(machine, option) for option in options(read(machine, value))}
    return answers.pop() if len(answers) == 1 else None


def _truth(machine: Machine, value: Value) -> bool | None:
    if isinstance(value, Const):
        if python.is_default(value.origins):
            return None
        return value.value != "\0" if isinstance(value.value, str) else bool(value.value)
    if isinstance(value, (Pointer, *_CALLABLE)):
        return True
    if value == NULLOPT:
        return False
    if isinstance(value, Ref):
        obj = machine.obj(value)
        if shape_of(obj.cls) is Shape.OPTIONAL:
            empty = is_empty_optional(machine, value)
            return None if empty is None else not empty
        if shape_of(obj.cls) is Shape.STREAM:
            return streams.is_good(machine, value)
        return None
    return True if isinstance(value, Text) and not python.is_default(value.origins) else None
