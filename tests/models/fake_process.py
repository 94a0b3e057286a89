# SPDX-License-Identifier: Apache-2.0
"""What both fake machines say of the process around a native: it has done nothing yet, and nothing goes on beside."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from rosward.domain.compound import Native
from rosward.domain.heap import Obj
from rosward.domain.memory import Heap
from rosward.domain.state import NOTHING_DONE, State
from rosward.domain.values import NONE, UNBOUND, Function, Ref, Value
from rosward.effects.log import EffectLog
from rosward.models.file_paths import Files, NoFiles
from rosward.source.definitions import Definition
from rosward.source.location import Place


class NoCallbacks:
    """Nothing is scheduled."""

    entries: tuple[()] = ()
    was_run = False
    main_raised: Value = UNBOUND
    threads_raised: Value = UNBOUND


class FakeProcess:
    """A process at its beginning."""

    def __init__(self) -> None:
        self.place = Place("demo.py", 1)
        self.path: tuple[Place, ...] = (self.place,)
        self.files: Files = NoFiles()
        self.log = EffectLog()
        self.state = State(Heap(), 0, NOTHING_DONE)
        self.schedule_book = NoCallbacks()
        self.asked: set[tuple[str, str, str]] = set()
        self.raised = 0
        self.choosing = False
        self.via: str | None = None
        self.handled: Value = NONE
        self.environment: Mapping[str, Value | None] = {}
        self.in_callback = False
        self.is_tried = False
        self.is_sure = True

    def fresh_version(self, compared: int = 0) -> int:
        del compared
        self.state.version += 1
        return self.state.version

    def keep_end(self) -> None:
        raise NotImplementedError

    def throw(self, exception: Value) -> None:
        raise NotImplementedError

    def unwind(self, exits: Sequence[Value], exception: Value) -> Value:
        raise NotImplementedError

    def wait_for(self, value: Value) -> Value:
        raise NotImplementedError

    def load_module(self, name: str, level: int = 0, *, asked: bool = False) -> Value:
        assert not level
        assert not asked
        return Native(name)

    def function_record(self, function: Function) -> Obj | None:
        del function
        return None

    def place_inner(self, owner: Ref, name: str, obj: Obj, *, again: bool) -> Ref:
        raise NotImplementedError

    def interface_definition(self, dotted: str) -> Definition | None:
        del dotted
        return None
