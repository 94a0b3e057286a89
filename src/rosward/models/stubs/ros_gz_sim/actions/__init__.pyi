# SPDX-License-Identifier: Apache-2.0
"""ros_gz_sim.actions: each includes a launch file of the package.

Read from ros_gz_sim 2.1.
"""

from launch.actions import IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch_ros.substitutions import FindPackageShare


def _source(file): return PythonLaunchDescriptionSource([FindPackageShare("ros_gz_sim"), "/launch/" + file])
def _given(**arguments): return [(name, value) for name, value in arguments.items() if value is not None]


class GzServer(IncludeLaunchDescription):
    def __init__(self, *, world_sdf_file="", world_sdf_string="", container_name="ros_gz_container",
                 create_own_container="False", use_composition="False", **kwargs):
        arguments = _given(world_sdf_file=world_sdf_file, world_sdf_string=world_sdf_string, container_name=container_name,
                           create_own_container=create_own_container, use_composition=use_composition)
        super().__init__(_source("gz_server.launch.py"), launch_arguments=arguments, **kwargs)


class GzSpawnModel(IncludeLaunchDescription):
    def __init__(self, *, world=None, file=None, model_string=None, topic=None, entity_name=None, allow_renaming=None,
                 x=None, y=None, z=None, roll=None, pitch=None, yaw=None, **kwargs):
        arguments = _given(world=world, file=file, model_string=model_string, topic=topic, entity_name=entity_name,
                           allow_renaming=allow_renaming, x=x, y=y, z=z, roll=roll, pitch=pitch, yaw=yaw)
        super().__init__(_source("gz_spawn_model.launch.py"), launch_arguments=arguments, **kwargs)
