# SPDX-License-Identifier: Apache-2.0
"""launch.actions.pop_environment."""

from launch.actions import PopEnvironment as PopEnvironment
from launch.action import Action as Action
from launch.launch_context import LaunchContext as LaunchContext
