# SPDX-License-Identifier: Apache-2.0
"""launch.actions.reset_environment."""

from launch.actions import ResetEnvironment as ResetEnvironment
from launch.action import Action as Action
from launch.launch_context import LaunchContext as LaunchContext
