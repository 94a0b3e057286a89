# SPDX-License-Identifier: Apache-2.0
"""In which enclave does each process run?

    process demo/pair with the nodes /a and /b        per node: /a, /b    per process: /pair    as launched: /

A context, and so a process, has one enclave (rcl, init.c). What its start names counts, whatever is asked for: ROS_SECURITY_ENCLAVE_OVERRIDE,
or the last --enclave among its arguments.
"""

from __future__ import annotations

import enum
from collections.abc import Collection, Iterable
from dataclasses import replace

from rosward.findings import Finding
from rosward.ros.entities import Node
from rosward.ros.names import fully_qualified, validate_enclave


class EnclaveMode(enum.Enum):
    """How enclaves are chosen where the start of a process names none."""

    NODE = "node"
    """Each node one of its own, as if each ran in a process of its own."""

    PROCESS = "process"
    """The nodes of a process share one."""

    LAUNCH = "launch"
    """As rcl does it: `/`."""


def with_enclaves(nodes: Iterable[Node], mode: EnclaveMode) -> tuple[list[Node], list[Finding]]:
    """The nodes with their enclaves, and what conflicts (RW308)."""
    processes: dict[str, list[Node]] = {}
    for node in nodes:
        processes.setdefault(node.process, []).append(node)
    taken = _spoken_for(processes.values())
    placed: list[Node] = []
    findings: list[Finding] = []
    for members in processes.values():
        given = sorted({n.given_enclave for n in members if n.given_enclave is not None})
        findings += _conflicts(members, given, mode)
        if given and mode is not EnclaveMode.NODE:
            placed += [replace(n, enclave=given[-1]) for n in members]
        elif mode is EnclaveMode.LAUNCH:
            placed += [replace(n, enclave="/") for n in members]
        elif mode is EnclaveMode.NODE or len({n.fqn for n in members}) == 1:
            placed += [replace(n, enclave=n.given_enclave or n.fqn) for n in members]
        else:
            enclave = _shared(members, taken)
            taken.add(enclave)
            placed += [replace(n, enclave=enclave) for n in members]
    return placed, findings


def _spoken_for(processes: Collection[list[Node]]) -> set[str]:
    """The enclaves that starts name, and those of nodes that run alone: one that is made up never meets them."""
    named = {n.given_enclave for members in processes for n in members if n.given_enclave is not None}
    alone = [members[0].fqn for members in processes if len({n.fqn for n in members}) == 1]
    return {*named, *alone}


def _conflicts(members: list[Node], given: list[str], mode: EnclaveMode) -> list[Finding]:
    place = members[0].launched_by or members[0].defined_at
    process = members[0].process
    found = [
        Finding("RW308", f"process {process}: enclave {enclave!r} is refused by rcl: {reason}", place)
        for enclave in given
        if "*" not in enclave and (reason := validate_enclave(enclave)) is not None
    ]
    if len(given) > 1:
        found.append(Finding("RW308", f"process {process} is given several enclaves: {', '.join(given)}", place))
    if given and mode is EnclaveMode.NODE and len({n.fqn for n in members}) > 1:
        found.append(
            Finding(
                "RW308", f"process {process} runs in {given[-1]}, which its {len(members)} nodes have to share", place
            )
        )
    return found


def _shared(members: list[Node], taken: set[str]) -> str:
    """An enclave for several nodes: the namespace of the first, then the executable."""
    first = members[0]
    label = first.process.rpartition("/")[2].replace("#", "_")
    wanted = fully_qualified(first.namespace, label)
    enclave, number = wanted, 2
    while enclave in taken:
        enclave, number = f"{wanted}_{number}", number + 1
    return enclave
