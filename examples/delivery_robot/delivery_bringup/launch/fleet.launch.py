# SPDX-License-Identifier: Apache-2.0
"""Two robots and the building."""

from launch import LaunchDescription
from launch.actions import GroupAction, IncludeLaunchDescription
from launch.launch_description_sources import AnyLaunchDescriptionSource, PythonLaunchDescriptionSource
from launch.substitutions import PathJoinSubstitution, ThisLaunchFileDir

ROBOTS = {'porter1': 'true', 'porter2': 'false'}


def beside(name):
    """Return the path of a launch file beside this one."""
    return PathJoinSubstitution([ThisLaunchFileDir(), name])


def generate_launch_description():
    """Describe the fleet: an include is not scoped by itself, so each robot gets a group of its own."""
    description = LaunchDescription([
        IncludeLaunchDescription(
            AnyLaunchDescriptionSource(beside('building.launch.xml')),
            launch_arguments={'robots': f'[{", ".join(ROBOTS)}]'}.items(),
        ),
    ])
    for robot, camera in ROBOTS.items():
        description.add_action(
            GroupAction([
                IncludeLaunchDescription(
                    PythonLaunchDescriptionSource(beside('robot.launch.py')),
                    launch_arguments={'robot': robot, 'camera': camera}.items(),
                ),
            ])
        )
    return description
