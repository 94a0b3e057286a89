# SPDX-License-Identifier: Apache-2.0
"""launch_ros.actions.set_ros_log_dir."""

from launch_ros.actions import SetROSLogDir as SetROSLogDir
