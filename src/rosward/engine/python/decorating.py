# SPDX-License-Identifier: Apache-2.0
"""What does a function or class become that is handed to code which is not known, to a decorator above all?

@lazy_property                  what its name calls one makes a property
@retry(stop=3)                  most decorators give what they are given, or something that calls it
def read(self): …               a method needs an object: who calls it is followed, a library may call what nothing else calls
handler = library.keep(read)    what is no decorator may do so, too
options = tyro.cli(Options)     a class that stands below nothing is made
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.domain.choice import join
from rosward.domain.compound import Descriptor, External
from rosward.domain.heap import Obj
from rosward.domain.unknown import Cause
from rosward.domain.values import Class, Function, Value
from rosward.engine.python import assignment, hidden_fields, members
from rosward.engine.unknown.escape import escape, name_of

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

_QUESTIONS: Final = ("is_", "has_", "isgenerator", "iscoroutine", "isasync", "ismethod", "isdata", "callable")
"""How the names of functions begin that answer whether something is so."""
_ABOUT: Final = frozenset({"ast", "dis", "gc", "inspect", "json", "pickle", "pprint", "pydoc", "sys"})
"""Modules of Python whose functions say something about a function or class: none is a decorator without a model."""

_LAMBDA: Final = "<lambda>"


def hand(machine: Engine, callee: Value, args: tuple[Value, ...], keywords: dict[str, Value]) -> Value | None:
    """What code that is not known makes of the one function or class that it is called with; None where it is called with something else.

    What is handed on has reached that code then.
    """
    if len(args) != 1 or keywords:
        return None
    given, behind = args[0], _behind(args[0])
    if behind is None:
        return None
    decorates = _stands_above(machine, behind)
    if _asks(callee.name) if isinstance(callee, External) else not decorates:
        return None
    if decorates and _is_method(behind):
        machine.trace.handed.setdefault(behind, machine.place)
    else:
        escape(machine, args, name_of(callee), callee)
    assignment.open_up(machine, behind, replaced=decorates)
    if decorates:
        return Descriptor("property", given, None, None) if _is_property(callee, given) else given
    return _made_of(machine, callee, given)


def _behind(given: Value) -> Function | Class | None:
    """The function or class that is meant: of a property, class method or static method its function."""
    behind = given.getter if isinstance(given, Descriptor) else given
    return behind if isinstance(behind, (Function, Class)) else None


def _asks(name: str) -> bool:
    return name.rpartition(".")[2].startswith(_QUESTIONS) or name.partition(".")[0] in _ABOUT


def _stands_above(machine: Engine, behind: Function | Class) -> bool:
    """Whether the call that is carried out stands above a function or class, as a decorator does."""
    if isinstance(behind, Class):
        return machine.place.file == behind.place.file and machine.place.line < behind.place.line
    code = behind.code
    return code.name != _LAMBDA and machine.place.file == code.file and machine.place.line < code.line


def _is_method(behind: Function | Class) -> bool:
    if isinstance(behind, Class):
        return False
    around = behind.code.qualname.rpartition(".")[0]
    return around != "" and not around.endswith("<locals>")


def _is_property(callee: Value, given: Value) -> bool:
    """Whether a decorator makes a property of a method, by its name: of one that needs its object alone."""
    if not isinstance(given, Function) or not _is_method(given) or len(given.code.parameters.names) != 1:
        return False
    return "property" in name_of(callee).rpartition(".")[2].lower()


def _made_of(machine: Engine, callee: Value, given: Value) -> Value:
    """What such a call gives that is no decorator: what it was given or something else, or an object of the class."""
    made = machine.unknown(Cause.CALL, name_of(callee))
    if isinstance(given, Function):
        # `Depends(get_node)` may keep it only, and a lambda is what something else is set to
        return made if given.code.name == _LAMBDA else join(given, made)
    if not isinstance(given, Class):
        return given
    initialiser = members.lookup(machine, given, "__init__")
    if isinstance(initialiser, Function) and not initialiser.code.is_model:
        return made
    ref = machine.allocate(Obj("instance", given))  # `tyro.cli(Options)`: one that holds anything
    hidden_fields.give(machine, given, ref, (made,), {})
    return ref
