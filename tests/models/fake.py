# SPDX-License-Identifier: Apache-2.0
"""A machine that is just enough for the natives of builtins, and which Python objects a value stands for."""

from __future__ import annotations

import builtins
from collections.abc import Callable, Iterable, Mapping, Sequence

from models.fake_process import FakeProcess
from rosward.domain.choice import options
from rosward.domain.compound import BoundMethod, Native, Range, Tuple
from rosward.domain.heap import Obj, ObjKind, fields_of
from rosward.domain.series import Series
from rosward.domain.text import make, matches
from rosward.domain.unknown import NO_ORIGINS, Cause, Origins, Reason
from rosward.domain.values import UNBOUND, Class, Const, Hole, Ref, Text, Unknown, Value
from rosward.location import Place
from rosward.models.native import Items, NativeCall, NativeFunction, perform
from rosward.models.python.builtins import attributes as builtin_attributes
from rosward.models.python.builtins import constructors as builtin_constructors
from rosward.models.python.builtins import functions as builtin_functions
from rosward.models.python.builtins import sequences as builtin_sequences
from rosward.models.python.builtins import specials as builtin_specials
from rosward.models.python.builtins.constructors import type_of
from rosward.models.python.containers import dicts, views
from rosward.models.python.containers import lists as containers_list
from rosward.models.python.containers import sets as containers_set
from rosward.models.python.operators import operators
from rosward.models.python.std import files as std_files
from rosward.models.python.strings import methods as strings

NATIVES: dict[str, NativeFunction] = {
    **builtin_attributes.NATIVES,
    **builtin_constructors.NATIVES,
    **builtin_functions.NATIVES,
    **builtin_sequences.NATIVES,
    **builtin_specials.NATIVES,
    **dicts.NATIVES,
    **views.NATIVES,
    **containers_list.NATIVES,
    **containers_set.NATIVES,
    **std_files.NATIVES,
    **strings.NATIVES,
}
REASON = Reason(Cause.PARAMETER, "p", Place("demo.py", 1))


def is_subclass(cls: Value, wanted: Value) -> bool | None:
    """issubclass(cls, wanted) of classes of Python; None where that is not known."""
    if isinstance(wanted, Tuple):
        answers = [is_subclass(cls, w) for w in wanted.items]
        return True if True in answers else (None if None in answers else False)
    if isinstance(cls, Native) and isinstance(wanted, Native):
        ours, theirs = (getattr(builtins, c.name.removeprefix("builtins."), None) for c in (cls, wanted))
        return issubclass(ours, theirs) if isinstance(ours, type) and isinstance(theirs, type) else None
    if isinstance(cls, Class) and isinstance(wanted, (Class, Native)):
        known = all(isinstance(b, (Class, Native)) for b in cls.mro)
        return True if wanted in cls.mro or wanted == Native("builtins.object") else False if known else None
    return True if cls == wanted else None


class FakeMachine(FakeProcess):
    """Keeps objects in a dict; records findings and deaths; calls natives and the Python functions it was given."""

    def __init__(self) -> None:
        super().__init__()
        self.findings: list[str] = []
        self.deaths: list[str] = []
        self.escaped: list[Value] = []

    def function(self, name: str, python: Callable[..., Value]) -> Value:
        value = Native(name)
        self.functions[value] = python
        return value

    def native(self, name: str, *args: Value, **keywords: Value) -> Value:
        return perform(NATIVES[name], NativeCall(self, name, args, keywords))

    def call_native(self, name: str, args: Sequence[Value], keywords: Mapping[str, Value] | None = None) -> Value:
        return self.call(Native(name), args, keywords)

    def call(self, function: Value, args: Sequence[Value], keywords: Mapping[str, Value] | None = None) -> Value:
        if isinstance(function, BoundMethod):
            return self.call(function.function, (function.receiver, *args), keywords)
        if function in self.functions:
            return self.functions[function](*args, **(keywords or {}))
        if isinstance(function, Native) and function.name in NATIVES:
            return self.native(function.name, *args, **(keywords or {}))
        return self.unknown(Cause.CALL, "call")

    def load_attr(self, value: Value, name: str) -> Value:
        if not isinstance(value, Ref):
            return self.unknown(Cause.OPERATION, name)
        obj = self.heap[value.address]
        found = obj.attrs.get(name)
        if found is None:
            for base in getattr(obj.cls, "mro", ()):
                inherited = self.heap[base.address].attrs.get(name)
                if inherited is not None:
                    return BoundMethod(value, inherited)
        return self.die("AttributeError", name) if found is None else found

    def store_attr(self, target: Value, name: str, value: Value) -> None:
        if not isinstance(target, Ref):
            return
        self.heap[target.address] = self.heap[target.address].with_attr(name, value)

    def load_item(self, value: Value, index: Value) -> Value:
        return operators.load_item(self, value, index)

    def store_item(self, target: Value, index: Value, value: Value) -> None:
        operators.store_item(self, target, index, value)

    def binary(self, operator: str, left: Value, right: Value) -> Value:
        return operators.binary(self, operator, left, right)

    def compare(self, operator: str, left: Value, right: Value) -> Value:
        return operators.compare(self, operator, left, right)

    def iterate(self, value: Value) -> Items:
        return operators.iterate(self, value)

    def series(self, value: Value) -> Series:
        return operators.series(self, value)

    def truth(self, value: Value) -> bool | None:
        return operators.truth(self, value)

    def is_instance(self, value: Value, classes: Value) -> bool | None:
        answers = {is_subclass(type_of(self, v), classes) for v in options(value)}
        return answers.pop() if len(answers) == 1 else None

    def is_subclass(self, cls: Value, wanted: Value) -> bool | None:
        answers = {is_subclass(c, wanted) for c in options(cls)}
        return answers.pop() if len(answers) == 1 else None

    def new_list(self, items: Iterable[Value], rest: Value | None = None, tail: tuple[Value, ...] = ()) -> Ref:
        return self._sequence("list", Series(tuple(items), rest, tail))

    def new_set(self, items: Iterable[Value], rest: Value | None = None) -> Ref:
        return self._sequence("set", Series(tuple(dict.fromkeys(items)), rest))

    def _sequence(self, kind: ObjKind, series: Series) -> Ref:
        return self.allocate(Obj(kind, Native(f"builtins.{kind}"), **fields_of(series, kind)))

    def new_dict(self, entries: Mapping[Value, Value], rest: Value | None = None) -> Ref:
        return self.allocate(Obj("dict", Native("builtins.dict"), entries=dict(entries), rest=rest))

    def escape(self, values: Iterable[Value], library: str, callee: Value | None = None) -> None:  # noqa: ARG002
        self.escaped.extend(values)

    def schedule(self, callback: Value, args: Sequence[Value], event: str, *, answered: Value | None = None) -> None:
        assert answered is None
        raise AssertionError((callback, args, event))

    def spin(self, *, serving: bool = False) -> None:
        raise AssertionError(serving)

    def waits(self, *, suspended: bool = False, others: bool = False) -> None:
        """No thread spins beside it."""

    def report(self, code: str, message: str, causes: tuple[str, ...] = ()) -> None:  # noqa: ARG002
        self.findings.append(code)

    def die(self, error: str, message: str, args: object = None, *, sure: bool = False, plain: bool = False) -> Value:  # noqa: ARG002
        self.deaths.append(error)
        return UNBOUND


