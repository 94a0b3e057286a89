# SPDX-License-Identifier: Apache-2.0
"""The flows of one process: its main body, then its callbacks in any order, until nothing changes.

What each sends is a sink, with the sources that it depends on. Where the walk, or the interpretation before it, reached a limit, a sink may
hold every source.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Final

from rosward.domain.compound import BoundMethod, Partial, function_behind
from rosward.domain.values import Function, Ref, Unknown, Value
from rosward.effects.flows import Flow, ProcessFlows, Sink, Source
from rosward.effects.log import EntityEffect
from rosward.effects.sent import SentEffect
from rosward.engine.running.seen import refs_of
from rosward.engine.unknown.escape import BY_BASE, BY_LIBRARY, BY_PYTHON, BY_WINDOW
from rosward.flow import blocks, computed, hidden, implicit, library, straight
from rosward.flow.awoken import callbacks_of
from rosward.flow.callbacks import begin
from rosward.flow.calls import send, sink_of
from rosward.flow.cpp import calls as cpp_calls
from rosward.flow.cpp import operations as cpp
from rosward.flow.marks import CANCELLED, NOTHING, Mark, Root, decided, demoted, triggering
from rosward.flow.native import parameters
from rosward.flow.said import wrong_marks
from rosward.flow.stored.content import Content, TooLongError
from rosward.flow.stored.memory import Memory
from rosward.flow.stored.shape import Shape
from rosward.flow.walker import Handler, Walker
from rosward.ir import ops
from rosward.ir.program import CPP, PYTHON
from rosward.location import Place

if TYPE_CHECKING:
    from collections.abc import Iterator

    from rosward.engine.interpreter import Interpreter
    from rosward.engine.running.scheduled import Scheduled
    from rosward.engine.running.seen import Activation
    from rosward.engine.watching.registered import Registered
    from rosward.engine.watching.watch import Watch

_ROUNDS: Final = 40
_LEAST: Final = 105_000
_MOST: Final = 300_000
"""The walk may take as many steps as the interpretation, or a quarter as many and the least; but no more than the most.

