# SPDX-License-Identifier: Apache-2.0
"""launch_ros.actions.load_composable_nodes."""

from launch_ros.actions import LoadComposableNodes as LoadComposableNodes
from launch.action import Action as Action
from launch.launch_context import LaunchContext as LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType, SomeSubstitutionsType_types_tuple as SomeSubstitutionsType_types_tuple
from launch_ros.actions.composable_node_container import ComposableNodeContainer as ComposableNodeContainer
from launch_ros.descriptions import ComposableNode as ComposableNode
from launch_ros.parameter_descriptions import ParameterFile as ParameterFile
