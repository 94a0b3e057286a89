# SPDX-License-Identifier: Apache-2.0
"""Which `__init_subclass__` does a new class call? The nearest of its bases; where there is none, its subclasses need not look again.

A chain of classes is as long as its order of bases: who looked through all of it for each class would do so as often as the square of its length.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.domain.values import UNBOUND, Class, Value

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

__all__ = ["inherited"]

_NAME: Final = "__init_subclass__"


def inherited(machine: Engine, cls: Class) -> Value | None:
    """The hook that Python calls for this class; None where no base has one.

    `machine.unhooked` is None as soon as a class is given a hook behind its body: from then on every class is looked at.
    """
    unhooked = machine.unhooked
    own = _NAME in machine.at(cls.address).attrs
    if own and unhooked:
        unhooked.clear()  # the same class may have had none before, and its subclasses may be among them
    if unhooked is not None and all(b.address in unhooked for b in cls.bases if isinstance(b, Class)):
        found = None
    else:
        hooks = (machine.at(b.address).attrs.get(_NAME) for b in cls.mro[1:] if isinstance(b, Class))
        found = next((h for h in hooks if h is not None and h is not UNBOUND), None)
    if unhooked is not None and not own and found is None:
        unhooked.add(cls.address)
    return found
