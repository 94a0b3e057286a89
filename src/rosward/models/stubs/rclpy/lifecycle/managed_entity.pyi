# SPDX-License-Identifier: Apache-2.0
"""rclpy.lifecycle.managed_entity.

Read from rclpy 9.1.2 (kilted) and the branches humble (3.3.15), iron (4.1.7), jazzy (7.1.3) and rolling (8.0.0, December 2024).
"""

from _rosward import reads_only

from enum import IntEnum
from functools import wraps


class TransitionCallbackReturn(IntEnum):
    SUCCESS = 97
    FAILURE = 98
    ERROR = 99


class ManagedEntity:
    _rosward_hidden = ()

    def on_configure(self, state):
        return TransitionCallbackReturn.SUCCESS

    def on_cleanup(self, state):
        return TransitionCallbackReturn.SUCCESS

    def on_shutdown(self, state):
        return TransitionCallbackReturn.SUCCESS

    def on_activate(self, state):
        return TransitionCallbackReturn.SUCCESS

    def on_deactivate(self, state):
        return TransitionCallbackReturn.SUCCESS

    def on_error(self, state):
        return TransitionCallbackReturn.SUCCESS


@reads_only
class SimpleManagedEntity(ManagedEntity):
    def __init__(self) -> None: ...

    @property
    def is_activated(self) -> bool: ...

    @staticmethod
    def when_enabled(wrapped=None, *, when_not_enabled=None):
        def decorator(wrapped):
            @wraps(wrapped)
            def only_when_enabled_wrapper(self, *args, **kwargs):
                if self.is_activated:
                    wrapped(self, *args, **kwargs)
                elif when_not_enabled is not None:
                    when_not_enabled()
            return only_when_enabled_wrapper
        return decorator if wrapped is None else decorator(wrapped)
