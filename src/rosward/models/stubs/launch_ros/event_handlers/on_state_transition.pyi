# SPDX-License-Identifier: Apache-2.0
"""launch_ros.event_handlers.on_state_transition."""

from launch_ros.event_handlers import OnStateTransition as OnStateTransition
from launch.event import Event as Event
from launch.event_handler import EventHandler as EventHandler
from launch.some_entities_type import SomeEntitiesType as SomeEntitiesType
from launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
from launch_ros.actions import LifecycleNode as LifecycleNode
from launch_ros.events.lifecycle import StateTransition as StateTransition
