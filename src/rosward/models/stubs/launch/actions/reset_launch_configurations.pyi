# SPDX-License-Identifier: Apache-2.0
"""launch.actions.reset_launch_configurations."""

from launch.actions import ResetLaunchConfigurations as ResetLaunchConfigurations
