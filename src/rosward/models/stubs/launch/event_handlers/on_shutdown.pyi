# SPDX-License-Identifier: Apache-2.0
"""launch.event_handlers.on_shutdown."""

from launch.event_handlers import OnShutdown as OnShutdown
from launch.event import Event as Event
from launch.event_handler import BaseEventHandler as BaseEventHandler
from launch.events import Shutdown as Shutdown
from launch.some_entities_type import SomeEntitiesType as SomeEntitiesType
