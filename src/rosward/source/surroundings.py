# SPDX-License-Identifier: Apache-2.0
"""Which environment variables are surely set wherever programs of ROS 2 are built and run?

    int(os.environ["ROS_VERSION"]) == 2     in programs, in launch files, and in setup.py

The setup files of every installation set them (the package ros_environment); ROS_DISTRO too, where the distribution is known.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

ROS_2: Final[Mapping[str, str]] = {"ROS_VERSION": "2", "ROS_PYTHON_VERSION": "3"}


def surroundings(distro: str) -> Mapping[str, str]:
    """The variables that a distribution sets."""
    return {**ROS_2, "ROS_DISTRO": distro}
