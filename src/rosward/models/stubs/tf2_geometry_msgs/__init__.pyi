# SPDX-License-Identifier: Apache-2.0
"""tf2_geometry_msgs: importing it registers conversions; its functions compute.

Read from ros2/geometry2, branches humble (2024-08), iron (2024-08), jazzy (2024-10) and rolling (2024-10).
"""
from _rosward import pure

from tf2_geometry_msgs.tf2_geometry_msgs import *

pure(__name__)
