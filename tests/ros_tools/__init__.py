# SPDX-License-Identifier: Apache-2.0
"""rosward among the tools of ROS 2: `ros2 security`, colcon, completion."""
