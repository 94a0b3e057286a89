# SPDX-License-Identifier: Apache-2.0
"""launch_ros.actions.composable_node_container."""

from launch_ros.actions import ComposableNodeContainer as ComposableNodeContainer
from launch.action import Action as Action
from launch.launch_context import LaunchContext as LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
from launch_ros.actions.node import Node as Node
from launch_ros.descriptions import ComposableNode as ComposableNode
