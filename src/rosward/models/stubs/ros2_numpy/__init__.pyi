# SPDX-License-Identifier: Apache-2.0
"""ros2_numpy: converts.

Read from Box-Robotics/ros2_numpy (2020-07).
"""

from ros2_numpy.registry import msgify as msgify, numpify as numpify
