# SPDX-License-Identifier: Apache-2.0
"""launch_ros.event_handlers.

Read from launch_ros 0.28.0, with what humble had before it.
"""

from _rosward.launch import REQUIRED, keep
from launch.event_handler import BaseEventHandler


class OnStateTransition(BaseEventHandler):
    def __init__(self, *, entities=REQUIRED, target_lifecycle_node=None, transition=None, start_state=None, goal_state=None,
                 matcher=None, **kwargs):
        keep(self, None, actions=entities, target=target_lifecycle_node)
        super().__init__(**kwargs)
