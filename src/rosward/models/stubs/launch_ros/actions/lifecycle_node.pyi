# SPDX-License-Identifier: Apache-2.0
"""launch_ros.actions.lifecycle_node."""

from launch_ros.actions import LifecycleNode as LifecycleNode
