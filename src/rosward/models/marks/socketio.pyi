# SPDX-License-Identifier: Apache-2.0
"""python-socketio: events of clients and servers."""

from _rosward import sink, source

class Client:
    @sink("network")
    def emit(self, event, data=None, *args, **kwargs): ...
    @sink("network")
    def send(self, data, *args, **kwargs): ...
    @sink("network")
    @source("network")
    def call(self, event, data=None, *args, **kwargs): ...
    @source("network")
    def on(self, event, handler=None, namespace=None): ...
    @source("network")
    def event(self, *args, **kwargs): ...

AsyncClient = Client
Server = Client
AsyncServer = Client
