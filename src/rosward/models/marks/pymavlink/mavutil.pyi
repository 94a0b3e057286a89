# SPDX-License-Identifier: Apache-2.0
"""pymavlink: messages to and from an autopilot."""

from _rosward import sink, source

@sink("device")
class _Messages: ...

class _Connection:
    mav: _Messages
    @source("device")
    def recv_match(self, *args, **kwargs): ...
    @source("device")
    def recv_msg(self): ...
    @source("device")
    def wait_heartbeat(self, *args, **kwargs): ...

def mavlink_connection(device, *args, **kwargs) -> _Connection: ...
