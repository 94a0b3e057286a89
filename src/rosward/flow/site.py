# SPDX-License-Identifier: Apache-2.0
"""What the interpretation says of an operation that calls, put together once: it is the same whenever the walk comes there.

self.pub.publish(text)      the functions of the program, those of one code together; the natives; whether anybody else is called
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator
from typing import Final, final

from rosward.domain.choice import options
from rosward.domain.compound import BoundMethod, Descriptor, External, Native, Partial, Tuple
from rosward.domain.values import Class, Const, Function, Ref, Value
from rosward.engine.running.seen import ALIVE, REACHED, Activation, Called, Handed, Seen
from rosward.flow.marks import Root, of_library
from rosward.ir import ops
from rosward.ir.op import walk
from rosward.ir.registers import reads
from rosward.models.flow_marks import FlowMark

_AS_A_FUNCTION: Final = frozenset(("__call__", "__init__", "__exit__", "__aexit__"))
"""Special methods of objects and classes that are handed as functions are."""


@final
class Site:
    """Of one operation in one activation.

    `callees`: what is called as it is written; `unknown`: somebody may be called of whom nothing is known. `creates`: it only makes an object
    of a class. `opens`: what it gives is open, and nothing of it is read yet. `spins`: callbacks run meanwhile. `calls_back`: a library runs
    functions of the program, `chooses`: which of them, what it was handed says. `waits`: others run meanwhile. `of_library`: somebody may be
    called of whom at most marks tell. `methods`: what a library calls of objects of the program that are called here.
    """

    __slots__ = (
        *("callees", "calls_back", "chooses", "creates", "externals", "methods", "of_library", "opens", "pauses"),
        *("spins", "unknown", "waits"),
    )

    def __init__(self, op: ops.Call, seen: Seen) -> None:
        functions = seen.functions
        own = {r for c in seen.calls.values() if c.function.code.name == "__call__" and c.args for r in c.args[0].refs}
        self.callees = tuple(
            c
            for c in _apart(_as_written(op, functions))
            if not isinstance(c, Function) and not (isinstance(c, Ref) and c.address in own)
        )
        self.unknown = not functions or not all(is_native(c) or isinstance(c, Class) for c in self.callees)
        self.methods: frozenset[Root] = frozenset(
            ("of", c.address, "__call__") for c in self.callees if isinstance(c, Ref)
        )
        self.calls_back = bool(seen.calls) and (any(map(is_native, self.callees)) or _runs_others(seen))
        self.chooses = self.calls_back and any(map(_is_handed, seen.calls.values()))
        self.of_library = self.unknown or any(isinstance(c, External) for c in self.callees)
        self.creates = len(seen.refs) == 1 and all(isinstance(f, Class) for f in functions)
        self.externals: frozenset[Root] = frozenset(map(of_library, seen.externals))
        self.opens = any(isinstance(f, Native) and f.name.endswith("open") for f in functions)
        self.waits = any(waits(_name(f)) for f in callees(functions))
        self.spins = any(_does(f, _SPINNING) for f in callees(functions))
        self.pauses = any(_does(f, _PAUSING) for f in callees(functions))


@final
class Sites:
    """Those of one walk."""

    def __init__(self) -> None:
        self._calls: dict[Seen, Site] = {}
        self._by_code: dict[Seen, dict[str, list[Called]]] = {}
        self._together: dict[tuple[Seen, str], list[Called]] = {}
        self._reads: dict[ops.Op, tuple[int, ...]] = {}
        self._computing: dict[Activation, bool] = {}

    def reads(self, op: ops.Op) -> tuple[int, ...]:
        """The registers that an operation reads."""
        found = self._reads.get(op)
        if found is None:
            found = self._reads[op] = tuple(reads(op))
        return found

    def of(self, op: ops.Call, seen: Seen) -> Site:
        """What is said of a call."""
        found = self._calls.get(seen)
        if found is None:
            found = self._calls[seen] = Site(op, seen)
        return found

    def by_code(self, seen: Seen) -> dict[str, list[Called]]:
        """The functions that an operation calls, those of one code together."""
        if not seen.calls:
            return _NO_CALLS
        found = self._by_code.get(seen)
        if found is None:
            found = self._by_code[seen] = {}
            for called in seen.calls.values():
                found.setdefault(called.function.code.key, []).append(called)
        return found

    def only_compute(self, activations: Collection[Activation], said: Callable[[str], FlowMark]) -> bool:
        """Whether these, and whatever they call, are code of models that only computes; not where nobody saw what runs."""
        return bool(activations) and all(self._only_computes(activation, said) for activation in activations)

    def _only_computes(self, activation: Activation, said: Callable[[str], FlowMark]) -> bool:
        found = self._computing.get(activation)
        if found is None:
            called = {activation: None}
            work = [activation]
            for each in work:
                new = [c for seen in each.seen.values() for c in seen.callees if c not in called]
                called.update(dict.fromkeys(new))
                work += new
            found = self._computing[activation] = all(self._is_calm(each, said) for each in called)
        return found

    def _is_calm(self, activation: Activation, said: Callable[[str], FlowMark]) -> bool:
        """Whether a body is one of a model that makes and sends nothing, writes to nothing that it is given, and calls nobody who may."""
        code = activation.code
        if not code.file.startswith("models:"):
            return False
        for seen in activation.seen.values():
            if seen.effects or seen.scheduled or seen.summaries:
                return False
            for called in seen.calls.values():
                function = called.function
                marks = said(f"{function.module.name}.{function.code.qualname}")
                if not marks.pure or (marks.changes and function.code.name not in _MAKING):
                    return False
        return not any(self._may_write(op, activation) for op in walk(code.ops))

    def _may_write(self, op: ops.Op, activation: Activation) -> bool:
        """Whether an operation writes to what a body is given, or calls somebody who may."""
        seen, code = activation.seen.get(op.number), activation.code
        if seen is None:
            return False
        if isinstance(op, ops.Call):
            natives = [f for f in callees(seen.functions) if isinstance(f, Native)]
            return self.of(op, seen).of_library or any(f.name.rpartition(".")[2] in WRITING for f in natives)
        if isinstance(op, (ops.StoreAttr, ops.StoreItem, ops.Delete)):
            return op.obj < len(code.parameters.names) and code.name not in _MAKING
        return bool(getattr(op, "inplace", False))

    def together(self, seen: Seen, key: str) -> list[Called]:
        """The calls of one code, those as one that differ in nothing but the objects that stand in a register."""
        found = self._together.get((seen, key))
        if found is None:
            ones: dict[object, Called] = {}
            for number, called in enumerate(self.by_code(seen)[key]):
                kind = _kind(called) or number
                known = ones.get(kind)
                ones[kind] = called if known is None else _both(known, called)
            found = self._together[seen, key] = list(ones.values())
        return found


def _kind(called: Called) -> object:
    """What tells a call from others with which it can be taken together; None where there are none such."""
    handed = (*called.args, *(h for _, h in called.keywords))
    if not all(h.registers or h.more for h in handed):
        return None
    return (called.function, len(called.args), tuple([h.registers for h in handed]), *[n for n, _ in called.keywords])


def _both(one: Called, other: Called) -> Called:
    args = tuple(map(Handed.joined, one.args, other.args))
    keywords = tuple((n, a.joined(b)) for (n, a), (_, b) in zip(one.keywords, other.keywords, strict=True))
    return Called(one.function, args, keywords)


_NO_CALLS: Final[dict[str, list[Called]]] = {}


def merged(several: list[Activation]) -> Activation:
    """All that was seen of one body. What was seen in one activation only, or of which nothing is known but that it ran, is not copied."""
    first = several[0]
    found = Activation(first.code, -1, first.cells, first.module)
    together, own = found.seen, set[int]()
    for each in several:
        found.names |= each.names
        for number, seen in each.seen.items():
            known = together.get(number)
            if known is None or known is REACHED or (known is ALIVE and seen.alive):
                together[number] = seen
            elif seen is not known and seen is not REACHED and not (seen is ALIVE and known.alive):
                if number not in own:
                    own.add(number)
                    together[number] = Seen()
                    together[number].absorb(known)
                together[number].absorb(seen)
    return found


def is_native(callee: Value) -> bool:
    """Whether it is a function of a library, or a method of a builtin."""
    return isinstance(callee, (Native, External)) or (
        isinstance(callee, BoundMethod) and isinstance(callee.function, Native)
    )


def callees(functions: Iterable[Value]) -> Iterable[Value]:
    """What is behind methods and partials."""
    for value in functions:
        for option in options(value):
            while isinstance(option, Partial):
                option = option.function  # noqa: PLW2901 - what it stands for
            if isinstance(option, BoundMethod) and not isinstance(option.function, Native):
                yield option.function
            elif isinstance(option, Descriptor):
                yield option.getter
            else:
                yield option


def _runs_others(seen: Seen) -> bool:
    """Whether a function of a model that has no body runs others."""
    called = {f.code.key: f.code.is_stub for f in callees(seen.functions) if isinstance(f, Function)}
    return any(called.values()) and any(c.function.code.key not in called for c in seen.calls.values())


def _is_handed(called: Called) -> bool:
    """Whether a function runs because somebody was handed it, not because an object that was handed is of a class that has it (`__len__`)."""
    name = called.function.code.name
    return not (name.startswith("__") and name.endswith("__")) or name in _AS_A_FUNCTION


def _as_written(op: ops.Call, functions: Iterable[Value]) -> Iterator[Value]:
    """What is called; not the natives of which the operation does not say what they are given (`Seen.performed`)."""
    for option in (o for f in functions for o in options(f)):
        for callee in callees((option,)):
            if not (op.spreads or isinstance(option, Partial)) or not is_native(callee):
                yield callee


def _apart(several: Iterable[Value]) -> Iterable[Value]:
    """Of the methods of natives, one for each function: what all of them are bound to is known."""
    return {(BoundMethod, c.function) if isinstance(c, BoundMethod) else c: c for c in several}.values()


_WAITING: Final = frozenset(
    (
        *("join", "wait", "wait_for", "wait_until", "sleep", "sleep_for", "sleep_until", "acquire", "lock", "result"),
        *("get", "arrive_and_wait"),
    )
)


def waits(name: str) -> bool:
    """Whether a function of a library of this name waits for others."""
    return name.rpartition(".")[2] in _WAITING


def _name(function: Value) -> str:
    """The name of a function of a library; '' where it is none."""
    if isinstance(function, Function):
        return function.code.name if function.code.file.startswith("models:") else ""
    return function.name if isinstance(function, (Native, External)) else ""


_SPINNING: Final = (Const("spins"), Const("suspends"))
_PAUSING: Final = (Const("waits"),)


def _does(function: Value, kinds: tuple[Const, ...]) -> bool:
    """Whether a function spins, or waits, as its model says."""
    if isinstance(function, Native):
        return function.name == "_rosward.spin" and kinds is _SPINNING
    return isinstance(function, Function) and any(
        isinstance(e, Tuple) and e.items[0] in kinds for e in function.effects
    )


_MAKING: Final = frozenset(("__init__", "__new__"))
WRITING: Final = frozenset(
    (
        *(
            "append",
            "appendleft",
            "extend",
            "extendleft",
            "insert",
            "pop",
            "popleft",
            "popitem",
            "remove",
            "clear",
            "sort",
        ),
        *("reverse", "rotate", "update", "setdefault", "add", "discard", "write", "writelines", "setattr", "delattr"),
    )
)
"""Natives that write to what they get, by the last words of their names."""
