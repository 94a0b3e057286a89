# SPDX-License-Identifier: Apache-2.0
"""What a library keeps to itself: what one of its functions gets, another gives, or calls a function of the program with, and the program
holds no object that says so.

logging.warning(text)            the handlers and filters of the program get it
warnings.warn(text)              `catch_warnings` records it
warnings.showwarning = show      gets what functions of `warnings` get
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Final

from rosward.domain.values import Value
from rosward.engine.running.seen import refs_of
from rosward.flow.marks import HANDLED, Mark, Root

if TYPE_CHECKING:
    from rosward.engine.running.scheduled import Scheduled
    from rosward.flow.walker import Walker

_KEEPING: Final = frozenset(("logging", "warnings"))
_GIVING: Final = ("logging.handlers.", "warnings.catch_warnings.")
"""What of it leads to all that is kept."""


def _kept(module: str) -> Root:
    return ("kept", module)


def keep(walker: Walker, name: str, mask: int) -> None:
    """A function of a library of this dotted name has got this."""
    module = name.partition(".")[0]
    is_told = module in walker.put_into.values()
    if module == "logging" and walker.logs:  # a record has the exception, too
        mask |= walker.memory.deep(walker.memory.of(HANDLED).whole)
    if module in _KEEPING or is_told:
        walker.memory.write_any((_kept(module),), Mark(mask))
        if walker.logs or is_told:
            walker.meet_callbacks()


def led_to(names: Iterable[str]) -> frozenset[Root]:
    """What the results of functions of these names lead to, beside what they get."""
    return frozenset(_kept(name.partition(".")[0]) for name in names if name.startswith(_GIVING))


def logged(walker: Walker) -> int:
    """What handlers of the program may find in the records of `logging`."""
    return walker.memory.of(_kept("logging")).whole.mask


def put_into(walker: Walker, owner: Mark, entry: Scheduled) -> None:
    """A function of the program is put into a module of a library, which calls it."""
    for module in filter(None, map(walker.shape.module_name, owner.roots)):
        walker.put_into[entry] = module


def told_to(walker: Walker, entry: Scheduled) -> int:
    """What such a function is called with."""
    module = walker.put_into.get(entry)
    return 0 if module is None else walker.memory.of(_kept(module)).whole.mask


def of_bases(walker: Walker, receiver: Value) -> int:
    """What the libraries keep of which an object of the program has a base class."""
    mask = 0
    for module in {m for address in refs_of(receiver) for m in walker.shape.libraries(address)}:
        if module in _KEEPING:
            mask |= walker.memory.of(_kept(module)).whole.mask
    return mask


def give_to_bases(walker: Walker, receiver: Value, mask: int) -> None:
    """A method that such a library calls has given this."""
    for module in {m for address in refs_of(receiver) for m in walker.shape.libraries(address)}:
        keep(walker, module, mask)
