# SPDX-License-Identifier: Apache-2.0
"""Entities in code that no process reaches: left out of the result, and told.

RW205 where it surely is not run; RW204 where a library may reach it all the same; RW212 where something unknown may call it.

class N(Node):
    def later(self):                              # nothing calls it
        self.create_publisher(String, 'late', 10)
if MODE == 'laser': …                             # MODE is known to be 'camera'
class P(acme.plugin.Plugin): …                    # nothing here makes a P, but acme may: RW204
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import partial
from typing import final

from rosward.analysis.seen import ClassSeen, Seen
from rosward.analysis.source_tree import SourceTree
from rosward.analysis.summary import Creation, creations_of
from rosward.findings import Finding, Findings
from rosward.ir.program import Module, OpKey
from rosward.location import Place
from rosward.models.facts import LibraryFacts


def unreached_of(
    seen: Sequence[Seen],
    modules: Iterable[Module],
    facts: LibraryFacts,
    sources: SourceTree,
    *,
    everywhere: bool = True,
) -> list[Finding]:
    """What `unreached` finds, and the same of the programs that are linked."""
    found = unreached(seen, modules, facts, sources.created)
    names = dict.fromkeys((each.program for each in seen if each.program), False)
    if everywhere:
        names |= {each.name: each.loadable for each in sources.unlinked(facts.creating) if each.name not in names}
    if names:
        from rosward.analysis.unreached_linked import unreached_linked

        functions = partial(sources.creating_functions, facts.creating)
        found += unreached_linked(seen, names, functions, everywhere=everywhere)
    return found


def unreached(
    seen: Sequence[Seen],
    modules: Iterable[Module],
    facts: LibraryFacts,
    created: Callable[[Module, LibraryFacts], Iterable[Creation]] = creations_of,
) -> list[Finding]:
    """One finding for each call that would create an entity, in a function that no process enters or in a branch that none takes."""
    entered: set[str] = set()
    reached: set[OpKey] = set()
    for each in seen:
        entered |= each.entered
        reached |= each.reached
    bases = _unknown_bases(seen)
    unseen = Unseen(seen)
    found = Findings()
    for read in (one for module in modules for one in created(module, facts)):
        place = Place(read.file, read.line, read.column)
        dead = read.function not in entered
        base = bases.get((read.file, read.qualname.rpartition(".")[0]))
        if dead and base is not None:
            what = f"nothing here calls {read.qualname}, but its base class {base} may: its {read.name} is not in the result"
            found.add(Finding("RW204", what, place))
        elif dead and unseen.may_call(read.file, read.qualname):
            what = f"no known code calls {read.qualname}, but unknown code may: its {read.name} is not in the result"
            found.add(Finding("RW212", what, place))
        elif dead:
            what = f"{read.qualname or 'this file'} is never called: its {read.name} is not in the result"
            found.add(Finding("RW205", what, place))
        elif read.name in facts.creating and read.op not in reached:
            what = f"no execution reaches this {read.name}, as far as the values are known: it is not in the result"
            found.add(Finding("RW205", what, place))
    return list(found)


@final
class Unseen:
    """What may be called without that a call of it is seen."""

    def __init__(self, seen: Sequence[Seen]) -> None:
        asked = {one for each in seen for one in each.asked}
        self._names = {name for _, _, name in asked if name}  # read from something unknown
        self._owners = {(file, owner) for file, owner, name in asked if not name}  # of which something unknown was read
        self._made = {(cls.place.file, cls.qualname) for each in seen for cls in _made(each)}

    def may_call(self, file: str, qualname: str) -> bool:
        """Whether something unknown may call a function: a method of an object that there is, by name; or by a name that is not known."""
        owner, _, name = qualname.rpartition(".")
        return (file, owner) in self._owners or (name in self._names and (file, owner) in self._made)


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
