# SPDX-License-Identifier: Apache-2.0
"""Which environment variables are surely set where programs of ROS 2 are built and run?

    int(os.environ["ROS_VERSION"]) == 2     in programs, in launch files, and in setup.py
    $ROS_DISTRO == humble                   in the conditions of package.xml

The setup files of every installation set some of them (the package ros_environment), the user gives others (`--env`).
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

ROS_2: Final[Mapping[str, str]] = {"ROS_VERSION": "2", "ROS_PYTHON_VERSION": "3"}
OF_DISTRO: Final = frozenset((*ROS_2, "ROS_DISTRO"))
"""The variables that follow from the distribution; nobody else gives them a value."""


class SurroundingsError(ValueError):
    """A variable that cannot have the value that it is given; the message says why."""


def surroundings(distro: str, given: Mapping[str, str] | None = None) -> Mapping[str, str]:
    """The variables that a distribution sets, and those that are given. Raises SurroundingsError where these contradict each other."""
    found = {**ROS_2, "ROS_DISTRO": distro}
    for name, value in (given or {}).items():
        if found.setdefault(name, value) != value:
            raise SurroundingsError(f"{name} is {found[name]!r} for the distro {distro}, so it cannot be {value!r}")
    return found


def parse_variable(text: str) -> tuple[str, str]:
    """`NAME=VALUE`. Raises SurroundingsError."""
    name, mark, value = text.partition("=")
    if not mark:
        raise SurroundingsError(f"{text!r} is not of the form NAME=VALUE")
    return checked_variable(name, value)


def checked_variable(name: str, value: str) -> tuple[str, str]:
    """A variable that an environment can hold. Raises SurroundingsError."""
    if name.endswith(":"):
        raise SurroundingsError(f"{name}={value} has the form of a launch argument (--arg); a variable is NAME=VALUE")
    if not name or "=" in name or any(c.isspace() or c == "\0" for c in name):
        raise SurroundingsError(f"{name!r} is not a valid name of an environment variable")
    if "\0" in value:
        raise SurroundingsError(f"the value of {name} contains a NUL byte")
    return name, value
