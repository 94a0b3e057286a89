# SPDX-License-Identifier: Apache-2.0
"""launch_ros.actions.set_parameter."""

from launch_ros.actions import SetParameter as SetParameter
from launch import Action as Action
from launch.launch_context import LaunchContext as LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
from launch_ros.parameters_type import ParameterValue as ParameterValue, SomeParameterValue as SomeParameterValue
