# SPDX-License-Identifier: Apache-2.0
"""In which enclave does each process run?

    process demo/pair with the nodes /a and /b        per node: /a, /b    per process: /pair    as launched: /
    a container /box with the components /a and /b    per process: /box
    the same, and the user assigned /b to /joint      /joint for both

A context, and so a process, has one enclave (rcl, init.c). What its start names counts, whatever is asked for: ROS_SECURITY_ENCLAVE_OVERRIDE,
or the last --enclave among its arguments. What the user assigns comes before all, and is told where it means that a start has to be changed.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator, Mapping
from typing import Final

from rosward.findings import Finding
from rosward.holes import Holed, literal, with_stars
from rosward.network.assigned import NOTHING_ASSIGNED, Assignment
from rosward.network.enclave_mode import EnclaveMode
from rosward.network.free import free
from rosward.network.launch_tree import CONTAINER
from rosward.records import replace
from rosward.ros.entities import Node
from rosward.ros.names import fully_qualified, validate_enclave

_FORBIDDEN: Final = re.compile(r"[^A-Za-z0-9_]")


def with_enclaves(
    nodes: Iterable[Node], mode: EnclaveMode, assigned: Assignment = NOTHING_ASSIGNED
) -> tuple[list[Node], list[Finding]]:
    """The nodes with their enclaves, and what conflicts (RW308) or is assigned in vain (RW341)."""
    processes: dict[str, list[Node]] = {}
    for node in nodes:
        processes.setdefault(node.process, []).append(node)
    taken = _spoken_for(processes.values()) | assigned.paths
    if mode is EnclaveMode.NODE:
        taken |= {n.fqn for members in processes.values() for n in members}
    own = _of_nameless([n for members in processes.values() for n in members], taken)
    placed: list[Node] = []
    findings: list[Finding] = assigned.unused(processes)
    for members in processes.values():
        given = sorted({n.given_enclave for n in members if n.given_enclave is not None})
        chosen = assigned.of(members)
        if chosen:
            findings += _differ(members, given, chosen)
            placed += [replace(n, enclave=chosen[0]) for n in members]
            continue
        findings += _conflicts(members, given, mode)
        if given and mode is not EnclaveMode.NODE:
            placed += [replace(n, enclave=given[-1]) for n in members]
        elif mode is EnclaveMode.LAUNCH:
            placed += [replace(n, enclave="/") for n in members]
        elif mode is EnclaveMode.NODE:
            placed += [replace(n, enclave=n.given_enclave or own.get(n.label or "", n.fqn)) for n in members]
        elif (name := _own_name(members, own)) is not None:
            placed += [replace(n, enclave=name) for n in members]
        else:
            enclave = _shared(members, taken)
            taken.add(enclave)
            placed += [replace(n, enclave=enclave) for n in members]
    return placed, findings


def each_its_own(nodes: Iterable[Node]) -> list[Node]:
    """What stands in for enclaves that cannot be chosen: each node in one of its own, which allows nothing to the others of its process."""
    listed = list(nodes)
    own = _of_nameless(listed, {n.fqn for n in listed})
    return [replace(n, enclave=n.given_enclave or own.get(n.label or "", n.fqn)) for n in listed]


def _of_nameless(nodes: Iterable[Node], taken: set[str]) -> dict[str, str]:
    """An enclave for each node of unknown name, by its label: its namespace, then its executable."""
    found: dict[str, str] = {}
    for node in sorted((n for n in nodes if n.label is not None), key=lambda n: n.label or ""):
        label = node.label or ""
        last = _FORBIDDEN.sub("_", label.partition("#")[0].rpartition(":" if node.assumed else "/")[2])
        wanted = str(fully_qualified(Holed(node.namespace), literal(f"_{last}" if last[:1].isdigit() else last)))
        found[label] = free(wanted, taken, "_")
        taken.add(found[label])
    return found


def _spoken_for(processes: Collection[list[Node]]) -> set[str]:
    """The enclaves that starts name, and those of processes that bear a node's name: one that is made up never meets them."""
    named = {n.given_enclave for members in processes for n in members if n.given_enclave is not None}
    alone = [own for members in processes if not members[0].label and (own := _own_name(members, {})) is not None]
    return {*named, *alone}


def _own_name(members: list[Node], nameless: Mapping[str, str]) -> str | None:
    """The node by whose name everybody knows a process: its only one, or the container that loads the others."""
    label = members[0].process.partition("#")[0]
    if label.startswith(CONTAINER):
        return label.removeprefix(CONTAINER)
    names = {n.display_name: nameless.get(n.label or "", n.fqn) for n in members}
    own = {names[n.display_name] for n in members if f"{n.package}/{n.executable}" == label}
    several = len({(n.package, n.executable) for n in members}) > 1
    for found in (set(names.values()), own if several else set()):
        if len(found) == 1:
            return found.pop()
    return None


def _differ(members: list[Node], given: list[str], chosen: tuple[str, ...]) -> Iterator[Finding]:
    place = members[0].launched_by or members[0].defined_at
    process = members[0].process
    if len(chosen) > 1:
        yield Finding("RW308", f"process {process} is assigned to several enclaves: {', '.join(chosen)}", place)
    if given and given[-1] != chosen[0]:
        message = (
            f"process {process} is assigned to {chosen[0]}, but it is started with {given[-1]}: change one of them"
        )
        yield Finding("RW308", message, place)


def _conflicts(members: list[Node], given: list[str], mode: EnclaveMode) -> list[Finding]:
    place = members[0].launched_by or members[0].defined_at
    process = members[0].process
    found = [
        Finding("RW308", f"process {process}: enclave {with_stars(enclave)!r} is rejected by rcl: {reason}", place)
        for enclave in given
        if (reason := validate_enclave(Holed(enclave))) is not None
    ]
    if len(given) > 1:
        found.append(Finding("RW308", f"process {process} is started with several enclaves: {', '.join(given)}", place))
    if given and mode is EnclaveMode.NODE and len({n.display_name for n in members}) > 1:
        found.append(
            Finding("RW308", f"process {process} runs in {given[-1]}, which its {len(members)} nodes must share", place)
        )
    return found


def _shared(members: list[Node], taken: set[str]) -> str:
    """An enclave for several nodes: the namespace of the first, then the executable, or the class of assumed nodes."""
    first = members[0]
    label = first.process.rpartition(":" if first.assumed else "/")[2].replace("#", "_")
    wanted = str(fully_qualified(Holed(first.namespace), literal(label)))
    return free(wanted, taken, "_")
