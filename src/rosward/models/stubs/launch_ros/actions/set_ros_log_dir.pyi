# SPDX-License-Identifier: Apache-2.0
"""launch_ros.actions.set_ros_log_dir."""

from launch_ros.actions import SetROSLogDir as SetROSLogDir
from launch import Action as Action, Substitution as Substitution
from launch.launch_context import LaunchContext as LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
