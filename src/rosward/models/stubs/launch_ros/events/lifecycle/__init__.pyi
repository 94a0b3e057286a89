# SPDX-License-Identifier: Apache-2.0
"""launch_ros.events.lifecycle.

Read from launch_ros 0.28.0, with what humble had before it.
"""

from _rosward import reads_only

from launch.event import Event

reads_only(__name__)


class ChangeState(Event):
    def __init__(self, *, lifecycle_node_matcher, transition_id): ...


class StateTransition(Event):
    def __init__(self, *, action, msg): ...


def matches_node_name(node_name): ...
