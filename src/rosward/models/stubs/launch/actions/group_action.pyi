# SPDX-License-Identifier: Apache-2.0
"""launch.actions.group_action."""

from launch.actions import GroupAction as GroupAction
from launch.action import Action as Action
from launch.actions.pop_environment import PopEnvironment as PopEnvironment
from launch.actions.pop_launch_configurations import PopLaunchConfigurations as PopLaunchConfigurations
from launch.actions.push_environment import PushEnvironment as PushEnvironment
from launch.actions.push_launch_configurations import PushLaunchConfigurations as PushLaunchConfigurations
from launch.actions.reset_environment import ResetEnvironment as ResetEnvironment
from launch.actions.reset_launch_configurations import ResetLaunchConfigurations as ResetLaunchConfigurations
from launch.actions.set_launch_configuration import SetLaunchConfiguration as SetLaunchConfiguration
from launch.launch_context import LaunchContext as LaunchContext
from launch.launch_description_entity import LaunchDescriptionEntity as LaunchDescriptionEntity
from launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
