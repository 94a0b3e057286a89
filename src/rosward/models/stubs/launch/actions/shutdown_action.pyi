# SPDX-License-Identifier: Apache-2.0
"""launch.actions.shutdown_action."""

from launch.actions import Shutdown as Shutdown
from launch.actions.emit_event import EmitEvent as EmitEvent
from launch.events import Shutdown as ShutdownEvent
from launch.events.process import ProcessExited as ProcessExited
from launch.launch_context import LaunchContext as LaunchContext
