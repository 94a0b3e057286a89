# SPDX-License-Identifier: Apache-2.0
"""launch_ros.actions.push_ros_namespace."""

from launch_ros.actions import PushROSNamespace as PushROSNamespace
from launch_ros.actions import PushRosNamespace as PushRosNamespace
