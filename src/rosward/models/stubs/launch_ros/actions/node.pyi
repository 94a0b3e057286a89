# SPDX-License-Identifier: Apache-2.0
"""launch_ros.actions.node."""

from launch_ros.actions import Node as Node
from launch.action import Action as Action
from launch.actions import ExecuteProcess as ExecuteProcess
from launch.launch_context import LaunchContext as LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
from launch.substitutions import LocalSubstitution as LocalSubstitution
from launch_ros.descriptions import Parameter as Parameter, ParameterFile as ParameterFile
from launch_ros.parameters_type import SomeParameters as SomeParameters
from launch_ros.remap_rule_type import SomeRemapRules as SomeRemapRules
from launch_ros.substitutions import ExecutableInPackage as ExecutableInPackage
