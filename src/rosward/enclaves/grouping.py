# SPDX-License-Identifier: Apache-2.0
"""In which order are enclaves best put together, from one for each process to one for all?

    camera, lidar, planner  ->  step 1: camera + lidar (price 0), step 2: [1] + planner (price 7)

Each step joins the two enclaves whose union adds least to the price: the application's rights first, then the system's, then names, so that
the same network gives the same ladder. The price is exact for each step; the ladder is greedy, so a cut of it need not be the best grouping
of all with that many enclaves. Processes that are in one enclave before (of one name, or in one container) stay together, and so
do those that are `fixed`: nobody joins these.
"""

from __future__ import annotations

import heapq
from collections.abc import Sequence

from rosward.enclaves.price import NOTHING, Price, Tariff
from rosward.records import NamedTuple

__all__ = ["Cut", "Ladder", "Merging", "Unit", "cut_at", "knee", "ladder", "most", "within"]


class Unit(NamedTuple):
    """Processes that are in one enclave to begin with. `fixed`: the launch files say so."""

    enclave: str
    processes: tuple[str, ...]
    fixed: bool = False


class Merging(NamedTuple):
    """Two groups become one. A group below the number of units is that unit, another one was made by a step before."""

    left: int
    right: int
    price: Price
    total: Price
    enclaves: int


class Ladder(NamedTuple):
    """All steps; `start` is the price of the units as they are."""

    units: tuple[Unit, ...]
    start: Price
    steps: tuple[Merging, ...]

    @property
    def totals(self) -> tuple[Price, ...]:
        """The price before the first step, and behind each."""
        return (self.start, *(step.total for step in self.steps))


class Cut(NamedTuple):
    """The ladder up to a step: groups of units."""

    steps: int
    groups: tuple[tuple[Unit, ...], ...]


def ladder(units: Sequence[Unit], tariff: Tariff) -> Ladder:
    """The ladder of these units, which are in the order of their enclaves."""
    members: dict[int, tuple[str, ...]] = {n: unit.processes for n, unit in enumerate(units) if not unit.fixed}
    prices = {number: tariff.price(processes) for number, processes in members.items()}
    start = NOTHING
    for unit in units:
        start = start.plus(tariff.price(unit.processes))
    fixed = len(units) - len(members)

    def offer(left: int, right: int) -> tuple[Price, int, int]:
        joint = tariff.price((*members[left], *members[right]))
        return joint.minus(prices[left]).minus(prices[right]), left, right

    numbers = sorted(members)
    queue = [offer(a, b) for i, a in enumerate(numbers) for b in numbers[i + 1 :]]
    heapq.heapify(queue)
    steps: list[Merging] = []
    total = start
    while queue:
        price, left, right = heapq.heappop(queue)
        if left not in members or right not in members:
            continue
        new = len(units) + len(steps)
        joint = (*members.pop(left), *members.pop(right))
        prices[new] = prices[left].plus(prices[right]).plus(price)
        total = total.plus(price)
        steps.append(Merging(left, right, price, total, len(members) + 1 + fixed))
        members[new] = joint
        for other in members:
            if other != new:
                heapq.heappush(queue, offer(other, new))
    return Ladder(tuple(units), start, tuple(steps))


def cut_at(made: Ladder, steps: int) -> Cut:
    """The groups behind so many steps, in the order of their first units."""
    groups: dict[int, tuple[int, ...]] = {number: (number,) for number in range(len(made.units))}
    for number, step in enumerate(made.steps[:steps]):
        groups[len(made.units) + number] = (*groups.pop(step.left), *groups.pop(step.right))
    ordered = sorted(tuple(sorted(group)) for group in groups.values())
    return Cut(steps, tuple(tuple(made.units[n] for n in group) for group in ordered))


def most(made: Ladder, enclaves: int) -> int | None:
    """The first cut with at most so many enclaves; None where the ladder has none."""
    if len(made.units) <= enclaves:
        return 0
    return next((n for n, step in enumerate(made.steps, 1) if step.enclaves <= enclaves), None)


def within(made: Ladder, budget: int) -> int | None:
    """The last cut whose price of application rights is not above a budget; None where even the start is."""
    fitting = [n for n, total in enumerate(made.totals) if total.application <= budget]
    return fitting[-1] if fitting else None


def knee(made: Ladder) -> int:
    """The cut after which enclaves begin to cost most.

    Of the line from the first cut to the last, it lies furthest below: most enclaves saved for the least part of the whole price. All steps
    where no step costs anything.
    """
    totals = made.totals
    whole = totals[-1].application - made.start.application
    if not whole:
        return len(made.steps)
    saved = {n: n * whole - (t.application - made.start.application) * len(made.steps) for n, t in enumerate(totals)}
    return max(saved, key=lambda n: (saved[n], -n))