def abstract(machine: FakeMachine, value: object, origins: Origins = NO_ORIGINS) -> Value:
    """The exact abstract value of a Python object."""
    if isinstance(value, list):
        return machine.new_list([abstract(machine, v) for v in value])
    if isinstance(value, tuple):
        return Tuple(tuple(abstract(machine, v) for v in value))
    if isinstance(value, (set, frozenset)):
        return machine.new_set([abstract(machine, v) for v in sorted(value, key=repr)])
    if isinstance(value, dict):
        return machine.new_dict({abstract(machine, k): abstract(machine, v) for k, v in value.items()})
    if isinstance(value, range):
        return Range(Const(value.start), Const(value.stop), Const(value.step))
    assert value is None or isinstance(value, (bool, int, float, complex, str, bytes))
    return Const(value, origins)


def text(*parts: str | Hole) -> Value:
    """A text; `*` stands for a hole."""
    return make(Hole((REASON,)) if p == "*" else p for p in parts)


def covers(machine: FakeMachine, value: Value, concrete: object) -> bool:
    """Whether an abstract value stands, among others, for a Python object."""
    return any(_covers(machine, option, concrete) for option in options(value))


def _covers(machine: FakeMachine, value: Value, concrete: object) -> bool:
    if isinstance(value, Unknown):
        return value.hint in ("", concrete.__class__.__name__)
    if isinstance(value, Text):
        return isinstance(concrete, str) and matches(value, concrete)
    if isinstance(value, Const):
        same = value.value.__class__ is concrete.__class__ and value.value == concrete
        return same or repr(value.value) == repr(concrete) == "nan"
    if isinstance(value, Tuple):
        return isinstance(concrete, tuple) and _each(machine, value.items, concrete)
    if isinstance(value, Range):
        ends = [e.value for e in value.fields() if isinstance(e, Const)]
        return isinstance(concrete, range) and concrete == range(*(e for e in ends if isinstance(e, int)))
    assert isinstance(value, Ref), value
    return _covers_object(machine, machine.obj(value), concrete)


def _covers_object(machine: FakeMachine, obj: Obj, concrete: object) -> bool:
    if isinstance(concrete, dict):
        return obj.kind == "dict" and _covers_dict(machine, obj, concrete)
    if isinstance(concrete, (set, frozenset)):
        if obj.kind != "set":
            return False
        if obj.items is None:
            return all(obj.rest is not None and covers(machine, obj.rest, c) for c in concrete)
        return len(obj.items) == len(concrete) and all(any(covers(machine, v, c) for v in obj.items) for c in concrete)
    if obj.kind != "list" or not isinstance(concrete, (list, tuple)):
        return False
    return series_covers(machine, obj.series(), concrete)


def series_covers(machine: FakeMachine, series: Series, concrete: Sequence[object]) -> bool:
    """Whether a series stands, among others, for these objects in their order."""
    if series.middle is None:
        return _each(machine, series.head, concrete)
    begin, end = len(series.head), len(concrete) - len(series.tail)
    return (
        begin <= end
        and _each(machine, series.head, concrete[:begin])
        and _each(machine, series.tail, concrete[end:])
        and all(covers(machine, series.middle, c) for c in concrete[begin:end])
    )


def _covers_dict(machine: FakeMachine, obj: Obj, concrete: dict[object, object]) -> bool:
    seen = []
    for key, value in concrete.items():
        known = next((k for k in obj.entries if isinstance(k, Const) and k.value == key), None)
        if known is not None:
            seen.append(known)
            if not covers(machine, obj.entries[known], value):
                return False
        elif (
            obj.rest is None
            or not covers(machine, obj.rest, value)
            or (obj.rest_key is not None and not covers(machine, obj.rest_key, key))
        ):
            return False
    return all(k in obj.maybe or k in seen for k in obj.entries)


def _each(machine: FakeMachine, values: Sequence[Value], concrete: Sequence[object]) -> bool:
    return len(values) == len(concrete) and all(covers(machine, v, c) for v, c in zip(values, concrete, strict=True))
