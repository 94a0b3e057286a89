# SPDX-License-Identifier: Apache-2.0
"""Containers: what is put in under a key, added, taken out, copied, or gone through.

points.append(msg.data)      any element
state['a'] = msg.data        the one of that key, and no other
copy.deepcopy(state)         a new object that holds the same; changing it changes nothing of the old one
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from rosward.flow import library
from rosward.flow.marks import NOTHING, Mark, Root, demoted
from rosward.flow.native import pairs
from rosward.flow.native.native_call import NativeCall
from rosward.flow.reading import elements, opaque
from rosward.flow.stored.content import Content

Handler = Callable[[NativeCall], Mark]
"""What a native gives, and what it writes."""

CONTAINERS: Final = frozenset({"list", "set", "dict", "tuple", "frozenset", "generator", "collections.deque"})


def _add(call: NativeCall) -> Mark:
    call.walker.memory.write_any(call.mark(0).roots, call.mark(1).under(call.pc), call.pc)
    return Mark(call.pc)


def _insert(call: NativeCall) -> Mark:
    call.walker.memory.collapse(call.mark(0).roots)
    written = call.mark(2).under(call.pc | call.mark(1).mask)
    call.walker.memory.write_any(call.mark(0).roots, written, call.pc)
    return Mark(call.pc)


def _extend(call: NativeCall) -> Mark:
    memory = call.walker.memory
    for argument in call.marks[1:]:
        found = elements(call.walker, argument).under(call.pc)
        size = call.pc | argument.mask | memory.size(argument.roots)
        if call.name.endswith("dict.update"):
            size |= pairs.keys(call, argument)
        slots: dict[object, Mark] = {}
        several = [memory.of(root).slots for root in argument.roots]
        for each in several:
            for key, mark in each.items():
                if isinstance(key, str):
                    slots[key] = mark.under(call.pc | argument.mask).joined(slots.get(key, NOTHING))
        if slots:
            perhaps = {key for key in slots if any(key not in each for each in several)}
            memory.write_each(call.mark(0).roots, slots, perhaps)
        if call.name.endswith("dict.update"):
            found = pairs.values(call, argument, found)
        memory.write_any(call.mark(0).roots, found if not _is_keyed(call, argument) else NOTHING, size)
    for given, mark in call.given():
        if given.kind == "keyword":
            memory.write(call.mark(0).roots, given.name, mark.under(call.pc))
    return Mark(call.pc)


def _is_keyed(call: NativeCall, mark: Mark) -> bool:
    """Whether all that a value holds stands under texts; of a list, or an object of a library, in which nothing is told apart, it does not."""
    memory, shape = call.walker.memory, call.walker.shape
    for root in mark.roots:
        content = memory.of(root)
        if content.any != NOTHING or content.base or not all(isinstance(k, str) for k in content.slots):
            return False
        if not (content.slots or (isinstance(root, int) and shape.kind(root) == "dict")):
            return False
    return bool(mark.roots)


def _take(call: NativeCall) -> Mark:
    """An element is taken out."""
    memory, owner = call.walker.memory, call.mark(0)
    found = memory.read_all(owner.roots)
    memory.take_out(owner.roots, call.pc | call.named_by(1))
    for each in call.marks[1:]:
        found = found.joined(each)
    return found.under(call.pc | owner.mask | memory.size(owner.roots))


def _get(call: NativeCall) -> Mark:
    memory, owner = call.walker.memory, call.mark(0)
    key = call.key(1)
    found = memory.read_all(owner.roots) if key is None else memory.read(owner.roots, key)
    mask = call.pc | owner.mask | call.named_by(1)
    if key is None:
        mask |= memory.size(owner.roots)
    return found.joined(call.mark(2)).under(mask)


def _set_default(call: NativeCall) -> Mark:
    memory, owner, under = call.walker.memory, call.mark(0), call.pc | call.named_by(1)
    key, written = call.key(1), call.mark(2).under(under)
    if key is None:
        memory.write_any(owner.roots, written, under)
        return memory.read_all(owner.roots).under(call.pc | owner.mask)
    memory.write(owner.roots, key, written.joined(memory.read(owner.roots, key)))
    return memory.read(owner.roots, key).under(call.pc | owner.mask)


def _clear(call: NativeCall) -> Mark:
    memory, owner = call.walker.memory, call.mark(0)
    if memory.is_one(owner.roots):
        for root in owner.roots:
            memory.place(root, Content(base=call.pc, size=call.pc))
    else:
        memory.write_any(owner.roots, Mark(call.pc), call.pc)
    return Mark(call.pc)


def _remove(call: NativeCall) -> Mark:
    """Which one is removed depends on all, and on what is looked for."""
    memory, owner = call.walker.memory, call.mark(0)
    memory.take_out(owner.roots, call.pc | memory.deep(owner) | memory.deep(call.mark(1)))
    return Mark(call.pc)


def _order(call: NativeCall) -> int:
    """What the order depends on: all elements, and what `key` makes of them."""
    memory = call.walker.memory
    mask = memory.deep(call.mark(0)) | call.pc
    for several in call.walker.bodies_of(call.seen).values():
        for activation in several:
            mask |= memory.deep(call.walker.results.get(activation, NOTHING))
    return mask


def _reorder(call: NativeCall) -> Mark:
    memory, owner, mask = call.walker.memory, call.mark(0), _order(call)
    memory.collapse(owner.roots)
    memory.write_any(owner.roots, Mark(mask))
    return Mark(call.pc)


def _shuffle(call: NativeCall) -> Mark:
    """Any element may stand anywhere, as chance has it."""
    roots = call.mark(0).roots
    call.walker.memory.collapse(roots)
    call.walker.memory.write_any(roots, Mark(library.perform(call.walker, call.name, 0, call.pc)))
    return Mark(call.pc)


def _copy(call: NativeCall) -> Mark:
    """A new container with the same elements under the same keys."""
    memory, owner = call.walker.memory, call.mark(0)
    content = Content()
    several = [memory.of(r) for r in owner.roots]
    if len(several) == 1:
        content = several[0]
    elif several:
        whole = memory.read_all(owner.roots)
        content = Content(0, whole, memory.size(owner.roots))
    under = owner.mask | call.pc
    slots = {key: mark.under(under) for key, mark in content.slots.items()}
    return call.new(Content(content.base | under, content.any.under(under), content.size | under, slots))


def _dict(call: NativeCall) -> Mark:
    """`dict(mapping, key=value, **more)`."""
    memory = call.walker.memory
    positional = [m for a, m in call.given() if a.kind != "keyword"]
    slots: dict[object, Mark] = {}
    rest, size = NOTHING, call.pc
    for mark in positional:
        under = mark.mask | call.pc
        size |= under | memory.size(mark.roots) | pairs.keys(call, mark)
        for root in mark.roots:
            content = memory.of(root)
            held = content.any
            for key, found in content.slots.items():
                if isinstance(key, str):
                    slots[key] = slots.get(key, NOTHING).joined(found).under(under)
                else:  # an element of a list of pairs
                    held = held.joined(found)
            rest = rest.joined(pairs.values(call, Mark(0, frozenset((root,))), held)).under(content.base | under)
    for argument, mark in call.given():
        if argument.kind == "keyword":
            slots[argument.name] = mark.under(call.pc)
    return call.new(Content(0, rest, size, slots))


def _deep_copy(call: NativeCall) -> Mark:
    """A new object with the same content that shares nothing; a dict that is given along holds all that was copied, and its copies."""
    memory, owner = call.walker.memory, call.mark(0)
    for memo in call.marks[1:]:
        memory.write_any(memo.roots, Mark(memory.deep(owner) | call.pc, owner.roots), memory.deep(owner) | call.pc)
    several = [memory.of(r) for r in owner.roots]
    under = owner.mask | call.pc
    if len(several) == 1 and not any(True for r in owner.roots if isinstance(r, int) for _ in memory.shape.parts(r)):
        content = several[0]
        slots = {key: Mark(memory.deep(mark) | under) for key, mark in content.slots.items()}
        rest = Mark(memory.deep(content.any))
        return call.new(Content(content.base | under, rest, content.size | under, slots))
    return call.new(Content(memory.deep(owner) | under))


def _all_elements(call: NativeCall) -> Mark:
    """A new container of the elements of all arguments."""
    memory = call.walker.memory
    found, size = NOTHING, call.pc
    for mark in call.marks:
        found = found.joined(elements(call.walker, mark))
        size |= mark.mask | memory.size(mark.roots)
    name = call.name.removeprefix("builtins.")
    if name in _CHOOSING:
        size |= memory.deep(found)
    elif name == "sorted":
        found = found.under(_order(call))
    paired = _PAIRS.get(name.rpartition(".")[2])
    if paired is not None:
        pair: Root = call.walker.shape.made(call.body.activation, call.op.number, "pair", "tuple")
        content = paired(call, size)
        memory.place(pair, content)
        return call.new(Content(0, Mark(call.pc, frozenset((pair,))), size))
    return call.new(Content(0, found.under(call.pc), size))


_CHOOSING: Final = frozenset(("filter", "set.union", "set.intersection", "set.difference", "set", "frozenset"))
"""What is in their result depends on what the elements are, and so does how much that is."""


def _numbered(call: NativeCall, size: int) -> Content:
    found = elements(call.walker, call.mark(0)).under(call.pc)
    return Content(0, NOTHING, call.pc, {0: Mark(call.pc | demoted(size)).joined(call.mark(1)), 1: found})


def _zipped(call: NativeCall, _size: int) -> Content:
    slots: dict[object, Mark] = {n: elements(call.walker, m).under(call.pc) for n, m in enumerate(call.marks)}
    return Content(0, NOTHING, call.pc, slots)


def _entries(call: NativeCall, size: int) -> Content:
    found = elements(call.walker, call.mark(0)).under(call.pc)
    return Content(0, NOTHING, call.pc, {0: Mark(size), 1: found})


def _mixed(call: NativeCall, size: int) -> Content:
    found = NOTHING
    for mark in call.marks:
        found = found.joined(elements(call.walker, mark))
    return Content(0, found.under(call.pc), size)


_PAIRS: Final[dict[str, Callable[[NativeCall, int], Content]]] = {
    "enumerate": _numbered,
    "zip": _zipped,
    "items": _entries,
    **dict.fromkeys(("product", "combinations", "pairwise", "permutations"), _mixed),
}
"""Iterators whose elements are tuples."""


def _one_element(call: NativeCall) -> Mark:
    """One of the elements of the first argument, or one of the others."""
    found = elements(call.walker, call.mark(0))
    for mark in call.marks[1:]:
        found = found.joined(mark)
    return found.under(call.pc | call.walker.memory.size(call.mark(0).roots))


def _one_if_any(call: NativeCall) -> Mark:
    """The same of a queue; how many there are decides whether that fails."""
    if call.walker.attempts:
        call.walker.attempts[-1].mask |= call.walker.memory.size(call.mark(0).roots)
    return _one_element(call)


def _next(call: NativeCall) -> Mark:
    """The next element, which is used up: what comes next depends on what decides that control is here."""
    shape, found = call.walker.shape, _one_element(call)
    kept = [r for r in call.mark(0).roots if not isinstance(r, int) or ((o := shape.record(r)) and o.kind == "list")]
    call.walker.memory.take_out(kept, call.pc)
    return found


def _extreme(call: NativeCall) -> Mark:
    """The largest of them depends on all."""
    mask, roots = call.pc, frozenset[Root]()
    for mark in call.marks:
        mask |= call.walker.memory.deep(mark)
        roots |= elements(call.walker, mark).roots
    return Mark(mask, roots)


def _size(call: NativeCall) -> Mark:
    """How many there are; of something of a library, all of it."""
    mark = call.mark(0)
    memory = call.walker.memory
    mask = call.pc | mark.mask | memory.size(mark.roots)
    held = frozenset[Root](root for root in opaque(mark) if root[0] not in ("tuple", "generator"))
    return Mark(mask | memory.deep(Mark(0, held)))


def change(call: NativeCall) -> Mark:
    """Any other method: what it is given may be anywhere in the container, and what stands there may have gone, or be given."""
    memory, owner, mask = call.walker.memory, call.mark(0), call.pc
    roots = frozenset[Root]()
    for mark in call.marks:
        mask |= memory.deep(mark)
        roots |= elements(call.walker, mark).roots
    for mark in call.marks[1:]:
        roots |= mark.roots
    memory.take_out(owner.roots, mask)
    memory.write_any(owner.roots, Mark(mask, roots), mask)
    return Mark(mask, roots | owner.roots)


READING: Final = frozenset(
    (
        *("__contains__", "__eq__", "__ne__", "__lt__", "__le__", "__gt__", "__ge__", "__add__", "__radd__", "__mul__"),
        *("__rmul__", "__and__", "__or__", "__xor__", "__sub__", "__rand__", "__ror__", "__rxor__", "__rsub__"),
        *("__iter__", "__reversed__", "__str__", "__repr__", "__format__", "__hash__", "__bool__", "__class_getitem__"),
        *("__sizeof__", "count", "index", "isdisjoint", "issubset", "issuperset", "symmetric_difference", "fromkeys"),
        *("__new__", "__copy__", "send", "throw", "close"),
    )
)
"""The methods of containers that write nothing, and are none of `METHODS`."""

METHODS: Final[dict[str, Handler]] = {
    **dict.fromkeys(("append", "add", "appendleft"), _add),
    "insert": _insert,
    **dict.fromkeys(("extend", "update", "extendleft", "__ior__"), _extend),
    **dict.fromkeys(("pop", "popleft", "popitem"), _take),
    **dict.fromkeys(("get", "__getitem__"), _get),
    "setdefault": _set_default,
    "clear": _clear,
    **dict.fromkeys(("sort", "reverse", "rotate"), _reorder),
    **dict.fromkeys(("remove", "discard"), _remove),
    "copy": _copy,
    **dict.fromkeys(("values", "items", "keys", "union", "intersection", "difference"), _all_elements),
    **dict.fromkeys(("__next__",), _next),
    "__len__": _size,
}
"""The methods of containers."""

KNOWN: Final[dict[str, Handler]] = {
    **dict.fromkeys(
        (
            *("list", "tuple", "set", "frozenset", "sorted", "reversed", "iter", "zip", "enumerate", "filter", "map"),
            *("itertools.product", "itertools.islice", "itertools.cycle", "itertools.combinations"),
            *("itertools.permutations", "itertools.pairwise", "itertools.repeat", "numpy._elements"),
            *("_rosward.contents", "collections._items", "collections._keys", "random.sample"),
        ),
        _all_elements,
    ),
    "dict": _dict,
    "copy.copy": _copy,
    "copy.deepcopy": _deep_copy,
    "queue._any": _one_if_any,
    "random.choice": _one_element,
    "random.shuffle": _shuffle,
    "next": _next,
    **dict.fromkeys(("max", "min", "sum"), _extreme),
    "len": _size,
}
"""Functions that work on containers."""
