# SPDX-License-Identifier: Apache-2.0
"""launch.event_handlers.

Read from launch 3.7.0, with what humble had before it.
"""

from _rosward import reads_only

from _rosward.launch import REQUIRED, keep
from launch.event_handler import BaseEventHandler


class OnActionEventBase(BaseEventHandler):
    def __init__(self, *, action_matcher=None, on_event=REQUIRED, target_event_cls=None, target_action_cls=None, **kwargs):
        keep(self, None, actions=on_event, target=action_matcher)
        super().__init__(**kwargs)


class OnExecutionComplete(BaseEventHandler):
    def __init__(self, *, target_action=None, on_completion=REQUIRED, **kwargs):
        keep(self, None, actions=on_completion, target=target_action)
        super().__init__(**kwargs)


class OnProcessExit(BaseEventHandler):
    def __init__(self, *, target_action=None, on_exit=REQUIRED, **kwargs):
        keep(self, None, actions=on_exit, target=target_action)
        super().__init__(**kwargs)


class OnProcessStart(BaseEventHandler):
    def __init__(self, *, target_action=None, on_start=REQUIRED, **kwargs):
        keep(self, None, actions=on_start, target=target_action)
        super().__init__(**kwargs)


class OnProcessIO(BaseEventHandler):
    def __init__(self, *, target_action=None, on_stdin=None, on_stdout=None, on_stderr=None, **kwargs):
        keep(self, None, actions=[f for f in (on_stdin, on_stdout, on_stderr) if f is not None], target=target_action)
        super().__init__(**kwargs)


class OnShutdown(BaseEventHandler):
    def __init__(self, *, on_shutdown=REQUIRED, **kwargs):
        keep(self, None, actions=on_shutdown)
        super().__init__(**kwargs)


class OnIncludeLaunchDescription(BaseEventHandler):
    """launch's own: it visits what is included."""


@reads_only
def event_named(name): ...
