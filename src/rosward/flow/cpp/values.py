# SPDX-License-Identifier: Apache-2.0
"""C++: what stands where a register leads, what a copy holds, what is written through a slot.

A register holds a value or a slot: the root of a slot is ('slot', object, key, how), that of an object its address (`engine.seen.places_of`).
What an operation gives leads where the interpretation saw it lead; what the value depends on comes from what stands there.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Final

from rosward.domain.values import Ref, Value
from rosward.engine.running.seen import refs_of
from rosward.flow.marks import NOTHING, Mark, Root, demoted, is_slot, slot_of
from rosward.flow.reading import arising
from rosward.flow.stored.content import Content
from rosward.models.cpp.values.typed import MESSAGE

if TYPE_CHECKING:
    from collections.abc import Collection

    from rosward.engine.running.seen import Seen
    from rosward.flow.body import Body
    from rosward.flow.walker import Walker

_DEEPEST: Final = 6


def nameless(mark: Mark) -> frozenset[Root]:
    """The objects that the interpretation does not know."""
    return frozenset([r for r in mark.roots if r.__class__ is not int and r[0] != "slot"])  # type: ignore[index]  # it is a tuple


def objects(mark: Mark) -> frozenset[Root]:
    """The objects that the interpretation knows, by their addresses."""
    return frozenset([r for r in mark.roots if r.__class__ is int])


def slots(mark: Mark) -> frozenset[Root]:
    """The slots that a register leads to."""
    return frozenset([r for r in mark.roots if r.__class__ is not int and r[0] == "slot"])  # type: ignore[index]  # it is a tuple


def value(walker: Walker, mark: Mark) -> Mark:
    """The value of a register: what stands in the slots to which it leads."""
    places = slots(mark)
    if not places:
        return walker.memory.told(mark)
    mask = mark.mask
    roots = set(mark.roots - places)
    for place in places:
        at = walker.memory.at(place)
        mask |= at.mask
        roots |= at.roots
    return walker.memory.told(Mark(mask, frozenset(roots)))


def settled(walker: Walker, mark: Mark, seen: Seen, body: Body) -> Mark:
    """The result of an operation: where it leads was seen, but for what nobody knows."""
    roots = frozenset(seen.refs) | nameless(mark)
    if seen.reasons or not seen.refs:
        roots |= mark.roots
    return Mark(mark.mask | body.pc | arising(walker, seen, read=True), roots)


def field(walker: Walker, root: Root, name: str) -> Mark:
    """What stands in a field; a field that a base has too is told apart by its class."""
    memory = walker.memory
    if is_slot(root):
        return memory.at(root)
    part = walker.shape.part(root, name)
    if part is not None:
        return memory.at(("slot", root, name, "one"))
    content = memory.of(root)
    found = content.read(name)
    for key, mark in content.slots.items():
        if isinstance(key, str) and key.startswith(f"{name} of "):
            found = found.joined(mark)
    return found


def elements(walker: Walker, mark: Mark) -> Mark:
    """All that stands in the containers of a value."""
    found = Mark(mark.mask)
    for root in mark.roots:
        if not is_slot(root):
            found = found.joined(walker.memory.of(root).whole)
            if not isinstance(root, int):
                found = found.joined(Mark(0, frozenset((root,))))
    return found


def keys(walker: Walker, roots: frozenset[Root]) -> int:
    """What the keys of maps are made of, which no slot holds."""
    bases = {slot_of(root)[0] if is_slot(root) else root for root in roots}
    return walker.memory.size([b for b in bases if isinstance(b, int) and walker.shape.kind(b) == "dict"])


# Copies


def _source(site: object) -> int | None:
    """Of what an object is a copy."""
    if isinstance(site, tuple) and len(site) == 2 and site[0] == "copy" and isinstance(site[1], int):
        return site[1]
    return None


def sources(seen: Seen) -> dict[int, int]:
    """The copies that an operation makes, by what they are copies of."""
    if not seen.made:
        return _NO_COPIES
    return {source: address for address, site in seen.made.items() if (source := _source(site)) is not None}


_NO_COPIES: Final[dict[int, int]] = {}


def copies(walker: Walker, seen: Seen, everything: Mark, *, but: Collection[Root] | None = None) -> None:
    """New objects stand here: copies with what is in their source, others empty. `but`: of copies those only that are not among these."""
    memory = walker.memory
    fresh = sources(seen)
    for address, site in seen.made.items():
        source = _source(site)
        if but is not None and (source is None or address in but):
            continue
        if source is not None and source != address:
            memory.place(address, _with_parts(walker, address, _renamed(memory.of(source), fresh), seen))
        elif isinstance(site, tuple) and site[:1] == ("pair",):  # an entry of a map
            held = value(walker, everything)
            first = Mark(everything.mask | keys(walker, slots(everything)))
            memory.place(address, Content(0, NOTHING, 0, {"first": first, "second": held}))
        elif site in _MERGED:
            memory.place(address, Content(memory.deep(everything)))
        elif but is None:
            memory.place(address, Content())


_MERGED: Final = ("copy of several", "opaque", MESSAGE)
"""What objects are made of of which it is not told apart what is in them."""


def _with_parts(walker: Walker, address: int, content: Content, seen: Seen) -> Content:
    """The content of a copy, which leads to the objects that were copied with it as its parts."""
    record = walker.shape.record(address)
    if record is None or record.kind != "instance":
        return content
    slots = dict(content.slots)
    for name, held in record.attrs.items():
        if held.__class__ is Ref and name not in slots:
            parts = frozenset[Root](r for r in refs_of(held) if r in seen.made)
            if parts:
                slots[name] = Mark(content.base, parts)
    return content.with_slots(slots) if len(slots) > len(content.slots) else content


def _renamed(content: Content, fresh: dict[int, int]) -> Content:
    """The content of a copy: what was copied with it leads to the copies."""

    def one(mark: Mark) -> Mark:
        if not any(r in fresh for r in mark.roots):
            return mark
        return Mark(mark.mask, frozenset(fresh.get(r, r) if isinstance(r, int) else r for r in mark.roots))

    held = {key: one(mark) for key, mark in content.slots.items()}
    return Content(content.base, one(content.any), content.size, held)


def copied(mark: Mark, seen: Seen) -> Mark:
    """A value of which the objects are the copies that were made."""
    fresh = sources(seen) if mark.roots else _NO_COPIES
    if not fresh:
        return mark
    return Mark(mark.mask, frozenset(fresh.get(r, r) if isinstance(r, int) else r for r in mark.roots))


# Writing


def write(walker: Walker, target: Mark, mark: Mark, *, sure: bool = True) -> None:
    """A value is written where a register leads; objects take it over."""
    several = len(target.roots) > 1 or not sure
    for root in target.roots:
        if is_slot(root):
            base, key, how = slot_of(root)
            if how == "one" and not several:
                walker.memory.write(frozenset((base,)), key, mark)
            else:
                walker.memory.write_any([root], mark)
        elif isinstance(root, int):
            assign(walker, root, mark, sure=not several)
        else:
            walker.memory.write_any([root], mark, mark.mask)


def assign(walker: Walker, target: int, mark: Mark, *, sure: bool, depth: int = 0) -> None:
    """An object stays where it is and takes over what others hold."""
    memory, shape = walker.memory, walker.shape
    braces = in_braces(walker, mark)
    if braces is not None:
        if sure and target not in shape.many:
            memory.place_again(target, Content(mark.mask))
        take_braces(walker, target, braces, sure=sure, depth=depth)
        return
    sources = [r for r in mark.roots if r != target]
    plain = mark.mask
    content: Content | None = None
    if len(sources) == 1 and len(mark.roots) == 1 and depth < _DEEPEST:
        found = memory.of(sources[0])
        content = Content(
            found.base | plain, found.any, found.size | plain, {k: m.under(plain) for k, m in found.slots.items()}
        )
    else:
        content = Content(memory.deep(mark), Mark(0, mark.roots))
    if sure and target not in shape.many:
        memory.place_again(target, content)
    else:
        memory.cover({target: content})
    record = shape.record(target)
    if record is None or record.kind != "instance":
        return
    other = shape.record(sources[0]) if len(sources) == 1 and isinstance(sources[0], int) else None
    for name, held in record.attrs.items():
        if held.__class__ is not Ref or depth >= _DEEPEST:
            continue
        inner = next(iter(refs_of(held)))
        theirs = None if other is None else other.attrs.get(name)
        if theirs == held:
            continue
        part = Mark(memory.deep(mark))
        if theirs is not None and theirs.__class__ is Ref:
            part = Mark(plain, frozenset(refs_of(theirs)))
        assign(walker, inner, part, sure=sure, depth=depth + 1)


def in_braces(walker: Walker, mark: Mark) -> Content | None:
    """What stands in a pair of braces, of a value that is nothing else."""
    roots = [r for r in mark.roots if r.__class__ is not int and r[0] == "tuple"]  # type: ignore[index]  # it is a tuple
    if len(roots) != 1:
        return None
    found = walker.memory.of(roots[0])
    led = found.any.roots.union(*[held.roots for held in found.slots.values()])
    return found if found.slots and mark.roots - {roots[0]} <= led else None


def handed(walker: Walker, mark: Mark) -> Mark:
    """What is given for a part of an object: a value, or a pair of braces."""
    if in_braces(walker, mark) is None:
        return value(walker, mark)
    return Mark(mark.mask, frozenset(r for r in nameless(mark) if r[0] == "tuple"))  # type: ignore[index]  # it is a tuple


def take_braces(walker: Walker, target: int, braces: Content, *, sure: bool, depth: int = 0) -> None:
    """`line = {start, {1, 2}}`: the parts of an object in their order; those that are objects stay where they are."""
    memory, parts = walker.memory, parts_of(walker, target)
    if depth >= _DEEPEST or not parts or any(n not in range(len(parts)) and n not in parts for n in braces.slots):
        mark = Mark(memory.deep(braces.whole))
        memory.write_any(consists_of(walker, target), mark, mark.mask)
        return
    for number, (key, held) in enumerate(parts.items()):
        found = braces.slots.get(key, braces.slots.get(number))
        if found is None:
            continue
        mark = handed(walker, found.under(braces.base))
        if held.__class__ is Ref:
            for inner in refs_of(held):
                assign(walker, inner, mark, sure=sure, depth=depth + 1)
        else:
            memory.write_any([("slot", target, key, "one")], mark)


def parts_of(walker: Walker, address: int) -> dict[object, Value]:
    """What an object consists of, in its order: the fields by name, the elements of an array by number."""
    record = walker.shape.record(address)
    if record is None or record.kind not in ("instance", "list"):
        return {}
    if record.kind == "list":
        return dict(enumerate(record.series().head))
    return {name: held for name, held in record.attrs.items()}  # noqa: C416 - its keys are wider


def consists_of(walker: Walker, address: int, depth: int = 0) -> list[Root]:
    """An object with all objects that are parts of it."""
    found: list[Root] = [address]
    record = walker.shape.record(address)
    rest = (record.rest,) if record is not None and record.kind == "list" and record.rest is not None else ()
    for held in (*parts_of(walker, address).values(), *rest):
        if held.__class__ is Ref and depth < _DEEPEST:
            for inner in refs_of(held):
                found += consists_of(walker, inner, depth + 1)
    return found


def under_choice(body: Body, target: Mark) -> int:
    """What decides where something is written."""
    return body.pc | demoted(target.mask)


def operands(body: Body, registers: Any) -> Mark:
    """Of all that an operation reads."""
    found = NOTHING
    for register in registers:
        found = found.joined(body.registers[register])
    return found
