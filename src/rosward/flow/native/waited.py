# SPDX-License-Identifier: Apache-2.0
"""`ready, _, _ = select.select([sock], [], [], 1.0)`: what has something to read is some of what is given, and that it has, comes from there."""

from __future__ import annotations

from typing import Final

from rosward.flow.marks import Mark, Root, name_of
from rosward.flow.native.native_call import NativeCall
from rosward.flow.outside import comes_in
from rosward.flow.reading import elements

_READS: Final = ("recv", "read", "accept")


def select(call: NativeCall) -> Mark:
    """Three lists, of which each holds some of what is given."""
    walker, mask, roots = call.walker, call.pc, frozenset[Root]()
    for mark in call.marks:
        found = elements(walker, mark)
        mask |= mark.mask | found.mask
        roots |= found.roots
    names = {name for root in roots if (name := name_of(root))}
    kinds = {kind for name in names for read in _READS for kind in walker.shape.said(f"{name}.{read}").sources}
    for kind in kinds or {"stdin"}:
        mask |= comes_in(walker, kind)
    return Mark(mask, roots)
