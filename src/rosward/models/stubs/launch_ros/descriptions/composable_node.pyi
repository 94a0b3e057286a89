# SPDX-License-Identifier: Apache-2.0
"""launch_ros.descriptions.composable_node."""

from launch_ros.descriptions import ComposableNode as ComposableNode
