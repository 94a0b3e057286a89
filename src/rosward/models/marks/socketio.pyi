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

class SimpleClient:
    @sink("network")
    def emit(self, event, data=None): ...
    @sink("network")
    @source("network")
    def call(self, event, data=None, timeout=60): ...
    @source("network")
    def receive(self, timeout=None): ...

AsyncSimpleClient = SimpleClient
AsyncClient = Client
Server = Client
AsyncServer = Client
