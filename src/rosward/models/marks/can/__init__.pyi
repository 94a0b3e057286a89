# SPDX-License-Identifier: Apache-2.0
"""python-can."""

from _rosward import sink, source

@source("device")
class Bus:
    @sink("device")
    def send(self, msg, timeout=None): ...
    @sink("device")
    def send_periodic(self, msgs, period, *args, **kwargs): ...
    @source("device")
    def recv(self, timeout=None): ...

ThreadSafeBus = Bus
