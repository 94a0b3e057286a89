# SPDX-License-Identifier: Apache-2.0
"""Operators: the special methods of instances first, then what the builtin types do, for each alternative."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.domain.choice import join, join_all, options
from rosward.domain.compound import BoundMethod, External, Native, Partial, Tuple
from rosward.domain.heap import Obj
from rosward.domain.unknown import Cause
from rosward.domain.values import (
    FALSE,
    NONE,
    TRUE,
    UNBOUND,
    Choice,
    Class,
    Const,
    Function,
    ModuleValue,
    Ref,
    Text,
    Unknown,
    Value,
)
from rosward.engine.calls.alternatives import each_apart
from rosward.engine.python import attributes, members, specials, stepping
from rosward.engine.python.assignment import is_replaced
from rosward.engine.python.specials import one_has, special
from rosward.models.interfaces import NO_INTERFACE, is_known_interface, same_interface
from rosward.models.python.builtins.attributes import is_open
from rosward.models.python.comparing.equal_objects import OF_OBJECT, compares
from rosward.models.python.comparing.kinds import names_kind
from rosward.models.python.containers.lists import ITERATOR
from rosward.models.python.contents import bare, contents
from rosward.models.python.operators import operators

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

__all__ = ["binary", "compare", "join_all", "may", "truth", "unary"]

_BINARY: Final = {
    "+": "add", "-": "sub", "*": "mul", "/": "truediv", "//": "floordiv", "%": "mod", "**": "pow", "@": "matmul",
    "&": "and", "|": "or", "^": "xor", "<<": "lshift", ">>": "rshift",
}  # fmt: skip
_COMPARE: Final = {"==": "eq", "!=": "ne", "<": "lt", "<=": "le", ">": "gt", ">=": "ge"}
_REFLECTED: Final = {"lt": "gt", "le": "ge", "gt": "lt", "ge": "le"}
_ORDERS: Final = ("__lt__", "__le__", "__gt__", "__ge__")
_UNARY: Final = {"-": "neg", "+": "pos", "~": "invert"}
_COMPARED: Final = frozenset(
    Native(f"builtins.{name}")
    for name in ("int", "str", "float", "complex", "bytes", "bytearray", "list", "tuple", "dict", "set", "frozenset")
)
"""Builtins with a `!=` of their own."""
_CALLABLE: Final = (Function, Class, Native, BoundMethod, Partial, ModuleValue)


def binary(machine: Engine, operator: str, left: Value, right: Value, *, inplace: bool) -> Value:
    """left operator right."""
    if _several_objects(machine, left):
        return each_apart(machine, options(left), lambda o: binary(machine, operator, o, right, inplace=inplace))
    if left.__class__ is not Ref and _several_objects(machine, right):
        return each_apart(machine, options(right), lambda o: binary(machine, operator, left, o, inplace=inplace))
    if left.__class__ is Ref or right.__class__ is Ref:
        name = _BINARY[operator]
        if inplace:
            made = specials.first_of(machine, [(left, f"__i{name}__", right)])
            if made is not None and not specials.refused(made):
                return made
            if operator == "+" and left.__class__ is Ref and machine.obj(left).kind == "list":
                machine.call(BoundMethod(left, Native("list.extend")), (right,))
                return left
            if operator == "|" and left.__class__ is Ref and machine.obj(left).kind in ("dict", "set"):
                machine.call(attributes.load(machine, left, "update"), (right,))
                return left
        tries = [(left, f"__{name}__", right), (right, f"__r{name}__", left)]
        if specials.goes_first(machine, left, right, f"__r{name}__"):
            tries.reverse()
        made = specials.first_of(machine, tries)
        if made is not None:
            return (
                machine.unknown(Cause.ERROR, f"unsupported operand for {operator}") if specials.refused(made) else made
            )
        left, right = bare(machine, left), bare(machine, right)
        formats = operator == "%" and left.__class__ is not Ref  # str % object
        if not formats and (_is_instance_object(machine, left) or _is_instance_object(machine, right)):
            return machine.unknown(Cause.OPERATION, operator)
    return operators.binary(machine, operator, left, right)


def _several_objects(machine: Engine, value: Value) -> bool:
    """Whether a value is one of several, among them an object whose class may say what an operator does."""
    return value.__class__ is Choice and any(
        o.__class__ is Ref and machine.obj(o).kind == "instance" and machine.obj(o).cls.__class__ is Class
        for o in value.options
    )


def _is_instance_object(machine: Engine, value: Value) -> bool:
    return value.__class__ is Ref and machine.obj(value).kind in ("instance", "generator")


def compare(machine: Engine, operator: str, left: Value, right: Value) -> Value:
    """left operator right."""
    if operator in ("is", "is-not"):
        return _identity(machine, operator, left, right)
    if _several_objects(machine, left):
        return each_apart(machine, options(left), lambda o: compare(machine, operator, o, right))
    if left.__class__ is not Ref and _several_objects(machine, right):
        return each_apart(machine, options(right), lambda o: compare(machine, operator, left, o))
    name = _COMPARE.get(operator)
    if name is not None and (left.__class__ in (Ref, Class) or right.__class__ in (Ref, Class)):
        reflected = f"__{_REFLECTED.get(name, name)}__"
        tries = [(left, f"__{name}__", right), (right, reflected, left)]
        if specials.goes_first(machine, left, right, reflected):
            tries.reverse()
        made = specials.first_of(machine, tries)
        if made is not None and not specials.refused(made):
            return made
        if operator == "!=" and made is None:  # without `__ne__`, the contrary of `__eq__`
            sides = [
                (one, "__eq__", other) for one, other in ((left, right), (right, left)) if not _has_ne(machine, one)
            ]
            made = specials.first_of(machine, sides)
            if made is not None and not specials.refused(made):
                return unary(machine, "not", made)
        left, right = bare(machine, left), bare(machine, right)
        if operator in ("==", "!=") and _same(machine, left, right) is not None and not _plain(machine, left):
            same = _same(machine, left, right)
            if same or (_asks_no_code(machine, left) and _asks_no_code(machine, right)):
                return TRUE if same is (operator == "==") else FALSE
            return machine.unknown(Cause.OPERATION, operator, "bool")
    if operator in ("in", "not-in"):
        method = special(machine, right, "__contains__")
        if method is not None:
            answer = truth(machine, machine.call(method, (left,)))
            if answer is None:
                return machine.unknown(Cause.OPERATION, operator, "bool")
            return TRUE if answer is (operator == "in") else FALSE
        if _is_asked_for_each(machine, left, right):
            found = machine.call(machine.load_attr(machine.load_module("_lazy"), "contains"), (right, left))
            return found if operator == "in" else unary(machine, "not", found)
    return operators.compare(machine, operator, bare(machine, left), bare(machine, right))


def _is_taken_from(machine: Engine, container: Value) -> bool:
    """Whether `in` takes items from an iterator, up to the one that is looked for: whoever asks again sees those that are left."""
    if container.__class__ is Ref and machine.obj(container).payload == ITERATOR:
        return True
    return contents(machine, container) is None and stepping.is_followed(machine, container)


def _is_asked_for_each(machine: Engine, item: Value, container: Value) -> bool:
    """Whether `in` asks for one element after the other: of an iterator, or because `==` runs code of the program."""
    if _is_taken_from(machine, container):
        return True
    if container.__class__ is Tuple:
        items = container.items
    elif container.__class__ is Ref and machine.obj(container).kind == "list":
        series = machine.obj(container).series()
        items = (*series.head, *series.tail, *(() if series.middle is None else (series.middle,)))
    else:
        return False
    return any(compares(machine, option) for value in (item, *items) for option in options(value))


def _has_ne(machine: Engine, value: Value) -> bool:
    """Whether an object inherits the `!=` of a builtin: then its `__eq__` has no say in that."""
    cls = machine.obj(value).cls if value.__class__ is Ref else None
    return cls.__class__ is Class and any(base in _COMPARED for base in cls.mro)


def _by_identity(machine: Engine, value: Value) -> bool:
    """A value that surely compares by identity: no `__eq__` but that of `object`, no base or decorator that may give one."""
    if value.__class__ is not Ref:
        return value.__class__ in (Class, Function)
    cls = machine.obj(value).cls
    if cls.__class__ is not Class or is_open(machine, cls):
        return False
    own = members.lookup(machine, cls, "__eq__")
    return own == OF_OBJECT or (
        own is None and not any(b.__class__ is not Class or (b.stub and not _is_enum(b)) for b in cls.mro)
    )


def _is_enum(base: Class) -> bool:
    """Whether a class is one of those of which enumerations without other bases derive: their members are the same or differ."""
    return base.module == "enum" and base.name in ("Enum", "Flag")


def _asks_no_code(machine: Engine, value: Value) -> bool:
    """Whether `==` with another object is False, as far as this one has a say: no `__eq__` of it takes objects of other types."""
    return _by_identity(machine, value) or value.__class__ in (Text, Tuple) or _plain(machine, value)


def _plain(machine: Engine, value: Value) -> bool:
    """A value that compares by content."""
    return value.__class__ is Const or (value.__class__ is Ref and machine.obj(value).kind in ("list", "dict", "set"))


def _same(machine: Engine, left: Value, right: Value) -> bool | None:
    """Whether both are one object; None where that is not known."""
    if left.__class__ is Ref and right.__class__ is Ref:
        if left == right:
            return None if machine.obj(left).many else True
        return False
    if left.__class__ in (Unknown, External, Choice) or right.__class__ in (Unknown, External, Choice):
        if left.__class__ is External and right.__class__ is External:
            return True if left == right else same_interface(machine, left, right)
        external, other = (left, right) if left.__class__ is External else (right, left)
        apart = _is_private(machine, other) or (
            isinstance(other, (*NO_INTERFACE, Ref)) and is_known_interface(machine, external)
        )
        return False if external.__class__ is External and apart else None
    if left.__class__ is Const and right.__class__ is Const:
        if not (left.is_settled and right.is_settled):
            return None
        if left.value.__class__ is not right.value.__class__:
            return False
        return bool(left.value == right.value)
    if left.__class__ is not right.__class__:
        return None if names_kind(left, right) else False
    if left == right:  # `node.tick is node.tick` makes two objects, of which each is itself
        return None if left.__class__ in (BoundMethod, Partial, Tuple) else True
    return None if left.__class__ not in (Class, Function, Native) else False


_OBJECT: Final = Native("builtins.object")


def _is_private(machine: Engine, value: Value) -> bool:
    """Whether a value is an `object()` by which a model tells that there is nothing: no library has it."""
    return (
        value.__class__ is Ref and value.address < machine.library.first_address and machine.obj(value).cls == _OBJECT
    )


def _identity(machine: Engine, operator: str, left: Value, right: Value) -> Value:
    answers = {_same(machine, a, b) for a in options(left) for b in options(right)}
    if len(answers) == 1 and None not in answers:
        return TRUE if answers.pop() is (operator == "is") else FALSE
    return machine.unknown(Cause.OPERATION, operator, "bool")


def unary(machine: Engine, operator: str, value: Value) -> Value:
    """operator value."""
    if operator == "not":
        decided = truth(machine, value)
        if decided is None:
            if all(o.__class__ is Const for o in options(value)):  # of a default, it is that of a default
                return operators.unary(machine, operator, value)
            return machine.unknown(Cause.OPERATION, "not", "bool")
        return FALSE if decided else TRUE
    name = f"__{_UNARY[operator]}__"
    if one_has(machine, value, name):
        return each_apart(machine, options(value), lambda o: unary(machine, operator, o))
    method = special(machine, value, name)
    if method is not None:
        return machine.call(method, ())
    return operators.unary(machine, operator, bare(machine, value))


def _says_truth(machine: Engine, value: Value) -> Value | None:
    """The method that is asked for the truth of an object, or of a class of a metaclass."""
    return next((m for n in ("__bool__", "__len__") if (m := special(machine, value, n)) is not None), None)


def truth(machine: Engine, value: Value) -> bool | None:
    """The truth of a value; None where both are possible."""
    if value.__class__ is Const:
        return bool(value.value) if value.is_settled else None
    if value.__class__ in _CALLABLE:
        if value.__class__ in (Function, BoundMethod):
            return None if is_replaced(machine, value) else True
        method = _says_truth(machine, value) if value.__class__ is Class else None
        return True if method is None else truth(machine, machine.call(method, ()))
    if value.__class__ is Choice:
        answers: set[bool | None] = set()

        def one(option: Value) -> Value:
            answers.add(truth(machine, option))
            return NONE

        if one_has(machine, value, "__bool__", "__len__"):
            each_apart(machine, value.options, one)
        else:
            answers.update(truth(machine, o) for o in value.options)
        return answers.pop() if len(answers) == 1 else None
    if value.__class__ is Ref:
        obj: Obj = machine.obj(value)
        if obj.kind == "instance":
            method = _says_truth(machine, value)
            if method is not None:
                answer = machine.call(method, ())
                return None if answer is value else truth(machine, answer)
            held = contents(machine, value)
            if held is not None:
                return truth(machine, held)
            return True if obj.cls.__class__ is Class and not has_unknown_base(obj.cls) else None
    if value is UNBOUND:
        return None
    return operators.truth(machine, value)


def has_unknown_base(cls: Class) -> bool:
    """Whether a class inherits from something that is neither among the sources nor modelled."""
    return any(base.__class__ in (External, Unknown) for base in cls.mro)


def may(machine: Engine, value: Value, test: str, other: Value | None, sense: bool) -> bool:
    """Whether a test may come out as `sense` for one alternative of a value."""
    if value.__class__ is not Ref or machine.obj(value).kind != "instance":
        return _may(machine, value, test, other, sense)
    before = machine.state
    machine.state = before.copy()  # the test was made already: what a method of the object does is not done again
    try:
        return _may(machine, value, test, other, sense)
    finally:
        machine.state = before


def _may(machine: Engine, value: Value, test: str, other: Value | None, sense: bool) -> bool:
    if test == "true":
        answer = truth(machine, value)
    elif test == "isinstance":
        answer = machine.is_instance(value, other) if other is not None else None
    elif other is None or (test == "in" and any(_is_taken_from(machine, o) for o in options(other))):
        answer = None
    elif value.__class__ is Const and other.__class__ is Const and test in ("is", "=="):
        answer = _equal_constants(value, other)
    elif test in ("<", ">") and _says_order(machine, value):
        answer = None  # `>=`, which stands here as what is not `<`, has a method of its own
    else:
        answer = truth(machine, compare(machine, test, value, other))
    return answer is None or answer is sense


def _says_order(machine: Engine, value: Value) -> bool:
    """Whether a method that somebody wrote compares an object; of a member of `IntEnum`, that of `int` does."""
    methods = [o for name in _ORDERS if (m := special(machine, value, name)) is not None for o in options(m)]
    return any(not isinstance(m, BoundMethod) or m.function.__class__ is not Native for m in methods)


def _equal_constants(left: Const, right: Const) -> bool | None:
    if not (left.is_settled and right.is_settled):
        return None
    return bool(left.value == right.value) and (left.value is not None or right.value is None)


def either(left: Value, right: Value) -> Value:
    """One of two values."""
    return join(left, right)
