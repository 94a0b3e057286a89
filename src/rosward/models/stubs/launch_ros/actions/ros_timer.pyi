# SPDX-License-Identifier: Apache-2.0
"""launch_ros.actions.ros_timer."""

from launch_ros.actions import ROSTimer as ROSTimer
from launch_ros.actions import RosTimer as RosTimer
from launch.actions import TimerAction as TimerAction
from launch.events import TimerEvent as TimerEvent
from launch.launch_context import LaunchContext as LaunchContext
from launch.launch_description_entity import LaunchDescriptionEntity as LaunchDescriptionEntity
from launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType, SomeSubstitutionsType_types_tuple as SomeSubstitutionsType_types_tuple
