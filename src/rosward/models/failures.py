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

    Where that is so of one of several alternatives, as of a node that may be another one, it is told if the others fail, too.
    """
    exception = machine.call(cls, args)
    finding = Finding("RW209", message, machine.place)
    for each in options(exception):
        if isinstance(each, Ref):
            if machine.is_alternative:
                machine.log.doubtful.append((each.address, finding))
            else:
                machine.log.failures.setdefault(each.address, Findings()).add(finding)
    machine.throw(exception)
    return UNBOUND


def tell_uncaught(machine: Machine, exception: Value) -> None:
    """An exception leaves the program, or a callback: where a library raised it, that is told."""
    for each in options(exception):
        if isinstance(each, Ref):
            machine.log.uncaught.add(each.address)
            machine.log.findings.update(machine.log.failures.get(each.address, ()))
