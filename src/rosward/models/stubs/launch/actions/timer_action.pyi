# SPDX-License-Identifier: Apache-2.0
"""launch.actions.timer_action."""

from launch.actions import TimerAction as TimerAction
from launch.action import Action as Action
from launch.actions.opaque_function import OpaqueFunction as OpaqueFunction
from launch.event_handler import EventHandler as EventHandler
from launch.events import Shutdown as Shutdown, TimerEvent as TimerEvent
from launch.launch_context import LaunchContext as LaunchContext
from launch.launch_description_entity import LaunchDescriptionEntity as LaunchDescriptionEntity
from launch.some_entities_type import SomeEntitiesType as SomeEntitiesType
from launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType, SomeSubstitutionsType_types_tuple as SomeSubstitutionsType_types_tuple
