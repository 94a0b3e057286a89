# SPDX-License-Identifier: Apache-2.0
"""rclpy.utilities.

Read from rclpy 9.1.2 (kilted) and the branches humble (3.3.15), iron (4.1.7), jazzy (7.1.3) and rolling (8.0.0, December 2024).
"""

import os

from _rosward import native, raises_nothing, reads_only, waits

from rclpy.context import Context

g_default_context = Context()


def get_default_context(*, shutting_down=False):
    return g_default_context


@native
def remove_ros_args(args=None): ...


@raises_nothing
@waits
@reads_only
def ok(*, context=None) -> bool: ...
def shutdown(*, context=None):
    (get_default_context() if context is None else context).shutdown()


def try_shutdown(*, context=None):
    (get_default_context() if context is None else context).try_shutdown()



def get_rmw_implementation_identifier():
    return os.environ["RMW_IMPLEMENTATION"]


@reads_only
def get_available_rmw_implementations() -> set: ...
@reads_only
def timeout_sec_to_nsec(timeout_sec) -> int: ...
