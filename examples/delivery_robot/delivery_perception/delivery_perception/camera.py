# SPDX-License-Identifier: Apache-2.0
"""The front camera, a lifecycle node: it has no topics before it is configured."""

from delivery_common.names import ROBOT
from delivery_common.qos import SENSOR
from delivery_common.run import run
from rclpy.lifecycle import LifecycleNode, TransitionCallbackReturn
from sensor_msgs.msg import CameraInfo, Image


class Camera(LifecycleNode):
    """Publishes grey pictures while it is active."""

    def __init__(self):
        super().__init__('camera', namespace=ROBOT)
        self.declare_parameter('frame', 'camera_link')
        self._image = None
        self._info = None
        self._timer = None

    def on_configure(self, state):
        """Open the camera."""
        self._image = self.create_lifecycle_publisher(Image, '~/image_raw', SENSOR)
        self._info = self.create_lifecycle_publisher(CameraInfo, '~/camera_info', SENSOR)
        return TransitionCallbackReturn.SUCCESS

    def on_activate(self, state):
        """Start to send pictures."""
        self._timer = self.create_timer(0.1, self._grab)
        return super().on_activate(state)

    def on_deactivate(self, state):
        """Stop to send pictures."""
        self.destroy_timer(self._timer)
        return super().on_deactivate(state)

    def on_cleanup(self, state):
        """Close the camera."""
        self.destroy_lifecycle_publisher(self._image)
        self.destroy_lifecycle_publisher(self._info)
        return TransitionCallbackReturn.SUCCESS

    def _grab(self):
        image = Image(height=48, width=64, encoding='mono8', step=64, data=bytes([128]) * (48 * 64))
        image.header.stamp = self.get_clock().now().to_msg()
        image.header.frame_id = self.get_parameter('frame').value
        self._image.publish(image)
        self._info.publish(CameraInfo(header=image.header, height=48, width=64))


def main(args=None):
    """Run the node."""
    run(Camera, args=args)


if __name__ == '__main__':
    main()
