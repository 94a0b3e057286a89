# SPDX-License-Identifier: Apache-2.0
"""The operations of C++: names, members and what pointers lead to, assignments, calls.

x_ = msg->x      what stands in the field x of the message is written to the slot of x_
f(p)             the body of f, with the object or the slot of p; of code that nobody knows, p may hold anything that it is given
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Final

from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, Class
from rosward.engine.running.seen import Seen, refs_of
from rosward.flow import computed, straight
from rosward.flow.body import Body
from rosward.flow.cpp import making, outside
from rosward.flow.cpp.acts import acts, is_busy
from rosward.flow.cpp.values import (
    copied,
    field,
    keys,
    nameless,
    objects,
    operands,
    settled,
    slots,
    under_choice,
    value,
    write,
)
from rosward.flow.library import perform, stop
from rosward.flow.marks import NOTHING, Mark, Root, demoted, is_slot, name_of, of_library, slot_of
from rosward.flow.outside import comes_in, out
from rosward.flow.reading import arising, constant
from rosward.flow.stored.content import Content
from rosward.ir import cpp, ops
from rosward.ir.registers import reads
from rosward.models.cpp.values.shared_storage import overlapping

if TYPE_CHECKING:
    from rosward.flow.walker import Walker


def _known(_walker: Walker, op: Any, body: Body, _seen: Seen) -> None:
    body.registers[op.dst] = Mark(body.pc)


def _type_of_value(walker: Walker, op: cpp.TypeOfValue, body: Body, _seen: Seen) -> None:
    """`typeid(*shape)`: which class it is, is decided by what decides which object it is."""
    source = body.registers[op.src]
    body.registers[op.dst] = Mark(body.pc | demoted(source.mask | value(walker, source).mask))


def _name(walker: Walker, op: cpp.Name, body: Body, seen: Seen) -> None:
    """A variable of a scope, a member of `this`, a function, a type."""
    given = acts(walker, op, body, seen, []) if seen.callees or seen.summaries or seen.bound else None
    mask, name = body.pc | arising(walker, seen), op.parts[-1].name
    if given is not None:
        for address in seen.wrote:
            walker.memory.write_any([address], Mark(value(walker, given).mask, nameless(given)))
        mask |= given.mask
    found = Mark(mask)
    if not op.slot:
        held = _this(body)
        for root in held.roots:
            found = found.joined(field(walker, root, name))
        for address, key in walker.shape.named(name):
            found = found.joined(walker.memory.read((address,), key))
    extern = frozenset(map(of_library, seen.externals))
    roots = frozenset(seen.refs) | nameless(found) | extern
    if seen.reasons and not op.slot:
        roots |= found.roots
        if not seen.refs:
            roots |= frozenset(
                ("slot", r, name, "one") for r in _this(body).roots if isinstance(r, int) and _has(walker, r, name)
            )
    body.registers[op.dst] = Mark(found.mask, roots)


def _this(body: Body) -> Mark:
    """The object whose method runs."""
    return body.registers[0] if body.registers and body.activation.code.parameters.names[:1] == ("this",) else NOTHING


def _has(walker: Walker, root: int, name: str) -> bool:
    record = walker.shape.record(root)
    return record is not None and name in record.attrs


def _cell_slot(walker: Walker, op: cpp.CellSlot, body: Body, seen: Seen) -> None:
    found = walker.memory.read(seen.cells, "value")
    mask = 0 if any(is_slot(r) and slot_of(r)[0] in seen.cells for r in seen.refs) else found.mask
    body.registers[op.dst] = Mark(mask | body.pc, frozenset(seen.refs))


def _load_cell(walker: Walker, op: ops.LoadCell, body: Body, seen: Seen) -> None:
    """The value of a variable; of one that holds something that nobody knows, where it stands, for what is called on it."""
    straight.TABLE[ops.LoadCell](walker, op, body, seen)
    if seen.reasons and not seen.refs:
        places = frozenset[Root](("slot", cell, "value", "one") for cell in seen.cells)
        body.registers[op.dst] = body.registers[op.dst].joined(Mark(0, places))


def _read(walker: Walker, op: cpp.Read, body: Body, seen: Seen) -> None:
    body.registers[op.dst] = settled(walker, value(walker, body.registers[op.src]), seen, body)


def _member(walker: Walker, op: cpp.Member, body: Body, seen: Seen) -> None:
    owner = body.registers[op.obj]
    held = value(walker, owner)
    given = acts(walker, op, body, seen, [owner]) if seen.bound or seen.callees else None
    found = Mark(held.mask | body.pc | _beside(walker, owner, held, op.name), nameless(held))
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


def _beside(walker: Walker, owner: Mark, held: Mark, name: str) -> int:
    """What is in a member because of others: those of a union are written together, the key of an entry stands where no slot is."""
    mask, shape = 0, walker.shape
    for root in held.roots:
        record = shape.record(root) if isinstance(root, int) else None
        if record is None or not isinstance(record.cls, Class):
            continue
        for other in overlapping(shape.record(record.cls.address), name):
            parts = refs_of(record.attrs.get(other, NONE))
            mask |= walker.memory.deep(Mark(0, frozenset((root, *parts))))
    if name == "first":
        mask |= keys(walker, frozenset(filter(is_slot, owner.roots)))
    return mask


def _item(walker: Walker, op: cpp.Item, body: Body, seen: Seen) -> None:
    owner, index = body.registers[op.obj], body.registers[op.index]
    held, named_by = value(walker, owner), walker.memory.deep(value(walker, index))
    given = acts(walker, op, body, seen, [owner, index]) if seen.bound else None
    for address in seen.wrote if given is None else ():  # `map[key]` makes what is not there
        walker.memory.write_any([address], NOTHING, body.pc | named_by)
    found = Mark(held.mask | named_by | body.pc, nameless(held))
    if op.slot:
        if not seen.refs or seen.reasons:
            found = found.joined(Mark(0, slots(owner)))
    else:
        key = constant(seen, op.index)
        for root in held.roots:
            found = found.joined(walker.memory.read((root,), key) if key is not None else walker.memory.of(root).whole)
        found = found.joined(_behind(walker, held if held.roots else owner, key))
    found = found if given is None else found.joined(given)
    mark = settled(walker, found, seen, body)
    body.registers[op.dst] = Mark(mark.mask | arising(walker, seen, read=True), mark.roots)


def _behind(walker: Walker, pointer: Mark, key: object) -> Mark:
    """What stands in an array at so many elements behind the one to which a pointer leads."""
    found = NOTHING
    for base, first, how in map(slot_of, slots(pointer)):
        if isinstance(base, int) and walker.shape.kind(base) == "list":
            known = how == "one" and isinstance(first, int) and isinstance(key, int)
            content = walker.memory.of(base)
            found = found.joined(content.read(first + key) if known else content.whole)  # type: ignore[operator]  # both are numbers
    return found


def _deref(walker: Walker, op: cpp.Deref, body: Body, seen: Seen) -> None:
    pointer = body.registers[op.src]
    given = acts(walker, op, body, seen, [pointer]) if seen.bound else None
    found = Mark(pointer.mask | body.pc, nameless(pointer) | slots(pointer))
    if not op.slot:
        found = value(walker, found)
        for root in pointer.roots:
            if (
                isinstance(root, int) and root not in seen.refs
            ):  # what is in an optional, or at the beginning of an array
                found = found.joined(walker.memory.of(root).whole)
    elif not seen.refs or seen.reasons:
        found = found.joined(Mark(0, pointer.roots))
    found = found if given is None else found.joined(given)
    body.registers[op.dst] = settled(walker, found, seen, body)


def _address_of(walker: Walker, op: cpp.AddressOf, body: Body, seen: Seen) -> None:
    source = body.registers[op.src]
    for address in seen.made:
        walker.memory.place(address, Content(0, value(walker, source)))
    mark = settled(walker, Mark(source.mask, source.roots), seen, body)
    body.registers[op.dst] = mark


def _assign(walker: Walker, op: cpp.Assign, body: Body, seen: Seen) -> None:
    target, source = _through(walker, body.registers[op.slot], seen), body.registers[op.src]
    given = None
    if is_busy(seen):
        converts = bool(seen.made) or not all(map(is_slot, target.roots))
        places = frozenset[Root]() if converts else frozenset(slot_of(r)[0] for r in target.roots)
        given = acts(walker, op, body, seen, [target, source], certain=True, done=places)
    mark = value(walker, source)
    written = copied(mark, seen).under(under_choice(body, target))
    before = value(walker, target)
    if op.operator != "=":
        written = written.joined(before)
    elif body.pc:  # a timer that nobody holds any more runs no more
        for root in before.roots:
            if isinstance(root, int) and walker.shape.class_name(root):
                stop(walker, root, body.pc)
    own = any(b.function.code.name.startswith("operator") and "=" in b.function.code.name for b in seen.bound.values())
    if given is not None and not own:
        written = written.under(given.mask)
    if not own:
        write(walker, target, written, sure=not seen.reasons)
    if op.dst != ops.NO_REGISTER:
        body.registers[op.dst] = settled(walker, Mark(target.mask, target.roots), seen, body)


def _through(walker: Walker, target: Mark, seen: Seen) -> Mark:
    """Where an assignment writes: to what a `std::reference_wrapper` refers to, where that is what was seen written."""
    mine = {slot_of(r)[0] if is_slot(r) else r for r in target.roots}
    others = seen.wrote - set(seen.made)
    if not others or mine & others or seen.bound or not slots(target) or any(isinstance(r, int) for r in target.roots):
        return target
    mask = target.mask | value(walker, target).mask
    return Mark(mask, nameless(target) | frozenset(("slot", each, None, "any") for each in others))


def _step(walker: Walker, op: cpp.Step, body: Body, seen: Seen) -> None:
    target = body.registers[op.slot]
    before = value(walker, target)
    given = acts(walker, op, body, seen, [target], certain=True) if is_busy(seen) else None
    if not seen.bound:
        write(walker, target, before.under(under_choice(body, target)))
    if op.dst != ops.NO_REGISTER:
        found = Mark(target.mask, target.roots) if op.prefix else before
        found = found if given is None else found.joined(given)
        body.registers[op.dst] = settled(walker, found, seen, body)


def _narrow(_walker: Walker, _op: cpp.Narrow, _body: Body, _seen: Seen) -> None:
    """What is known of a value is no other value."""


def _lambda(walker: Walker, op: cpp.MakeLambda, body: Body, seen: Seen) -> None:
    root: Root = ("captured", op.code.key)
    for number, register in enumerate(op.copies):
        mark = value(walker, body.registers[register]).under(body.pc)
        walker.memory.write_any([root], NOTHING, body.pc)
        old = walker.memory.of(root).slots.get(number, NOTHING)
        walker.memory.write(frozenset((root,)), number, old.joined(mark))
    body.registers[op.dst] = Mark(body.pc, frozenset((*seen.refs, root)))


def _invoke(walker: Walker, op: cpp.Invoke | cpp.InvokeMember, body: Body, seen: Seen) -> None:
    marks = [body.registers[a.register] for a in op.arguments]
    pc = 0
    called: tuple[str, ...] = ()
    if isinstance(op, cpp.InvokeMember):
        walker.run(op.seen, body)
        function = body.registers[op.obj]
        marks = [function, *marks]
        called = _methods(walker, function, op.name, seen)
        receivers = value(walker, function)
        if seen.bound and _is_chosen(walker, receivers, seen):  # what chooses an object decides what is done to it
            pc = demoted(receivers.mask)
    else:
        function = body.registers[op.func]
        pc = demoted(value(walker, function).mask)
        held = slots(function) | (nameless(function) if seen.strange or not seen.natives else frozenset())
        if not seen.effects and (held or function.mask & ~body.pc):  # a model in code holds nothing
            marks = [*marks, Mark(function.mask, held)]
    given = acts(walker, op, body, seen, marks, pc=pc, called=called)
    if given is None:
        given = Mark(walker.memory.deep(value(walker, operands(body, reads(op)))))
    mark = settled(walker, copied(given, seen), seen, body)
    mask = mark.mask | pc | arising(walker, seen)
    body.registers[op.dst] = Mark(mask, mark.roots)


def _is_chosen(walker: Walker, receivers: Mark, seen: Seen) -> bool:
    """Whether a method may run on one of several objects, or be one of several."""
    if len(receivers.roots) != 1 or len({b.function.code.key for b in seen.bound.values()}) > 1:
        return True
    (root,) = receivers.roots
    record = walker.shape.record(root) if isinstance(root, int) else None
    return record is None or record.many


def _methods(walker: Walker, owner: Mark, method: str, seen: Seen) -> tuple[str, ...]:
    """The dotted names of a method of objects of which only their classes are known by name: by what made them, else by why they are not."""
    named = {name_of(root) for root in value(walker, owner).roots} - {"", "object"}
    named = named or {reason.subject.replace("::", ".") for reason in seen.reasons if reason.cause is Cause.CALL}
    return tuple(sorted(f"{name}.{method}" for name in named))


def _binary(walker: Walker, op: ops.Binary, body: Body, seen: Seen) -> None:
    """`stream << value` among others."""
    left, right = body.registers[op.left], body.registers[op.right]
    held, other = value(walker, left), value(walker, right)
    kind = outside.stream(walker, held)
    mask = walker.memory.deep(other) | body.pc
    if op.operator == "<<" and kind:
        if kind != "text":
            out(walker, kind, mask)
        outside.written_to(walker, kind, Mark(0, objects(held) or slots(left)), mask)
        body.registers[op.dst] = Mark(left.mask, left.roots)
        return
    if op.operator == ">>" and kind == "file":
        read = comes_in(walker, "file")
        walker.memory.write_any(slots(right), Mark(read), read)
    if is_busy(seen):
        given = acts(walker, op, body, seen, [left, right], certain=True)
        mark = Mark(walker.memory.deep(held) | mask) if given is None else given
        if seen.bound and given is not None:
            body.registers[op.dst] = settled(walker, given, seen, body)
            return
        body.registers[op.dst] = settled(walker, mark.joined(held).joined(other), seen, body)
        return
    if seen.wrote:
        outside.natives(walker, body, seen, [left, right])
    if op.operator in ("<<", ">>", ",") and seen.reasons:  # an operator that nobody knows
        for name in _methods(walker, left, f"operator{op.operator}", seen):
            mask |= perform(walker, name, mask, body.pc)
        for one, two in ((left, other), (right, held)):
            walker.memory.write_any(nameless(one) | slots(one), two.under(mask), mask)
    places = slots(left) if op.operator in ("<<", ",") and seen.reasons else frozenset()  # `matrix << 1, 2`
    computed.plain(walker, op, body, seen)
    body.registers[op.dst] = settled(
        walker, body.registers[op.dst].joined(Mark(0, nameless(held) | nameless(other) | places)), seen, body
    )


def _computed(walker: Walker, op: Any, body: Body, seen: Seen) -> None:
    """What is computed: by an operator of a class, too."""
    if not is_busy(seen):
        (straight.TABLE.get(op.__class__) or computed.plain)(walker, op, body, seen)
        return
    marks = [body.registers[r] for r in reads(op)]
    given = acts(walker, op, body, seen, marks, certain=True)
    mask = body.pc if given is None else given.mask
    if not seen.bound:
        for mark in marks:
            mask |= walker.memory.deep(mark)
    body.registers[op.dst] = settled(walker, Mark(mask, NOTHING.roots if given is None else given.roots), seen, body)


TABLE: Final[dict[type[ops.Op], Any]] = {
    **making.TABLE,
    **dict.fromkeys((cpp.MakeType, cpp.Declared, cpp.LocalSymbol, cpp.UnknownValue), _known),
    cpp.Name: _name,
    cpp.TypeOfValue: _type_of_value,
    cpp.CellSlot: _cell_slot,
    cpp.Read: _read,
    ops.LoadCell: _load_cell,
    cpp.Member: _member,
    cpp.Item: _item,
    cpp.Deref: _deref,
    cpp.AddressOf: _address_of,
    cpp.Assign: _assign,
    cpp.Step: _step,
    cpp.Narrow: _narrow,
    cpp.MakeLambda: _lambda,
    cpp.Invoke: _invoke,
    cpp.InvokeMember: _invoke,
    ops.Binary: _binary,
    ops.Unary: _computed,
    ops.Compare: _computed,
}
