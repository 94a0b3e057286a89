# SPDX-License-Identifier: Apache-2.0
"""C++: copies and construction, the fields of an object, the parts and elements of a value.

Pose p = last;           p is another object that holds the same: what is written to it is not in `last`
Point{x, y}              the fields in their order
for (auto & p : path)    the objects or slots that were seen
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Final

from rosward.domain.values import NONE, Ref, Value
from rosward.engine.running.seen import Bound, Seen, refs_of
from rosward.flow.body import Body
from rosward.flow.cpp import calls, outside
from rosward.flow.cpp.acts import acts, is_busy
from rosward.flow.cpp.values import (
    consists_of,
    copied,
    copies,
    elements,
    field,
    handed,
    in_braces,
    keys,
    nameless,
    operands,
    parts_of,
    settled,
    slots,
    sources,
    value,
    write,
)
from rosward.flow.marks import NOTHING, Mark, Root, demoted, is_slot
from rosward.flow.stored.content import Content
from rosward.ir import cpp, ops
from rosward.ir.registers import reads

if TYPE_CHECKING:
    from rosward.flow.walker import Walker


def _copy(walker: Walker, op: cpp.Copy | cpp.Convert, body: Body, seen: Seen) -> None:
    source = body.registers[op.src]
    given = acts(walker, op, body, seen, [source], certain=True) if is_busy(seen) else None
    found = value(walker, source)
    if isinstance(op, cpp.Convert) and op.kind == "buffer":
        found = found.joined(Mark(0, slots(source)))
    found = found if given is None else found.under(given.mask)
    if isinstance(op, cpp.Convert) and op.kind == "placed":
        target = body.registers[op.type]
        write(walker, target, copied(found, seen), sure=not seen.reasons)
        found = found.joined(Mark(target.mask, target.roots))
    body.registers[op.dst] = settled(walker, copied(found, seen), seen, body)


def _construct(walker: Walker, op: cpp.Construct, body: Body, seen: Seen) -> None:
    marks = [body.registers[a.register] for a in op.arguments]
    given = acts(walker, op, body, seen, marks, certain=True) if is_busy(seen) else None
    places = [r for r in seen.refs if isinstance(r, int) and r in seen.made]
    found = NOTHING
    for mark in marks:
        found = found.joined(value(walker, mark))
    if not seen.natives:
        written = _aggregate(walker, op, seen, places, marks)
        if written and seen.callees:
            calls.defaults(walker, seen, found, body.pc, written)
    if places:
        decides = given is not None and not seen.bound  # what a constructor is given is in the object, and chooses none
        mask = body.pc | (demoted(given.mask) if given is not None and decides else 0)
        body.registers[op.dst] = Mark(mask, frozenset(seen.refs))
        return
    found = found if given is None else found.joined(given)
    if not marks and seen.reasons and not seen.refs:  # an object of which nobody knows what it is
        root = walker.shape.made(body.activation, op.number, "object")
        walker.memory.renew(root)
        found = found.joined(Mark(0, frozenset((root,))))
    body.registers[op.dst] = settled(walker, copied(found, seen), seen, body)


def _aggregate(walker: Walker, op: cpp.Construct, seen: Seen, places: list[int], marks: list[Mark]) -> set[object]:
    """`Point{x, y}` of a class without a constructor: the fields in their order. The names of those that are written.

    What a message is made of by one value, is in any of its fields.
    """
    written: set[object] = set()
    built = _built(seen)
    for place in places if marks else ():
        parts = parts_of(walker, place)
        is_message = seen.made.get(place) == "message"
        if place in built or not (is_message or seen.made.get(place) == "object" or walker.shape.kind(place) == "list"):
            continue
        given = None if is_message else _braced(walker, op, marks, parts)
        if given is None:
            mask, roots = 0, frozenset[Root]()
            for mark in marks:
                held = value(walker, mark)
                mask, roots = mask | walker.memory.deep(held), roots | held.roots
            walker.memory.write_any([r for r in consists_of(walker, place) if r not in built], Mark(mask, roots))
            continue
        for key, mark in given.items():
            _give_part(walker, seen, place, key, mark, parts.get(key, NONE))
        written |= given.keys()
    return written


def _built(seen: Seen) -> set[Root]:
    """The objects for which a constructor runs."""
    return {p for b in seen.bound.values() if b.given for p in b.given[0].places if b.function.code.name[:1] != "~"}


def _braced(
    walker: Walker, op: cpp.Construct, marks: list[Mark], parts: dict[object, Value]
) -> dict[object, Mark] | None:
    """What is given for each part; None where that is not known."""
    given: dict[object, Mark] = dict(enumerate(marks))
    braces = in_braces(walker, marks[0]) if len(marks) == 1 else None
    whole = op.form.startswith("brace") and next(iter(parts.values()), NONE).__class__ is Ref
    if braces is not None and not (whole and all(isinstance(n, int) for n in braces.slots)):
        inside = {key: mark.under(braces.base) for key, mark in braces.slots.items()}
        given = inside if len(inside) <= len(parts) or len(parts) < len(given) else given
    names = list(parts)
    if any(isinstance(key, int) and key >= len(names) and names != [] for key in given):
        return None
    if any(isinstance(key, str) and key not in parts for key in given):
        return None
    return {names[key] if isinstance(key, int) and names else key: mark for key, mark in given.items()}


def _give_part(walker: Walker, seen: Seen, owner: int, key: object, mark: Mark, held: Value) -> None:
    """The first value of a field or element: an object by value is another one."""
    found = copied(handed(walker, mark), seen)
    if held.__class__ is Ref:
        inner = next(iter(refs_of(held)))
        if inner not in found.roots and inner not in sources(seen).values() and inner not in _built(seen):
            write(walker, Mark(0, frozenset((inner,))), found)
        elif found.mask:  # of a copy of what was made of a pair of braces, the value says what is in it
            walker.memory.write_any([inner], Mark(found.mask), found.mask)
        found = Mark(found.mask, frozenset((inner,)))
    walker.memory.write(frozenset((owner,)), key, found)


def _initialise(walker: Walker, op: cpp.Initialise, body: Body, seen: Seen) -> bool | None:
    """Bases and fields of `this`: what is written for each, then what nothing is written for."""
    this, done = body.registers[0], set[object]()
    everything = NOTHING
    copied_yet = False
    for member in op.members:
        for block in (member.type_body, member.body):
            if block and block[0].number in body.activation.seen and not walker.run(block, body):
                return False
        known = {a.register: body.registers[a.register] for a in member.arguments}
        marks = list(known.values())
        for mark in marks:
            everything = everything.joined(mark)
        if not copied_yet and len(op.members) == 1:
            copied_yet = True
            copies(walker, seen, everything)
        elif not copied_yet:
            copied_yet = True
            copies(walker, seen, Mark(walker.memory.deep(everything)))
        _one_member(walker, body, seen, member, this, known, done)
    if not copied_yet:
        copies(walker, seen, everything)
    calls.callees(walker, body, seen, everything, certain=True, done=done)
    outside.natives(walker, body, seen, [everything], done=_fields(walker, this))
    outside.strange(walker, op.number, body, seen, [everything])
    calls.register(walker, body, seen, everything)
    return None


def _fields(walker: Walker, this: Mark) -> frozenset[Root]:
    """An object with those that are parts of it: into each was written what is given for it, and no more."""
    return frozenset(part for root in this.roots if isinstance(root, int) for part in consists_of(walker, root))


def _one_member(
    walker: Walker,
    body: Body,
    seen: Seen,
    member: cpp.MemberInit,
    this: Mark,
    known: dict[int, Mark],
    done: set[object],
) -> None:
    fields: set[int] = set()
    for root in this.roots:
        record = walker.shape.record(root) if isinstance(root, int) else None
        held = None if record is None else record.attrs.get(member.name)
        if held.__class__ is Ref and held is not None:
            fields |= set(refs_of(held))
    records = [walker.shape.record(root) for root in this.roots if isinstance(root, int)]
    is_field = any(record is not None and member.name in record.attrs for record in records)

    def mine(bound: Bound) -> bool:
        places = bound.given[0].places if bound.given else frozenset()
        if is_field:
            return bool(places & fields)
        return bool(places & this.roots) and any(g.registers & known.keys() for g in bound.given[1:])

    everything = NOTHING
    for mark in known.values():
        everything = everything.joined(mark)
    parts = frozenset[Root](part for field in fields for part in consists_of(walker, field))
    if not parts.isdisjoint(seen.made):  # what stands in the source now: it may be a member further up
        copies(walker, seen, everything, but=seen.made.keys() - parts)
    given = calls.callees(walker, body, seen, everything, registers=known, certain=True, only=mine, done=done)
    if given is not None and (fields or not is_field):
        return
    found = NOTHING
    for mark in known.values():
        found = found.joined(value(walker, mark) if not any(is_slot(r) for r in mark.roots) else _either(walker, mark))
    found = copied(found, seen).under(body.pc)
    if not is_field:  # a base that is a container
        mark = Mark(walker.memory.deep(found), found.roots)
        walker.memory.write_any(this.roots, mark, mark.mask)
        return
    for root in this.roots:
        if isinstance(root, int):
            if len(known) == 1 or not fields:
                _give_part(walker, seen, root, member.name, found, parts_of(walker, root).get(member.name, NONE))
            else:
                mark = Mark(walker.memory.deep(found), found.roots)
                for inner in fields:
                    walker.memory.write_any(consists_of(walker, inner), mark, mark.mask)


def _either(walker: Walker, mark: Mark) -> Mark:
    """A field that is a reference leads to the slot, any other holds what stands there."""
    found = value(walker, mark)
    return Mark(found.mask, found.roots | slots(mark))


def _end_scope(walker: Walker, op: cpp.EndScope, body: Body, seen: Seen) -> None:
    """Destructors run; of what a pointer or a container holds, if anything."""
    if not seen.bound:
        return
    marks, held = [body.registers[r] for r in op.variables], 0
    for mark in marks:
        found = value(walker, mark)
        held |= found.mask | walker.memory.size(found.roots)
    acts(walker, op, body, seen, marks, pc=demoted(held))


def _static_local(walker: Walker, op: cpp.StaticLocal, body: Body, seen: Seen) -> None:
    if op.body and op.body[0].number in body.activation.seen:
        before = walker.point(body)
        if walker.run(op.body, body):
            first = value(walker, body.registers[op.result])
            for root in seen.refs:
                if is_slot(root):
                    walker.memory.write_any([root], first)
            before.join(walker.point(body))
        walker.go(body, before)
    body.registers[op.dst] = Mark(body.pc, frozenset(seen.refs))


def _default(walker: Walker, op: cpp.Default, body: Body, _seen: Seen) -> None:
    if op.body and op.body[0].number in body.activation.seen:
        before = walker.point(body)
        if walker.run(op.body, body):
            before.join(walker.point(body))
        walker.go(body, before)


def _braces(walker: Walker, op: cpp.Braces, body: Body, seen: Seen) -> None:
    root = walker.shape.made(body.activation, op.number, "", "tuple")
    marks = [body.registers[a.register].under(body.pc) for a in op.items]
    if any(a.kind == "pack" for a in op.items) or (any(op.names) and not all(op.names)):
        walker.memory.place(root, Content(0, operands(body, reads(op)), body.pc))
    else:
        keys_of = op.names if any(op.names) else range(len(marks))
        walker.memory.place(root, Content(0, NOTHING, body.pc, dict(zip(keys_of, marks, strict=False))))
    body.registers[op.dst] = Mark(body.pc, frozenset(seen.refs) | {root})


def _elements(walker: Walker, op: cpp.Elements, body: Body, seen: Seen) -> None:
    source = body.registers[op.src]
    held = value(walker, source)
    given = acts(walker, op, body, seen, [source]) if seen.bound else None
    found = elements(walker, held)
    if given is not None:
        found = found.joined(given).joined(elements(walker, given))
    if op.slot:
        is_known = bool(seen.refs) and not seen.reasons
        found = Mark(held.mask if is_known else found.mask, found.roots | slots(source))
    for address in seen.made:  # the pairs of a map
        whole = elements(walker, held)
        keys = whole.under(walker.memory.size(held.roots))
        walker.memory.place(address, Content(0, NOTHING, 0, {"first": keys, "second": whole}))
    root = walker.shape.made(body.activation, op.number, "elements", "tuple")
    walker.memory.place(root, Content(0, found.under(body.pc), walker.memory.size(held.roots) | held.mask))
    body.registers[op.dst] = Mark(body.pc, frozenset((root,)))


def _destructure(walker: Walker, op: cpp.Destructure, body: Body, seen: Seen) -> None:
    source = body.registers[op.src]
    held = value(walker, source)
    for number, register in enumerate(op.dsts):
        refs = seen.parts.get(number, seen.refs)
        found = Mark(held.mask | body.pc, nameless(held))
        if number == 0:
            found = found.under(keys(walker, slots(source)))
        for root in held.roots:
            record = walker.shape.record(root) if isinstance(root, int) else None
            names = list(record.attrs) if record is not None and record.kind == "instance" else []
            if op.slot and refs and not seen.reasons:
                continue
            part = field(walker, root, names[number]) if number < len(names) else walker.memory.read((root,), number)
            found = found.joined(part)
        places = frozenset(refs) | nameless(found)
        if op.slot and (not refs or seen.reasons):
            places |= slots(source)
        body.registers[register] = Mark(found.mask, places)


def _spread(walker: Walker, op: cpp.Spread, body: Body, seen: Seen) -> None:
    found = operands(body, [op.init] if op.init != ops.NO_REGISTER else [])
    for pack, item in zip(op.packs, op.items, strict=False):
        mark = body.registers[pack]
        inside = elements(
            walker, Mark(0, frozenset(r for r in mark.roots if not isinstance(r, int) and r[0] == "tuple"))
        )
        body.registers[item] = mark.joined(inside)
    if op.body and op.body[0].number in body.activation.seen:
        before = walker.point(body)
        if walker.run(op.body, body):
            found = found.joined(body.registers[op.result])
            before.join(walker.point(body))
        walker.go(body, before)
    given = acts(walker, op, body, seen, [found]) if seen.bound else None
    found = value(walker, found) if given is None else value(walker, found).joined(given)
    body.registers[op.dst] = settled(walker, found, seen, body)


def _placed(walker: Walker, op: cpp.Placed, body: Body, seen: Seen) -> None:
    source = body.registers[op.src]
    if op.pack:
        tuples = frozenset(r for r in source.roots if not isinstance(r, int) and r[0] == "tuple")
        source = source.joined(elements(walker, Mark(0, tuples)))
    held = value(walker, source)
    found = held if op.how == "found" else copied(held, seen)
    places = frozenset(r for r in seen.refs if is_slot(r)) - slots(source)
    write(walker, Mark(0, places), found, sure=len(places) == 1)
    if op.how == "taken" or seen.reasons or not seen.refs:
        body.registers[op.dst] = settled(walker, found, seen, body)
    else:
        mask = 0 if frozenset(seen.refs) == places else source.mask
        body.registers[op.dst] = Mark(mask | body.pc, frozenset(seen.refs) | nameless(found))


TABLE: Final[dict[type[ops.Op], Any]] = {
    cpp.Copy: _copy,
    cpp.Convert: _copy,
    cpp.Construct: _construct,
    cpp.Initialise: _initialise,
    cpp.EndScope: _end_scope,
    cpp.StaticLocal: _static_local,
    cpp.Default: _default,
    cpp.Braces: _braces,
    cpp.Elements: _elements,
    cpp.Destructure: _destructure,
    cpp.Spread: _spread,
    cpp.Placed: _placed,
}
