# SPDX-License-Identifier: Apache-2.0
"""launch.event_handler: what is done when something happens.

Read from launch 3.7.0, with what humble had before it.
"""

from _rosward import reads_only

from _rosward.launch import REQUIRED, keep

reads_only(__name__)


class BaseEventHandler:
    def __init__(self, *, matcher=None, handle_once=False, **kwargs):
        keep(self, kwargs)

    def matches(self, event) -> bool: ...
    def describe(self): ...
    def handle(self, event, context): ...
    @property
    def handle_once(self) -> bool: ...
    @property
    def entities(self): ...


class EventHandler(BaseEventHandler):
    def __init__(self, *, matcher=REQUIRED, entities=None, handle_once=False, **kwargs):
        keep(self, None, matcher=matcher, actions=entities)
        super().__init__(**kwargs)
