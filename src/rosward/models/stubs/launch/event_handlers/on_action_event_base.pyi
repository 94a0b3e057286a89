# SPDX-License-Identifier: Apache-2.0
"""launch.event_handlers.on_action_event_base."""

from launch.event_handlers import OnActionEventBase as OnActionEventBase
from launch.event import Event as Event
from launch.event_handler import BaseEventHandler as BaseEventHandler
from launch.launch_context import LaunchContext as LaunchContext
from launch.launch_description_entity import LaunchDescriptionEntity as LaunchDescriptionEntity
from launch.some_entities_type import SomeEntitiesType as SomeEntitiesType