Walks that come to their end take 5 times as many steps in small processes, and fewer in large ones; others would go on in vain.
"""
_A_ROUND: Final = 30_000
"""To go through all callbacks once may take so many, or a quarter of all: walks of which a round took more did not come to their end."""
_EVENTS: Final = {
    "message": ("topic", "subscription"),
    "service": ("service", "service_server"),
    "goal": ("goal", "action_server"),
    "execute": ("goal", "action_server"),
    "accepted": ("goal", "action_server"),
    "cancel": ("goal", "action_server"),
    "feedback": ("feedback", "action_client"),
}
"""The kind of source that an event brings, and of the entity at which it arrives."""
_ANSWERS: Final = frozenset({"future", "response", "result", "goal response"})
"""Callbacks that run when an answer is there."""
_PLAIN: Final = {"timer": "timer", "thread": "thread", "parameters": "parameters"}


class Table(dict[type[ops.Op], Handler]):
    """The handlers by kind of operation; of others it is known what they read and write."""

    def __missing__(self, cls: type[ops.Op]) -> Handler:
        return computed.plain


def flows_of(machine: Interpreter, watch: Watch) -> ProcessFlows:
    """Walk through a process that was interpreted while somebody watched; not where it has no node, of which something could be told."""
    machine.log.findings.update(wrong_marks(machine))
    if not machine.log.nodes:
        return ProcessFlows()
    both = {**straight.TABLE, **blocks.TABLE}
    tables = {PYTHON: Table(both), CPP: Table({**both, **cpp.TABLE})}
    steps = machine.precision.steps
    most = min(max(_LEAST + (steps >> 2), steps), _MOST)
    walker = Walker(watch, Shape(machine), tables, most, machine.budget.watched)
    complete = not any(f.code == "RW201" for f in machine.log.findings)
    try:
        complete = _settle(walker, machine) and complete
    except TooLongError:
        complete = False
    complete = complete and not walker.lost
    if not complete:
        _every_sink(walker)
    more = 0 if complete else walker.sources.all
    flows = []
    for sink, mask in walker.sinks.masks.items():
        events = 0
        for event in walker.sinks.events[sink]:
            events |= walker.sources.trigger(event)
        data, control, trigger = walker.sources.apart(mask | events | more)
        assumed = data - walker.sources.apart(mask)[0]
        calls = walker.sinks.calls(sink, walker.sources) if complete else ()
        flows.append(Flow(sink, data, control, trigger, _paths(walker, sink, data | control), assumed, calls))
    callbacks = callbacks_of(walker, machine.schedule_book.entries.values(), _node)
    walker.close()
    return ProcessFlows(tuple(flows), complete, callbacks)


def _every_sink(walker: Walker) -> None:
    """What was seen to be sent is told, also where the walk did not come there."""
    for several in walker.watch.activations.values():
        for seen in (seen for activation in several for seen in activation.seen.values()):
            for _, effect in seen.effects:
                if isinstance(effect, SentEffect):
                    walker.sinks.add(sink_of(effect), 0, ())


def _paths(walker: Walker, sink: Sink, sources: Iterable[Source]) -> dict[Source, tuple[Place, ...]]:
    trail, arriving = walker.trail, walker.arriving
    return {s: trail.way(sink, walker.sources.number(s), s, arriving) for s in sources}


def _settle(walker: Walker, machine: Interpreter) -> bool:
    """Until nothing changes; False where that takes too long."""
    entries = list(machine.schedule_book.entries.values())
    entries = list({_where(e): e for e in reversed(entries)}.values())[::-1]
    walker.threaded = machine.schedule_book.threads or any(e.event == "thread" for e in entries)
    walker.logs = any(e.event == "log" for e in entries)
    most = walker.most
    a_round = max(_A_ROUND, most >> 2)
    for _ in range(_ROUNDS):
        walker.changed = False
        _main(walker)
        main_changed = walker.changed
        for _ in range(_ROUNDS):
            walker.changed = False
            walker.most = min(most, walker.shape.spent + a_round)
            for entry in entries:
                _callback(walker, entry)
            walker.most = most
            if not walker.changed:
                break
            main_changed = True
        if not main_changed:
            return True
    return False


def _where(entry: Scheduled) -> object:
    """What tells a callback from others; those that many turns of a loop register at one place are one."""
    function = function_behind(entry.callback)
    code = entry if function is None else function.code.key
    return (entry.place, entry.context, entry.event, code) if entry.event == "thread" else entry


def _main(walker: Walker) -> None:
    """The main body, beside which callbacks may run."""
    walker.event = (Source("main"),)
    walker.trail.begin("main", None)
    walker.node = _only(walker)
    walker.memory = Memory(walker.shape)
    walker.shape.placed.clear()
    for activation in walker.watch.begun:
        walker.enter(activation, [], 0)
        walker.leave()
    for (key, context), roots in walker.watch.activations.items():
        if context == 0 and key.endswith("#0") and roots[0].of(0).bound:  # what starts a program that is linked
            cpp_calls.begin(walker, roots[0], [], 0, 0)
            walker.leave()


def _only(walker: Walker) -> int | None:
    """The node of a process that has one."""
    return next(iter(walker.shape.nodes)) if len(walker.shape.nodes) == 1 else None


def _callback(walker: Walker, entry: Scheduled) -> None:
    """One callback, from all that others may have written."""
    root = next(iter(walker.watch.activations.get((f"{entry.place.file}#0", entry.context), ())), None)
    if root is None:
        return
    walker.memory = walker.beside.memory.copy()
    walker.shape.placed.clear()
    sources = tuple(_sources(walker, entry))
    walker.event = walker.arriving[entry] = sources
    walker.trail.begin(entry, _beginning(entry.callback))
    walker.node = _node(walker, entry)
    pc = demoted(walker.registered.get(entry, 0))
    for source in sources:
        pc |= walker.sources.trigger(source) if source.kind != "main" else 0
    registered = walker.watch.entries.get(entry)
    for owner in _owners(entry, registered):
        pc |= demoted(walker.stopped.get(owner, 0))
    if entry.event in ("execute", "accepted"):
        pc |= walker.stopped.get(_accepts("goal", registered), 0)
    arguments = [_argument(walker, entry, n, sources) for n in range(len(entry.args or ()))]
    if entry.event in _ANSWERS:
        for argument in arguments:
            pc |= triggering(walker.memory.deep(argument))
    seen, given = root.of(0), walker.given.get(entry, 0)
    handed = _handed(walker, entry, root) if entry.args is None else []
    given |= hidden.told_to(walker, entry)
    if entry.event == "log":
        given |= hidden.logged(walker)
        pc |= demoted(given)  # what a logger holds may say whether it is told
    if _implicit(walker, entry):
        told, brought = implicit.arguments_of(walker, entry.callback), library.brought_to(walker, entry.callback)
        given, pc = given | told.mask | brought, pc | decided(brought)
        handed = handed or [told] * _free(entry)
    if root.code.language == CPP or seen.bound:
        result = cpp_calls.begin(walker, root, arguments, given, pc)
        if arguments and entry.event == "service":  # the response is the last of them
            result = result.joined(arguments[-1])
    else:
        result = begin(walker, root, arguments, _as_registered(walker, entry), given, pc, handed)
    for _, effect in seen.effects:
        if isinstance(effect, SentEffect):
            send(walker, effect, walker.memory.deep(result) | pc)
    _judged(walker, entry, result)
    if entry.event == "log":  # what filters put into records, or factories into new ones
        records = Mark(0, result.roots | (arguments[0].roots if arguments else frozenset()))
        hidden.keep(walker, "logging", walker.memory.deep(records))
    if entry.event == BY_LIBRARY:
        walker.give_back(entry, walker.memory.deep(result))
    if _implicit(walker, entry):
        implicit.keep(
            walker,
            entry.callback,
            walker.memory.deep(result),
            writes=walker.memory.wrote_to_others(walker.beside.memory),
        )
    walker.leave()


def _judged(walker: Walker, entry: Scheduled, result: Mark) -> None:
    """What becomes of a goal, a request to cancel, or parameters that are set, depends on what a callback says of them."""
    if entry.event == "parameters" and walker.node is not None:
        parameters.judged(walker, walker.node, demoted(walker.memory.deep(result)))
    elif entry.event in ("goal", "cancel"):
        root = _accepts(entry.event, walker.watch.entries.get(entry))
        library.stop(walker, root, demoted(walker.memory.deep(result)))


def _accepts(event: str, registered: Registered | None) -> Root:
    """Where it stands what decides that a server, the innermost that registers, accepts a goal; of requests to cancel, servers are not told apart."""
    server = registered.receivers[:1] if registered is not None else ()
    return ("accepts", *server) if event == "goal" else CANCELLED


def _argument(walker: Walker, entry: Scheduled, number: int, sources: tuple[Source, ...]) -> Mark:
    """What a callback is called with: the first of a message or request is new each time."""
    value: Value = (entry.args or ())[number]
    roots = frozenset(refs_of(value))
    if roots and _came(walker, entry):
        return Mark(0, roots)
    if entry.event == "log":
        return Mark(hidden.logged(walker), roots)
    if number == _which(entry) and entry.event in ("message", "service", "goal", "feedback") and sources:
        mask = 0
        for source in sources:
            mask |= walker.sources.data(source)
        if entry.event in ("message", "service"):
            for root in roots:
                walker.memory.place(root, Content(base=mask))
        if not roots:
            return Mark(mask, frozenset((("arrived", id(entry), number),)))
        return Mark(0, roots) if entry.event != "goal" else Mark(mask, roots)
    if isinstance(value, Ref) or entry.event in ("service", "execute"):
        return Mark(0, roots)
    return Mark(walker.given.get(entry, 0), roots)


def _handed(walker: Walker, entry: Scheduled, root: Activation) -> list[Mark]:
    """The objects of a library with which it calls a callback, in front of what nobody knows."""
    classes = walker.handed.get(entry, ())[: _free(entry)]
    return [Mark(0, frozenset((walker.shape.made(root, -1 - n, name),))) for n, name in enumerate(classes)]


def _free(entry: Scheduled) -> int:
    """How many parameters of a callback nothing is bound to yet."""
    function, bound = entry.callback, 0
    while isinstance(function, (BoundMethod, Partial)):
        bound += 1 if isinstance(function, BoundMethod) else len(function.arguments)
        function = function.function
    return max(len(function.code.parameters.positional) - bound, 0) if isinstance(function, Function) else 0


def _implicit(walker: Walker, entry: Scheduled) -> bool:
    """Whether nothing in the program hands on this callback: Python calls it by itself, or a library that has an object of its class."""
    return entry.event in (BY_PYTHON, BY_BASE, BY_WINDOW) or (
        entry.event == BY_LIBRARY and entry not in walker.registered
    )


def _as_registered(walker: Walker, entry: Scheduled) -> Mark:
    """What a callback is made of: the defaults of a function that is made on the spot, and what partial functions give."""
    found = walker.callbacks.get(entry, NOTHING)
    callback = entry.callback
    while isinstance(callback, Partial):
        callback = callback.function
    return found if isinstance(callback, Function) else Mark(0, found.roots)


def _beginning(callback: Value) -> Place | None:
    """The first line of a callback."""
    function = function_behind(callback)
    if function is not None and not function.code.file.startswith("models:"):
        return Place(function.code.file, function.code.line)
    return None


def _which(entry: Scheduled) -> int:
    """Which of the arguments is the message or request: of a service, the first that is an object and not the service itself."""
    args = entry.args or ()
    if entry.event != "service" or len(args) < 2:
        return 0
    return max(0, len(args) - 2) if entry.answered is not None else int(isinstance(args[0], Unknown))


def _sources(walker: Walker, entry: Scheduled) -> Iterator[Source]:
    """The events in which a callback runs."""
    kind = _EVENTS.get(entry.event)
    if entry.event in _ANSWERS:
        yield from _answers(walker, entry)
    elif kind is None:
        yield Source(_PLAIN.get(entry.event, "thread"))
    else:
        arriving = [Source(kind[0], node=e.address, given=e.name) for e in walker.shape.entities if e.kind == kind[1]]
        yield from _arriving(walker, entry) or arriving or [Source("thread")]


def _owners(entry: Scheduled, registered: Registered | None) -> Iterator[Root]:
    """The objects that stop a callback where they are stopped: its timer, its subscription."""
    if registered is None:
        return
    yield from registered.receivers
    yield from registered.by.refs
    if entry.event == "timer":  # in C++ it is handed on with the callback
        yield from (root for value in entry.args or () for root in refs_of(value))
    elif entry.event in ("message", "service"):  # and these are made beside it
        yield from (made for seen in (registered.among.seen.values() if registered.among else ()) for made in seen.made)


def _arriving(walker: Walker, entry: Scheduled) -> list[Source]:
    """What arrives: at the objects that the callback was given to, else at those made with it; none where nobody knows."""
    registered, kind = walker.watch.entries.get(entry), _EVENTS.get(entry.event)
    if registered is None or kind is None:
        return []
    found = [s for r in registered.receivers if (s := walker.shape.entity(r, kind[0])) is not None]
    if found:
        return found
    made = [e for turn, e in registered.effects() if turn == registered.turn and isinstance(e, EntityEffect)]
    return [Source(kind[0], node=e.address, given=e.name) for e in made if e.kind == kind[1]]


def _came(walker: Walker, entry: Scheduled) -> bool:
    """Whether what a callback is called with came in where it was registered, as with message filters."""
    return (
        entry.event in _EVENTS
        and not _arriving(walker, entry)
        and any(walker.memory.known(root) is not None for value in entry.args or () for root in refs_of(value))
    )


def _answers(walker: Walker, entry: Scheduled) -> Iterator[Source]:
    """What a future waits for: the answers in it."""
    mask = 0
    for value in entry.args or ():
        mask |= walker.memory.deep(Mark(0, frozenset(refs_of(value))))
    for source in walker.sources.apart(mask)[0]:
        if source.kind in ("response", "result"):
            yield source


def _node(walker: Walker, entry: Scheduled) -> int | None:
    """The node on whose behalf a callback runs."""
    registered = walker.watch.entries.get(entry)
    for receiver in registered.receivers if registered is not None else ():
        if receiver in walker.shape.nodes:
            return receiver
    for address in refs_of(getattr(entry.callback, "receiver", entry.callback)):
        if address in walker.shape.nodes:
            return address
    return _only(walker)
