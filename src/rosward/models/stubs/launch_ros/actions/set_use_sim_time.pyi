# SPDX-License-Identifier: Apache-2.0
"""launch_ros.actions.set_use_sim_time."""

from launch_ros.actions import SetUseSimTime as SetUseSimTime
