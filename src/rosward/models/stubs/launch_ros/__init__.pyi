# SPDX-License-Identifier: Apache-2.0
"""launch_ros: nodes and what belongs to them.

Read from launch_ros 0.28.0, with what humble had before it.
"""

from _rosward import before_sources

from launch_ros import actions as actions
from launch_ros import descriptions as descriptions
from launch_ros import event_handlers as event_handlers
from launch_ros import events as events
from launch_ros import parameter_descriptions as parameter_descriptions
from launch_ros import remap_rule_type as remap_rule_type
from launch_ros import substitutions as substitutions
from launch_ros import utilities as utilities

before_sources(__name__)
