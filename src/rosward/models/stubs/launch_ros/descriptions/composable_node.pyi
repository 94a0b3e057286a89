# SPDX-License-Identifier: Apache-2.0
"""launch_ros.descriptions.composable_node."""

from launch_ros.descriptions import ComposableNode as ComposableNode
from launch.condition import Condition as Condition
from launch.conditions import IfCondition as IfCondition, UnlessCondition as UnlessCondition
from launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
from launch.substitution import Substitution as Substitution
from launch_ros.parameters_type import Parameters as Parameters, SomeParameters as SomeParameters
from launch_ros.remap_rule_type import RemapRules as RemapRules, SomeRemapRules as SomeRemapRules
