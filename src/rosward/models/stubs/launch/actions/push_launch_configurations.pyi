# SPDX-License-Identifier: Apache-2.0
"""launch.actions.push_launch_configurations."""

from launch.actions import PushLaunchConfigurations as PushLaunchConfigurations
