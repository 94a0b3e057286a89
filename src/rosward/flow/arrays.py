# SPDX-License-Identifier: Apache-2.0
"""Functions on arrays that compute only, but for two things: some give a view of what they get, and some write their result into it.

a.reshape(2, 2)[0, 0] = v        what is written to the view, stands in `a`
numpy.add(b, c, out=a)           `a` holds `b` and `c`
a.fill(v)                        `a` holds `v`
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, Final

from rosward.flow.array_names import CHANGE, INTO, VIEWS
from rosward.flow.marks import Mark, Root

if TYPE_CHECKING:
    from rosward.flow.stored.memory import Memory
    from rosward.ir import ops


def viewed(names: Iterable[str], given: Iterable[Mark]) -> frozenset[Root]:
    """The objects that the result of functions of these names may be a view of."""
    if not any(name.startswith("numpy.") and name.rpartition(".")[2] in VIEWS for name in names):
        return frozenset()
    return frozenset[Root]().union(*(mark.roots for mark in given))


def changed(arguments: Iterable[ops.Argument], names: Iterable[str], marks: list[Mark], owner: Mark) -> Iterator[Mark]:
    """What functions of these names write to, of what they get."""
    named = {a.name: m for a, m in zip(arguments, marks, strict=False) if a.kind == "keyword"}
    yield from (named[n] for n in ("out", "dst", "output") if n in named)
    for name in names:
        method = name.rpartition(".")[2]
        if method in CHANGE and not name.startswith(_MODULES):
            yield owner
        elif name.startswith("numpy.") and method in INTO:
            yield from marks[INTO[method] - (name.count(".") > 1) :]


def write(memory: Memory, given: Mark, mask: int) -> None:
    """Something is written into what a function is given for its results: an array, or a tuple of such."""
    several = [root for root in given.roots if root.__class__ is tuple and root[0] == "tuple"]
    memory.write_any(given.roots.union(memory.read_all(several).roots), Mark(mask), mask)


_MODULES: Final = ("numpy.random.", "numpy.sort", "numpy.put", "numpy.partition", "numpy.resize")
"""Functions of the same names that are no methods."""
