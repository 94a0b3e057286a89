# SPDX-License-Identifier: Apache-2.0
"""Who notes what is seen (`seen.py`)? The handlers of a language, each wrapped in one that notes what it gives.

watching(PYTHON)     the same language, whose operations tell the watch

The interpreter does not know of it, but for what runs no operation: results that are remembered, callbacks, what is sent.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from operator import is_
from typing import TYPE_CHECKING, Any, Final, final

from rosward.domain.choice import options
from rosward.domain.compound import Tuple
from rosward.domain.slots import Pointer, Slot
from rosward.domain.values import NONE, UNBOUND, Const, Function, Ref, Value
from rosward.engine.running.seen import (
    Activation,
    Bound,
    Called,
    Given,
    Seen,
    places_of,
    refs_of,
)
from rosward.engine.watching.noted import CELLED, noting
from rosward.engine.watching.performed import handed, is_as_written, performed, standing
from rosward.engine.watching.registered import Registered, period_of
from rosward.ir import cpp, ops
from rosward.ir.program import CPP
from rosward.ir.registers import reads, writes

if TYPE_CHECKING:
    from rosward.effects.log import EntityEffect
    from rosward.effects.sent import SentEffect
    from rosward.engine.machine import Engine, Handler, Language
    from rosward.engine.running.frame import Frame
    from rosward.engine.running.scheduled import Scheduled
    from rosward.ir.program import Code
    from rosward.ir.symbols import Signature

__all__ = ["Watch", "is_of_program"]


def _receivers(machine: Engine) -> Iterator[int]:
    for frame in reversed(machine.frames):
        if frame.registers:
            yield from refs_of(frame.registers[0])
        if not frame.stub:
            return


def _turn(machine: Engine) -> int:
    return machine.frames[-1].context if machine.frames else 0


@final
class Watch:
    """Notes what the interpretation of one process sees."""

    def __init__(self) -> None:
        self.activations: dict[tuple[str, int], list[Activation]] = {}
        self.bodies: dict[str, list[Activation]] = {}  # by the key of the body
        # So much was seen that contexts of one body of the program are not told apart from then on.
        self.is_large = False
        self._shared: dict[str, Activation] = {}  # what stands for those of many contexts
        self._count_down = 1  # so many activations later it is looked again whether it is large
        self.begun: dict[Activation, None] = {}  # those that nothing called: the main body
        self.entries: dict[Scheduled, Registered] = {}
        self._remembered: dict[object, tuple[str, int]] = {}
        self._reads: dict[ops.Op, tuple[int, ...]] = {}  # the operands of each
        self._running: list[tuple[Frame, Seen, tuple[int, ...]]] = []  # the operations of C++, with what they read

    def close(self) -> None:
        """Forget everything: what refers to itself would stay, as nobody collects it while an analysis runs."""
        for several in self.activations.values():
            for activation in several:
                activation.seen.clear()
        self.__dict__.clear()

    def watching(self, language: Language) -> Language:
        """The language, noting what its operations do."""
        table: dict[type[ops.Op], Handler] = {
            cls: noting(cls, handler, self._activation) for cls, handler in language.table.items()
        }
        if language.name == CPP:
            return replace(
                language, table={cls: self._noting_cpp(cls, handler) for cls, handler in language.table.items()}
            )
        call_function, call = language.call_function, language.call

        def calling(machine: Engine, function: Function, args: tuple[Value, ...], keywords: dict[str, Value]) -> Value:
            self._call(machine, function, args, keywords)
            return call_function(machine, function, args, keywords)

        def performing(machine: Engine, function: Value, args: tuple[Value, ...], keywords: dict[str, Value]) -> Value:
            frame = machine.frames[-1] if machine.frames else None
            if frame is not None and not is_as_written(frame, function):
                for native in performed(frame, self._read_by(frame.op), function, args, keywords):
                    self.at(machine).perform(native)
            return call(machine, function, args, keywords)

        return replace(language, table=table, call_function=calling, call=performing)

    def at(self, machine: Engine) -> Seen:
        """That of the operation that is running; what runs under no frame is of no activation."""
        if not machine.frames:
            return Seen()
        return self._of(machine, len(machine.frames) - 1)

    def _of(self, machine: Engine, depth: int) -> Seen:
        """That of what runs in a frame."""
        frame = machine.frames[depth]
        if self._running:
            for running, seen, _ in reversed(self._running):
                if running is frame:
                    return seen
        return self._activation(machine, frame, depth).of(frame.op.number)

    def schedule(self, machine: Engine, entry: Scheduled) -> None:
        """A callback is registered here."""
        self.at(machine).note("scheduled", (_turn(machine), entry))
        among = machine.frames[-1].seen if machine.frames and self._running else None
        period = period_of(machine) if entry.event == "timer" else None
        registered = Registered(tuple(_receivers(machine)), self.at(machine), _turn(machine), among, period)
        self.entries.setdefault(entry, registered)

    def gave_up(self, op: ops.Op, frame: Frame) -> None:
        """What an operation makes is too large to keep; control goes on behind it."""
        if frame.seen is not None:
            seen = frame.seen.of(op.number)
            seen.alive = True
            for register in writes(op):
                seen.give(frame.registers[register])

    def effect(self, machine: Engine, effect: EntityEffect | SentEffect) -> None:
        """An entity is created, or a message sent, here."""
        self.at(machine).note("effects", (_turn(machine), effect))

    def summary(self, machine: Engine, code: Code, context: int) -> None:
        """The result of a call is taken from the summary of the function, which runs in a context of its own."""
        self.at(machine).note("summaries", (code.key, context))

    def remember(self, key: object, code: Code, context: int) -> None:
        """The result of a call is remembered."""
        self._remembered[key] = (code.key, context)

    def again(self, machine: Engine, key: object) -> None:
        """What is remembered of a call is its result once more."""
        self.at(machine).note("summaries", self._remembered[key])

    def recalled(self, machine: Engine, code: Code, context: int) -> None:
        """A call does what it did before in that context: what was seen of it then counts here, too."""
        seen = self.at(machine)
        if not any(a.context == context and a.code is code for a in seen.callees):
            seen.note("summaries", (code.key, context))

    def of(self, code: Code, context: int, cells: tuple[int, ...], module: int) -> Activation:
        """The activation of a body in a context, with these variables. Once very much was seen, one stands for those of many contexts."""
        known = self.activations.setdefault((code.key, context), [])
        for each in known:
            if each.cells == cells:
                return each
        if self.is_large and is_of_program(code) and not code.key.endswith(_FILE):
            found = self._shared.get(code.key)
            if found is None:
                found = self._shared[code.key] = Activation(code, context, cells, module)
                self.bodies.setdefault(code.key, []).append(found)
            if found not in known:
                known.append(found)
            return found
        known.append(Activation(code, context, cells, module))
        self.bodies.setdefault(code.key, []).append(known[-1])
        self._count_down -= 1
        if not self._count_down and not self.is_large:
            self.measure()
        return known[-1]

    def measure(self) -> bool:
        """Whether very many operations were seen, each as often as it was told apart."""
        activations = [a for several in self.bodies.values() for a in several]
        self.is_large = sum(len(a.seen) for a in activations) > _LARGE
        self._count_down = (len(activations) >> 3) + 1
        return self.is_large

    def _activation(self, machine: Engine, frame: Frame, depth: int) -> Activation:
        """That of a frame; noted with who called it where it is new."""
        found = frame.seen
        if found is None:
            found = frame.seen = self.of(frame.code, frame.context, frame.cells, frame.module.address)
            if frame.namespace >= 0:
                found.names.add(frame.namespace)
            if depth:
                self._of(machine, depth - 1).note("callees", found)
            elif frame.code.ops:
                self.begun[found] = None
            if frame.code.language == CPP:
                self._begin(found, frame)
        return found

    def _begin(self, activation: Activation, frame: Frame) -> None:
        """Where the parameters of a body in C++ lead."""
        signature = frame.code.signature
        count = max(len(frame.code.parameters.names), 0 if signature is None else _width(signature))
        for number in range(min(count, len(frame.registers))):
            if number == len(activation.begun):
                activation.begun.append(set())
            activation.begun[number].update(places_of(frame.registers[number]))

    def _call(self, machine: Engine, function: Function, args: tuple[Value, ...], keywords: dict[str, Value]) -> None:
        if not machine.frames:
            return
        frame = machine.frames[-1]
        seen = self.at(machine) if self._running or frame.seen is None else frame.seen.of(frame.op.number)
        written = None  # with what, where the operation alone says where that stands
        if not keywords and frame.op.__class__ is ops.Call and frame.op.simple is not None:
            written = (function.code, function.cells, *args)
            before = seen.written
            if before is not None and len(before) == len(written) and all(map(is_, before, written)):
                return
        seen.written = written
        values = (*args, *keywords.values()) if keywords else args
        where = standing(frame.registers, self._read_by(frame.op), values)
        key = (function.code.key, function.cells, where, *keywords)
        if key not in seen.calls:
            given = handed(where)
            named = tuple(zip(keywords, given[len(args) :], strict=True))
            seen.note("calls", key, Called(function, tuple(given[: len(args)]), named))

    def _read_by(self, op: ops.Op) -> tuple[int, ...]:
        """The operands of an operation, each once."""
        found = self._reads.get(op)
        if found is None:
            registers = (
                (a.register for m in op.members for a in m.arguments) if isinstance(op, cpp.Initialise) else reads(op)
            )
            found = self._reads[op] = tuple(dict.fromkeys(registers))
        return found

    def swallows(self, machine: Engine) -> None:
        """The `with` that is running may swallow an exception."""
        self.at(machine).swallows = True

    # C++

    def wrote(self, address: int) -> None:
        """The object at an address is written to."""
        if self._running:
            self._running[-1][1].hold("wrote", (address,))

    def made(self, address: int, site: object) -> None:
        """An object is made, of what the site says."""
        if self._running:
            seen = self._running[-1][1]
            if address not in seen.made:
                seen.note("made", address, site)

    def native(self, name: str) -> None:
        """A model in code runs."""
        if self._running:
            self._running[-1][1].note("natives", name)

    def strange(self, name: str) -> None:
        """Code that nobody knows gets hold of something."""
        if self._running:
            self._running[-1][1].note("strange", name)

    def bound(self, machine: Engine, function: Function, args: tuple[Value, ...], registers: list[Value]) -> None:
        """A function in C++ is called with these arguments, which stand in its registers so."""
        if not machine.frames:
            return
        frame = machine.frames[-1]
        operands: list[tuple[int, Value]] = []
        if self._running and self._running[-1][0] is frame:
            operands = [(r, frame.registers[r]) for r in self._running[-1][2]]
        signature = function.code.signature
        leading = 0 if signature is None else signature.leading
        types = 0 if signature is None else len(signature.template)
        given = []
        for number, value in enumerate(registers):
            first = number if number < leading else number - types
            if leading <= number < leading + types or value is UNBOUND:
                given.append(_NOTHING_GIVEN)
                continue
            is_pack = signature is not None and number == len(registers) - 1 and _ends_in_pack(signature)
            mine = args[first:] if is_pack else args[first : first + 1]
            where = frozenset(r for r, v in operands for a in mine if v is a)
            given.append(Given(where, frozenset(places_of(value)), _kind(value)))
        key = (function.code.key, function.cells, tuple(given))
        self.at(machine).note("bound", key, Bound(function, tuple(given)))

    def _noting_cpp(self, cls: type[ops.Op], handler: Handler) -> Handler:
        """The handler of a kind of operation, noting what it gives; what it does itself is its own, not that of its blocks."""
        structured, celled = cls in _STRUCTURED and cls is not ops.ForEach, cls in CELLED

        def noting(machine: Engine, op: Any, frame: Frame) -> bool | None:
            activation = frame.seen or self._activation(machine, frame, len(machine.frames) - 1)
            seen = activation.of(op.number)
            operands = self._reads.get(op) or self._read_by(op)
            if celled:
                seen.hold("cells", (frame.cells[op.cell],))
            if cls in _KEYED_CPP:
                for register in operands:
                    seen.key(register, _standing(machine, frame.registers[register]))
                if cls is cpp.Invoke:
                    function = frame.registers[op.func]
                    seen.several = seen.several or len([o for o in options(function) if o != NONE]) > 1
            self._running.append((frame, seen, operands))
            try:
                result = handler(machine, op, frame)
            finally:
                self._running.pop()
            if structured:
                seen.alive = seen.alive or result is not False
            elif result is not False:
                seen.alive = True
                registers = frame.registers
                written = [registers[r] for r in writes(op)]
                if len(written) > 1:
                    seen.give_several(written, places_of)
                elif written:
                    seen.give(written[0], places_of)
            return result

        return noting


_STRUCTURED: Final = frozenset(
    {ops.If, ops.While, ops.ForEach, ops.Try, ops.With, ops.Return, ops.Break, ops.Continue, ops.Raise}
)
_KEYED_CPP: Final = frozenset({cpp.Invoke, cpp.InvokeMember, cpp.Item, cpp.Construct, ops.Compare})
_NOTHING_GIVEN: Final = Given(frozenset(), frozenset(), "none")


def _standing(machine: Engine, value: Value) -> Value:
    """What stands in a variable; looking at it is no question of the program."""
    if value.__class__ is not Slot or value.kind != "cell" or not isinstance(value.base, Ref):
        return value
    cell = machine.state.heap.get(value.base.address)
    return value if cell is None else cell.attrs.get("value", value)


def is_of_program(code: Code) -> bool:
    """Whether it is code of the program in Python; what a library does with a name depends on which one that is."""
    return code.language != CPP and not code.file.startswith("models:")


_FILE: Final = "#0"
"""The end of the keys of what stands in no function, from where callbacks begin in contexts of their own."""
_LARGE: Final = 12_000
"""In a process of which more operations are seen, what is seen of one body in several contexts is taken together."""


def _width(signature: Signature) -> int:
    return signature.leading + len(signature.template) + len(signature.parameters)


def _ends_in_pack(signature: Signature) -> bool:
    return bool(signature.parameters) and signature.parameters[-1].pack


def _kind(value: Value) -> str:
    """Whether a value only leads somewhere, is surely the same each time, or depends on more."""
    several = options(value)
    if all(o.__class__ is Const and not o.origins for o in several):
        return "none"
    if all(o == NONE or o.__class__ in (Ref, Slot, Pointer) for o in several):
        return "place"
    if value.__class__ is Tuple and not value.items:
        return "none"
    return "value"
