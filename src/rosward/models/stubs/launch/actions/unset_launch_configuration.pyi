# SPDX-License-Identifier: Apache-2.0
"""launch.actions.unset_launch_configuration."""

from launch.actions import UnsetLaunchConfiguration as UnsetLaunchConfiguration
from launch.action import Action as Action
from launch.launch_context import LaunchContext as LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
from launch.substitution import Substitution as Substitution
