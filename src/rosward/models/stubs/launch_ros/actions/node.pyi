# SPDX-License-Identifier: Apache-2.0
"""launch_ros.actions.node."""

from launch_ros.actions import Node as Node
