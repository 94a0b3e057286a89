# SPDX-License-Identifier: Apache-2.0
"""Where the robot is: the transform from the map to the odometry frame."""

from delivery_common.names import SIDES
from delivery_common.nodes import HeartbeatNode
from delivery_common.qos import SENSOR, STATE
from delivery_common.run import run
from geometry_msgs.msg import PoseStamped, PoseWithCovarianceStamped, TransformStamped
from nav_msgs.msg import OccupancyGrid
from rclpy.time import Time
from sensor_msgs.msg import LaserScan
from tf2_ros import (
    Buffer,
    StaticTransformBroadcaster,
    TransformBroadcaster,
    TransformException,
    TransformListener,
)


class Localisation(HeartbeatNode):
    """Keeps the pose of the robot on the map."""

    def __init__(self):
        super().__init__('localisation')
        self._map = None
        self._correction = TransformStamped(child_frame_id='odom')
        self._correction.header.frame_id = 'map'
        self._buffer = Buffer()
        self._listener = TransformListener(self._buffer, self)
        self._transforms = TransformBroadcaster(self)
        self._mounts = StaticTransformBroadcaster(self)
        self._mounts.sendTransform([self._mount(side) for side in SIDES])
        self._pose = self.create_publisher(PoseStamped, 'pose', STATE)
        self.create_subscription(OccupancyGrid, '/map', self._on_map, STATE)
        self.create_subscription(LaserScan, 'scan', self._on_scan, SENSOR)
        self.create_subscription(PoseWithCovarianceStamped, 'initial_pose', self._on_initial_pose, 1)

    def _mount(self, side):
        mount = TransformStamped(child_frame_id=f'lidar_{side}')
        mount.header.frame_id = 'base_link'
        mount.transform.translation.x = 0.3 if side == 'front' else -0.3
        return mount

    def _on_map(self, grid):
        self._map = grid

    def _on_initial_pose(self, start):
        self._correction.transform.translation.x = start.pose.pose.position.x
        self._correction.transform.translation.y = start.pose.pose.position.y
        self._correction.transform.rotation = start.pose.pose.orientation

    def _on_scan(self, scan):
        self._correction.header.stamp = scan.header.stamp
        self._transforms.sendTransform(self._correction)
        try:
            found = self._buffer.lookup_transform('map', 'base_link', Time())
        except TransformException:
            self.get_logger().warning('not localised', throttle_duration_sec=5.0)
            return
        pose = PoseStamped(header=found.header)
        pose.pose.position.x = found.transform.translation.x
        pose.pose.position.y = found.transform.translation.y
        pose.pose.orientation = found.transform.rotation
        self._pose.publish(pose)


def main(args=None):
    """Run the node."""
    run(Localisation, args=args)


if __name__ == '__main__':
    main()
