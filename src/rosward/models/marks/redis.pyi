# SPDX-License-Identifier: Apache-2.0
"""redis-py: each command goes to a server, and its answer comes from there."""

from _rosward import sink, source

@source("network")
class PubSub:
    def get_message(self, *args, **kwargs): ...
    def listen(self): ...
    def psubscribe(self, *args, **kwargs): ...
    def subscribe(self, *args, **kwargs): ...

@sink("network")
@source("network")
class Redis:
    def pubsub(self, **kwargs) -> PubSub: ...

StrictRedis = Redis
