# SPDX-License-Identifier: Apache-2.0
"""The walk through the code of a process: the second component of its interpretation, over what the first has seen.

Which operations run, what objects an attribute leads to, whom a call reaches: all that is known (`engine/running/seen.py`). What is new is what each
value depends on. Straight operations are in `straight.py`, calls in `calls.py`, blocks in `blocks.py`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import TYPE_CHECKING, Any, Final, final

from rosward.effects.flows import Sink, Source
from rosward.engine.running.seen import Activation, Seen
from rosward.engine.unknown.escape import BY_LIBRARY
from rosward.engine.watching.watch import is_of_program
from rosward.flow.body import Attempt, Body, Point, here, where
from rosward.flow.failing import STRUCTURED, may_fail
from rosward.flow.marks import NOTHING, Mark, Root, Sources, demoted
from rosward.flow.site import Sites, merged
from rosward.flow.stored.beside import Beside
from rosward.flow.stored.content import TooLongError
from rosward.flow.stored.memory import Memory
from rosward.flow.stored.remembered import MOST, News, Remembered, gather
from rosward.flow.stored.sinks import DEEP, Chain, Sinks
from rosward.flow.stored.tracker import KeySets, Tracker
from rosward.flow.stored.trail import Trail
from rosward.ir import ops
from rosward.ir.program import CPP
from rosward.ir.registers import writes
from rosward.location import Place

if TYPE_CHECKING:
    from rosward.engine.running.scheduled import Scheduled
    from rosward.engine.watching.watch import Watch
    from rosward.flow.stored.shape import Shape

Handler = Callable[["Walker", Any, Body, Seen], "bool | None"]
"""What an operation does to what is known: False where control does not go on behind it."""


@final
class Walker:
    """Walks through one process. `memory` is where it is; `beside`: what all callbacks may have written."""

    def __init__(
        self,
        watch: Watch,
        shape: Shape,
        tables: Mapping[str, Mapping[type[ops.Op], Handler]],
        most: int,
        watched: frozenset[str],
    ) -> None:
        self.watch = watch
        self.shape = shape
        self.tables = tables  # by language
        self.sources = Sources()
        self.sinks = Sinks()
        self.trail = shape.trail = Trail(self.place)
        self.memory = Memory(shape)
        self.beside = Beside(shape)
        self.bodies: list[Body] = []
        self.attempts: list[Attempt] = []
        self.results: dict[Activation, Mark] = {}
        self.arguments: dict[Activation, list[Mark]] = {}
        self.registered: dict[Scheduled, int] = {}  # what decides that a callback is registered
        self.given: dict[Scheduled, int] = {}  # what its arguments depend on
        self.callbacks: dict[Scheduled, Mark] = {}  # as each was registered
        self.handed: dict[Scheduled, tuple[str, ...]] = {}  # the classes of what a library calls each with
        self.followed = shape.followed()  # special methods that the interpretation follows, with their classes
        self.implicit: set[int] = set()  # the classes of which Python has called special methods by itself
        self.writing: set[int] = set()  # those of which such methods write to other objects
        self.calling: set[Root] = set()  # objects of libraries to which functions of the program were handed
        self.logs = False  # handlers of the program get what is logged
        self.put_into: dict[Scheduled, str] = {}  # the modules of libraries that hold functions of the program
        self.returned: dict[Scheduled, int] = {}  # what those return that a library calls
        self.arriving: dict[object, tuple[Source, ...]] = {}  # in each callback
        self.event: tuple[Source, ...] = ()  # in the callback of which all this runs
        self.node: int | None = None  # on whose behalf
        self.stopped: dict[Root, int] = {}  # what decides that timers and subscriptions go on
        self.recursive: set[Activation] = set()  # the bodies that may call themselves
        self.heads: dict[object, Point] = {}  # what loops have found at their beginnings, by the way that led there
        self.changed = False
        self.watched = watched  # the functions that release something
        self.lost = False  # code may run that nobody can name
        self.threaded = False  # whether something runs beside this
        self.narrowed: list[str] = []  # the names of parameters that the branches around are about
        self.sites = Sites()
        self.most = most  # so many steps it may take
        self.together = watch.measure()  # calls of one body are not told apart by what was seen in each
        self._key_sets: KeySets = {}
        self._remembered: dict[Activation, list[Remembered]] = {}
        self._news = News()
        self._bodies: dict[Seen, dict[str, list[Activation]]] = {}
        self._wholes: dict[str, Activation] = {}

    def run(self, block: ops.Block, body: Body) -> bool:
        """Walk through a block; False where control does not come out at its end."""
        activation = body.activation
        table, shape, seen, trail = self.tables[activation.code.language], self.shape, activation.seen, self.trail
        attempts = self.attempts
        for op in block:
            known = seen.get(op.number)
            if known is None:
                return False
            body.at, shape.spent = op, shape.spent + 1
            if shape.spent > self.most:
                raise TooLongError
            if attempts:
                self._attempted(op, body, known)
            cls = op.__class__
            if table[cls](self, op, body, known) is False:
                return False
            if cls in _READING:
                mask, roots = body.registers[op.dst]  # type: ignore[attr-defined]  # all of them have one
                mask |= self.memory.base(roots) if roots else 0
                if mask & ~trail.had:
                    trail.meet(mask, getattr(op, "name", "") if cls is ops.LoadAttr else "")
            if not known.alive and cls not in STRUCTURED:
                return False
            if attempts:
                self.wrote(body, range(len(activation.code.variables)) if cls in STRUCTURED else writes(op))
        return True

    def close(self) -> None:
        """Forget everything: what refers to itself would stay, as nobody collects it while an analysis runs."""
        self.shape.__dict__.clear()
        self.trail.__dict__.clear()
        self.__dict__.clear()

    def _attempted(self, op: ops.Op, body: Body, seen: Seen) -> None:
        """An operation that may fail decides whether what follows in the `try` runs."""
        attempt = self.attempts[-1]
        if may_fail(op, seen):
            for register in self.sites.reads(op):
                attempt.mask |= self.memory.near(body.registers[register])
        if attempt.handles:
            attempt.body.pc |= demoted(attempt.mask)

    def wrote(self, body: Body, registers: Iterable[int]) -> None:
        """What stands in registers is what a handler around may find there."""
        attempt = self.attempts[-1] if self.attempts else None
        if attempt is not None and attempt.body is body:
            known, now = attempt.point.registers, body.registers
            for number in registers:
                known[number] = known[number].joined(now[number])

    def bodies_of(self, seen: Seen) -> dict[str, list[Activation]]:
        """The bodies that an operation runs, by their keys.

        Of many activations of one body, or in a large process, all that was seen of it is taken together.
        """
        found = self._bodies.get(seen)
        if found is None:
            found = {}
            further = (a for key in seen.summaries for a in self.watch.activations.get(key, ()))
            for activation in dict.fromkeys((*seen.callees, *further)):
                found.setdefault(activation.code.key, []).append(activation)
            for key, several in found.items():
                if self.together and is_of_program(several[0].code):
                    found[key] = [self._whole(key, several[0])]
                elif len(several) > _FEW and several[0].code.language != CPP:  # where each has variables of its own
                    found[key] = [merged(several)]
            self._bodies[seen] = found
        return found

    def register(self, entry: Scheduled, pc: int, given: int, callback: Mark = NOTHING) -> None:
        """A callback is registered where `pc` decides so, and may be `given` what is at hand there."""
        before = self.registered.get(entry), self.given.get(entry), self.callbacks.get(entry)
        self.registered[entry] = (before[0] or 0) | pc
        self.given[entry] = (before[1] or 0) | given
        self.callbacks[entry] = callback.joined(before[2] or NOTHING)
        if before != (self.registered[entry], self.given[entry], self.callbacks[entry]):
            self.changed = True
        if entry.event in (BY_LIBRARY, "thread"):
            self.meet_callbacks()

    def give_back(self, entry: Scheduled, mask: int) -> None:
        """What a function returns that a library calls depends on this: whatever the library makes of it may."""
        old = self.returned.get(entry, 0)
        if old | mask != old:
            self.returned[entry] = old | mask
            self.tell((entry,))

    def may_call(self, owners: frozenset[Root]) -> None:
        """These objects of libraries were handed functions of the program: whoever calls methods of them may run these."""
        new = owners - self.calling
        if new:
            self.calling |= new
            self.tell(each for root in new for each in self.shape.numbers.alike(root))

    def tell(self, news: Iterable[object]) -> None:
        """Walks that have asked for these find something else from now on."""
        self._news.tell(news)
        self.changed = True

    def ask(self, keys: Iterable[object]) -> None:
        """What is done here depends on these, of which no memory tells."""
        if self.shape.tracker is not None:
            self.shape.tracker.asked.update(keys)

    def forget(self) -> None:
        """What is remembered of calls may not hold any more."""
        self._remembered.clear()
        self.changed = True

    def send(self, sink: Sink, mask: int) -> None:
        """Something leaves the process."""
        self.trail.send(sink, mask)
        if self.shape.tracker is not None:
            self.shape.tracker.send(sink, here(self.bodies[-1]), mask)
        self.changed |= self.sinks.add(sink, mask, self.event)
        self.sinks.called(sink, self._chain(), self._with_event(mask))

    def _chain(self) -> Chain | None:
        """The statements that have led to where control is; None where one of them may have called itself."""
        if any(body.activation in self.recursive for body in self.bodies):
            return None
        return tuple(place for body in self.bodies for place in here(body))[-DEEP:]

    def _with_event(self, mask: int) -> int:
        for source in self.event:
            mask |= self.sources.trigger(source)
        return mask

    def way(self, op: ops.Op) -> object:
        """How control came to an operation: in which callback, through which calls."""
        return (self.trail.event, *[(body.activation, body.at.number) for body in self.bodies], op.number)

    def place(self) -> Place:
        """The statement of the user's code that is running."""
        return where(self.bodies)

    @property
    def hurries(self) -> bool:
        """Whether so much was walked through that functions of libraries that only compute are taken as a whole."""
        return self.shape.spent > CALM

    def meet_callbacks(self) -> None:
        """A callback may have run that was handed to somebody: in the main body, those of ROS have not."""
        if self.event != (Source("main"),):
            self.join_beside()

    def join_beside(self) -> None:
        """Callbacks run here: all that they may have written may stand here."""
        if self.shape.tracker is not None:
            self.shape.tracker.beside = True
        self.beside.meet(self.memory)

    def wait(self) -> None:
        """Others run while this waits: they find what it wrote so far, and it finds what they write."""
        self.leave()
        self.join_beside()

    def leave(self) -> None:
        """What runs has come to its end, or lets others run: they may find what it wrote."""
        self.changed |= self.beside.take(self.memory)

    def arrives_here(self, kind: str) -> int:
        """What arrives here, of that kind: at the object of whose method this runs, or at any that it may be."""
        mask, alike = 0, self.shape.numbers.alike
        for body in reversed(self.bodies):
            for root in body.registers[0].roots if body.registers else ():
                for each in alike(root):
                    found = self.shape.entity(each, kind)
                    mask |= 0 if found is None else self.sources.data(found)
            if mask:
                return mask
        return self.sources.data(Source(kind))

    def point(self, body: Body) -> Point:
        """Where control is, to come back to."""
        return Point(body.registers.copy(), self.memory.copy())

    def go(self, body: Body, point: Point) -> None:
        """Go on from a point (which is used up)."""
        body.registers = point.registers
        self._stand(point.memory)

    def _stand(self, memory: Memory) -> None:
        """Control goes on with this, wherever it comes from: what is written is noted for the innermost `try` that is running now."""
        self.memory = memory.current()
        self.memory.log = self.attempts[-1].log if self.attempts else None

    def enter(self, activation: Activation, arguments: list[Mark], pc: int) -> Mark:
        """Walk through a body: what it returns. One that is running already returns what it is known to, so far."""
        if gather(self.arguments, activation, arguments):
            self.tell((activation,))
        if any(b.activation is activation for b in self.bodies):
            self.ask((activation,))
            self.recursive.add(activation)
            return self.results.get(activation, NOTHING)
        given = (tuple(arguments), pc, self.event, self.node, tuple(self.narrowed), bool(self.attempts))
        earlier = self._remembered.setdefault(activation, [])
        outer = self.shape.tracker
        for each in earlier:
            current = each.given == given and self._news.holds(each) and self.memory.finds(each.tracker)
            if current and self.beside.holds(each):
                self._repeat(each, outer)
                return each.result
        tracker = self.shape.tracker = Tracker()
        beside, told = self.beside.state, self._news.told
        before = self.attempts[-1].mask if self.attempts else 0
        if self.attempts:
            self.attempts[-1].mask = 0
        try:
            result = self._walk(activation, arguments, pc)
        finally:
            self.shape.tracker = outer
            if activation in self.recursive:
                tracker.forget_ways()
            if outer is not None:
                outer.absorb(tracker, here(self.bodies[-1]), self.memory)
        raising = self.attempts[-1].mask if self.attempts else 0
        if self.attempts:
            self.attempts[-1].mask |= before
        if not tracker.open:
            left, merges = self.memory.left(tracker, self._key_sets), len(self.memory.numbers.merges)
            tracker.ended(self._key_sets)
            del earlier[MOST[activation.code.language] - 1 :]
            earlier.insert(0, Remembered(given, tracker, left, result, raising, beside, told, merges))
        return result

    def _repeat(self, each: Remembered, outer: Tracker | None) -> None:
        """A call does what it did before."""
        if each.tracker.beside:  # which it may have covered before it began
            self.join_beside()
        if outer is not None:
            outer.repeat(each.tracker, here(self.bodies[-1]), self.memory.now)
        self.memory.replay(each.writes, each.tracker.placed)
        before = self._chain()
        for (sink, chain), mask in each.tracker.sent.items():
            self.trail.send(sink, mask)
            whole = None if chain is None or before is None else (before + chain)[-DEEP:]
            self.sinks.called(sink, whole, self._with_event(mask))
        if self.attempts:
            self.attempts[-1].mask |= each.raising

    def _walk(self, activation: Activation, arguments: list[Mark], pc: int) -> Mark:
        """Through a body."""
        code = activation.code
        given = arguments
        if activation in self.recursive or len(self.bodies) > _DEEP:
            self.ask((activation,))
            given = self.arguments[activation]
        body = Body(activation, [*given, *[NOTHING] * (code.registers - len(given))], pc)
        own = activation.cells[: len(code.cells)] if code.language == CPP else ()
        if own and any(b.activation is activation for b in self.bodies):
            own = ()
        self.shape.ended.difference_update(own)
        self.memory.forget(own)
        self.bodies.append(body)
        try:
            alive = self.run(code.ops, body)
        finally:
            self.bodies.pop()
            self.shape.ended.update(own)
        if body.returned is not None:
            if alive:
                body.returned.join(self.memory)
            self._stand(body.returned)
        for cls in self.followed.get(code.key, ()):
            self.memory.write_any([("followed", cls)], Mark(self.memory.deep(body.result)))
        old = self.results.get(activation)
        new = body.result if old is None else old.joined(body.result)
        if new is not old:
            self.results[activation] = new
            self.tell((activation,))
        return body.result

    def advance(self, activation: Activation, pc: int) -> Mark:
        """Run a generator or coroutine with what it was made with: what it yields and returns."""
        key = activation.code.key
        activation = self._whole(key, activation)
        arguments = self.memory.of(("arguments", key))
        count = len(activation.code.parameters.names)
        returned = self.enter(activation, [arguments.read(n) for n in range(count)], pc)
        if not activation.code.is_generator:
            if returned != NOTHING:  # who holds it may get that
                self.memory.write_any([("generator", key)], returned)
            return returned
        return self.memory.of(("generator", key)).any.under(pc).joined(returned)

    def _whole(self, key: str, activation: Activation) -> Activation:
        """All that was seen of a body. Of a generator, another part of it runs each time it goes on."""
        found = self._wholes.get(key)
        if found is None:
            found = self._wholes[key] = merged(self.watch.bodies.get(key, [activation]))
        return found


_READING: Final = frozenset((ops.LoadAttr, ops.LoadItem, ops.LoadGlobal, ops.Call))
"""What may be the first to meet a source."""
CALM: Final = 5_000
"""Functions of libraries that only compute are walked through before so much was."""
_FEW: Final = 8
"""So many activations of a body are walked through one by one for one operation."""
_DEEP: Final = 40
"""So many calls deep the arguments of all calls are taken together."""
