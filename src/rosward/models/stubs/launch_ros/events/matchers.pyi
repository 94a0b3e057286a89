# SPDX-License-Identifier: Apache-2.0
"""launch_ros.events.matchers."""

from launch_ros.events import matches_node_name as matches_node_name
