# SPDX-License-Identifier: Apache-2.0
"""launch.actions.push_environment."""

from launch.actions import PushEnvironment as PushEnvironment
from launch.action import Action as Action
from launch.launch_context import LaunchContext as LaunchContext
