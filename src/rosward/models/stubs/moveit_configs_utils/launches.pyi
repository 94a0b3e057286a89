# SPDX-License-Identifier: Apache-2.0
"""moveit_configs_utils.launches: the launch files of a MoveIt configuration package.

Read from moveit_configs_utils 2.12.
"""

from _rosward import unknown
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription
from launch.conditions import IfCondition
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue
from moveit_configs_utils.launch_utils import DeclareBooleanLaunchArg, add_debuggable_node


def _included(moveit_config, name, **kwargs):
    return IncludeLaunchDescription(PythonLaunchDescriptionSource(str(moveit_config.package_path / "launch" / name)), **kwargs)


def generate_rsp_launch(moveit_config):
    return LaunchDescription([
        DeclareLaunchArgument("publish_frequency", default_value="15.0"),
        Node(package="robot_state_publisher", executable="robot_state_publisher",
             parameters=[moveit_config.robot_description, {"publish_frequency": LaunchConfiguration("publish_frequency")}]),
    ])


def generate_moveit_rviz_launch(moveit_config):
    config = str(moveit_config.package_path / "config/moveit.rviz")
    ld = LaunchDescription([DeclareBooleanLaunchArg("debug"), DeclareLaunchArgument("rviz_config", default_value=config)])
    add_debuggable_node(ld, package="rviz2", executable="rviz2", arguments=["-d", LaunchConfiguration("rviz_config")],
                        parameters=[moveit_config.planning_pipelines, moveit_config.robot_description_kinematics,
                                    moveit_config.joint_limits])
    return ld


def generate_setup_assistant_launch(moveit_config):
    ld = LaunchDescription([DeclareBooleanLaunchArg("debug")])
    add_debuggable_node(ld, package="moveit_setup_assistant", executable="moveit_setup_assistant",
                        arguments=[["--config_pkg=", str(moveit_config.package_path)]])
    return ld


def generate_static_virtual_joint_tfs_launch(moveit_config):
    ld = LaunchDescription()
    for name in unknown("file", "virtual joints", "list"):
        words = ["--frame-id", unknown("file", "frame", "str"), "--child-frame-id", unknown("file", "frame", "str")]
        number = unknown("file", "number of a virtual joint", "int")
        ld.add_action(Node(package="tf2_ros", executable="static_transform_publisher",
                           name=f"static_transform_publisher{number}", arguments=words))
    return ld


def generate_spawn_controllers_launch(moveit_config):
    ld = LaunchDescription()
    for name in unknown("file", "controllers", "list"):
        ld.add_action(Node(package="controller_manager", executable="spawner", arguments=[name]))
    ld.add_action(Node(package="controller_manager", executable="spawner", arguments=["joint_state_broadcaster"]))
    return ld


def generate_warehouse_db_launch(moveit_config):
    path = str(moveit_config.package_path / "default_warehouse_mongo_db")
    settings = {
        "overwrite": False,
        "database_path": LaunchConfiguration("moveit_warehouse_database_path"),
        "warehouse_port": LaunchConfiguration("moveit_warehouse_port"),
        "warehouse_host": LaunchConfiguration("moveit_warehouse_host"),
        "warehouse_exec": "mongod",
        "warehouse_plugin": "warehouse_ros_mongo::MongoDatabaseConnection",
    }
    return LaunchDescription([
        DeclareLaunchArgument("moveit_warehouse_database_path", default_value=path),
        DeclareBooleanLaunchArg("reset"),
        DeclareLaunchArgument("moveit_warehouse_port", default_value="33829"),
        DeclareLaunchArgument("moveit_warehouse_host", default_value="localhost"),
        Node(package="warehouse_ros_mongo", executable="mongo_wrapper_ros.py", parameters=[settings]),
        Node(package="moveit_ros_warehouse", executable="moveit_init_demo_warehouse",
             condition=IfCondition(LaunchConfiguration("reset"))),
    ])


def generate_move_group_launch(moveit_config):
    scene = LaunchConfiguration("publish_monitored_planning_scene")
    settings = {
        "publish_robot_description_semantic": True,
        "allow_trajectory_execution": LaunchConfiguration("allow_trajectory_execution"),
        "capabilities": ParameterValue(LaunchConfiguration("capabilities"), value_type=str),
        "disable_capabilities": ParameterValue(LaunchConfiguration("disable_capabilities"), value_type=str),
        "publish_planning_scene": scene,
        "publish_geometry_updates": scene,
        "publish_state_updates": scene,
        "publish_transforms_updates": scene,
        "monitor_dynamics": False,
    }
    given = moveit_config.move_group_capabilities
    ld = LaunchDescription([
        DeclareBooleanLaunchArg("debug"),
        DeclareBooleanLaunchArg("allow_trajectory_execution", default_value=True),
        DeclareBooleanLaunchArg("publish_monitored_planning_scene", default_value=True),
        DeclareLaunchArgument("capabilities", default_value=given["capabilities"]),
        DeclareLaunchArgument("disable_capabilities", default_value=given["disable_capabilities"]),
        DeclareBooleanLaunchArg("monitor_dynamics"),
    ])
    add_debuggable_node(ld, package="moveit_ros_move_group", executable="move_group", extra_debug_args=["--debug"],
                        parameters=[moveit_config.to_dict(), settings])
    return ld


def generate_demo_launch(moveit_config, launch_package_path=None):
    controllers = str(moveit_config.package_path / "config/ros2_controllers.yaml")
    ld = LaunchDescription([
        DeclareBooleanLaunchArg("db"),
        DeclareBooleanLaunchArg("debug"),
        DeclareBooleanLaunchArg("use_rviz", default_value=True),
    ])
    joints = moveit_config.package_path / "launch/static_virtual_joint_tfs.launch.py"
    if joints.exists():
        ld.add_action(_included(moveit_config, "static_virtual_joint_tfs.launch.py"))
    for name, condition in (("rsp", None), ("move_group", None), ("moveit_rviz", "use_rviz"), ("warehouse_db", "db")):
        test = None if condition is None else IfCondition(LaunchConfiguration(condition))
        ld.add_action(_included(moveit_config, name + ".launch.py", condition=test))
    ld.add_action(Node(package="controller_manager", executable="ros2_control_node", parameters=[controllers],
                       remappings=[("/controller_manager/robot_description", "/robot_description")]))
    ld.add_action(_included(moveit_config, "spawn_controllers.launch.py"))
    return ld
