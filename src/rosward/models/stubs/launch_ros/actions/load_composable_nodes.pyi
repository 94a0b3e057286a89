# SPDX-License-Identifier: Apache-2.0
"""launch_ros.actions.load_composable_nodes."""

from launch_ros.actions import LoadComposableNodes as LoadComposableNodes
