# SPDX-License-Identifier: Apache-2.0
"""Which parameters do the command lines of a node set?"""

from __future__ import annotations

from rosward.domain.choice import join_all, options
from rosward.domain.text import pattern
from rosward.domain.values import Value
from rosward.effects.log import EffectLog, NodeEffect
from rosward.naming.command_line import given_to
from rosward.naming.final_name import command_lines, final_name
from rosward.ros.names import fully_qualified


def values_of(log: EffectLog, effect: NodeEffect) -> dict[str, Value]:
    """The parameters that the command lines of a node set, by name."""
    own, general = command_lines(log, effect)
    if not own.parameters and not general.parameters:
        return {}
    name, space = final_name(log, effect)
    found: dict[str, list[Value]] = {}
    for fqn in {fully_qualified(pattern(s), pattern(n)): None for n in options(name) for s in options(space)}:
        for label, value in {**given_to(fqn, general.parameters), **given_to(fqn, own.parameters)}.items():
            found.setdefault(label, []).append(value)
    return {label: join_all(values) for label, values in found.items()}
