# SPDX-License-Identifier: Apache-2.0
"""tf2_ros: transforms over /tf and /tf_static. The package in Python has no BufferServer (only C++ has).

Read from ros2/geometry2, branches humble (2024-08), iron (2024-08), jazzy (2024-10) and rolling (2024-10).
"""

from tf2_py import *

from tf2_ros.buffer import *
from tf2_ros.buffer_client import *
from tf2_ros.buffer_interface import *
from tf2_ros.static_transform_broadcaster import *
from tf2_ros.transform_broadcaster import *
from tf2_ros.transform_listener import *
