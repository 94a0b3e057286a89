# SPDX-License-Identifier: Apache-2.0
"""rclpy.signals.

Read from rclpy 9.1.2 (kilted) and the branches humble (3.3.15), iron (4.1.7), jazzy (7.1.3) and rolling (8.0.0, December 2024).
"""

from _rosward import reads_only

from enum import IntEnum

from rclpy.guard_condition import GuardCondition

reads_only(__name__)


class SignalHandlerOptions(IntEnum):
    NO = 0
    SIGINT = 1
    SIGTERM = 2
    ALL = 3


def install_signal_handlers(options=SignalHandlerOptions.ALL) -> None: ...
def get_current_signal_handlers_options(): ...
def uninstall_signal_handlers() -> None: ...


class SignalHandlerGuardCondition(GuardCondition):
    def __init__(self, context=None) -> None: ...
    def destroy(self) -> None: ...
