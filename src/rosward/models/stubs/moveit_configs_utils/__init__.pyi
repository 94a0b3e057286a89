# SPDX-License-Identifier: Apache-2.0
"""moveit_configs_utils: what MoveIt configures a robot with.

The configuration is generated from the description of a robot: which parameters it has is not known here, only that they are given.

Read from moveit_configs_utils 2.12.
"""

from _rosward import unknown
from ament_index_python.packages import get_package_share_directory
from pathlib import Path


def _parameters(robot): return unknown("file", "MoveIt configuration of " + robot, "dict")


class MoveItConfigs:
    def __init__(self, robot, package):
        self.package_path = Path(get_package_share_directory(package))
        self._robot = robot
        self.robot_description = _parameters(robot)
        self.robot_description_semantic = _parameters(robot)
        self.robot_description_kinematics = _parameters(robot)
        self.planning_pipelines = _parameters(robot)
        self.trajectory_execution = _parameters(robot)
        self.planning_scene_monitor = _parameters(robot)
        self.sensors_3d = _parameters(robot)
        self.move_group_capabilities = {"capabilities": unknown("file", "capabilities", "str"),
                                        "disable_capabilities": unknown("file", "disable_capabilities", "str")}
        self.joint_limits = _parameters(robot)
        self.moveit_cpp = _parameters(robot)
        self.pilz_cartesian_limits = _parameters(robot)
        self.cartesian_limits = _parameters(robot)

    def to_dict(self): return _parameters(self._robot)


class MoveItConfigsBuilder:
    def __init__(self, robot_name, robot_description="robot_description", package_name=None):
        self._robot = robot_name
        self._package = package_name or robot_name + "_moveit_config"
        self._package_path = Path(get_package_share_directory(self._package))

    def robot_description(self, file_path=None, mappings=None): return self
    def robot_description_semantic(self, file_path=None, mappings=None): return self
    def robot_description_kinematics(self, file_path=None): return self
    def joint_limits(self, file_path=None): return self
    def moveit_cpp(self, file_path=None): return self
    def trajectory_execution(self, file_path=None, moveit_manage_controllers=True): return self
    def planning_scene_monitor(self, publish_planning_scene=True, publish_geometry_updates=True, publish_state_updates=True,
                               publish_transforms_updates=True, publish_robot_description=False,
                               publish_robot_description_semantic=False): return self
    def sensors_3d(self, file_path=None): return self
    def planning_pipelines(self, default_planning_pipeline=None, pipelines=None, load_all=True): return self
    def pilz_cartesian_limits(self, file_path=None): return self
    def cartesian_limits(self, file_path=None): return self
    def yaml(self, file_path, parameter_namespace=None): return self
    def parameter(self, parameter_name, parameter_value): return self
    def to_moveit_configs(self): return MoveItConfigs(self._robot, self._package)
    def to_dict(self, include_moveit_configs=True): return _parameters(self._robot)
