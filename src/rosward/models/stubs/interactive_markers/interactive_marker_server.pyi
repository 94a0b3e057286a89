# SPDX-License-Identifier: Apache-2.0
"""interactive_markers.interactive_marker_server (2024-03)."""

from _rosward import changes, creator, pure, reads_only, schedule, unknown
from rclpy.qos import QoSProfile
from std_msgs.msg import Header
from visualization_msgs.msg import InteractiveMarkerFeedback, InteractiveMarkerUpdate
from visualization_msgs.srv import GetInteractiveMarkers


@pure
def _update(markers) -> InteractiveMarkerUpdate: ...
@pure
def _found(markers, name): ...
@changes("response")
def _fill(response, markers) -> None: ...


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
        self._markers = []
        self.get_interactive_markers_srv = node.create_service(
            GetInteractiveMarkers, namespace + "/get_interactive_markers", self.getInteractiveMarkersCallback
        )
        self.update_pub = node.create_publisher(InteractiveMarkerUpdate, namespace + "/update", update_pub_qos)
        self.feedback_sub = node.create_subscription(
            InteractiveMarkerFeedback, namespace + "/feedback", self.processFeedback, feedback_sub_qos
        )

    def shutdown(self) -> None: ...

    def insert(self, marker, *, feedback_callback=None, feedback_type=DEFAULT_FEEDBACK_CALLBACK):
        self._markers.append(marker)
        if feedback_callback is not None:
            self.setCallback(marker.name, feedback_callback, feedback_type)

    def setPose(self, name, pose, header=Header()):
        self._markers.append((name, pose, header))
        return unknown("live", "markers", "bool")

    def erase(self, name):
        self._markers.append(name)
        return unknown("live", "markers", "bool")

    def clear(self) -> None: ...

    def setCallback(self, name, feedback_callback, feedback_type=DEFAULT_FEEDBACK_CALLBACK):
        if feedback_callback is not None:
            schedule(feedback_callback, self.feedback_sub._taken(), event="message")
        return unknown("live", "markers", "bool")

    def applyChanges(self):
        self.publish(_update(self._markers))

    def get(self, name):
        return _found(self._markers, name)

    def processFeedback(self, feedback):
        self._markers.append(feedback)

    def getInteractiveMarkersCallback(self, request, response):
        _fill(response, self._markers)
        return response

    def publish(self, update):
        self.update_pub.publish(update)

    def doSetPose(self, update, name, pose, header) -> None: ...
