# SPDX-License-Identifier: Apache-2.0
"""What is raised: the object that `raise` makes, what it was raised from, and which `except` catches it.

raise Refused                    an object of Refused, with its data, made here
raise Refused('x') from error    its __cause__ is error; what is being handled becomes its __context__
int('x')                         a builtin that fails makes a ValueError with the message that Python gives it
"""

from __future__ import annotations

import builtins
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Final

from rosward.domain.choice import join_all, options
from rosward.domain.compound import External, Native, Tuple
from rosward.domain.heap import Obj
from rosward.domain.state import State, join_states
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, UNBOUND, Class, Const, Ref, Unknown, Value
from rosward.engine.python.classes import exception_object
from rosward.engine.python.instances import is_subclass, type_of
from rosward.engine.running.catcher import LIBRARY, OPERATION, Catcher
from rosward.engine.throwing import note, rethrow, throw
from rosward.models.python.exceptions import builtin_base

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

_EVERYTHING: Final = ("Exception", "BaseException")


def made(machine: Engine, value: Value) -> Value:
    """The object that `raise value` raises: of a class it is made here. UNBOUND where making it fails."""
    found: list[Value] = []
    for option in options(value):
        if option.__class__ is Class or (option.__class__ is Native and builtin_base(option) is not None):
            found.extend(options(machine.call(option, ())))
        elif option.__class__ is External:
            found.append(machine.allocate(Obj("instance", option), "raise"))
        elif option.__class__ in (Ref, Unknown):
            found.append(option)
        else:
            found.append(exception_object(machine, Native("builtins.TypeError"), (_unknown_message(machine),)))
    return join_all(found)


def _unknown_message(machine: Engine) -> Value:
    """A message that Python writes, and that is not followed."""
    return machine.unknown(Cause.LIVE, "message of an exception", "str")


def chain(machine: Engine, exception: Value, cause: Value | None) -> None:
    """Set `__cause__` and `__context__` of what is about to be raised."""
    context = machine.handled
    for option in options(exception):
        if option.__class__ is not Ref:
            continue
        if context != NONE and option not in options(context):
            machine.update(option, machine.obj(option).with_attr("__context__", context))
        if cause is not None:
            given = made(machine, cause) if cause.__class__ in (Class, Native) else cause
            obj = machine.obj(option).with_attr("__cause__", given)
            machine.update(option, obj.with_attr("__suppress_context__", Const(True)))


def may_catch(machine: Engine, exception: Value, wanted: Value | None) -> bool | None:
    """Whether a handler for `wanted` catches; None where it may."""
    if wanted is None:
        return True
    answers: set[bool | None] = set()
    for each in options(exception):
        cls = each if each.__class__ is Native else type_of(machine, each)
        if cls is None or (cls.__class__ is External and cls != wanted):
            answers.add(True if _catches_any(wanted) else None)  # what libraries raise is an Exception
        else:
            answers.add(is_subclass(machine, cls, wanted))
    return answers.pop() if len(answers) == 1 else None


def _catches_any(wanted: Value) -> bool:
    """Whether a handler is for Exception or BaseException."""
    if wanted.__class__ is Tuple:
        return any(_catches_any(w) for w in wanted.items)
    return wanted.__class__ is Native and wanted.name.removeprefix("builtins.") in _EVERYTHING


def class_of(machine: Engine, exception: Value) -> Value:
    """The class of what was raised, as `__exit__` and `sys.exc_info()` have it."""
    found: list[Value] = []
    for each in options(exception):
        cls = type_of(machine, each)
        found.append(machine.unknown(Cause.LIVE, "class of an exception") if cls is None else cls)
    return join_all(found)


def builtin_error(machine: Engine, error: str, args: Sequence[Value] | None) -> Value:
    """An exception of Python's own; without `args` what it says is not known."""
    made = exception_object(machine, Native(f"builtins.{error}"), tuple(args or ()))
    if args is None and made.__class__ is Ref:
        unknown = machine.unknown(Cause.LIVE, "exception.args", "tuple")
        machine.put(made.address, machine.obj(made).with_attr("args", unknown))
    return made


def fail(machine: Engine, error: str, told: str, args: Sequence[Value] | None, *, sure: bool, plain: bool) -> Value:
    """A builtin raises for the values that we see.

    Where the program says that it waits for this exception, its handler gets it; where moreover no value is a mere default, the path ends
    here (UNBOUND). Anywhere else the values that we see may not be all, and the path goes on with a value that is not known.
    """
    unknown = machine.unknown(Cause.ERROR, told)
    waits = _waits(machine, error)
    if waits is None:
        note(machine, OPERATION if hasattr(builtins, error) else LIBRARY)
        return unknown
    throw(machine, builtin_error(machine, error, args))
    return UNBOUND if sure and (waits or plain) else unknown


def guarded(machine: Engine, action: Callable[[], Value], error: str, *, unseen: bool = True) -> tuple[Value, bool]:
    """What an action gives, and whether it may raise a builtin exception, which goes no further (`getattr(x, 'y', default)`).

    `unseen`: whether what Python or a library may raise by itself, in any operation, counts as that exception.
    """
    frame, catchers = machine.frames[-1], machine.catchers
    catcher, others = Catcher(machine, frame, handles=True, classes=(error,)), Catcher(machine, frame)
    machine.catchers = [*catchers, catcher]
    try:
        value = action()
    finally:
        machine.catchers = catchers
    caught: list[State] = [catcher.snapshot.state.copy()] if catcher.level and unseen else []
    for exception, snapshot in catcher.arrivals.items():
        answer = may_catch(machine, exception, Native(f"builtins.{error}"))
        if answer is not False:
            caught.append(snapshot.state.copy())
        if answer is not True:
            others.arrive(machine, exception, snapshot.state)
    if catcher.level and machine.catchers:
        machine.catchers[-1].take_over(machine, catcher)
    rethrow(machine, others)
    if value is not UNBOUND:
        caught.append(machine.state)
    if caught:
        machine.state = caught[0]
        for state in caught[1:]:
            machine.state = join_states(machine.state, state, machine.fresh_version)
    return value, len(caught) > (value is not UNBOUND)


def _waits(machine: Engine, error: str) -> bool | None:
    """Whether a `try` around catches a builtin exception: True by its name, False by a handler for everything, None where none does."""
    raised = getattr(builtins, error, None)
    may = None  # a `with` on the way may swallow it
    for catcher in reversed(machine.catchers):
        for name in catcher.classes:
            wanted = getattr(builtins, name, None)
            if isinstance(raised, type) and isinstance(wanted, type) and issubclass(raised, wanted):
                if catcher.handles or name not in _EVERYTHING:
                    return name not in _EVERYTHING
                may = False
    return may
