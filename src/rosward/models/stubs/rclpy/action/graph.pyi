# SPDX-License-Identifier: Apache-2.0
"""rclpy.action.graph: the running system, which nobody knows before it runs.

Read from rclpy 9.1.2 (kilted) and the branches humble (3.3.15), iron (4.1.7), jazzy (7.1.3) and rolling (8.0.0, December 2024).
"""

from _rosward import unknown


def get_action_client_names_and_types_by_node(node, remote_node_name, remote_node_namespace):
    return unknown("live", "action clients of a node")


def get_action_server_names_and_types_by_node(node, remote_node_name, remote_node_namespace):
    return unknown("live", "action servers of a node")


def get_action_names_and_types(node):
    return unknown("live", "actions of the system")
