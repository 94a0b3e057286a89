# SPDX-License-Identifier: Apache-2.0
"""launch_ros.actions.lifecycle_transition."""

from launch_ros.actions import LifecycleTransition as LifecycleTransition
from launch import LaunchContext as LaunchContext, SomeSubstitutionsType as SomeSubstitutionsType
from launch.action import Action as Action
from launch.actions import EmitEvent as EmitEvent, RegisterEventHandler as RegisterEventHandler
from launch_ros.event_handlers import OnStateTransition as OnStateTransition
from launch_ros.events.lifecycle import ChangeState as ChangeState, StateTransition as StateTransition
