# SPDX-License-Identifier: Apache-2.0
"""What do processes that share an enclave hold of each other's rights, and what is that worth?

    camera needs publisher /image; viewer needs subscription /image
      ->  together: camera may subscribe to /image (1), viewer may publish it (2): a price of 3

A right that acts on others counts 2: to publish, to ask for a service or an action, or to answer for one. To listen counts 1. What the
client library alone needs (parameter services under each node's own name) is counted apart, as `system`: with it, one process can pose as
another towards who reads its parameters, but not command it. A right that a process needs under a pattern covers each name of the pattern; a
pattern that it does not need is one right.

Where it is known what each process can influence, each name that only the others' rights let it influence counts 1 more.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Final, final

from rosward.enclaves.privileges import Privilege
from rosward.policies.match import Pattern
from rosward.records import NamedTuple
from rosward.ros.entities import EntityKind

__all__ = ["ACTS", "INFLUENCES", "LISTENS", "NOTHING", "Price", "Tariff"]

ACTS: Final = 2
LISTENS: Final = 1
INFLUENCES: Final = 1


class Price(NamedTuple):
    """Rights that processes hold and do not need: those of the application by weight, those of the client library by number."""

    application: int
    system: int

    def plus(self, other: Price) -> Price:
        """Both."""
        return Price(self.application + other.application, self.system + other.system)

    def minus(self, other: Price) -> Price:
        """The difference."""
        return Price(self.application - other.application, self.system - other.system)


NOTHING: Final = Price(0, 0)


@final
class Tariff:
    """The rights of all processes of a network, ready to be compared. A set of rights is an integer, one bit for each."""

    def __init__(
        self, needed: Mapping[str, Mapping[Privilege, bool]], influence: Mapping[str, frozenset[str]] | None = None
    ) -> None:
        """`needed`: by process, its rights, and whether the client library alone needs each. `influence`: names that each can influence."""
        everything: dict[Privilege, bool] = {}
        for rights in needed.values():
            for right, system in rights.items():
                everything[right] = everything.get(right, True) and system
        self._rights = sorted(everything, key=lambda r: (r.name, r.kind.value, r.ros))
        bits = {right: 1 << index for index, right in enumerate(self._rights)}
        self._system = sum(bits[r] for r, system in everything.items() if system)
        listens = sum(bits[r] for r in bits if r.kind is EntityKind.SUBSCRIPTION)
        self._listens = listens & ~self._system
        self._acts = sum(bits.values()) & ~listens & ~self._system
        self._own = {process: sum(bits[r] for r in rights) for process, rights in needed.items()}
        self._covered = {
            process: self._own[process] | sum(bits[r] for r in self._under_patterns(rights))
            for process, rights in needed.items()
        }

        self._names = sorted({name for names in influence.values() for name in names}) if influence is not None else []
        number = {name: 1 << index for index, name in enumerate(self._names)}
        self._influence = (
            None if influence is None else {p: sum(number[each] for each in n) for p, n in influence.items()}
        )

    def _under_patterns(self, own: Iterable[Privilege]) -> Iterator[Privilege]:
        wild = [(right, Pattern(right.name)) for right in own if "*" in right.name]
        if wild:
            for other in self._rights:
                name = Pattern(other.name)
                if other not in own and any(
                    r.kind is other.kind and r.ros is other.ros and p.covers(name) for r, p in wild
                ):
                    yield other

    def union(self, processes: Iterable[str]) -> int:
        """All that some processes need."""
        held = 0
        for process in processes:
            held |= self._own[process]
        return held

    def price(self, processes: Iterable[str]) -> Price:
        """The price of an enclave with these processes: what each of them holds and does not need."""
        members = tuple(processes)
        held = self.union(members)
        application = system = 0
        for process in members:
            surplus = held & ~self._covered[process]
            application += ACTS * (surplus & self._acts).bit_count() + LISTENS * (surplus & self._listens).bit_count()
            system += (surplus & self._system).bit_count()
        if self._influence is not None:
            application += INFLUENCES * sum(self._more(process, members).bit_count() for process in members)
        return Price(application, system)

    def _more(self, process: str, members: Iterable[str]) -> int:
        """The names that a process can influence with the rights of the others alone."""
        reached = 0
        if self._influence is None:
            return reached
        for member in members:
            reached |= self._influence[member]
        return reached & ~self._influence[process]

    def influenced(self, process: str, processes: Iterable[str]) -> tuple[str, ...] | None:
        """What a process can influence in an enclave with others, and could not alone; None where nobody asked."""
        if self._influence is None:
            return None
        more = self._more(process, processes)
        return tuple(name for index, name in enumerate(self._names) if more >> index & 1)

    def surplus(self, process: str, processes: Iterable[str]) -> tuple[tuple[Privilege, bool], ...]:
        """What a process holds in an enclave with others and does not need; with each right, whether it is of the system."""
        bits = self.union(processes) & ~self._covered[process]
        return tuple(
            (right, bool(self._system >> index & 1)) for index, right in enumerate(self._rights) if bits >> index & 1
        )
