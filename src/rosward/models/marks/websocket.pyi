# SPDX-License-Identifier: Apache-2.0
"""websocket-client."""

from _rosward import sink, source

class WebSocket:
    @sink("network")
    def send(self, payload, opcode=1): ...
    @source("network")
    def recv(self): ...

class WebSocketApp:
    @sink("network")
    def send(self, data, opcode=1): ...

def create_connection(url, timeout=None, **options) -> WebSocket: ...
