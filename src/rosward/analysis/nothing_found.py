# SPDX-License-Identifier: Apache-2.0
"""Why is there no node in what was read, and what can be done about it?

three packages that depend on roscpp    they are for ROS 1
helpers.py                              nothing starts the classes of a library
"""

from __future__ import annotations

from typing import Final

from rosward.analysis.read import SourcesRead
from rosward.findings import Finding
from rosward.location import Place
from rosward.source.ros_1 import is_for_ros_1

_CLIENTS: Final = frozenset({"rclcpp", "rclcpp_lifecycle", "rclcpp_components"})


def nothing_found(read: SourcesRead) -> Finding:
    """RW007 for sources of which every executable was asked for."""
    return Finding("RW007", f"No node was found: {_why(read)}", Place("", 0))


def nothing_started(read: SourcesRead) -> Finding:
    """The same for sources of which launch files were asked for."""
    why = "the launch files start none" if read.workspace.launch_files else "there is no launch file"
    return Finding("RW007", f"No node was found: {why}. Without --launch, every executable is analysed.", Place("", 0))


def _why(read: SourcesRead) -> str:
    packages = read.workspace.packages
    if any(map(is_for_ros_1, packages)) and not any(package.build_type.startswith("ament") for package in packages):
        return "the packages are for ROS 1. Pass the branch or the fork that is for ROS 2."
    programs = sum(not entry.assumed for entry in read.plan.entries)
    if programs:
        analysed = (
            "one program was analysed, which creates none"
            if programs == 1
            else f"{programs} programs were analysed, which create none"
        )
        return f"{analysed}. If this is part of a larger system, pass the whole workspace."
    if read.plan.related or read.plan.entries or any(not package.depends.isdisjoint(_CLIENTS) for package in packages):
        return (
            "files use ROS 2, but nothing starts them: no executable is installed, and no file has a main function."
            " If this is a library, pass the workspace with the programs that use it."
        )
    return "no file uses ROS 2. Pass the workspace, a package or a file; if there are submodules, clone them, too."
