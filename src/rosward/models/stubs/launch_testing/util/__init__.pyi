# SPDX-License-Identifier: Apache-2.0
"""launch_testing.util.

Read from launch 3.7.0, with what humble had before it.
"""

from launch.actions import TimerAction


class KeepAliveProc(TimerAction):
    def __init__(self):
        super().__init__(period=1.0, actions=[])
