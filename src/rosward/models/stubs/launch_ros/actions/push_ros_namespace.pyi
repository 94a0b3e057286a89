# SPDX-License-Identifier: Apache-2.0
"""launch_ros.actions.push_ros_namespace."""

from launch_ros.actions import PushROSNamespace as PushROSNamespace
from launch_ros.actions import PushRosNamespace as PushRosNamespace
from launch import Action as Action, Substitution as Substitution
from launch.launch_context import LaunchContext as LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
from launch.substitutions import SubstitutionFailure as SubstitutionFailure
