# SPDX-License-Identifier: Apache-2.0
"""What both fake machines have: a heap, and a process around a native that has done nothing yet, and beside which nothing goes on."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence

from rosward.domain.compound import Native
from rosward.domain.heap import Obj
from rosward.domain.memory import Heap
from rosward.domain.state import NOTHING_DONE, State
from rosward.domain.unknown import Cause, Reason
from rosward.domain.values import NONE, UNBOUND, Function, Ref, Unknown, Value
from rosward.effects.log import EffectLog, NodeEffect
from rosward.location import Place
from rosward.models.file_paths import Files
from rosward.models.native import ResumptionKind
from rosward.source.definitions import Definition


class NoCallbacks:
    """Nothing is scheduled."""

    entries: tuple[()] = ()
    was_run = False
    parallel = False
    threads = False
    main_raised: Value = UNBOUND
    threads_raised: Value = UNBOUND


class NoFiles:
    """No file is known."""

    def read(self, package: str, relative: str) -> str | None:
        del package, relative
        return None

    def is_file(self, package: str, relative: str) -> bool:
        del package, relative
        return False

    def is_folder(self, package: str, relative: str) -> bool:
        del package, relative
        return False

    def listing(self, package: str, relative: str) -> tuple[str, ...] | None:
        del package, relative
        return None

    def name_of(self, package: str, relative: str) -> str | None:
        del package, relative
        return None

    def modules(self, relative: str) -> tuple[str, ...]:
        del relative
        return ()


class FakeProcess:
    """A process at its beginning; keeps objects in a dict."""

    def __init__(self) -> None:
        self.place = Place("demo.py", 1)
        self.path: tuple[Place, ...] = (self.place,)
        self.files: Files = NoFiles()
        self.log = EffectLog()
        self.state = State(Heap(), 0, NOTHING_DONE)
        self.schedule_book = NoCallbacks()
        self.asked: set[tuple[str, str, str]] = set()
        self.raised = 0
        self.choosing = 0
        self.is_alternative = False
        self.language_name = "python"
        self.via: str | None = None
        self.handled: Value = NONE
        self.environment: Mapping[str, Value | None] = {}
        self.in_callback = False
        self.is_tried = False
        self.is_sure = True
        self.heap: dict[int, Obj] = {}
        self.spent = 0
        self.functions: dict[Value, Callable[..., Value]] = {}

    def fresh_version(self, compared: int = 0) -> int:
        del compared
        self.state.version += 1
        return self.state.version

    def is_node(self, address: int) -> bool:
        return self.log.count_at(address) > 0

    def nodes_at(self, addresses: Collection[int] | None) -> list[NodeEffect]:
        return list(self.log.nodes) if addresses is None else self.log.nodes_at(addresses)

    def keep_end(self) -> None:
        raise NotImplementedError

    def note_creation(self, *, new: bool, exact: bool, key: object = None) -> None:
        pass

    def note_effect(self, effect: object) -> None:
        pass

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

    def load_file(self, file: str, name: str) -> Value | None:
        del file, name
        return None

    def function_record(self, function: Function) -> Obj | None:
        del function
        return None

    def place_inner(self, owner: Ref, name: str, obj: Obj, *, again: bool) -> Ref:
        raise NotImplementedError

    def interface_definition(self, dotted: str) -> Definition | None:
        del dotted
        return None

    def store_attr(self, target: Value, name: str, value: Value) -> None:
        raise NotImplementedError

    def delete_attr(self, target: Value, name: str) -> None:
        if isinstance(target, Ref) and name in self.obj(target).attrs:
            self.update(target, self.obj(target).with_attr(name, UNBOUND))

    def keep_attr(self, owner: Ref, name: str, value: Value, *, weak: bool = False) -> None:
        del weak
        self.store_attr(owner, name, value)

    def is_stepped(self, value: Value) -> bool:
        return isinstance(value, Ref) and self.obj(value).kind == "generator"

    def next_of(self, iterator: Value, kind: ResumptionKind, value: Value, default: Value | None = None) -> Value:
        return self.unknown(Cause.CALL, f"{kind} {iterator} {value} {default}")

    def close_generator(self, ref: Ref) -> None:
        assert self.obj(ref).kind

    def obj(self, ref: Ref) -> Obj:
        return self.heap[ref.address]

    def part(self, ref: Ref, _name: str) -> Obj:
        return self.obj(ref)

    def update(self, ref: Ref, obj: Obj) -> None:
        self.heap[ref.address] = obj

    def allocate(self, obj: Obj, site: object = None, *, counted: bool = True) -> Ref:  # noqa: ARG002 - each one is apart here
        address = len(self.heap) + 1
        self.heap[address] = obj
        return Ref(address)

    def unknown(self, cause: Cause, subject: str, hint: str = "") -> Unknown:
        return Unknown((Reason(cause, subject, self.place),), hint)

    def variables(self, *, local: bool) -> Value:
        return self.unknown(Cause.LIVE, "locals" if local else "globals", "dict")

    def spend(self, steps: int) -> None:
        self.spent += steps

    def guarded(self, action: Callable[[], Value], error: str, *, unseen: bool = True) -> tuple[Value, bool]:
        del error, unseen
        return action(), False
