# SPDX-License-Identifier: Apache-2.0
"""Event handlers of launch: which event they wait for, and what they do then.

OnProcessExit(target_action=spawner, on_exit=[node])     'process-exit', the list
"""

from __future__ import annotations

from typing import Final

from rosward.deployment.python.objects import Objects
from rosward.domain.values import NONE, Ref, Value

_EVENTS: Final = {
    "launch.event_handlers.OnProcessStart": "process-start",
    "launch.event_handlers.OnProcessExit": "process-exit",
    "launch.event_handlers.OnProcessIO": "process-io",
    "launch.event_handlers.OnExecutionComplete": "execution-complete",
    "launch.event_handlers.OnShutdown": "shutdown",
    "launch.event_handlers.OnIncludeLaunchDescription": "include-complete",
    "launch_ros.event_handlers.OnStateTransition": "lifecycle",
}


def event_of(objects: Objects, handler: Ref) -> tuple[str, Value]:
    """The event that a handler waits for, and the entities or function that it was given."""
    if objects.overrides(handler, "handle"):
        return "other", objects.machine.load_attr(handler, "handle")
    return _EVENTS.get(objects.kind(handler), "other"), objects.field(handler, "actions") or NONE
