# SPDX-License-Identifier: Apache-2.0
"""What has every operation, of any language? Its place, its number, and the blocks that it holds."""

from __future__ import annotations

from collections.abc import Iterator


class Op:
    """An operation; `line` and `column` (both from 1) say where in the source it stands, `number` (from 1) which one of its `Code` it is.

    Several operations may stand at one place (`f(f(x))`, `a().b()`), so a place does not tell them apart; the number does.
    """

    __slots__ = ("column", "line", "number")

    def __init__(self, line: int, column: int) -> None:
        self.line = line
        self.column = column
        self.number = 0  # given when the code is complete

    @property
    def blocks(self) -> tuple[Block, ...]:
        """The blocks that it holds, in the order in which they stand."""
        return ()


Block = list[Op]


def walk(block: Block) -> Iterator[Op]:
    """The operations of a block in the order in which they stand, each before those in its own blocks."""
    left = [iter(block)]
    while left:
        for op in left[-1]:
            yield op
            if op.blocks:
                left += map(iter, reversed(op.blocks))
                break
        else:
            left.pop()
