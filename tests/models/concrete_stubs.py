# SPDX-License-Identifier: Apache-2.0
"""Runs the bodies of stubs as the plain Python that they are, with effects recorded: they must be right as Python."""

from __future__ import annotations

import builtins
import importlib
import types
from collections.abc import Callable
from pathlib import Path
from typing import Any, Final

import rosward.domain
from models.fake_std import FakeMachine
from rosward.domain.choice import options, reasons_of
from rosward.domain.unknown import NO_ORIGINS
from rosward.domain.values import Value
from rosward.models.python.std.support import NotKnown, from_plain, to_plain

STUBS: Final = Path(rosward.domain.__file__).parent.parent / "models" / "stubs"


class Unknown(str):
    """Something that is not known: a text that names its subject, so that text operations go on."""

    __slots__ = ()

    def __iter__(self) -> Any:
        return iter([self])

    def __call__(self, *_: object, **__: object) -> Unknown:
        return self

    def __getitem__(self, _: object) -> Unknown:
        return self


class Default:
    """A value that is only the default."""

    def __init__(self, name: str, value: object) -> None:
        self.name = name
        self.value = value

    def __repr__(self) -> str:
        return f"default {self.name}={self.value!r}"


class Either:
    """One of several."""

    def __init__(self, *values: object) -> None:
        flat: list[object] = []
        for value in values:
            flat.extend(value.values if isinstance(value, Either) else (value,))
        self.values: tuple[object, ...] = tuple(flat)

    def __call__(self, *args: object, **keywords: object) -> object:
        return either(*(v(*args, **keywords) for v in self.values if callable(v)))

    def __repr__(self) -> str:
        return " or ".join(map(repr, self.values))


def either(*values: object) -> object:
    found = Either(*values).values
    return found[0] if len(found) == 1 else Either(*found)


class Stubs:
    """The stubs as modules of plain Python."""

    def __init__(self, **natives: Callable[..., object]) -> None:
        self.natives = natives
        self.modules: dict[str, types.ModuleType] = {}
        self.scheduled: list[tuple[Callable[..., object], tuple[object, ...], str]] = []
        self.spins = 0
        self.machine = FakeMachine()

    def load(self, name: str) -> types.ModuleType:
        if name in self.modules:
            return self.modules[name]
        inner = name.replace(".", "/")
        path = next((p for p in (STUBS / f"{inner}.pyi", STUBS / inner / "__init__.pyi") if p.is_file()), None)
        if path is None:
            raise ImportError(name)
        module = self.modules[name] = types.ModuleType(name)
        module.__dict__["__builtins__"] = {**vars(builtins), "__import__": self._import}
        module.__dict__["__getattr__"] = lambda attr: getattr(importlib.import_module(name), attr)  # a public native
        exec(compile(path.read_text(encoding="utf-8"), str(path), "exec"), module.__dict__)
        return module

    def _import(
        self, name: str, _globals: object = None, _locals: object = None, names: Any = (), _level: int = 0
    ) -> Any:
        if name.partition(".")[0] == "_rosward":
            return types.SimpleNamespace(
                environment=lambda _name: None,
                unset=lambda _name: False,
                changes=lambda *_names: lambda function: function,
                removed=lambda _name: False,
                variable=lambda _name: None,
                set_variable=lambda _name, _value: None,
                write_file=lambda _path, _text: None,
                replaced=lambda _source, _target: None,
                native=self._native,
                unknown=lambda cause, subject, hint="": Unknown(f"?{subject}") if cause and hint is not None else None,
                default=lambda _kind, name, value: Default(name, value),
                either=either,
                contents=lambda value: value,
                beside=lambda: None,
                schedule=lambda function, *args, event="timer": self.scheduled.append((function, args, event)),
                spin=self._spin,
                escape=lambda *_: None,
                ask=lambda *_: None,
                tried=lambda: False,
                waits=lambda marked: marked,
                reads_only=lambda marked: marked,
                pure=lambda marked: marked,
                stops=lambda marked: marked,
                sink=lambda *_: lambda marked: marked,
                source=lambda *_: lambda marked: marked,
                raises_nothing=lambda marked: marked,
                register=lambda *_: None,
                spins=lambda function: function,
            )
        found = self.load(name)
        return found if names else self.load(name.partition(".")[0])

    def _spin(self) -> None:
        self.spins += 1

    def _native(self, function: Callable[..., object]) -> Callable[..., object]:
        name = f"{function.__module__ if function.__module__ != 'builtins' else ''}.{function.__name__}"
        if function.__name__ in self.natives:
            return self.natives[function.__name__]

        def call(*args: object) -> object:
            given = [from_plain(self.machine, a) for a in args]
            owner = next(m for m, v in self.modules.items() if v.__dict__ is function.__globals__)
            return self._plain(self.machine.native(f"{owner}.{name.rpartition('.')[2]}", *given))

        return call

    def _plain(self, value: Value) -> object:
        found = options(value)
        if len(found) > 1:
            return Either(*map(self._plain, found))
        try:
            plain, origins = to_plain(self.machine, value)
        except NotKnown:
            return Unknown(f"?{reasons_of(value)}")
        assert origins == NO_ORIGINS
        return plain
