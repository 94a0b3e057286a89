# SPDX-License-Identifier: Apache-2.0
"""launch_ros.actions.set_parameters_from_file."""

from launch_ros.actions import SetParametersFromFile as SetParametersFromFile
from launch import Action as Action
from launch.launch_context import LaunchContext as LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
