# SPDX-License-Identifier: Apache-2.0
"""launch.event_handlers.on_process_io."""

from launch.event_handlers import OnProcessIO as OnProcessIO
from launch.event import Event as Event
from launch.event_handlers.on_action_event_base import OnActionEventBase as OnActionEventBase
from launch.events.process import ProcessIO as ProcessIO
from launch.launch_context import LaunchContext as LaunchContext
from launch.some_entities_type import SomeEntitiesType as SomeEntitiesType
