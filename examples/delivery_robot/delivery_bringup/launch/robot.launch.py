# SPDX-License-Identifier: Apache-2.0
"""One delivery robot: all its nodes in the namespace that is its name."""

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, GroupAction
from launch.conditions import IfCondition
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import (
    ComposableNodeContainer,
    LifecycleNode,
    Node,
    PushRosNamespace,
    SetParametersFromFile,
    SetRemap,
)
from launch_ros.descriptions import ComposableNode
from launch_ros.substitutions import FindPackageShare

ROBOT = LaunchConfiguration('robot')

NODES = [
    ('delivery_base', 'base_driver'),
    ('delivery_base', 'battery_monitor'),
    ('delivery_navigation', 'localisation'),
    ('delivery_navigation', 'delivery_planner'),
    ('delivery_perception', 'lidar_filter'),
]
LIDARS = ['front', 'rear', 'mast']


def lidar(place):
    """Describe the driver of one lidar, which its container loads."""
    return ComposableNode(
        package='delivery_drivers',
        plugin='delivery_drivers::LidarDriver',
        name=f'lidar_{place}',
        namespace='',
        parameters=[{'place': place}],
        remappings=[('~/motor', f'lidars/{place}/motor')],
    )


def generate_launch_description():
    """Describe the robot."""
    settings = PathJoinSubstitution([FindPackageShare('delivery_bringup'), 'config', 'robot.yaml'])
    return LaunchDescription([
        DeclareLaunchArgument('robot', default_value='porter', description='name and namespace'),
        DeclareLaunchArgument('camera', default_value='true', description='whether it has one'),
        GroupAction([
            PushRosNamespace(ROBOT),
            SetRemap('/porter/heartbeat', '/fleet/heartbeat'),
            SetRemap('/porter/cmd_vel', ['/', ROBOT, '/cmd_vel']),
            SetParametersFromFile(settings),
            *(Node(package=package, executable=name) for package, name in NODES),
            ComposableNodeContainer(
                package='rclcpp_components',
                executable='component_container',
                name='lidars',
                namespace='',
                composable_node_descriptions=[lidar(place) for place in LIDARS],
            ),
            LifecycleNode(package='delivery_cargo', executable='compartment', name='compartment', namespace=''),
            Node(
                package='delivery_base',
                executable='teleop_mux',
                namespace='teleop',
                parameters=[{'hold': 1.0}],
            ),
            LifecycleNode(
                package='delivery_perception',
                executable='camera',
                name='eye',
                namespace='',
                parameters=[{'frame': [ROBOT, '/camera_link']}],
                condition=IfCondition(LaunchConfiguration('camera')),
            ),
            Node(
                package='delivery_perception',
                executable='dock_detector',
                parameters=[{'camera': 'eye'}],
                condition=IfCondition(LaunchConfiguration('camera')),
            ),
            Node(
                package='tf2_ros',
                executable='static_transform_publisher',
                name='camera_mount',
                arguments=['--frame-id', 'base_link', '--child-frame-id', [ROBOT, '/camera_link']],
                condition=IfCondition(LaunchConfiguration('camera')),
            ),
        ]),
    ])
