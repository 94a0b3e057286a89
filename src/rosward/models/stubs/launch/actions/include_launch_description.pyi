# SPDX-License-Identifier: Apache-2.0
"""launch.actions.include_launch_description."""

from launch.actions import IncludeLaunchDescription as IncludeLaunchDescription
