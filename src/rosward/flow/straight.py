# SPDX-License-Identifier: Apache-2.0
"""Straight operations: what is computed depends on all that it is computed from; what is read, on what stands there.

x = a + b        a and b
x = self.last    what was written to `last` of this object, and which object it is
self.last = x    x, and what decides that control is here
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Final

from rosward.domain.unknown import Cause
from rosward.flow import computed, hidden, implicit, library, suspending
from rosward.flow.body import Body
from rosward.flow.calls import call, run_callees, schedule
from rosward.flow.marks import FUNCTIONS, NOTHING, Mark, Root, demoted, name_of, of_library
from rosward.flow.native import frames
from rosward.flow.native.constructed import attributes
from rosward.flow.native.partials import bound_in
from rosward.flow.reading import arising, constant, elements, leads, narrowed, opaque
from rosward.flow.stored.content import Content
from rosward.flow.stored.store import MELTED
from rosward.ir import ops
from rosward.ir.registers import reads

if TYPE_CHECKING:
    from rosward.engine.running.seen import Seen
    from rosward.flow.walker import Walker

_NO_ROOTS: Final[frozenset[Root]] = frozenset()
_OF_PARTIAL: Final = frozenset(("args", "keywords"))
"""The attributes of a partial function in which its arguments stand."""
_SLICE: Final[Root] = ("slice",)
"""What an index leads to that stands for several elements."""


def _const(_walker: Walker, op: ops.Const, body: Body, _seen: Seen) -> None:
    body.registers[op.dst] = Mark(body.pc)


def _move(_walker: Walker, op: ops.Move, body: Body, _seen: Seen) -> None:
    body.registers[op.dst] = body.registers[op.src].under(body.pc)


def _assume(_walker: Walker, op: ops.Assume, body: Body, _seen: Seen) -> None:
    body.registers[op.dst] = body.registers[op.src].under(body.pc)


def _load_cell(walker: Walker, op: ops.LoadCell, body: Body, seen: Seen) -> None:
    found = walker.memory.read(seen.cells, "value")
    body.registers[op.dst] = Mark(found.mask | body.pc, leads(seen, found))


def _store_cell(walker: Walker, op: ops.StoreCell, body: Body, seen: Seen) -> None:
    walker.memory.write(frozenset(seen.cells), "value", body.registers[op.src].under(body.pc))


def _load_global(walker: Walker, op: ops.LoadGlobal, body: Body, seen: Seen) -> None:
    found = walker.memory.read((body.activation.module,), op.name)
    body.registers[op.dst] = Mark(found.mask | body.pc, leads(seen, found) | external(walker, seen))


def _store_global(walker: Walker, op: ops.StoreGlobal, body: Body, _seen: Seen) -> None:
    if not op.narrowing:
        walker.memory.write(frozenset((body.activation.module,)), op.name, body.registers[op.src].under(body.pc))


def _load_name(walker: Walker, op: ops.LoadName, body: Body, seen: Seen) -> None:
    """A name in the body of a class: one of the class, of a function around it, or of the module."""
    memory, activation = walker.memory, body.activation
    found = memory.read(activation.names, op.name)
    if op.cell != ops.NO_REGISTER:
        found = found.joined(memory.read(activation.cells[op.cell : op.cell + 1], "value"))
    found = found.joined(memory.read((activation.module,), op.name))
    body.registers[op.dst] = Mark(found.mask | body.pc, leads(seen, found) | external(walker, seen))


def _store_name(walker: Walker, op: ops.StoreName, body: Body, _seen: Seen) -> None:
    walker.memory.write(frozenset(body.activation.names), op.name, body.registers[op.src].under(body.pc))


def external(_walker: Walker, seen: Seen) -> frozenset[Root]:
    """Something of a library, by its dotted name."""
    return frozenset(map(of_library, seen.externals))


def _of_base(seen: Seen) -> bool:
    """Whether an attribute is one of a base class that is not known, or an array of a message, to which somebody may write."""
    return not seen.refs and (seen.opaque or any(reason.cause is not Cause.MESSAGE for reason in seen.reasons))


def _of_model(walker: Walker, op: ops.LoadAttr, body: Body, root: int) -> Mark:
    """What an object of a library has under a name, and its model does not know: `program.stdin`."""
    name = walker.shape.class_name(root)
    return (
        Mark(0, frozenset((walker.shape.made(body.activation, op.number, f"{name}.{op.name}"),))) if name else NOTHING
    )


def _load_attr(walker: Walker, op: ops.LoadAttr, body: Body, seen: Seen) -> None:
    owner, name = body.registers[op.obj], op.name
    if name == "__dict__":  # the same slots by another way
        body.registers[op.dst] = Mark(owner.mask | body.pc, owner.roots or frozenset((FUNCTIONS,)))
        return
    memory, shape = walker.memory, walker.shape
    if name in frames.VARIABLES and not any(map(frames.is_frame, owner.roots)):
        walker.lost = True  # of a function that has ended
    given = run_callees(walker, op, body, seen)
    mask, roots = owner.mask | body.pc, set[Root](seen.refs)
    several = memory.apart(owner.roots)
    shape.spent += (len(owner.roots) + len(seen.refs)) >> 3
    known = bool(owner.roots)  # whether it was written wherever it may stand
    if not owner.roots:
        kept = memory.part(FUNCTIONS, name).read(name)
        mask |= kept.mask
        roots |= kept.roots
    for root in several:
        if root.__class__ is tuple and root[0] == "external":  # no address
            known = known and name in memory.part(root, name).slots
            continue
        content = memory.part(root, name, "__class__")
        found, slots = content.read(name), content.slots
        if name in _OF_PARTIAL and bound_in(Mark(0, frozenset((root,)))):
            found = memory.of(root).whole
        if "__class__" in slots:
            found = found.under(slots["__class__"].mask)
        if name not in slots:
            known = False
            if shape.part(root, name) in seen.refs:
                found = content.any  # which part of a message it is, the message does not say
            if (isinstance(root, int) or root[0] == MELTED) and _of_base(seen):
                part = ("of", root, name) if isinstance(root, int) else root  # many objects have one content
                found = Mark(found.mask, found.roots | {part}).joined(library.of_base(walker, root, name))
        if seen.reasons and isinstance(root, int) and not seen.refs and not any(map(name_of, found.roots)):
            found = found.joined(_of_model(walker, op, body, root))
        mask |= found.mask
        roots |= found.roots if seen.opaque else opaque(found)
    for cls in shape.classes_of(owner.roots):
        found = memory.part(cls, name).read(name)
        mask |= found.mask
        roots |= found.roots if seen.opaque else opaque(found)
    found = library.attribute(walker, opaque(owner), name)
    mask, roots = mask | found.mask, roots | found.roots
    if given is not None:
        mask, roots = mask | given.mask, roots | leads(seen, given)
        _kept(walker, owner, op.name, given.under(body.pc))
    if not known:
        mask |= arising(walker, seen, read=True)  # what was written here, is known
    if walker.narrowed:  # of the one parameter, what its value leads to is of no interest
        whole = memory.deep(Mark(mask, opaque(Mark(0, frozenset(roots)))))
        mask, roots = narrowed(walker, whole), {r for r in roots if isinstance(r, int)} if whole != mask else roots
    body.registers[op.dst] = memory.told(Mark(mask, frozenset(roots) | external(walker, seen)))


def _kept(walker: Walker, owner: Mark, name: str, given: Mark) -> None:
    """What a `cached_property` gives stands in the object from then on."""
    for root in owner.roots:
        record = walker.shape.record(root) if isinstance(root, int) else None
        if record is not None and record.kind == "instance" and name in record.attrs:
            old = walker.memory.part(root, name).read(name)
            walker.memory.set_attribute(frozenset((root,)), name, old.joined(given))


def _store_attr(walker: Walker, op: ops.StoreAttr, body: Body, seen: Seen) -> None:
    if op.narrowing:
        return
    owner, value = body.registers[op.obj], body.registers[op.src]
    run_callees(walker, op, body, seen)
    if seen.scheduled:
        schedule(walker, seen, *library.put_there(walker, owner, op.name, value, body.pc))
        walker.may_call(owner.roots)
        for _, entry in seen.scheduled:
            hidden.put_into(walker, owner, entry)
    if not seen.calls:  # a generator that goes on at the end of a loop's body is no property
        walker.memory.set_attribute(owner.roots, op.name, value.under(body.pc | demoted(owner.mask)))


def _containers(mark: Mark, seen: Seen) -> frozenset[Root]:
    """The objects of which an operation takes an element. A tuple, which has no address, leads to its elements, too: these are none."""
    if seen.untupled or not any(r.__class__ is tuple and r[0] == "tuple" for r in mark.roots):
        return mark.roots
    return frozenset(opaque(mark))


def _load_item(walker: Walker, op: ops.LoadItem, body: Body, seen: Seen) -> None:
    owner, index = body.registers[op.obj], body.registers[op.index]
    given = run_callees(walker, op, body, seen)
    key = constant(seen, op.index)
    held = _containers(owner, seen)
    found = walker.memory.read(held, key) if key is not None else walker.memory.read_all(held)
    roots = leads(seen, found)
    roots |= frozenset(r for r in owner.roots if not isinstance(r, int) and r[0] != "tuple")  # a view of it
    mask = owner.mask | walker.memory.deep(index) | found.mask | body.pc | implicit.given_by(walker, (index,))
    if _SLICE in index.roots:
        mask |= walker.memory.size(owner.roots)
    if given is not None:
        mask, roots = mask | given.mask, roots | leads(seen, given)
    mask |= library.operator(walker, owner, "__getitem__", index, body.pc)
    body.registers[op.dst] = Mark(mask | arising(walker, seen, read=True), roots)


def _store_item(walker: Walker, op: ops.StoreItem, body: Body, seen: Seen) -> None:
    if op.narrowing:
        return
    owner, index, value = (body.registers[r] for r in (op.obj, op.index, op.src))
    given = run_callees(walker, op, body, seen)
    index = index.under(walker.memory.deep(index) | implicit.given_by(walker, (index,)))
    written = value.under(body.pc | demoted(owner.mask) | index.mask)
    library.operator(walker, owner, "__setitem__", written, body.pc)
    key = constant(seen, op.index)
    if _SLICE in index.roots:
        mask = body.pc | demoted(owner.mask) | index.mask
        size = mask | value.mask | walker.memory.size(value.roots)
        walker.memory.take_out(owner.roots, mask)
        walker.memory.write_any(owner.roots, elements(walker, written), size)
        if given is not None:
            walker.memory.write_any(owner.roots, implicit.made_of(walker, seen, given), given.mask)
    elif key is None:
        walker.memory.write_any(owner.roots, written, index.mask | body.pc | demoted(owner.mask))
    else:
        walker.memory.write(owner.roots, key, written)
        walker.memory.write_any(owner.roots, NOTHING, body.pc | demoted(owner.mask))


def _delete(walker: Walker, op: ops.Delete, body: Body, seen: Seen) -> None:
    """What is deleted is gone, if control is here: that stands under its key, or anywhere."""
    if op.kind not in ("attr", "item"):
        return
    owner = body.registers[op.obj]
    run_callees(walker, op, body, seen)
    if op.kind == "attr":
        walker.memory.write(owner.roots, op.name, Mark(body.pc | demoted(owner.mask)))
        return
    index = body.registers[op.index]
    mask = body.pc | demoted(owner.mask) | walker.memory.deep(index)
    key = constant(seen, op.index)
    if isinstance(key, str):
        walker.memory.write(owner.roots, key, Mark(mask))
        walker.memory.write_any(owner.roots, NOTHING, mask)
    else:
        walker.memory.take_out(owner.roots, mask)


def _build(walker: Walker, op: ops.Build, body: Body, seen: Seen) -> None:
    root: Root = walker.shape.made(body.activation, op.number, "", "tuple")
    places: list[Root] = [*seen.refs] if op.kind != "tuple" else [root]
    size, slots, rest = body.pc, dict[object, Mark](), NOTHING
    given = run_callees(walker, op, body, seen)
    if given is not None:  # methods say what is spread
        rest = implicit.gone_through(walker, given)
        size |= rest.mask
    if walker.implicit and op.kind in ("set", "dict"):  # which of them are equal
        size |= implicit.given_by(walker, [body.registers[r] for _, r in op.items])
    pending: int | None = None
    for number, (starred, register) in enumerate(op.items):
        mark = body.registers[register].under(body.pc)
        if starred:
            rest = rest.joined(elements(walker, mark))
            size |= walker.memory.size(mark.roots)
        elif op.kind == "dict":
            if pending is None:
                pending = register
                continue
            key = constant(seen, pending)
            named_by = walker.memory.deep(body.registers[pending])
            mark = mark.under(named_by)
            if key is None:
                rest, size = rest.joined(mark), size | named_by
            else:
                slots[key] = mark if key not in slots else slots[key].joined(mark)
            pending = None
        elif op.kind == "set" or any(s for s, _ in op.items):
            rest = rest.joined(mark)
        else:
            slots[number] = mark
    content = Content(0, rest, size, slots)
    if op.kind != "tuple" and len(places) != 1:
        for place in places:
            walker.memory.write_any([place], content.whole, size)
    else:
        for place in places:
            walker.memory.place(place, content)
    roots = frozenset(places) | (frozenset(seen.refs) if op.kind == "tuple" else _NO_ROOTS)
    body.registers[op.dst] = Mark(body.pc, roots)


def _unpack(walker: Walker, op: ops.Unpack, body: Body, seen: Seen) -> None:
    source = body.registers[op.src]
    given = run_callees(walker, op, body, seen)
    if given is not None:
        given = implicit.gone_through(walker, given)
    held = _containers(source, seen)
    for number, register in enumerate(op.dsts):
        if op.star == ops.NO_REGISTER or number < op.star:
            found = walker.memory.read(held, number)
        else:
            found = walker.memory.read_all(held)
        if given is not None:
            found = found.joined(given)
        roots = found.roots if seen.opaque else opaque(found)
        roots |= frozenset(seen.parts.get(number, seen.refs))
        roots |= frozenset(r for r in source.roots if not isinstance(r, int) and r[0] != "tuple")
        body.registers[register] = Mark(found.mask | source.mask | body.pc, roots)


def _make_function(walker: Walker, op: ops.MakeFunction, body: Body, _seen: Seen) -> None:
    """Its defaults are known by their addresses; of what has none, all of it is in the function."""
    mask = body.pc
    for register in reads(op):
        mark = body.registers[register]
        mask |= walker.memory.deep(Mark(mark.mask, opaque(mark)))
    body.registers[op.dst] = Mark(mask)


def _make_class(walker: Walker, op: ops.MakeClass, body: Body, seen: Seen) -> None:
    computed.plain(walker, op, body, seen)
    prepared = run_callees(walker, op, body, seen, ("__prepare__",))
    if prepared is not None:
        attributes(walker.memory, frozenset(seen.refs), prepared, body.pc)


def _intrinsic(walker: Walker, op: ops.Intrinsic, body: Body, seen: Seen) -> None:
    registers = [body.registers[r] for r in op.arguments]
    if op.name in ("append", "set_add"):
        walker.memory.write_any(registers[0].roots, registers[1].under(body.pc), body.pc)
    elif op.name == "dict_set":
        under = body.pc | walker.memory.deep(registers[1])
        walker.memory.write_any(registers[0].roots, registers[2].under(under), under)
    elif op.name == "getattr":
        found = walker.memory.read_all(registers[0].roots)
        given = run_callees(walker, op, body, seen)
        found = found if given is None else found.joined(given)
        body.registers[op.dst] = Mark(found.mask | registers[0].mask | body.pc, leads(seen, found))
        return
    elif op.name in ("isinstance", "hasattr", "is_sequence", "is_mapping", "length_is", "length_at_least"):
        mask = body.pc | registers[0].mask | walker.memory.size(registers[0].roots)
        given = run_callees(walker, op, body, seen)
        body.registers[op.dst] = Mark(mask if given is None else mask | given.mask)
        return
    computed.plain(walker, op, body, seen)
    if op.name == "slice":
        body.registers[op.dst] = Mark(body.registers[op.dst].mask, frozenset((_SLICE,)))


TABLE: Final[dict[type[ops.Op], Any]] = {
    ops.Const: _const,
    ops.Move: _move,
    ops.Assume: _assume,
    ops.LoadCell: _load_cell,
    ops.StoreCell: _store_cell,
    ops.LoadGlobal: _load_global,
    ops.StoreGlobal: _store_global,
    ops.LoadName: _load_name,
    ops.StoreName: _store_name,
    ops.LoadAttr: _load_attr,
    ops.StoreAttr: _store_attr,
    **computed.TABLE,
    ops.LoadItem: _load_item,
    ops.StoreItem: _store_item,
    ops.Delete: _delete,
    ops.Build: _build,
    ops.Unpack: _unpack,
    ops.MakeFunction: _make_function,
    ops.MakeClass: _make_class,
    **suspending.TABLE,
    ops.Intrinsic: _intrinsic,
    ops.Call: call,
}
