# SPDX-License-Identifier: Apache-2.0
"""Which objects does nothing hold any more, when the callbacks run once more? What is made there next takes the place of these.

def on_timer(self):
    msg = String()           the message of the last time is gone: here is one new message, not one of several
    self.pub.publish(msg)    (so is the cell of a local variable that an inner function captures, or, in C++, whose address is taken)
def on_scan(self, msg):
    self.last = msg          held: the next one that arrives is another one beside it
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator
from itertools import repeat
from typing import TYPE_CHECKING, Final

from rosward.domain.compound import BoundMethod, Descriptor, External, Native, Partial, Slice, Super, Tuple
from rosward.domain.heap import Obj
from rosward.domain.memory import SHIFT, Page
from rosward.domain.slots import Overloads, Pointer, Slot
from rosward.domain.suspended import Suspension
from rosward.domain.values import Choice, Const, Function, Ref, Text, Unknown, Value
from rosward.engine.running.schedule_book import PageLeads
from rosward.engine.unknown.held import values_in

if TYPE_CHECKING:
    from rosward.engine.machine import Engine
    from rosward.engine.running.frame import Frame
    from rosward.engine.running.scheduled import Scheduled

_LASTING: Final = ("class", "module")
ARRIVING: Final = ("message", "service")
"""Events with which new messages arrive as arguments."""
_NOTHING: Final = repeat(None)
_MOST_PAIRS: Final = 2_000
_LEAVES: Final = frozenset((Const, Text, Unknown, Native, External))


def unheld(machine: Engine, entries: Iterable[Scheduled], frames: Iterable[Frame]) -> set[int]:
    """The addresses to which nothing leads: no class, module or node, no variable that lasts, no frame of the main body, no callback.

    A callback refers to the message that arrives with it only if it is given another time, too.
    """
    if machine.advancing:
        return set()  # generators that are running hold values elsewhere
    held = {effect.address for effect in machine.log.nodes} | machine.lasting
    inside: dict[int, tuple[int, ...]] = {}  # where objects lead
    for number, page in machine.state.heap.shared_pages():
        leads = _leads_of(machine, number, page)
        held.update(leads.held)
        inside.update(leads.inside)
    held.update(r.address for r in _refs(machine.schedule_book.raised))
    arriving: Counter[int] = Counter()
    seen: set[tuple[int, int]] = set()  # the pairs of pages, by id(), that another callback had as well
    for entry in entries:
        held.update(r.address for r in _refs((entry.callback, *(() if entry.answered is None else (entry.answered,)))))
        for ref in _refs(entry.args or ()):
            arriving[ref.address] += 1 if entry.event in ARRIVING else 2
        for pair in entry.state.heap.pages_apart(machine.state.heap):
            key = (id(pair[0]), id(pair[1]))
            if key not in seen:
                seen.add(key)
                held.update(_only_there(machine, key, pair))
    held.update(address for address, count in arriving.items() if count > 1)
    for frame in frames:
        held.update(frame.cells)
        held.update(r.address for r in _refs(frame.registers))
        held.update(r.address for r in _refs((frame.exits.value,)))
    held.update(r.address for r in _refs(machine.trace.handed))
    work = [address for address in inside if address in held]
    while work:
        for address in inside[work.pop()]:
            if address in inside and address not in held:
                held.add(address)
                work.append(address)
    return inside.keys() - held


def _leads_of(machine: Engine, number: int, page: Page) -> PageLeads:
    """Where the objects of a page lead; most pages are those of the last time."""
    kept, inner = machine.schedule_book.leads, machine.inner
    before = kept.get(number)
    if before is not None and before.page is page:
        if before.inner == len(inner):
            return before
        if inner.keys().isdisjoint(before.inside):
            found = kept[number] = before._replace(inner=len(inner))
            return found
    held: set[int] = set()
    inside: dict[int, tuple[int, ...]] = {}
    first = machine.library.first_address
    for address, obj in enumerate(page, number << SHIFT):
        if obj is None:
            continue
        to = [r.address for r in _refs(values_in(obj))]
        to += _cells_of(obj)
        if obj.kind in _LASTING or address < first or (address in inner and not _is_message(obj)):
            held.update(to)
        else:
            inside[address] = tuple(to)
    found = kept[number] = PageLeads(page, len(inner), frozenset(held), inside)
    return found


def _is_message(obj: Obj) -> bool:
    return obj.kind == "instance" and obj.cls.__class__ is External


def _cells_of(obj: Obj) -> Iterator[int]:
    """The variables of a generator that waits, which inner functions capture."""
    if isinstance(obj.payload, Suspension):
        for point in obj.payload.points:
            yield from point.cells


def _only_there(machine: Engine, key: tuple[int, int], pair: tuple[Page, Page | None]) -> frozenset[int]:
    """Where objects lead that a callback finds as they were when it was registered: those of a page that are not on the one that is here."""
    kept = machine.schedule_book.leads_there
    found = kept.get(key)
    if found is None:
        if len(kept) > _MOST_PAIRS:
            kept.clear()
        page, own = pair
        here = _NOTHING if own is None else own
        objects = [obj for obj, known in zip(page, here, strict=False) if known is None and obj is not None]
        addresses = frozenset([r.address for obj in objects for r in _refs(values_in(obj))])
        found = kept[key] = (pair, addresses)  # with the pages: no other takes the place of one
    return found[1]


def _refs(values: Iterable[Value]) -> Iterator[Ref]:
    """The references in values."""
    for value in values:
        cls = value.__class__
        if cls in _LEAVES:
            continue
        if value.__class__ is Ref:
            yield value
        elif isinstance(value, Choice):
            yield from _refs(value.options)
        elif isinstance(value, Tuple):
            yield from _refs(value.items)
        elif isinstance(value, BoundMethod):
            yield from _refs((value.receiver, value.function))
        elif isinstance(value, Partial):
            yield from _refs((value.function, *value.arguments, *(v for _, v in value.keywords)))
        elif isinstance(value, Function):
            yield from map(Ref, value.cells)
            yield from _refs((*value.defaults, *(v for _, v in value.kwdefaults)))
        elif isinstance(value, Pointer):
            yield from _refs((value.target,))
        elif isinstance(value, Slot):
            yield from _refs((value.base, *((value.key,) if isinstance(value.key, Value) else ())))
        elif isinstance(value, Overloads):
            yield from _refs((*value.functions, *(() if value.receiver is None else (value.receiver,))))
        elif isinstance(value, Super):
            yield from _refs((value.receiver,))
        elif isinstance(value, Descriptor):
            yield from _refs(v for v in (value.getter, value.setter, value.deleter) if v is not None)
        elif isinstance(value, Slice):
            yield from _refs(value.fields())


def arrive(machine: Engine, entry: Scheduled) -> None:
    """Messages arrive with which a callback is called: new ones, or further ones beside those that are still held."""
    for argument in entry.args or ():
        if argument.__class__ is not Ref or entry.event not in ARRIVING:
            continue
        new = entry.state.heap.get(argument.address)
        if new is not None and new.cls.__class__ is External:
            machine.place_anew(argument.address, new.replace(many=False))
