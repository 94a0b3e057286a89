# SPDX-License-Identifier: Apache-2.0
"""A machine that is just enough for the natives of the standard library: a heap, plain operations, what it was told."""

from __future__ import annotations

import operator
from collections.abc import Callable, Iterable, Mapping, Sequence

from models.fake_process import FakeProcess
from rosward.domain.choice import options
from rosward.domain.compound import Native, Partial, Range, Tuple
from rosward.domain.heap import Obj, fields_of
from rosward.domain.series import Series
from rosward.domain.unknown import Cause
from rosward.domain.values import FALSE, NONE, TRUE, UNBOUND, Class, Const, Function, Ref, Text, Unknown, Value
from rosward.models.native import Items, NativeCall, NativeFunction, perform
from rosward.models.python.std import arguments as std_arguments
from rosward.models.python.std import data as std_data
from rosward.models.python.std import enums as std_enum
from rosward.models.python.std import files as std_files
from rosward.models.python.std import functional as std_functional
from rosward.models.python.std import named_tuples as std_named_tuples
from rosward.models.python.std import numbers as std_numbers
from rosward.models.python.std import objects as std_objects
from rosward.models.python.std import paths as std_paths
from rosward.models.python.std import processes as std_process
from rosward.models.python.std import records as std_records
from rosward.models.python.std import texts as std_text

TABLES = (
    std_arguments.NATIVES,
    std_data.NATIVES,
    std_enum.NATIVES,
    std_files.NATIVES,
    std_functional.NATIVES,
    std_named_tuples.NATIVES,
    std_numbers.NATIVES,
    std_objects.NATIVES,
    std_paths.NATIVES,
    std_process.NATIVES,
    std_records.NATIVES,
    std_text.NATIVES,
)
_OPERATORS: dict[str, Callable[..., object]] = {
    "+": operator.add,
    "-": operator.sub,
    "*": operator.mul,
    "|": operator.or_,
    "&": operator.and_,
    "%": operator.mod,
}
_COMPARISONS: dict[str, Callable[..., object]] = {
    "==": operator.eq,
    "!=": operator.ne,
    "<": operator.lt,
    ">": operator.gt,
}


