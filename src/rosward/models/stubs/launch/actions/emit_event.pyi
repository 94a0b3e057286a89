# SPDX-License-Identifier: Apache-2.0
"""launch.actions.emit_event."""

from launch.actions import EmitEvent as EmitEvent
from launch.action import Action as Action
from launch.event import Event as Event
from launch.launch_context import LaunchContext as LaunchContext
