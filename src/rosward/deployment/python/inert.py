# SPDX-License-Identifier: Apache-2.0
"""Which actions of launch and its relatives start nothing, and set nothing for what is started?

LogInfo(msg='x')                  starts nothing: it is passed over
GTest(path='build/test_arm')      runs a program of a test, which may be a node: it is told (RW321)

Each action that a model describes stands here or among the readers of `actions.py`; what stands in neither is told.
"""

from __future__ import annotations

from types import MappingProxyType
from typing import Final

__all__ = ["INERT", "NOT_READ"]

INERT: Final = frozenset(
    {
        "launch.actions.EmitEvent",  # what waits for the event is executed in any case, as conditional
        "launch.actions.Shutdown",
        "launch.actions.Log",
        "launch.actions.LogInfo",
        "launch.actions.UnregisterEventHandler",  # the handler is executed in any case
        "launch_ros.actions.LifecycleTransition",
        "launch_ros.actions.SetROSLogDir",
        "launch_ros.actions.SetUseSimTime",  # of launch's own node
        "launch_testing.actions.ReadyToTest",
    }
)
"""By the dotted name of the class; what derives from one of them is inert, too."""

NOT_READ: Final = MappingProxyType(
    {
        "launch_testing.actions.GTest": "it runs a test program",
        "launch_testing.actions.PyTest": "it runs a test program",
        "launch_testing.actions.Test": "it runs a test program",
    }
)
"""What may start a node, and is not followed; why."""
