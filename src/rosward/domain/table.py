# SPDX-License-Identifier: Apache-2.0
"""How do the variables of an object stand in memory where it has thousands, each written at another moment?

Few are a dict, which is copied with each write. Many are a `Table`: pages of values in the order in which their names came. Who adds or
changes one copies its page; two versions share all others, and what differs between them is found on the pages that differ.

    written(attrs, 'x', value)       {**attrs, 'x': value}
    differing(old, new)              the names that differ, with both values
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Set
from itertools import islice
from typing import Final, TypeVar, final

__all__ = ["NO_MARKS", "Table", "differing", "marked", "more_marks", "unmarked", "written"]

V = TypeVar("V")
_SHIFT: Final = 6
_MASK: Final = (1 << _SHIFT) - 1
_MANY: Final = 128


@final
class Table(Mapping[str, V]):
    """An immutable mapping that keeps the order of its names. Versions share the slots of names, as long as they add the same ones."""

    __slots__ = ("_names", "_pages", "_size", "_slots")

    def __init__(self, names: list[str], slots: dict[str, int], pages: tuple[tuple[V, ...], ...], size: int) -> None:
        self._names = names  # shared by versions, grows at its end; this one has the first `_size`
        self._slots = slots
        self._pages = pages
        self._size = size

    @classmethod
    def of(cls, values: Mapping[str, V]) -> Table[V]:
        """The same as a table."""
        names, held = list(values), tuple(values.values())
        pages = tuple(held[start : start + _MASK + 1] for start in range(0, len(held), _MASK + 1))
        return cls(names, {name: slot for slot, name in enumerate(names)}, pages, len(names))

    def __getitem__(self, name: str) -> V:
        slot = self._slots[name]
        if slot >= self._size:
            raise KeyError(name)
        return self._pages[slot >> _SHIFT][slot & _MASK]

    def __contains__(self, name: object) -> bool:
        return self._slots.get(name, self._size) < self._size  # type: ignore[call-overload, no-any-return]  # any object may be asked for

    def __iter__(self) -> Iterator[str]:
        return islice(self._names, self._size)

    def __len__(self) -> int:
        return self._size

    def written(self, name: str, value: V) -> Table[V]:
        """A version with this value under this name."""
        names, slots, size = self._names, self._slots, self._size
        slot = slots.get(name, size)
        if slot < size:
            page = self._pages[slot >> _SHIFT]
            at = slot & _MASK
            changed = (*page[:at], value, *page[at + 1 :])
            number = slot >> _SHIFT
            return Table(names, slots, (*self._pages[:number], changed, *self._pages[number + 1 :]), size)
        if slot > size or (len(names) > size and names[size] != name):  # another version has added something else
            names = names[:size]
            slots = {each: index for index, each in enumerate(names)}
        if len(names) == size:
            names.append(name)
            slots[name] = size
        if size & _MASK:
            return Table(names, slots, (*self._pages[:-1], (*self._pages[-1], value)), size + 1)
        return Table(names, slots, (*self._pages, (value,)), size + 1)

    def differing(self, other: Table[V]) -> Iterator[tuple[str, V | None, V | None]]:
        """As the function of that name."""
        if self._names is not other._names:
            yield from _apart(self, other)
            return
        for number in range(max(len(self._pages), len(other._pages))):
            ours = self._pages[number] if number < len(self._pages) else ()
            theirs = other._pages[number] if number < len(other._pages) else ()
            if ours is theirs:
                continue
            for at in range(max(len(ours), len(theirs))):
                a = ours[at] if at < len(ours) else None
                b = theirs[at] if at < len(theirs) else None
                if a is not b:
                    yield self._names[(number << _SHIFT) + at], a, b


def written(values: Mapping[str, V], name: str, value: V) -> Mapping[str, V]:
    """The same with this value under this name."""
    if values.__class__ is dict and len(values) < _MANY:
        return {**values, name: value}
    table = values if values.__class__ is Table else Table.of(values)
    return table.written(name, value)


def differing(ours: Mapping[str, V], theirs: Mapping[str, V]) -> Iterator[tuple[str, V | None, V | None]]:
    """The names under which two mappings hold different objects, with both; None where one of them has none."""
    if ours is theirs:
        return iter(())
    if ours.__class__ is Table and theirs.__class__ is Table:
        return ours.differing(theirs)
    return _apart(ours, theirs)


def _apart(ours: Mapping[str, V], theirs: Mapping[str, V]) -> Iterator[tuple[str, V | None, V | None]]:
    shared = 0
    for name, value in theirs.items():
        own = ours.get(name)
        if own is not None:
            shared += 1
        if own is not value:
            yield name, own, value
    if shared < len(ours):
        for name, value in ours.items():
            if name not in theirs:
                yield name, value, None


@final
class Marks(Set[str]):
    """A set of names, as a table."""

    __slots__ = ("table",)

    def __init__(self, table: Mapping[str, bool]) -> None:
        self.table = table

    def __contains__(self, name: object) -> bool:
        return self.table.get(name, False)  # type: ignore[call-overload, no-any-return]  # any object may be asked for

    def __iter__(self) -> Iterator[str]:
        return (name for name, there in self.table.items() if there)

    def __len__(self) -> int:
        return sum(self.table.values())


NO_MARKS: Final[Set[str]] = frozenset()


def marked(marks: Set[str], name: str) -> Set[str]:
    """The set with this name; itself where it has it."""
    if name in marks:
        return marks
    if marks.__class__ is Marks:
        return Marks(written(marks.table, name, value=True))
    if len(marks) < _MANY:
        return frozenset((*marks, name))
    return marked(Marks(Table.of(dict.fromkeys(sorted(marks), True))), name)


def unmarked(marks: Set[str], name: str) -> Set[str]:
    """The set without this name; itself where it does not have it."""
    if name not in marks:
        return marks
    return Marks(written(marks.table, name, value=False)) if marks.__class__ is Marks else frozenset(marks - {name})


def more_marks(ours: Set[str], theirs: Set[str]) -> Iterator[str]:
    """The names that only the other has."""
    if ours is theirs:
        return iter(())
    if ours.__class__ is Marks and theirs.__class__ is Marks:
        return (name for name, a, b in differing(ours.table, theirs.table) if b and not a)
    return (name for name in theirs if name not in ours)
