# SPDX-License-Identifier: Apache-2.0
"""launch.actions.push_launch_configurations."""

from launch.actions import PushLaunchConfigurations as PushLaunchConfigurations
from launch.action import Action as Action
from launch.launch_context import LaunchContext as LaunchContext