class FakeMachine(FakeProcess):
    """Keeps objects in a dict; records findings, deaths and schedules."""

    def __init__(self) -> None:
        super().__init__()
        self.findings: list[tuple[str, str]] = []
        self.deaths: list[tuple[str, str]] = []
        self.scheduled: list[Value] = []

    # What natives use

    def call_native(self, name: str, args: Sequence[Value], keywords: Mapping[str, Value] | None = None) -> Value:
        return self.call(Native(name), args, keywords)

    def call(self, function: Value, args: Sequence[Value], keywords: Mapping[str, Value] | None = None) -> Value:
        if isinstance(function, Partial):
            merged = {**dict(function.keywords), **(keywords or {})}
            return self.call(function.function, (*function.arguments, *args), merged)
        if function in self.functions:
            return self.functions[function](*args, **(keywords or {}))
        if function == Native("builtins.iter"):
            return args[0]
        if function == Native("builtins.int") and isinstance(args[0], Const):
            return Const(int(str(args[0].value)))
        if function == Native("builtins.tuple"):
            return self.unknown(Cause.OPERATION, "tuple", "tuple")
        if isinstance(function, Native):
            return self.native(function.name, *args, **(keywords or {}))
        if isinstance(function, Class):
            instance = self.allocate(Obj("instance", function))
            self.call(self.heap[function.address].attrs["__init__"], (instance, *args), keywords)
            return instance
        return self.unknown(Cause.CALL, repr(function))

    def load_attr(self, value: Value, name: str) -> Value:
        if isinstance(value, Native):  # a module
            return Native(f"{value.name}.{name}")
        assert isinstance(value, Ref)
        obj = self.heap[value.address]
        if name in obj.attrs:
            return obj.attrs[name]
        assert isinstance(obj.cls, Class), name
        return self.heap[obj.cls.address].attrs[name]

    def store_attr(self, target: Value, name: str, value: Value) -> None:
        assert isinstance(target, (Ref, Class))
        self.heap[target.address] = self.heap[target.address].with_attr(name, value)

    def load_item(self, value: Value, index: Value) -> Value:
        assert isinstance(index, Const)
        if isinstance(value, Tuple):
            return value.items[int(str(index.value))]
        assert isinstance(value, Ref)
        obj = self.heap[value.address]
        return obj.entries[index] if obj.kind == "dict" else (obj.items or ())[int(str(index.value))]

    def store_item(self, target: Value, index: Value, value: Value) -> None:
        assert isinstance(target, Ref)
        assert isinstance(index, Const)
        obj = self.heap[target.address]
        items = list(obj.items or ())
        items[int(str(index.value))] = value
        self.heap[target.address] = obj.replace(items=tuple(items))

    def binary(self, operator: str, left: Value, right: Value) -> Value:
        if isinstance(left, Const) and isinstance(right, Const):
            return Const(_OPERATORS[operator](left.value, right.value))  # type: ignore[arg-type]
        return self.unknown(Cause.OPERATION, operator)

    def compare(self, operator: str, left: Value, right: Value) -> Value:
        if isinstance(left, Tuple) and isinstance(right, Tuple) and operator == "==":
            return TRUE if left == right else FALSE
        if isinstance(left, Const) and isinstance(right, Const):
            return Const(bool(_COMPARISONS[operator](left.value, right.value)))
        return self.unknown(Cause.OPERATION, operator, "bool")

    def series(self, value: Value) -> Series:
        return Series(*self.iterate(value))

    def iterate(self, value: Value) -> Items:
        if isinstance(value, Tuple):
            return Items(value.items)
        if isinstance(value, Const) and isinstance(value.value, str):
            return Items(tuple(map(Const, value.value)))
        if isinstance(value, Range):
            bounds = [int(str(v.value)) for v in (value.start, value.stop, value.step) if isinstance(v, Const)]
            return Items(tuple(map(Const, range(*bounds))))
        if isinstance(value, Ref):
            obj = self.heap[value.address]
            if obj.kind == "dict":
                return Items(tuple(obj.entries), obj.rest_key)
            return Items(obj.items or (), obj.rest)
        return Items((), value if isinstance(value, Unknown) else self.unknown(Cause.OPERATION, "iteration"))

    def truth(self, value: Value) -> bool | None:
        if isinstance(value, Const) and not value.origins:
            return bool(value.value)
        return None if isinstance(value, (Unknown, Text, Const)) else True

    def is_instance(self, value: Value, classes: Value) -> bool | None:
        return None if value is classes else False

    def is_subclass(self, cls: Value, wanted: Value) -> bool | None:
        return None if cls is wanted else False

    def new_list(self, items: Iterable[Value], rest: Value | None = None, tail: tuple[Value, ...] = ()) -> Ref:
        middle = None if rest is UNBOUND else rest
        return self.allocate(Obj("list", NONE, **fields_of(Series(tuple(items), middle, tail))))

    def new_set(self, items: Iterable[Value], rest: Value | None = None) -> Ref:
        return self.allocate(Obj("set", NONE, items=tuple(items), rest=rest))

    def new_dict(self, entries: Mapping[Value, Value], rest: Value | None = None) -> Ref:
        return self.allocate(Obj("dict", NONE, entries=dict(entries), rest=rest))

    def escape(self, values: Iterable[Value], library: str, callee: Value | None = None) -> None:  # noqa: ARG002
        self.scheduled.extend(v for v in values if isinstance(v, Function) and library)

    def schedule(self, callback: Value, args: Sequence[Value], event: str, *, answered: Value | None = None) -> None:
        assert answered is None
        assert event, args
        self.scheduled.append(callback)

    def spin(self, *, serving: bool = False) -> None:  # noqa: ARG002
        self.scheduled.clear()

    def waits(self, *, suspended: bool = False, others: bool = False) -> None:
        """No thread spins beside it."""

    def report(self, code: str, message: str, causes: tuple[str, ...] = ()) -> None:  # noqa: ARG002
        self.findings.append((code, message))

    def die(self, error: str, message: str, args: object = None, *, sure: bool = False, plain: bool = False) -> Value:  # noqa: ARG002
        self.deaths.append((error, message))
        return UNBOUND

    # What tests use

    def native(self, name: str, /, *args: Value, **keywords: Value) -> Value:
        """Call a native by its dotted name."""
        table: dict[str, NativeFunction] = {}
        for one in TABLES:
            table.update(one)
        return perform(table[name], NativeCall(self, name, args, keywords))

    def cls(self, name: str, attrs: Mapping[str, Value], *bases: Value, stub: bool = False) -> Class:
        """A class of the program with these attributes."""
        where = self.allocate(Obj("class", NONE, dict(attrs)))
        mro: list[Value] = []
        for base in bases:
            mro.extend(base.mro if isinstance(base, Class) else (base,))
        module = "enum" if stub else "demo"
        return Class(where.address, name, name, module, tuple(bases), tuple(mro), self.place, stub)

    def plain(self, value: Value) -> object:
        """A readable form: constants as they are, containers by content, `?` for unknown."""
        if isinstance(value, Const):
            return value.value
        if isinstance(value, Tuple):
            return tuple(self.plain(v) for v in value.items)
        if isinstance(value, Text):
            return "".join(p if isinstance(p, str) else "*" for p in value.parts)
        if isinstance(value, Ref):
            obj = self.heap[value.address]
            if obj.kind == "list":
                return [
                    *(self.plain(v) for v in obj.items or ()),
                    *(() if obj.rest is None else ("...", self.plain(obj.rest))),
                ]
            if obj.kind == "dict":
                return {self.plain(k): self.plain(v) for k, v in obj.entries.items()}
            return {k: self.plain(v) for k, v in obj.attrs.items() if not k.startswith("_")}
        if len(options(value)) > 1:
            return {self.plain(o) for o in options(value)}
        return "?" if isinstance(value, Unknown) else value
