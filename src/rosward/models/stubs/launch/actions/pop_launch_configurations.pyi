# SPDX-License-Identifier: Apache-2.0
"""launch.actions.pop_launch_configurations."""

from launch.actions import PopLaunchConfigurations as PopLaunchConfigurations
from launch.action import Action as Action
from launch.launch_context import LaunchContext as LaunchContext
