# SPDX-License-Identifier: Apache-2.0
"""launch_ros.actions.ros_timer."""

from launch_ros.actions import ROSTimer as ROSTimer
from launch_ros.actions import RosTimer as RosTimer
