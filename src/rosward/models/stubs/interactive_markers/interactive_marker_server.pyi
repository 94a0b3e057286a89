# SPDX-License-Identifier: Apache-2.0
"""interactive_markers.interactive_marker_server (2024-03)."""

from _rosward import creator, message, reads_only, schedule, unknown
from rclpy.qos import QoSProfile
from std_msgs.msg import Header
from visualization_msgs.msg import InteractiveMarkerFeedback, InteractiveMarkerUpdate
from visualization_msgs.srv import GetInteractiveMarkers


@reads_only
@creator
class InteractiveMarkerServer:
    DEFAULT_FEEDBACK_CALLBACK = 255

    def __init__(
        self,
        node,
        namespace,
        *,
        update_pub_qos=QoSProfile(depth=100),
        feedback_sub_qos=QoSProfile(depth=1),
    ):
        self.node = node
        self.namespace = namespace
        self.seq_num = 0
        self.get_interactive_markers_srv = node.create_service(
            GetInteractiveMarkers, namespace + "/get_interactive_markers", self.getInteractiveMarkersCallback
        )
        self.update_pub = node.create_publisher(InteractiveMarkerUpdate, namespace + "/update", update_pub_qos)
        self.feedback_sub = node.create_subscription(
            InteractiveMarkerFeedback, namespace + "/feedback", self.processFeedback, feedback_sub_qos
        )

    def shutdown(self) -> None: ...

    def insert(self, marker, *, feedback_callback=None, feedback_type=DEFAULT_FEEDBACK_CALLBACK):
        if feedback_callback is not None:
            self.setCallback(marker.name, feedback_callback, feedback_type)

    def setPose(self, name, pose, header=Header()) -> bool: ...

    def erase(self, name) -> bool: ...

    def clear(self) -> None: ...

    def setCallback(self, name, feedback_callback, feedback_type=DEFAULT_FEEDBACK_CALLBACK):
        if feedback_callback is not None:
            schedule(feedback_callback, message(InteractiveMarkerFeedback), event="message")
        return unknown("live", "markers", "bool")

    def applyChanges(self) -> None: ...

    def get(self, name):
        return unknown("live", "markers")

    def processFeedback(self, feedback) -> None: ...

    def getInteractiveMarkersCallback(self, request, response):
        return response

    def publish(self, update) -> None: ...

    def doSetPose(self, update, name, pose, header) -> None: ...
