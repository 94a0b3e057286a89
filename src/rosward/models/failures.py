# SPDX-License-Identifier: Apache-2.0
"""What does a library raise for sure, and what is told of it?

self.get_parameter('rate')      never declared: ParameterNotDeclaredException is raised here, and RW209 says so where nothing catches it
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from rosward.domain.choice import options
from rosward.domain.values import UNBOUND, Ref, Value
from rosward.findings import Finding, Findings

if TYPE_CHECKING:
    from rosward.models.native import Machine


def fail(machine: Machine, cls: Value, message: str, args: tuple[Value, ...]) -> Value:
    """The library raises `cls(*args)` here; returns `UNBOUND`, since nothing follows on this path.

    Where that is so of one of several alternatives, as of a node that may be another one, it is told if none of them goes on.
    """
    exception = machine.call(cls, args)
    finding = Finding("RW209", message, machine.place)
    for each in options(exception):
        if not isinstance(each, Ref):
            continue
        if machine.is_alternative:
            machine.log.withheld.append((each.address, finding, machine.is_tried))
        else:
            machine.log.failures.setdefault(each.address, Findings()).add(finding)
    machine.throw(exception)
    return UNBOUND


def tell_withheld(machine: Machine, start: int, *, ended: bool) -> None:
    """All alternatives were followed. `start`: what is withheld from there on is of them; `ended`: none of them goes on."""
    withheld = machine.log.withheld
    if ended and machine.is_alternative:
        return
    if ended:
        for address, finding, caught in withheld[start:]:
            machine.log.failures.setdefault(address, Findings()).add(finding)
            if not caught:
                machine.log.findings.add(finding)
    del withheld[start:]


def tell_uncaught(machine: Machine, exception: Value) -> None:
    """An exception leaves the program, or a callback: where a library raised it, that is told."""
    for each in options(exception):
        if isinstance(each, Ref):
            machine.log.findings.update(machine.log.failures.get(each.address, ()))
