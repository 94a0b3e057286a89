# SPDX-License-Identifier: Apache-2.0
"""websockets."""

from _rosward import sink, source

class ClientConnection:
    @sink("network")
    def send(self, message): ...
    @source("network")
    def recv(self): ...

def connect(uri, **kwargs) -> ClientConnection: ...
