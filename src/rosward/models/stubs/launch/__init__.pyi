# SPDX-License-Identifier: Apache-2.0
"""launch: descriptions of what is started.

Read from launch 3.7.0, with what humble had before it.
"""

from _rosward import before_sources, exact_calls

from launch import actions as actions
from launch import conditions as conditions
from launch import descriptions as descriptions
from launch import event_handlers as event_handlers
from launch import events as events
from launch import launch_description_sources as launch_description_sources
from launch import logging as logging
from launch import substitutions as substitutions
from launch.action import Action as Action
from launch.condition import Condition as Condition
from launch.event import Event as Event
from launch.event_handler import BaseEventHandler as BaseEventHandler
from launch.event_handler import EventHandler as EventHandler
from launch.launch_context import LaunchContext as LaunchContext
from launch.launch_description import LaunchDescription as LaunchDescription
from launch.launch_description_entity import LaunchDescriptionEntity as LaunchDescriptionEntity
from launch.launch_description_source import LaunchDescriptionSource as LaunchDescriptionSource
from launch.launch_introspector import LaunchIntrospector as LaunchIntrospector
from launch.launch_service import LaunchService as LaunchService
from launch.some_actions_type import SomeActionsType as SomeActionsType
from launch.some_entities_type import SomeEntitiesType as SomeEntitiesType
from launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
from launch.substitution import Substitution as Substitution

before_sources(__name__)
exact_calls("launch")


class InvalidLaunchFileError(Exception): ...
