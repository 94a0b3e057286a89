# SPDX-License-Identifier: Apache-2.0
"""Entities in code that no process reaches: left out of the result, and told.

RW205 where it surely is not run; RW204 where a library may reach it all the same; RW212 where something unknown may call it.

class N(Node):
    def later(self):                              # nothing calls it
        self.create_publisher(String, 'late', 10)
if MODE == 'laser': …                             # MODE is known to be 'camera'
class P(rqt_gui_py.plugin.Plugin): …              # nothing here makes a P, but rqt may: RW204
"""

from __future__ import annotations

from collections.abc import Container, Iterable, Iterator, Sequence
from typing import final

from rosward.analysis.seen import ClassSeen, Seen
from rosward.analysis.source_tree import SourceTree
from rosward.findings import Finding, Findings
from rosward.ir import ops
from rosward.ir.op import walk
from rosward.ir.program import Code, Module, OpKey
from rosward.models.facts import LibraryFacts
from rosward.source.location import Place


def unreached_of(
    seen: Sequence[Seen],
    modules: Iterable[Module],
    facts: LibraryFacts,
    sources: SourceTree,
    *,
    everywhere: bool = True,
) -> list[Finding]:
    """What `unreached` finds, and the same of the programs that are linked."""
    found = unreached(seen, modules, facts)
    names = dict.fromkeys(each.program for each in seen if each.program)
    if names:
        from rosward.analysis.unreached_linked import unreached_linked

        programs = [p for p in map(sources.program, names) if p is not None]
        found += unreached_linked(seen, programs, facts.creating, everywhere=everywhere)
    return found


def unreached(seen: Sequence[Seen], modules: Iterable[Module], facts: LibraryFacts) -> list[Finding]:
    """One finding for each call that would create an entity, in a function that no process enters or in a branch that none takes."""
    entered: set[str] = set()
    reached: set[OpKey] = set()
    for each in seen:
        entered |= each.entered
        reached |= each.reached
    bases = _unknown_bases(seen)
    unseen = _Unseen(seen)
    found = Findings()
    for module in modules:
        names = facts.creators_of(name.partition(".")[0] for name in module.imports)
        for code in _functions(module.code):
            dead = code.key not in entered
            for name, op, key in _creations(code, facts.creating, names):
                base = bases.get((code.file, code.qualname.rpartition(".")[0]))
                if dead and base is not None:
                    what = f"nothing here calls {code.qualname}, but its base class {base} may: its {name} is not in the result"
                    found.add(Finding("RW204", what, Place(code.file, op.line, op.column)))
                    continue
                if dead and unseen.may_call(code):
                    what = f"no known code calls {code.qualname}, but unknown code may: its {name} is not in the result"
                    found.add(Finding("RW212", what, Place(code.file, op.line, op.column)))
                    continue
                if dead:
                    what = f"{code.qualname or 'this file'} is never called: its {name} is not in the result"
                elif name in facts.creating and key not in reached:
                    what = f"no execution reaches this {name}, as far as the values are known: it is not in the result"
                else:
                    continue
                found.add(Finding("RW205", what, Place(code.file, op.line, op.column)))
    return list(found)


@final
class _Unseen:
    """What may be called without that a call of it is seen."""

    def __init__(self, seen: Sequence[Seen]) -> None:
        asked = {one for each in seen for one in each.asked}
        self._names = {name for _, _, name in asked if name}  # read from something unknown
        self._owners = {(file, owner) for file, owner, name in asked if not name}  # of which something unknown was read
        self._made = {(cls.place.file, cls.qualname) for each in seen for cls in _made(each)}

    def may_call(self, code: Code) -> bool:
        """Whether something unknown may call a function: a method of an object that there is, by name; or by a name that is not known."""
        owner, _, name = code.qualname.rpartition(".")
        return (code.file, owner) in self._owners or (name in self._names and (code.file, owner) in self._made)


def _made(seen: Seen) -> Iterator[ClassSeen]:
    """The classes of which a process has objects, and those above them."""
    at: dict[Place, list[ClassSeen]] = {}
    for cls in seen.classes:
        at.setdefault(cls.place, []).append(cls)
    waiting = [place for place in at if place in seen.instantiated]
    known = set(waiting)
    while waiting:
        for cls in at[waiting.pop()]:
            yield cls
            above = [place for place in cls.bases if place in at and place not in known]
            known.update(above)
            waiting += above


def _unknown_bases(seen: Iterable[Seen]) -> dict[tuple[str, str], str]:
    """The first base that is not among the sources, by file and qualified name of the class."""
    return {
        (cls.place.file, cls.qualname): cls.outside for each in seen for cls in each.classes if cls.outside is not None
    }


def _functions(code: Code) -> Iterator[Code]:
    """The code itself and all functions in it."""
    yield code
    for _, op in _all_ops(code):
        if isinstance(op, ops.MakeFunction):
            yield from _functions(op.code)


def _creations(code: Code, methods: Container[str], names: Container[str]) -> Iterator[tuple[str, ops.Op, OpKey]]:
    """The reads of what creates an entity, in nested blocks too but not in functions."""
    called: set[int] = set()
    for body, op in reversed(list(_all_ops(code))):
        if isinstance(op, ops.Call):
            called.add(op.func)
        elif isinstance(op, (ops.LoadAttr, ops.LoadGlobal, ops.LoadName)):
            if (isinstance(op, ops.LoadAttr) and op.name in methods) or (op.dst in called and op.name in names):
                yield op.name, op, (body.key, op.number)


def _all_ops(code: Code) -> Iterator[tuple[Code, ops.Op]]:
    """Every operation of a body and of the bodies of its classes, each with the body that it belongs to."""
    for op in walk(code.ops):
        yield code, op
        if isinstance(op, ops.MakeClass):
            yield from _all_ops(op.code)
