# SPDX-License-Identifier: Apache-2.0
"""launch.actions.unregister_event_handler."""

from launch.actions import UnregisterEventHandler as UnregisterEventHandler
from launch.action import Action as Action
from launch.event_handler import BaseEventHandler as BaseEventHandler
from launch.launch_context import LaunchContext as LaunchContext
