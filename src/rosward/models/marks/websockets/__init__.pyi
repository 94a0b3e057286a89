# SPDX-License-Identifier: Apache-2.0
"""websockets."""

from _rosward import hands, sink, source

class Connection:
    @sink("network")
    def send(self, message): ...
    @source("network")
    def recv(self): ...

def connect(uri, **kwargs) -> Connection: ...
@hands("websockets.Connection")
def serve(handler, host=None, port=None, **kwargs): ...
