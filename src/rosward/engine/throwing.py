# SPDX-License-Identifier: Apache-2.0
"""An exception is raised, or may be: which running `try` or `with` is told, and what where there is none?"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from rosward.domain.choice import join_all, options
from rosward.domain.state import State
from rosward.domain.unknown import Cause
from rosward.domain.values import Unknown, Value
from rosward.engine.running.catcher import ANYTHING, LIBRARY, OPERATION, Catcher
from rosward.engine.running.told import Kind, Telling
from rosward.models.failures import tell_uncaught
from rosward.models.python.plain import EXCEPTION_HINT

if TYPE_CHECKING:
    from rosward.engine.machine import Engine


def note(machine: Engine, level: int = OPERATION) -> None:
    """An exception that is not known may be raised here: tell the innermost try."""
    if machine.catchers:
        machine.noted = max(machine.noted, level)
        machine.catchers[-1].note(machine, level)


def note_turn(machine: Engine) -> None:
    """A loop goes round: in Python that may raise."""
    if machine.catchers and machine.language.run_noting is not None:
        note(machine)


def note_call(machine: Engine) -> None:
    """Unknown code runs here: it may raise what it likes, and an import in it may fail."""
    if machine.catchers:
        note(machine, ANYTHING if machine.trace.handed or machine.schedule_book.by_library else LIBRARY)
        machine.catchers[-1].importing = True


def note_sources(machine: Engine) -> None:
    """Code of the sources runs here that is not followed: what it raises may be of any class."""
    note(machine, ANYTHING)


def note_import(machine: Engine) -> None:
    """An ImportError may be raised here: of a module that is not among the sources."""
    if machine.catchers:
        note(machine, LIBRARY)
        machine.catchers[-1].importing = True


def unseen(machine: Engine) -> Unknown:
    """An exception that Python or a library may have raised, as the program sees it."""
    return machine.unknown(Cause.LIVE, "exception", EXCEPTION_HINT)


def is_unseen(exception: Value) -> bool:
    """Whether a value is such an exception. Where it is raised again, that does not count as an end of the program."""
    return exception.__class__ is Unknown and exception.hint == EXCEPTION_HINT


def throw(machine: Engine, exception: Value) -> None:
    """An exception is raised here. Where it surely is, the path ends behind; else it goes on."""
    machine.raised += 1
    known = [o for o in options(exception) if not is_unseen(o)]
    if len(known) < len(options(exception)):
        note(machine, LIBRARY)
    if not known:
        return
    exception = join_all(known)
    if machine.catchers:
        machine.catchers[-1].arrive(machine, exception, machine.state)
    else:
        tell_uncaught(machine, exception)
        may_end(machine, exception)
        machine.uncaught(exception)


def may_end(machine: Engine, exception: Value) -> None:
    """An exception that nothing catches may end the main body here."""
    summaries, state = machine.summaries, machine.state
    if summaries.told is not None:
        summaries.told.append(Telling(Kind.ARRIVED, 0, exception, state.heap.copy(), state.done))
    summaries.uncaught += not machine.in_callback
    machine.log.may_end(machine)


def rethrow(machine: Engine, inner: Catcher, seen: Callable[[State], State] = State.copy) -> None:
    """What leaves a call by exceptions reaches the `try` around it; the machine's state is left as it is.

    `seen`: what a state of it is for who calls, as a state of its own.
    """
    if machine.catchers and machine.catchers[-1] is inner:  # within what it is of: it is there already
        return
    if machine.catchers and inner.level:
        machine.catchers[-1].take_over(machine, inner, seen(inner.snapshot.state))
        machine.noted = max(machine.noted, inner.level)
    here = machine.state
    for exception, snapshot in list(inner.arrivals.items()):  # a callback that runs here may add to them
        machine.state = seen(snapshot.state)
        throw(machine, exception)
    machine.state = here
