# SPDX-License-Identifier: Apache-2.0
"""webots_ros2_core: the Python nodes of webots_ros2 before 2022.

Read from cyberbotics/webots_ros2, tag 1.2.3.
"""

