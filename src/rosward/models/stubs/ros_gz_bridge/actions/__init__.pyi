# SPDX-License-Identifier: Apache-2.0
"""ros_gz_bridge.actions: the bridge, by a launch file of the package.

Read from ros_gz_bridge 2.1.
"""

from launch.actions import IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch_ros.substitutions import FindPackageShare


class RosGzBridge(IncludeLaunchDescription):
    def __init__(self, *, bridge_name, config_file, container_name="ros_gz_container", create_own_container="False",
                 namespace="", use_composition="False", use_respawn="False", log_level="info", **kwargs):
        arguments = [("bridge_name", bridge_name), ("config_file", config_file), ("container_name", container_name),
                     ("create_own_container", create_own_container), ("namespace", namespace),
                     ("use_composition", use_composition), ("use_respawn", use_respawn), ("log_level", log_level)]
        source = PythonLaunchDescriptionSource([FindPackageShare("ros_gz_bridge"), "/launch/ros_gz_bridge.launch.py"])
        super().__init__(source, launch_arguments=arguments, **kwargs)
