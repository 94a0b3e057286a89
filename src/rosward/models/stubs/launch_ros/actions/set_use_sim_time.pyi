# SPDX-License-Identifier: Apache-2.0
"""launch_ros.actions.set_use_sim_time."""

from launch_ros.actions import SetUseSimTime as SetUseSimTime
from launch import Action as Action
from launch.launch_context import LaunchContext as LaunchContext
