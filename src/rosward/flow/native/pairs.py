# SPDX-License-Identifier: Apache-2.0
"""Lists of pairs of which a dict is made, or into which they are put: what the keys are, and what stands under them.

dict(zip(names, values))     the values; which of them stands under a name, the names say
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from rosward.flow.marks import Mark, Root

if TYPE_CHECKING:
    from rosward.flow.native.native_call import NativeCall


def keys(call: NativeCall, mark: Mark) -> int:
    """What the keys depend on that a list of pairs gives: equal ones count once."""
    memory, mask = call.walker.memory, 0
    for pair in _pairs(call, mark):
        mask |= memory.deep(memory.of(pair).read(0) if _is_pair(call, pair) else Mark(0, frozenset((pair,))))
    return mask


def values(call: NativeCall, mark: Mark, found: Mark) -> Mark:
    """What stands under the keys then, of what was found to stand in the mapping or the list of pairs: of a pair, its second element.

    It may stand under any key, as they may be.
    """
    several = frozenset(pair for pair in _pairs(call, mark) if _is_pair(call, pair))
    if not several:
        return found
    second = call.walker.memory.read(several, 1).under(keys(call, mark))
    if all(_is_row(call, root) for root in mark.roots):
        return Mark(found.mask, found.roots - several).joined(second)
    return found.joined(second)  # it may be a mapping of a library, whose values are pairs


def _pairs(call: NativeCall, mark: Mark) -> Iterator[Root]:
    """The elements of what is no dict."""
    memory, shape = call.walker.memory, call.walker.shape
    for root in mark.roots:
        if not (isinstance(root, int) and shape.kind(root) == "dict"):
            yield from memory.of(root).whole.roots


def _is_pair(call: NativeCall, root: Root) -> bool:
    """Whether something that is taken for a pair has elements that are told apart."""
    return call.walker.shape.kind(root) in ("list", "tuple") if isinstance(root, int) else root[0] == "tuple"


def _is_row(call: NativeCall, root: Root) -> bool:
    """Whether something surely has elements, one after another, and is no mapping."""
    return _is_pair(call, root) or call.walker.shape.is_iterator(root)
