# SPDX-License-Identifier: Apache-2.0
"""tf2_geometry_msgs.tf2_geometry_msgs.

Read from ros2/geometry2, branches humble (2024-08), iron (2024-08), jazzy (2024-10) and rolling (2024-10).
"""

from _rosward import reads_only

from geometry_msgs.msg import (
    Point as Point,
    PointStamped as PointStamped,
    PolygonStamped as PolygonStamped,
    Pose as Pose,
    PoseStamped as PoseStamped,
    PoseWithCovarianceStamped as PoseWithCovarianceStamped,
    TransformStamped as TransformStamped,
    Vector3Stamped as Vector3Stamped,
)

reads_only(__name__)


def to_msg_msg(msg):
    return msg


def from_msg_msg(msg):
    return msg


def transform_covariance(cov_in, transform): ...
def do_transform_point(point, transform) -> PointStamped: ...
def do_transform_vector3(vector3, transform) -> Vector3Stamped: ...
def do_transform_pose(pose, transform) -> Pose: ...
def do_transform_pose_stamped(pose, transform) -> PoseStamped: ...
def do_transform_pose_with_covariance_stamped(pose, transform) -> PoseWithCovarianceStamped: ...
def do_transform_polygon_stamped(polygon, transform) -> PolygonStamped: ...
