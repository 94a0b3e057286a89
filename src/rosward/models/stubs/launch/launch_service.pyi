# SPDX-License-Identifier: Apache-2.0
"""launch.launch_service: a program that launches by itself.

Read from launch 3.7.0, with what humble had before it.
"""

from _rosward import reads_only, report

reads_only(__name__)


class LaunchService:
    def __init__(self, *, argv=None, noninteractive=False, debug=False): ...

    def include_launch_description(self, launch_description):
        report("RW210", "launch.LaunchService starts what a launch description says")

    def emit_event(self, event) -> None: ...
    async def run_async(self, *, shutdown_when_idle=True) -> int: ...
    def run(self, *, shutdown_when_idle=True) -> int: ...
    def shutdown(self, force_sync=False) -> None: ...
    @property
    def context(self): ...
