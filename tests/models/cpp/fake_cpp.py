# SPDX-License-Identifier: Apache-2.0
"""A machine that is just enough for the natives of C++, and how tests call them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from models.fake import FakeMachine
from rosward.domain.compound import External, Partial, Tuple
from rosward.domain.heap import Obj
from rosward.domain.slots import Slot, TypeOf
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, Const, Ref, Value
from rosward.models.cpp import operators
from rosward.models.cpp.values.slots import read
from rosward.models.cpp.values.types import method_types, name_of
from rosward.models.native import NativeCall, perform
from rosward.models.tables import cpp_natives

NATIVES = cpp_natives()
STRING = External("std.string")
INT = TypeOf("int", ())


class CppMachine(FakeMachine):
    """Calls natives by their names, and the Python functions that it was given; notes what is thrown."""

    def __init__(self) -> None:
        super().__init__()
        self.thrown: list[str] = []
        self.scheduled: list[Value] = []
        self.is_tried = False
        self.language_name = "c++"

    def call(self, function: Value, args: Sequence[Value], keywords: Mapping[str, Value] | None = None) -> Value:
        if isinstance(function, Partial):
            return self.call(function.function, (*function.arguments, *args), keywords)
        if isinstance(function, (External, TypeOf)):
            name = name_of(function)
            types = {"types": Tuple(function.arguments)} if isinstance(function, TypeOf) else {}
            if name in NATIVES:
                return perform(NATIVES[name], NativeCall(self, name, tuple(args), {**types, **(keywords or {})}))
            if f"{name}.new" in NATIVES:
                return perform(NATIVES[f"{name}.new"], NativeCall(self, f"{name}.new", (function, *args), {}))
            if name.endswith(("_error", "_range", "_argument", "_access")):
                return Const(name)
        return super().call(function, args, keywords)

    def throw(self, exception: Value) -> None:
        self.thrown.append(str(getattr(exception, "value", exception)).removeprefix("std."))

    def schedule(self, callback: Value, args: Sequence[Value], event: str, *, answered: Value | None = None) -> None:
        assert event == "thread"
        assert answered is None
        self.scheduled.append(Partial(callback, tuple(args), ()))

    def binary(self, operator: str, left: Value, right: Value) -> Value:
        return operators.binary(self, operator, left, right)

    def compare(self, operator: str, left: Value, right: Value) -> Value:
        return operators.compare(self, operator, left, right)

    def truth(self, value: Value) -> bool | None:
        return operators.truth(self, value)

    # What tests write

    def variable(self, value: Value) -> Slot:
        """The slot of a new variable."""
        return Slot(self.allocate(Obj("cell", NONE, {"value": value}), len(self.heap)), "cell", None)

    def function_of(self, name: str, *args: Value, types: tuple[Value, ...] = ()) -> Value:
        """std::name<types>(args)."""
        return self.call(TypeOf(f"std.{name}", types) if types else External(f"std.{name}"), args)

    def method(self, receiver: Value, name: str, *args: Value) -> Value:
        """receiver.name(args)."""
        held = read(self, receiver)
        place = held if isinstance(held, Ref) else receiver
        for type_ in method_types(self, held):
            if f"{type_}.{name}" in NATIVES:
                return perform(NATIVES[f"{type_}.{name}"], NativeCall(self, f"{type_}.{name}", (place, *args), {}))
        return self.unknown(Cause.CALL, name)


def const(value: str | float | None) -> Const:
    return Const(value)
