# SPDX-License-Identifier: Apache-2.0
"""Which processes should share an enclave, under which path, and what does each of them get that it does not need?

    --max 2  ->  /robot1/camera_and_lidar: demo/camera, demo/lidar, price 0      /robot1/planner: demo/planner, price 0

The path of a joint enclave is the namespace that its parts share, and their last names (`/driver_x2` for /left/driver and /right/driver).
"""

from __future__ import annotations

import enum
from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import Final

from rosward.enclaves.grouping import Cut, Ladder, Unit, cut_at, knee, ladder, most, within
from rosward.enclaves.influence import influence_of
from rosward.enclaves.price import Price, Tariff
from rosward.enclaves.privileges import Privilege, on_dds, privileges
from rosward.enclaves.size import LARGEST, signed_size
from rosward.network.checks import UnknownNames
from rosward.network.contexts import with_enclaves
from rosward.network.enclave_mode import EnclaveMode
from rosward.network.enclaves import LONGEST_ENCLAVE, enclave_paths
from rosward.records import NamedTuple
from rosward.ros.entities import Node

__all__ = ["JointEnclave", "Suggestion", "Surplus", "Wish", "suggest"]

_MOST_NAMED: Final = 2


class Wish(enum.Enum):
    """Where the ladder is cut: the last step that costs nothing, at a number of enclaves, at a price."""

    FREE = "free"
    MOST = "max"
    BUDGET = "budget"


class Surplus(NamedTuple):
    """A process in an enclave, its nodes, and the rights that it holds there and does not need.

    `influenced`: what these let it influence and it could not before; None where that was not asked for.
    """

    process: str
    nodes: tuple[str, ...]
    application: tuple[Privilege, ...]
    system: tuple[Privilege, ...]
    influenced: tuple[str, ...] | None = None


class JointEnclave(NamedTuple):
    """One enclave of the suggestion. `fixed`: the launch files name it. `size`: of its signed permissions, in bytes."""

    path: str
    processes: tuple[Surplus, ...]
    price: Price
    size: int
    fixed: bool

    @property
    def too_large(self) -> bool:
        """Whether its permissions may break the handshake of DDS."""
        return self.size > LARGEST


class Suggestion(NamedTuple):
    """A ladder, where it is cut, and the enclaves there.

    `met` is False where no cut fulfils the wish; then it is the nearest. `knee` is the step behind which enclaves cost most. `needed` are the
    rights of the application that processes need themselves, by number.
    """

    ladder: Ladder
    wish: Wish
    limit: int | None
    cut: Cut
    met: bool
    knee: int
    needed: int
    enclaves: tuple[JointEnclave, ...]


def suggest(
    nodes: Sequence[Node],
    wish: Wish = Wish.FREE,
    limit: int = 0,
    *,
    unknown: UnknownNames = "deny",
    ignore_given: bool = False,
    influence: bool = False,
) -> Suggestion:
    """The enclaves for the processes of these nodes, which are in one enclave for each process, or in the one that its start names.

    `ignore_given`: as if no start named one. `influence`: what a process can then influence counts, too, by the flows of the nodes.
    """
    placed = list(nodes)
    if ignore_given and any(node.given_enclave is not None for node in nodes):
        placed, _ = with_enclaves([replace(node, given_enclave=None) for node in nodes], EnclaveMode.PROCESS)
    by_process = _by_process(placed)
    rights = {process: privileges(members, unknown) for process, members in by_process.items()}
    tariff = Tariff(rights, influence_of(by_process) if influence else None)
    made = ladder(_units(placed), tariff)
    found = (
        most(made, limit)
        if wish is Wish.MOST
        else within(made, limit if wish is Wish.BUDGET else made.start.application)
    )
    nearest = len(made.steps) if wish is Wish.MOST else 0
    cut = cut_at(made, nearest if found is None else found)
    return Suggestion(
        made,
        wish,
        None if wish is Wish.FREE else limit,
        cut,
        found is not None,
        knee(made),
        sum(not system for needed in rights.values() for system in needed.values()),
        tuple(_enclaves(cut, tariff, by_process, unknown)),
    )


def _by_process(nodes: Iterable[Node]) -> dict[str, list[Node]]:
    by_process: dict[str, list[Node]] = {}
    for node in nodes:
        by_process.setdefault(node.process, []).append(node)
    return by_process


def _units(nodes: Sequence[Node]) -> list[Unit]:
    paths = enclave_paths(nodes)
    processes: dict[str, set[str]] = {}
    fixed: set[str] = set()
    for node in nodes:
        processes.setdefault(paths[node.enclave], set()).add(node.process)
        if node.given_enclave is not None:
            fixed.add(paths[node.enclave])
    return [Unit(path, tuple(sorted(processes[path])), path in fixed) for path in sorted(processes)]


def _enclaves(cut: Cut, tariff: Tariff, by_process: dict[str, list[Node]], unknown: UnknownNames) -> list[JointEnclave]:
    taken = {unit.enclave for group in cut.groups for unit in group}
    made: list[JointEnclave] = []
    for group in cut.groups:
        path = group[0].enclave if len(group) == 1 else _path([unit.enclave for unit in group], taken)
        taken.add(path)
        members = tuple(sorted(process for unit in group for process in unit.processes))
        rights = privileges((node for process in members for node in by_process[process]), unknown)
        size = signed_size(path, (right for each in rights for right in on_dds(each)))
        made.append(
            JointEnclave(
                path,
                tuple(_surplus(process, members, tariff, by_process) for process in members),
                tariff.price(members),
                size,
                group[0].fixed,
            )
        )
    return sorted(made, key=lambda enclave: enclave.path)


def _surplus(process: str, members: tuple[str, ...], tariff: Tariff, by_process: dict[str, list[Node]]) -> Surplus:
    more = tariff.surplus(process, members)
    return Surplus(
        process,
        tuple(sorted({node.fqn for node in by_process[process]})),
        tuple(right for right, system in more if not system),
        tuple(right for right, system in more if system),
        tariff.influenced(process, members),
    )


def _path(parts: Sequence[str], taken: set[str]) -> str:
    """A path that nobody has: what the parts share, then the last name of the first, and of the second or how many more."""
    tokens = [part.split("/")[1:] for part in parts]
    shared: list[str] = []
    for level in zip(*(each[:-1] for each in tokens), strict=False):
        if len(set(level)) > 1:
            break
        shared.append(level[0])
    last = [each[-1] or "root" for each in tokens]
    if len(set(last)) == 1:
        label = f"{last[0]}_x{len(last)}"
    else:
        label = "_and_".join(last) if len(last) <= _MOST_NAMED else f"{last[0]}_and_{len(last) - 1}_more"
    return _free("/" + "/".join((*shared, label)), taken)


def _free(wanted: str, taken: set[str]) -> str:
    """Short enough for a certificate, and not another enclave's."""
    stem = wanted if len(wanted) <= LONGEST_ENCLAVE else wanted[: LONGEST_ENCLAVE - 6].rstrip("/_")
    path, number = stem, 2
    while path in taken:
        path, number = f"{stem[: LONGEST_ENCLAVE - 6].rstrip('/_')}_{number}", number + 1
    return path
