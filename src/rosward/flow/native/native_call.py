# SPDX-License-Identifier: Apache-2.0
"""One call of a native: what it is given, by number, name and key, and where its result stands."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, final

from rosward.flow.marks import NOTHING, Mark, Root, demoted
from rosward.flow.reading import constant
from rosward.flow.stored.content import Content

if TYPE_CHECKING:
    from rosward.engine.running.seen import Seen
    from rosward.flow.body import Body
    from rosward.flow.walker import Walker
    from rosward.ir import ops


@final
class NativeCall:
    """One call of a native: the receiver is among the marks, the last of which are those of the arguments as they are written.

    `keys`: which of the marks are constants, of a call that is not written; `within`: another call makes it, whose result is something else.
    """

    __slots__ = ("_keys", "arguments", "body", "marks", "name", "op", "pc", "seen", "walker", "within")

    def __init__(
        self,
        walker: Walker,
        op: ops.Op,
        body: Body,
        seen: Seen,
        name: str,
        marks: list[Mark],
        arguments: Sequence[ops.Argument] = (),
        receiver: Mark = NOTHING,
        keys: Sequence[object] | None = None,
        *,
        within: bool = False,
    ) -> None:
        self.walker, self.op, self.body, self.seen = walker, op, body, seen
        self.name, self.marks, self.arguments = name, marks, arguments
        self._keys, self.within = keys, within
        self.pc = body.pc  # what decides that control is here, and at this object
        if receiver.mask and not walker.memory.is_one(receiver.roots):
            self.pc |= demoted(receiver.mask)

    def mark(self, number: int) -> Mark:
        """Of one argument."""
        return self.marks[number] if number < len(self.marks) else NOTHING

    def named_by(self, number: int) -> int:
        """What a key or an index depends on, with all that stands in it: `get((msg.data, 1))`."""
        return self.walker.memory.deep(self.mark(number))

    def key(self, number: int) -> object:
        """The constant that one of the marks surely is."""
        if self._keys is not None:
            return self._keys[number] if number < len(self._keys) else None
        written = number - (len(self.marks) - len(self.arguments))
        if not 0 <= written < len(self.arguments):
            return None
        return constant(self.seen, self.arguments[written].register)

    def given(self) -> Iterator[tuple[ops.Argument, Mark]]:
        """The arguments as they are written, with their marks."""
        return zip(self.arguments, self.marks[len(self.marks) - len(self.arguments) :], strict=True)

    def new(self, content: Content) -> Mark:
        """A new object with this content."""
        if self.within:
            root = self._made()
            self.walker.memory.place(root, content)
            return Mark(self.pc, frozenset((root,)))
        fresh: list[Root] = [*self.seen.refs] or [self._made()]
        held = content.whole.roots
        places = [p for p in fresh if p not in held and not any(p in m.roots for m in self.marks)]
        if not places:
            places = [self._made()]
        if len(places) == 1:
            self.walker.memory.place(places[0], content)
        else:
            self.walker.memory.write_any(places, content.whole, content.size)
        return Mark(self.pc, frozenset(places))

    def computed(self, mask: int) -> Mark:
        """A value that is made of this: an object that somebody may write to, unless it surely is none."""
        if not self.seen.opaque:
            return Mark(mask)
        root = self._made()
        self.walker.memory.renew(root)
        return Mark(mask, frozenset((root,)))

    def _made(self) -> Root:
        name = self.name if self.within else ""
        return self.walker.shape.made(self.body.activation, self.op.number, name)
