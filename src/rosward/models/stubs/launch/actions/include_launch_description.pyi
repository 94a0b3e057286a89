# SPDX-License-Identifier: Apache-2.0
"""launch.actions.include_launch_description."""

from launch.actions import IncludeLaunchDescription as IncludeLaunchDescription
from launch.action import Action as Action
from launch.actions.set_launch_configuration import SetLaunchConfiguration as SetLaunchConfiguration
from launch.launch_context import LaunchContext as LaunchContext
from launch.launch_description_entity import LaunchDescriptionEntity as LaunchDescriptionEntity
from launch.launch_description_source import LaunchDescriptionSource as LaunchDescriptionSource
from launch.launch_description_sources import AnyLaunchDescriptionSource as AnyLaunchDescriptionSource
from launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
