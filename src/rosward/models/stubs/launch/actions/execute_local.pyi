# SPDX-License-Identifier: Apache-2.0
"""launch.actions.execute_local."""

from launch.actions import ExecuteLocal as ExecuteLocal
from launch.action import Action as Action
from launch.actions.emit_event import EmitEvent as EmitEvent
from launch.actions.opaque_function import OpaqueFunction as OpaqueFunction
from launch.actions.timer_action import TimerAction as TimerAction
from launch.descriptions import Executable as Executable
from launch.event import Event as Event
from launch.event_handler import EventHandler as EventHandler
from launch.event_handlers import OnProcessExit as OnProcessExit, OnProcessIO as OnProcessIO, OnProcessStart as OnProcessStart, OnShutdown as OnShutdown
from launch.events import Shutdown as Shutdown
from launch.events.process import ProcessExited as ProcessExited, ProcessIO as ProcessIO, ProcessStarted as ProcessStarted, ProcessStderr as ProcessStderr, ProcessStdin as ProcessStdin, ProcessStdout as ProcessStdout, ShutdownProcess as ShutdownProcess, SignalProcess as SignalProcess
from launch.launch_context import LaunchContext as LaunchContext
from launch.launch_description import LaunchDescription as LaunchDescription
from launch.launch_description_entity import LaunchDescriptionEntity as LaunchDescriptionEntity
from launch.some_entities_type import SomeEntitiesType as SomeEntitiesType
from launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
from launch.substitution import Substitution as Substitution
from launch.substitutions import LaunchConfiguration as LaunchConfiguration, PythonExpression as PythonExpression
