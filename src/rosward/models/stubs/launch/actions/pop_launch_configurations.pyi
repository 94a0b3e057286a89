# SPDX-License-Identifier: Apache-2.0
"""launch.actions.pop_launch_configurations."""

from launch.actions import PopLaunchConfigurations as PopLaunchConfigurations
