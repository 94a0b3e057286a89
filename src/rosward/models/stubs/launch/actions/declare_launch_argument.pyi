# SPDX-License-Identifier: Apache-2.0
"""launch.actions.declare_launch_argument."""

from launch.actions import DeclareLaunchArgument as DeclareLaunchArgument
