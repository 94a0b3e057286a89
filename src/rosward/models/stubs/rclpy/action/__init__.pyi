# SPDX-License-Identifier: Apache-2.0
"""rclpy.action.

Read from rclpy 9.1.2 (kilted) and the branches humble (3.3.15), iron (4.1.7), jazzy (7.1.3) and rolling (8.0.0, December 2024).
"""

from rclpy.action.client import ActionClient as ActionClient
from rclpy.action.graph import get_action_client_names_and_types_by_node as get_action_client_names_and_types_by_node
from rclpy.action.graph import get_action_names_and_types as get_action_names_and_types
from rclpy.action.graph import get_action_server_names_and_types_by_node as get_action_server_names_and_types_by_node
from rclpy.action.server import ActionServer as ActionServer
from rclpy.action.server import CancelResponse as CancelResponse
from rclpy.action.server import GoalResponse as GoalResponse
