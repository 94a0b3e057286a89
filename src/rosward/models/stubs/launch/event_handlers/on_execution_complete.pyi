# SPDX-License-Identifier: Apache-2.0
"""launch.event_handlers.on_execution_complete."""

from launch.event_handlers import OnExecutionComplete as OnExecutionComplete
from launch.event import Event as Event
from launch.event_handlers.on_action_event_base import OnActionEventBase as OnActionEventBase
from launch.events import ExecutionComplete as ExecutionComplete
from launch.launch_context import LaunchContext as LaunchContext
from launch.some_entities_type import SomeEntitiesType as SomeEntitiesType
