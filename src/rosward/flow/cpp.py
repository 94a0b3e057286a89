# SPDX-License-Identifier: Apache-2.0
"""The operations of C++: names, members and what pointers lead to, copies, construction, calls.

x_ = msg->x      what stands in the field x of the message is written to the slot of x_
Pose p = last;   p is another object that holds the same: what is written to it is not in `last`
f(p)             the body of f, with the object or the slot of p; of code that nobody knows, p may hold anything that it is given
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Final

from rosward.domain.values import Ref
from rosward.engine.seen import Bound, refs_of
from rosward.flow import cpp_calls, straight
from rosward.flow.body import Body
from rosward.flow.content import Content
from rosward.flow.cpp_values import (
    copied,
    copies,
    elements,
    field,
    nameless,
    operands,
    settled,
    slots,
    sources,
    under_choice,
    value,
    write,
)
from rosward.flow.marks import NOTHING, Mark, Root, demoted
from rosward.flow.memory import is_slot
from rosward.flow.outside import out
from rosward.flow.reading import arising, constant
from rosward.ir import cpp, ops
from rosward.ir.check import reads
from rosward.ir.program import CPP

if TYPE_CHECKING:
    from rosward.engine.seen import Seen
    from rosward.flow.walker import Walker


def _acts(
    walker: Walker, op: ops.Op, body: Body, seen: Seen, marks: list[Mark], *, pc: int = 0, certain: bool = False
) -> Mark | None:
    """All that an operation does besides: what it makes, calls, writes; what that gives. None where it does nothing."""
    everything = NOTHING
    for mark in marks:
        everything = everything.joined(mark)
    keys = tuple([constant(seen, a.register) for a in op.arguments]) if isinstance(op, cpp.Invoke) else ()
    cpp_calls.fresh(walker, seen, everything)
    result = cpp_calls.callees(walker, body, seen, everything, pc=pc, certain=certain)
    if result is not None and sources(seen):
        given = Mark(0, frozenset(p for b in seen.bound.values() for g in b.given for p in g.places))
        copies(walker, seen, everything, but=frozenset(walker.memory.reached(given)))
    cpp_calls.sends(walker, body, seen, marks)
    for done in (
        cpp_calls.natives(walker, body, seen, marks, keys),
        cpp_calls.strange(walker, op.number, body, seen, marks),
    ):
        if done is not None:
            result = done if result is None else result.joined(done)
    cpp_calls.register(walker, body, seen, everything)
    if any(n in _SPINS for n in seen.natives):
        walker.join_beside()
    return result


_SPINS: Final = frozenset({"rosward.spin", "rosward.spun"})


# What something is


def _known(_walker: Walker, op: Any, body: Body, _seen: Seen) -> None:
    body.registers[op.dst] = Mark(body.pc)


def _name(walker: Walker, op: cpp.Name, body: Body, seen: Seen) -> None:
    """A variable of a scope, a member of `this`, a function, a type."""
    given = _acts(walker, op, body, seen, []) if seen.callees or seen.summaries or seen.bound else None
    mask, name = body.pc | arising(walker, seen), op.parts[-1].name
    if given is not None:
        for address in seen.wrote:
            walker.memory.write_any([address], Mark(value(walker, given).mask, nameless(given)))
        mask |= given.mask
    found = Mark(mask)
    if not op.slot:
        held = (
            body.registers[0] if body.registers and body.activation.code.parameters.names[:1] == ("this",) else NOTHING
        )
        for root in held.roots:
            found = found.joined(field(walker, root, name))
        for address, key in walker.shape.named(name):
            found = found.joined(walker.memory.read((address,), key))
    extern = frozenset[Root](("external", n) for n in seen.externals)
    roots = frozenset(seen.refs) | nameless(found) | extern
    if seen.reasons and not op.slot:
        roots |= found.roots
    body.registers[op.dst] = Mark(found.mask, roots)


def _cell_slot(walker: Walker, op: cpp.CellSlot, body: Body, seen: Seen) -> None:
    found = walker.memory.read(seen.cells, "value")
    mask = 0 if any(is_slot(r) and r[1] in seen.cells for r in seen.refs) else found.mask  # type: ignore[index]  # a slot
    body.registers[op.dst] = Mark(mask | body.pc, frozenset(seen.refs))


def _read(walker: Walker, op: cpp.Read, body: Body, seen: Seen) -> None:
    body.registers[op.dst] = settled(walker, value(walker, body.registers[op.src]), seen, body)


def _member(walker: Walker, op: cpp.Member, body: Body, seen: Seen) -> None:
    owner = body.registers[op.obj]
    held = value(walker, owner)
    given = _acts(walker, op, body, seen, [owner]) if seen.bound or seen.callees else None
    found = Mark(held.mask | body.pc, nameless(held))
    if op.slot:
        if not seen.refs or seen.reasons:  # a part of something that is not known stands where that does
            found = found.joined(Mark(0, slots(owner)))
    else:
        for root in held.roots:
            found = found.joined(field(walker, root, op.name))
        for address, key in walker.shape.named(op.name):
            found = found.joined(walker.memory.read((address,), key))
    found = found if given is None else found.joined(given)
    mark = settled(walker, found, seen, body)
    if op.slot:
        mark = Mark(
            mark.mask,
            frozenset(r for r in mark.roots if r not in held.roots or r in seen.refs or not isinstance(r, int)),
        )
    body.registers[op.dst] = mark


def _item(walker: Walker, op: cpp.Item, body: Body, seen: Seen) -> None:
    owner, index = body.registers[op.obj], body.registers[op.index]
    held, number = value(walker, owner), value(walker, index)
    given = _acts(walker, op, body, seen, [owner, index]) if seen.bound else None
    for address in seen.wrote if given is None else ():  # `map[key]` makes what is not there
        walker.memory.write_any([address], NOTHING, body.pc | number.mask)
    found = Mark(held.mask | number.mask | body.pc, nameless(held))
    if op.slot:
        if not seen.refs or seen.reasons:
            found = found.joined(Mark(0, slots(owner)))
    else:
        key = constant(seen, op.index)
        for root in held.roots:
            found = found.joined(walker.memory.read((root,), key) if key is not None else walker.memory.of(root).whole)
    found = found if given is None else found.joined(given)
    mark = settled(walker, found, seen, body)
    body.registers[op.dst] = Mark(mark.mask | arising(walker, seen, read=True), mark.roots)


def _deref(walker: Walker, op: cpp.Deref, body: Body, seen: Seen) -> None:
    pointer = body.registers[op.src]
    given = _acts(walker, op, body, seen, [pointer]) if seen.bound else None
    found = Mark(pointer.mask | body.pc, nameless(pointer) | slots(pointer))
    if not op.slot:
        found = value(walker, found)
    found = found if given is None else found.joined(given)
    body.registers[op.dst] = settled(walker, found, seen, body)


def _address_of(walker: Walker, op: cpp.AddressOf, body: Body, seen: Seen) -> None:
    source = body.registers[op.src]
    for address in seen.made:
        walker.memory.place(address, Content(0, value(walker, source)))
    mark = settled(walker, Mark(source.mask, source.roots), seen, body)
    body.registers[op.dst] = mark


# Writing


def _assign(walker: Walker, op: cpp.Assign, body: Body, seen: Seen) -> None:
    target, source = body.registers[op.slot], body.registers[op.src]
    given = _acts(walker, op, body, seen, [target, source], certain=True) if _is_busy(seen) else None
    mark = value(walker, source)
    written = copied(mark, seen).under(under_choice(body, target))
    if op.operator != "=":
        written = written.joined(value(walker, target))
    own = any(b.function.code.name.startswith("operator") and "=" in b.function.code.name for b in seen.bound.values())
    if given is not None and not own:
        written = written.under(given.mask)
    if not own:
        write(walker, target, written, sure=not seen.reasons)
    if op.dst != ops.NO_REGISTER:
        body.registers[op.dst] = settled(walker, Mark(target.mask, target.roots), seen, body)


def _is_busy(seen: Seen) -> bool:
    return bool(seen.made or seen.bound or seen.callees or seen.natives or seen.strange or seen.summaries)


def _step(walker: Walker, op: cpp.Step, body: Body, seen: Seen) -> None:
    target = body.registers[op.slot]
    before = value(walker, target)
    given = _acts(walker, op, body, seen, [target], certain=True) if _is_busy(seen) else None
    if not seen.bound:
        write(walker, target, before.under(under_choice(body, target)))
    if op.dst != ops.NO_REGISTER:
        found = Mark(target.mask, target.roots) if op.prefix else before
        found = found if given is None else found.joined(given)
        body.registers[op.dst] = settled(walker, found, seen, body)


def _narrow(_walker: Walker, _op: cpp.Narrow, _body: Body, _seen: Seen) -> None:
    """What is known of a value is no other value."""


# Copies and construction


def _copy(walker: Walker, op: cpp.Copy | cpp.Convert, body: Body, seen: Seen) -> None:
    source = body.registers[op.src]
    given = _acts(walker, op, body, seen, [source], certain=True) if _is_busy(seen) else None
    found = value(walker, source)
    if isinstance(op, cpp.Convert) and op.kind == "buffer":
        found = found.joined(Mark(0, slots(source)))
    found = found if given is None else found.under(given.mask)
    body.registers[op.dst] = settled(walker, copied(found, seen), seen, body)


def _construct(walker: Walker, op: cpp.Construct, body: Body, seen: Seen) -> None:
    marks = [body.registers[a.register] for a in op.arguments]
    given = _acts(walker, op, body, seen, marks, certain=True) if _is_busy(seen) else None
    places = [r for r in seen.refs if isinstance(r, int) and r in seen.made]
    found = NOTHING
    for mark in marks:
        found = found.joined(value(walker, mark))
    if not seen.natives:
        _aggregate(walker, seen, places, marks)
    if places:
        mask = body.pc | demoted(given.mask if given is not None else 0)
        body.registers[op.dst] = Mark(mask, frozenset(seen.refs))
        return
    found = found if given is None else found.joined(given)
    body.registers[op.dst] = settled(walker, copied(found, seen), seen, body)


def _aggregate(walker: Walker, seen: Seen, places: list[int], marks: list[Mark]) -> None:
    """`Point{x, y}` of a class without a constructor: the fields in their order."""
    built = {p for b in seen.bound.values() if b.given for p in b.given[0].places if b.function.code.name[:1] != "~"}
    for place in places:
        record = walker.shape.record(place)
        site = seen.made.get(place)
        if not marks or record is None or place in built or site != "object":
            continue
        given = _braced(walker, marks)
        names = list(record.attrs)
        if given is None or len(given) > len(names):
            whole = NOTHING
            for mark in marks:
                whole = whole.joined(value(walker, mark))
            walker.memory.write_any([place], Mark(walker.memory.deep(whole), whole.roots))
            continue
        for name, mark in zip(names, given, strict=False):
            _give_field(walker, seen, place, name, mark)


def _braced(walker: Walker, marks: list[Mark]) -> list[Mark] | None:
    """The arguments, of one pair of braces what is in it; None where the order is not known."""
    if len(marks) != 1:
        return marks
    roots = [r for r in marks[0].roots if not isinstance(r, int) and r[0] == "tuple"]
    if len(roots) != 1:
        return marks
    held = walker.memory.of(roots[0]).slots
    return [held[n] for n in range(len(held))] if all(n in held for n in range(len(held))) else None


def _give_field(walker: Walker, seen: Seen, owner: int, name: str, mark: Mark) -> None:
    """The first value of a field: an object by value is another one."""
    found = copied(value(walker, mark), seen)
    record = walker.shape.record(owner)
    held = None if record is None else record.attrs.get(name)
    if held.__class__ is Ref and held is not None:
        inner = next(iter(refs_of(held)))
        if inner not in found.roots and inner not in seen.made:
            write(walker, Mark(0, frozenset((inner,))), found)
        found = Mark(found.mask, frozenset((inner,)))
    walker.memory.write(frozenset((owner,)), name, found)


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
    cpp_calls.callees(walker, body, seen, everything, certain=True, done=done)
    cpp_calls.natives(walker, body, seen, [everything])
    cpp_calls.strange(walker, op.number, body, seen, [everything])
    cpp_calls.register(walker, body, seen, everything)
    return None


def _one_member(
    walker: Walker,
    body: Body,
    seen: Seen,
    member: cpp.MemberInit,
    this: Mark,
    known: dict[int, Mark],
    done: set[object],
) -> None:
    fields: set[Root] = set()
    for root in this.roots:
        record = walker.shape.record(root) if isinstance(root, int) else None
        held = None if record is None else record.attrs.get(member.name)
        if held.__class__ is Ref and held is not None:
            fields |= set(refs_of(held))
    is_field = any(
        record is not None and member.name in record.attrs
        for root in this.roots
        if isinstance(root, int) and (record := walker.shape.record(root)) is not None
    )

    def mine(bound: Bound) -> bool:
        places = bound.given[0].places if bound.given else frozenset()
        if is_field:
            return bool(places & fields)
        return bool(places & this.roots) and any(g.registers & known.keys() for g in bound.given[1:])

    everything = NOTHING
    for mark in known.values():
        everything = everything.joined(mark)
    given = cpp_calls.callees(walker, body, seen, everything, registers=known, certain=True, only=mine, done=done)
    if not is_field or (given is not None and fields):
        return
    found = NOTHING
    for mark in known.values():
        found = found.joined(value(walker, mark) if not any(is_slot(r) for r in mark.roots) else _either(walker, mark))
    found = copied(found, seen).under(body.pc)
    for root in this.roots:
        if isinstance(root, int):
            if len(known) == 1 or not fields:
                _give_field(walker, seen, root, member.name, found)
            else:
                for inner in fields:
                    walker.memory.write_any([inner], Mark(walker.memory.deep(found), found.roots))


def _either(walker: Walker, mark: Mark) -> Mark:
    """A field that is a reference leads to the slot, any other holds what stands there."""
    found = value(walker, mark)
    return Mark(found.mask, found.roots | slots(mark))


def _end_scope(walker: Walker, op: cpp.EndScope, body: Body, seen: Seen) -> None:
    if seen.bound:
        _acts(walker, op, body, seen, [body.registers[r] for r in op.variables])


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


# Parts and elements


def _braces(walker: Walker, op: cpp.Braces, body: Body, seen: Seen) -> None:
    root = walker.shape.made(body.activation, op.number, "", "tuple")
    marks = [body.registers[a.register].under(body.pc) for a in op.items]
    if any(op.names) or any(a.kind == "pack" for a in op.items):
        walker.memory.place(root, Content(0, operands(body, reads(op)), body.pc))
    else:
        walker.memory.place(root, Content(0, NOTHING, body.pc, dict(enumerate(marks))))
    body.registers[op.dst] = Mark(body.pc, frozenset(seen.refs) | {root})


def _elements(walker: Walker, op: cpp.Elements, body: Body, seen: Seen) -> None:
    source = body.registers[op.src]
    held = value(walker, source)
    given = _acts(walker, op, body, seen, [source]) if seen.bound else None
    found = elements(walker, held)
    if given is not None:
        found = found.joined(given).joined(elements(walker, given))
    if op.slot:
        is_known = bool(seen.refs) and not seen.reasons
        found = Mark(held.mask if is_known else found.mask, found.roots | slots(source))
    for address in seen.made:  # the pairs of a map
        walker.memory.place(address, Content(0, elements(walker, held), 0))
    root = walker.shape.made(body.activation, op.number, "elements", "tuple")
    walker.memory.place(root, Content(0, found.under(body.pc), walker.memory.size(held.roots) | held.mask))
    body.registers[op.dst] = Mark(body.pc, frozenset((root,)))


def _destructure(walker: Walker, op: cpp.Destructure, body: Body, seen: Seen) -> None:
    source = body.registers[op.src]
    held = value(walker, source)
    for number, register in enumerate(op.dsts):
        refs = seen.parts.get(number, seen.refs)
        found = Mark(held.mask | body.pc, nameless(held))
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
    given = _acts(walker, op, body, seen, [found]) if seen.bound else None
    found = value(walker, found) if given is None else value(walker, found).joined(given)
    body.registers[op.dst] = settled(walker, found, seen, body)


# Calls


def _lambda(walker: Walker, op: cpp.MakeLambda, body: Body, seen: Seen) -> None:
    root: Root = ("captured", op.code.key)
    for number, register in enumerate(op.copies):
        mark = value(walker, body.registers[register]).under(body.pc)
        walker.memory.write_any([root], NOTHING, body.pc)
        old = walker.memory.of(root).slots.get(number, NOTHING)
        walker.memory.write(frozenset((root,)), number, old.joined(mark))
    body.registers[op.dst] = Mark(body.pc, frozenset(seen.refs))


def _invoke(walker: Walker, op: cpp.Invoke | cpp.InvokeMember, body: Body, seen: Seen) -> None:
    marks = [body.registers[a.register] for a in op.arguments]
    pc = 0
    if isinstance(op, cpp.InvokeMember):
        walker.run(op.seen, body)
        function = body.registers[op.obj]
        marks = [function, *marks]
        if len({b.function.code.key for b in seen.bound.values()}) > 1:
            pc = demoted(value(walker, function).mask)
    else:
        function = body.registers[op.func]
        pc = demoted(value(walker, function).mask)
        if nameless(function) or function.mask & ~body.pc:
            marks = [*marks[:0], *marks, Mark(function.mask, nameless(function))] if not seen.effects else marks
    given = _acts(walker, op, body, seen, marks, pc=pc)
    if given is None:
        given = Mark(walker.memory.deep(value(walker, operands(body, reads(op)))))
    mark = settled(walker, copied(given, seen), seen, body)
    mask = mark.mask | pc | arising(walker, seen)
    body.registers[op.dst] = Mark(mask, mark.roots)


def _binary(walker: Walker, op: ops.Binary, body: Body, seen: Seen) -> None:
    """`stream << value` among others."""
    if body.activation.code.language != CPP:
        straight.plain(walker, op, body, seen)
        return
    left, right = body.registers[op.left], body.registers[op.right]
    held, other = value(walker, left), value(walker, right)
    kind = _stream(walker, held)
    mask = walker.memory.deep(other) | body.pc
    if op.operator == "<<" and kind:
        if kind != "text":
            out(walker, kind, mask)
        if kind != "stdout":
            walker.memory.write_any([r for r in held.roots if isinstance(r, int)] or slots(left), Mark(mask), mask)
        body.registers[op.dst] = Mark(left.mask, left.roots)
        return
    if _is_busy(seen):
        given = _acts(walker, op, body, seen, [left, right], certain=True)
        mark = Mark(walker.memory.deep(held) | mask) if given is None else given
        if seen.bound and given is not None:
            body.registers[op.dst] = settled(walker, given, seen, body)
            return
        body.registers[op.dst] = settled(walker, mark.joined(held).joined(other), seen, body)
        return
    if seen.wrote:
        cpp_calls.natives(walker, body, seen, [left, right])
    straight.plain(walker, op, body, seen)
    body.registers[op.dst] = settled(walker, 
        body.registers[op.dst].joined(Mark(0, nameless(held) | nameless(other))), seen, body
    )


_STREAMS: Final = {"std.cout": "stdout", "std.cerr": "stdout", "std.clog": "stdout", "std.wcout": "stdout"}


def _stream(walker: Walker, mark: Mark) -> str:
    """What kind of stream a value is; '' where it is none."""
    for root in mark.roots:
        if not isinstance(root, int):
            if root[0] == "external" and root[1] in _STREAMS:
                return _STREAMS[str(root[1])]
            continue
        record = walker.shape.record(root)
        name = str(getattr(getattr(record, "cls", None), "name", ""))
        if name.endswith("stream"):
            return "file" if "fstream" in name else "text"
    return ""


def _computed(walker: Walker, op: Any, body: Body, seen: Seen) -> None:
    """What is computed: by an operator of a class, too."""
    if body.activation.code.language != CPP or not _is_busy(seen):
        (straight.TABLE.get(op.__class__) or straight.plain)(walker, op, body, seen)
        return
    marks = [body.registers[r] for r in reads(op)]
    given = _acts(walker, op, body, seen, marks, certain=True)
    mask = body.pc if given is None else given.mask
    if not seen.bound:
        for mark in marks:
            mask |= walker.memory.deep(mark)
    body.registers[op.dst] = settled(walker, Mark(mask, NOTHING.roots if given is None else given.roots), seen, body)


def _other(walker: Walker, op: Any, body: Body, seen: Seen) -> None:
    straight.plain(walker, op, body, seen)


TABLE: Final[dict[type[ops.Op], Any]] = {
    **dict.fromkeys((cpp.MakeType, cpp.TypeOfValue, cpp.Declared, cpp.LocalSymbol, cpp.UnknownValue), _known),
    cpp.Name: _name,
    cpp.CellSlot: _cell_slot,
    cpp.Read: _read,
    cpp.Member: _member,
    cpp.Item: _item,
    cpp.Deref: _deref,
    cpp.AddressOf: _address_of,
    cpp.Assign: _assign,
    cpp.Step: _step,
    cpp.Narrow: _narrow,
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
    cpp.MakeLambda: _lambda,
    cpp.Invoke: _invoke,
    cpp.InvokeMember: _invoke,
    ops.Binary: _binary,
    ops.Unary: _computed,
    ops.Compare: _computed,
}
