# SPDX-License-Identifier: Apache-2.0
"""launch.events: no event starts anything by itself.

Read from launch 3.7.0, with what humble had before it.
"""

from _rosward import reads_only

from launch.event import Event
from launch.events import process as process


class ExecutionComplete(Event):
    def __init__(self, *, action): self.action = action


class IncludeLaunchDescription(Event):
    def __init__(self, launch_description): self.launch_description = launch_description


@reads_only
class Shutdown(Event):
    def __init__(self, *, reason="reason not given", due_to_sigint=False): ...


@reads_only
class TimerEvent(Event):
    def __init__(self, *, timer_action): ...


def matches_action(target_action): return lambda action: action is target_action
