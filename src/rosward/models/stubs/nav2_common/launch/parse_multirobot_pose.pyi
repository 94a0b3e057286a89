# SPDX-License-Identifier: Apache-2.0
"""nav2_common.launch.parse_multirobot_pose."""

from nav2_common.launch import ParseMultiRobotPose as ParseMultiRobotPose
