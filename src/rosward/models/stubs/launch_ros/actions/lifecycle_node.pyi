# SPDX-License-Identifier: Apache-2.0
"""launch_ros.actions.lifecycle_node."""

from launch_ros.actions import LifecycleNode as LifecycleNode
from launch import SomeSubstitutionsType as SomeSubstitutionsType
from launch.action import Action as Action
from launch_ros.actions.node import Node as Node
from launch_ros.events.lifecycle import ChangeState as ChangeState, StateTransition as StateTransition
