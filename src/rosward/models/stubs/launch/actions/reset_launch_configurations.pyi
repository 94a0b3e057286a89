# SPDX-License-Identifier: Apache-2.0
"""launch.actions.reset_launch_configurations."""

from launch.actions import ResetLaunchConfigurations as ResetLaunchConfigurations
from launch.action import Action as Action
from launch.launch_context import LaunchContext as LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
