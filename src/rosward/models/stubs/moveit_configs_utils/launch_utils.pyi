# SPDX-License-Identifier: Apache-2.0
"""moveit_configs_utils.launch_utils.

Read from moveit_configs_utils 2.12.
"""

from launch.actions import DeclareLaunchArgument
from launch.conditions import IfCondition, UnlessCondition
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


class DeclareBooleanLaunchArg(DeclareLaunchArgument):
    def __init__(self, name, *, default_value=False, description=None, **kwargs):
        super().__init__(name, default_value=str(default_value), description=description, **kwargs)


def add_debuggable_node(ld, package, executable, condition_name="debug", commands_file=None, extra_debug_args=None, **kwargs):
    for word in ("output", "arguments"):
        kwargs.setdefault(word, None)
    arguments = kwargs.pop("arguments") or []
    debug = LaunchConfiguration(condition_name)
    ld.add_action(Node(package=package, executable=executable, condition=UnlessCondition(debug), arguments=arguments, **kwargs))
    arguments = [*arguments, *(extra_debug_args or [])]
    ld.add_action(Node(package=package, executable=executable, condition=IfCondition(debug), arguments=arguments, **kwargs))
