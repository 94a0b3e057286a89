# SPDX-License-Identifier: Apache-2.0
"""launch.actions.opaque_coroutine."""

from launch.actions import OpaqueCoroutine as OpaqueCoroutine
from launch.action import Action as Action
from launch.event import Event as Event
from launch.event_handlers import OnShutdown as OnShutdown
from launch.launch_context import LaunchContext as LaunchContext
from launch.launch_description_entity import LaunchDescriptionEntity as LaunchDescriptionEntity
from launch.some_entities_type import SomeEntitiesType as SomeEntitiesType
