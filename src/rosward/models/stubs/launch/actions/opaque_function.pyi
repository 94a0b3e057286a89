# SPDX-License-Identifier: Apache-2.0
"""launch.actions.opaque_function."""

from launch.actions import OpaqueFunction as OpaqueFunction
from launch.action import Action as Action
from launch.launch_context import LaunchContext as LaunchContext
from launch.launch_description_entity import LaunchDescriptionEntity as LaunchDescriptionEntity
