# SPDX-License-Identifier: Apache-2.0
"""What was seen of a program while it was interpreted: which operations ran, what each gave, and whom it called.

self.pub.publish(self.text(msg))     the attribute `pub` was the object at 70; `text` ran, in the activation of `App.text` in this context

An analysis that asks something else of the same program (`flow`) starts from here: it need not find out again what stands where. Where
nobody asks, nothing is noted.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Final, NamedTuple, final

from rosward.domain.choice import options, reasons_of
from rosward.domain.compound import External, Partial, Tuple
from rosward.domain.slots import Pointer, Slot
from rosward.domain.values import Class, Const, Function, Ref, Text, Unknown, Value

if TYPE_CHECKING:
    from rosward.domain.unknown import Origin, Reason
    from rosward.effects.log import EntityEffect
    from rosward.effects.sent import SentEffect
    from rosward.engine.scheduled import Scheduled
    from rosward.ir.program import Code

_DEPTH: Final = 6


def refs_of(value: Value, depth: int = 0) -> Iterator[int]:
    """The addresses of the objects that a value is or holds; not those that a function or method is bound to.

    A class stands where its attributes and those of its bases do.
    """
    for option in options(value):
        if option.__class__ is Ref:
            yield option.address
        elif option.__class__ is Class:
            yield from (c.address for c in option.mro if c.__class__ is Class and not c.stub)
        elif option.__class__ is Tuple and depth < _DEPTH:
            for item in option.items:
                yield from refs_of(item, depth + 1)
        elif isinstance(option, Partial) and depth < _DEPTH:
            for item in (*option.arguments, *(v for _, v in option.keywords)):
                yield from refs_of(item, depth + 1)
        elif isinstance(option, Pointer):
            yield from refs_of(option.target, depth + 1)
        elif isinstance(option, Slot):
            yield from refs_of(option.base, depth + 1)


class Handed(NamedTuple):
    """One argument of a call: in which registers of the caller it stands as it is, and the objects that it is."""

    registers: frozenset[int]
    refs: frozenset[int]


class Called(NamedTuple):
    """A function that an operation calls, with what."""

    function: Function
    args: tuple[Handed, ...]
    keywords: tuple[tuple[str, Handed], ...]


@final
class Seen:
    """What was seen of one operation in one activation.

    `refs`: the objects that its results are,
    `parts`: those of each of several; `reasons` and `origins`: those of its results; `several`: it gave more than one value.
    `effects`: the entities that it creates and what it sends, `scheduled`: the callbacks that it registers, each with the context of the turn.
    `alive`: control came out behind it. `callees`: the functions that it ran, `summaries`: those of which it took a summary.
    """

    __slots__ = (
        "alive",
        "callees",
        "calls",
        "cells",
        "effects",
        "externals",
        "functions",
        "keys",
        "last",
        "origins",
        "parts",
        "reasons",
        "refs",
        "scheduled",
        "several",
        "summaries",
    )

    def __init__(self) -> None:
        self.alive = False
        self.last: tuple[Value, ...] = ()
        self.refs: set[int] = set()
        self.several = False
        self.parts: dict[int, set[int]] = {}
        self.reasons: dict[Reason, None] = {}
        self.origins: dict[Origin, None] = {}
        self.externals: dict[str, None] = {}
        self.keys: dict[int, Value | None] = {}
        self.functions: dict[Value, None] = {}
        self.calls: dict[object, Called] = {}
        self.callees: dict[Activation, None] = {}
        self.summaries: dict[tuple[str, int], None] = {}
        self.cells: set[int] = set()
        self.effects: dict[tuple[int, EntityEffect | SentEffect], None] = {}
        self.scheduled: dict[tuple[int, Scheduled], None] = {}

    def absorb(self, other: Seen) -> None:
        """What was seen of the same operation in another activation counts too."""
        self.alive = self.alive or other.alive
        self.several = self.several or other.several
        self.refs |= other.refs
        self.cells |= other.cells
        for number, refs in other.parts.items():
            self.parts.setdefault(number, set()).update(refs)
        for register, value in other.keys.items():
            self.keys[register] = value if self.keys.get(register, value) == value else None
        for name in ("reasons", "origins", "effects", "externals", "scheduled", "functions", "calls", "callees"):
            getattr(self, name).update(getattr(other, name))
        self.summaries.update(other.summaries)

    def key(self, register: int, value: Value) -> None:
        """The operation finds a value in a register that may name a slot: what it is, where it is always the same constant."""
        found = value if value.__class__ is Const and all(o.settled for o in value.origins) else None
        if register not in self.keys:
            self.keys[register] = found
        elif self.keys[register] != found:
            self.keys[register] = None

    def constant(self, register: int) -> object:
        """The constant that a register always holds here; None where it does not."""
        found = self.keys.get(register)
        return found.value if isinstance(found, Const) else None

    def give(self, values: tuple[Value, ...]) -> None:
        """The operation gave these values."""
        self.alive = True
        if len(values) == len(self.last) and all(a is b for a, b in zip(values, self.last, strict=True)):
            return
        self.last = values
        if len(values) > 1:
            for number, value in enumerate(values):
                self.parts.setdefault(number, set()).update(refs_of(value))
        for value in values:
            for option in options(value):
                if option.__class__ is Const or option.__class__ is Text:
                    self.origins.update(dict.fromkeys(option.origins))
                elif option.__class__ is Unknown:
                    self.reasons.update(dict.fromkeys(option.reasons))
                elif option.__class__ is External:
                    self.externals[option.name] = None
            if value.__class__ is Text:
                self.reasons.update(dict.fromkeys(reasons_of(value)))
            self.refs.update(refs_of(value))


@final
class Activation:
    """What was seen of one body in one context, whenever it ran there."""

    __slots__ = ("cells", "code", "context", "module", "seen")

    def __init__(self, code: Code, context: int, cells: tuple[int, ...], module: int) -> None:
        self.code = code
        self.module = module  # the address of its variables
        self.context = context
        self.cells = cells
        self.seen: dict[int, Seen] = {}

    def of(self, number: int) -> Seen:
        """That of an operation, by its number; made where it is the first time."""
        found = self.seen.get(number)
        if found is None:
            found = self.seen[number] = Seen()
        return found

    def __repr__(self) -> str:
        return f"Activation({self.code.qualname}, {self.context})"
