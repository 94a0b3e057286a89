# SPDX-License-Identifier: Apache-2.0
"""controller_manager.launch_utils: a spawner of controllers.

Read from controller_manager 4.20.
"""

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration, PythonExpression
from launch_ros.actions import Node


def _spawner(arguments): return Node(package="controller_manager", executable="spawner", arguments=arguments, shell=True)


def generate_controllers_spawner_launch_description(controller_names, controller_params_files=None, extra_spawner_args=[]):
    words = [*controller_names, "--controller-manager", LaunchConfiguration("controller_manager_name")]
    for file in controller_params_files or []:
        words += ["--param-file", file] if file else []
    unload = PythonExpression(['"--unload-on-kill" if "true" == "', LaunchConfiguration("unload_on_kill"), '" else ""'])
    return LaunchDescription([
        DeclareLaunchArgument("controller_manager_name", default_value="controller_manager"),
        DeclareLaunchArgument("unload_on_kill", default_value="false"),
        _spawner([*words, unload, *extra_spawner_args]),
    ])


def generate_controllers_spawner_launch_description_from_dict(controller_info_dict, extra_spawner_args=[]):
    files = []
    for found in controller_info_dict.values():
        if found:
            files += found if isinstance(found, list) else [found]
    return generate_controllers_spawner_launch_description(list(controller_info_dict), files, extra_spawner_args)


def generate_load_controller_launch_description(controller_name, controller_params_file=None, extra_spawner_args=[]):
    files = [controller_params_file] if controller_params_file else None
    return generate_controllers_spawner_launch_description([controller_name], files, extra_spawner_args)


def generate_spawner_launch_description(controller_info_dict, extra_spawner_args=[]):
    words = []
    for name, settings in controller_info_dict.items():
        words += ["--controller", name]
        files = settings.get("param_file", None)
        for file in files if isinstance(files, list) else [files]:
            words += ["--param-file", file] if file else []
        if settings.get("load_only", False):
            words.append("--load-only")
        if settings.get("inactive", False):
            words.append("--inactive")
        if "ros_args" in settings:
            words += ["--controller-ros-args", settings["ros_args"]]
    return LaunchDescription([_spawner([*words, *extra_spawner_args])])
