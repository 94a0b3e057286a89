# SPDX-License-Identifier: Apache-2.0
"""The environment in which everything is started, as values.

shell({'ROS_VERSION': '2', 'ROBOT': 'r1'})     '2' as in every ROS 2; 'r1' because it was given: a name made of it is bound
"""

from __future__ import annotations

from collections.abc import Mapping

from rosward.domain.unknown import Origin
from rosward.domain.values import Const
from rosward.ros.distro import Distro
from rosward.source.surroundings import OF_DISTRO, ROS_2

ORIGIN = "environment variable"
"""The kind of the origins of values that come from the environment."""

Shell = Mapping[str, Const]


def shell(variables: Mapping[str, str]) -> Shell:
    """The value of each variable, with where it comes from."""
    found = {name: _value(name, text) for name, text in variables.items()}
    if "ROS_DISTRO" in variables:
        for name, text in Distro(variables["ROS_DISTRO"]).facts.environment.items():
            found.setdefault(name, Const(text, frozenset({Origin(ORIGIN, name)})))
    return found


def usual_shell() -> Shell:
    """That of which nothing else is known: some ROS 2 is set up."""
    return shell(ROS_2)


def _value(name: str, text: str) -> Const:
    if name in OF_DISTRO:
        return Const(text)
    return Const(text, frozenset({Origin(ORIGIN, name, settled=True, given=True)}))
