# SPDX-License-Identifier: Apache-2.0
"""Frames: who asks for one may read the variables of the functions that run.

inspect.currentframe().f_back.f_locals     all variables of the caller
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.flow.marks import NOTHING, Mark, Root, name_of
from rosward.flow.stored.content import Content

if TYPE_CHECKING:
    from rosward.flow.body import Body
    from rosward.flow.native.native_call import NativeCall
    from rosward.flow.walker import Walker

_FRAME: Final = "types.FrameType"
_LOCALS: Final = "f_locals"
VARIABLES: Final = (_LOCALS, "cell_contents")
"""The attributes that lead to variables, of a frame and of a function."""


def current(call: NativeCall) -> Mark:
    """`inspect.currentframe()`."""
    return Mark(call.pc, frozenset(_frames(call)[-1:]))


def any_of(call: NativeCall) -> Mark:
    """`sys._getframe(depth)`."""
    return Mark(call.pc | call.mark(0).mask, frozenset(_frames(call)))


def stack(call: NativeCall) -> Mark:
    """`inspect.stack()`: a list of what is told of each frame."""
    frames = Mark(call.pc, frozenset(_frames(call)))
    told = call.walker.shape.made(call.body.activation, call.op.number, "inspect.FrameInfo")
    call.walker.memory.place(told, Content(0, NOTHING, 0, {"frame": frames, 0: frames}))
    several: Root = call.walker.shape.made(call.body.activation, call.op.number, kind="tuple")
    call.walker.memory.place(several, Content(0, Mark(call.pc, frozenset((told,))), call.pc))
    return Mark(call.pc, frozenset((several,)))


def variables(walker: Walker, body: Body) -> Mark:
    """Those of a function that runs, as they are now."""
    found = NOTHING
    for mark in body.registers:
        found = found.joined(mark)
    for cell in body.activation.cells:
        found = found.joined(walker.memory.read((cell,), "value"))
    return found


def is_frame(root: Root) -> bool:
    """Whether it is one of a function that is known."""
    return name_of(root) == _FRAME


def _frames(call: NativeCall) -> list[Root]:
    """One for each function that runs, the innermost last."""
    walker = call.walker
    if walker.shape.tracker is not None:
        walker.shape.tracker.open = True  # who calls it next time holds something else
    found: list[Root] = []
    for number, body in enumerate(b for b in walker.bodies if not b.activation.code.file.startswith("models:")):
        frame = walker.shape.made(body.activation, call.op.number, _FRAME)
        held = walker.shape.made(body.activation, call.op.number, _LOCALS)
        walker.memory.place(held, Content(0, variables(walker, body), call.pc))
        slots: dict[object, Mark] = {
            _LOCALS: Mark(call.pc, frozenset((held,))),
            "f_globals": Mark(call.pc, frozenset((body.activation.module,))),
        }
        if number:
            slots["f_back"] = Mark(call.pc, frozenset(found[-1:]))
        walker.memory.place(frame, Content(0, NOTHING, 0, slots))
        found.append(frame)
    return found
