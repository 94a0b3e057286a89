# SPDX-License-Identifier: Apache-2.0
"""launch.actions.append_environment_variable."""

from launch.actions import AppendEnvironmentVariable as AppendEnvironmentVariable
from launch.action import Action as Action
from launch.launch_context import LaunchContext as LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
from launch.substitution import Substitution as Substitution
