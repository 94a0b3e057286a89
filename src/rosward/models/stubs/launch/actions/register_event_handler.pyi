# SPDX-License-Identifier: Apache-2.0
"""launch.actions.register_event_handler."""

from launch.actions import RegisterEventHandler as RegisterEventHandler
from launch.action import Action as Action
from launch.event_handler import BaseEventHandler as BaseEventHandler
from launch.launch_context import LaunchContext as LaunchContext
from launch.launch_description_entity import LaunchDescriptionEntity as LaunchDescriptionEntity
