# SPDX-License-Identifier: Apache-2.0
"""How can enclaves be put together, at which price, and what is suggested? For a person: the ladder, then the enclaves of the chosen cut.

step  enclaves     price     total    system  joins
             3         -         0         0  (as they are)
   1         2         0         0        28  /camera + /lidar
   2         1         7         7        70  [1] + /planner
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator
from typing import Final

from rosward.enclaves.grouping import Ladder
from rosward.enclaves.price import ACTS, INFLUENCES, LISTENS
from rosward.enclaves.privileges import Privilege
from rosward.enclaves.size import LARGEST
from rosward.enclaves.suggestion import JointEnclave, Suggestion, Surplus, Wish
from rosward.network.counts import listed, several
from rosward.safe import printable

__all__ = ["enclaves_text"]

_MOST_SHOWN: Final = 4


def enclaves_text(suggestion: Suggestion, *, verbose: bool = False) -> str:
    """The text. `verbose`: every right that a process would hold and does not need."""
    lines = [*_ladder(suggestion), "", *_verdict(suggestion), ""]
    for enclave in suggestion.enclaves:
        lines += [*_enclave(enclave, verbose=verbose), ""]
    return "\n".join(printable(line) for line in lines)


def _ladder(suggestion: Suggestion) -> Iterator[str]:
    made = suggestion.ladder
    here = f"  <- {_cut_by(suggestion)}"
    yield f"{'step':>5} {'enclaves':>9} {'price':>9} {'total':>9} {'system':>9}  joins"
    chosen = suggestion.cut.steps
    first = f"{'':>5} {len(made.units):>9} {'-':>9} {made.start.application:>9} {made.start.system:>9}  (as they are)"
    yield first + (here if chosen == 0 else "")
    for number, step in enumerate(made.steps, 1):
        numbers = f"{number:>5} {step.enclaves:>9} {step.price.application:>9} {step.total.application:>9} {step.total.system:>9}"
        joins = f"{_named(made, step.left)} + {_named(made, step.right)}"
        mark = here if number == chosen else "  (the knee)" if number == suggestion.knee else ""
        yield f"{numbers}  {joins}{mark}"


def _named(made: Ladder, group: int) -> str:
    return made.units[group].enclave if group < len(made.units) else f"[{group - len(made.units) + 1}]"


def _cut_by(suggestion: Suggestion) -> str:
    match suggestion.wish:
        case Wish.FREE:
            return "the last step that costs nothing"
        case Wish.MOST:
            return f"at most {suggestion.limit} enclaves"
        case Wish.BUDGET:
            return f"within a price of {suggestion.limit}"


def _verdict(suggestion: Suggestion) -> Iterator[str]:
    enclaves = suggestion.enclaves
    total = suggestion.ladder.totals[suggestion.cut.steps]
    processes = [process for enclave in enclaves for process in enclave.processes]
    application = sum(len(process.application) for process in processes)
    knee = suggestion.ladder.steps[suggestion.knee - 1] if suggestion.knee else None
    if not suggestion.met:
        yield f"No step meets the request ({_cut_by(suggestion)}); this is the closest."
    yield (
        f"{several(len(processes), 'process', 'processes')} in {several(len(enclaves), 'enclave', 'enclaves')}, price {total.application}: "
        f"{several(application, 'permission', 'permissions')} of the application and {total.system} of the client library "
        f"are held by processes that do not need them; they need {suggestion.needed} application permissions."
    )
    yield f"The price counts {ACTS} for a permission that affects other nodes and {LISTENS} for a subscription."
    influenced = [each for process in processes for each in process.influenced or ()]
    if any(process.influenced is not None for process in processes):
        yield f"It also counts {INFLUENCES} for each name that a process could not influence before, here {len(influenced)}."
    free = sum(step.price.application == 0 for step in suggestion.ladder.steps)
    if knee is not None and suggestion.wish is Wish.FREE and suggestion.knee > suggestion.cut.steps:
        yield f"The best trade-off for fewer enclaves is the knee, --max {knee.enclaves}: price {knee.total.application}."
    if free:
        yield f"{several(free, 'step costs', 'steps cost')} only permissions of the client library."
    if any(enclave.fixed for enclave in enclaves):
        yield "Enclaves set by launch files are kept; use --ignore-given to regroup them."


def _enclave(enclave: JointEnclave, *, verbose: bool) -> Iterator[str]:
    size = f"permissions {-(-enclave.size // 1024)} KB"
    if enclave.too_large:
        size += f", above the {LARGEST // 1024} KB limit"
    given = ", set by a launch file" if enclave.fixed else ""
    yield f"{enclave.path}{given}: price {enclave.price.application}, {enclave.price.system} system, {size}"
    for process in enclave.processes:
        yield f"  {process.process} ({_some(process.nodes, verbose=verbose)})"
        if process.application or process.system:
            yield f"    not needed: {_counts(process)}"
        if process.application:
            yield f"    {_some([_said(p) for p in process.application], verbose=verbose)}"
        if process.influenced:
            yield f"    could also influence {_some(process.influenced, verbose=verbose)}"


def _counts(process: Surplus) -> str:
    counted = Counter(right.kind.value for right in process.application)
    parts = [f"{number} {kind}{'s' if number > 1 else ''}" for kind, number in sorted(counted.items())]
    return ", ".join([*parts, f"{len(process.system)} system"])


def _said(right: Privilege) -> str:
    return f"{right} (a pattern)" if "*" in right.name else str(right)


def _some(words: Iterable[str], *, verbose: bool) -> str:
    ordered = list(words)
    return listed(ordered, len(ordered) if verbose else _MOST_SHOWN)
