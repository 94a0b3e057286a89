# SPDX-License-Identifier: Apache-2.0
"""What the marks of rosward's own stubs say, written down, so that not each run has to read them all (`tests/models/test_facts.py` does)."""

from __future__ import annotations

from typing import Final

from rosward.models.facts import LibraryFacts

OWN: Final = LibraryFacts(
    node_classes=frozenset({"rclpy.node.Node"}),
    node_methods=frozenset(
        {"create_client", "create_publisher", "create_service", "create_subscription", "create_timer"}
    ),
    creating=frozenset(
        {"create_client", "create_lifecycle_publisher", "create_publisher", "create_service", "create_subscription"}
    ),
    creators=frozenset(
        {
            ("ActionClient", "rclpy"),
            ("ActionServer", "rclpy"),
            ("BasicNavigator", "nav2_simple_commander"),
            ("BufferClient", "tf2_ros"),
            ("InteractiveMarkerServer", "interactive_markers"),
            ("StaticTransformBroadcaster", "tf2_ros"),
            ("Subscriber", "message_filters"),
            ("TransformBroadcaster", "tf2_ros"),
            ("TransformListener", "tf2_ros"),
            ("Updater", "diagnostic_updater"),
            ("call_change_states", "ros2lifecycle"),
            ("call_describe_parameters", "ros2param"),
            ("call_get_available_transitions", "ros2lifecycle"),
            ("call_get_parameters", "ros2param"),
            ("call_get_states", "ros2lifecycle"),
            ("call_get_transition_graph", "ros2lifecycle"),
            ("call_list_parameters", "ros2param"),
            ("call_set_parameters", "ros2param"),
            ("load_parameter_dict", "ros2param"),
            ("load_parameter_file", "ros2param"),
            ("wait_for_message", "rclpy"),
        }
    ),
    precise=("create_", "declare_parameter"),
    exact=("launch", "rclpy."),
    raising_nothing=frozenset(
        {
            "contextlib",
            "logging",
            "rclpy.clock",
            "rclpy.clock_type",
            "rclpy.duration",
            "rclpy.impl.implementation_singleton",
            "rclpy.impl.logging_severity",
            "rclpy.impl.rcutils_logger",
            "rclpy.logging",
            "rclpy.logging_service",
            "rclpy.time",
            "rclpy.time_source",
            "rclpy.timer",
        }
    ),
    asking=frozenset({"rclpy"}),
    before_sources=frozenset({"launch", "launch_ros", "launch_xml", "launch_yaml", "nav2_common", "rclpy"}),
    plugin_classes=(("qt_gui.plugin.Plugin", "rqt_gui.main._open"),),
)
