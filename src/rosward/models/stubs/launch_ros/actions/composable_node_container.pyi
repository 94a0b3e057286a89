# SPDX-License-Identifier: Apache-2.0
"""launch_ros.actions.composable_node_container."""

from launch_ros.actions import ComposableNodeContainer as ComposableNodeContainer
