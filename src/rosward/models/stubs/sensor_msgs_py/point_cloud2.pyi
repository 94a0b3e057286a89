# SPDX-License-Identifier: Apache-2.0
"""sensor_msgs_py.point_cloud2: computes.

Read from ros2/common_interfaces, branch rolling (2024-11).
"""

from _rosward import reads_only

from sensor_msgs.msg import PointCloud2

reads_only(__name__)

DUMMY_FIELD_PREFIX = "unnamed_field"


def read_points(cloud, field_names=None, skip_nans=False, uvs=None, reshape_organized_cloud=False): ...
def read_points_numpy(cloud, field_names=None, skip_nans=False, uvs=None, reshape_organized_cloud=False): ...
def read_points_list(cloud, field_names=None, skip_nans=False, uvs=None) -> list: ...
def dtype_from_fields(fields, point_step=None): ...
def create_cloud(header, fields, points, point_step=None) -> PointCloud2: ...
def create_cloud_xyz32(header, points) -> PointCloud2: ...
