# SPDX-License-Identifier: Apache-2.0
"""message_filters: subscriptions whose messages reach callbacks one by one or in matching sets.

Read from ros2/message_filters, branches humble to rolling (2024-10); src/message_filters/__init__.py differs only in comments.
"""

from _rosward import either, creator, message, reads_only, schedule, unknown


@reads_only
class SimpleFilter:
    def __init__(self) -> None: ...

    def registerCallback(self, cb, *args):
        schedule(cb, *self._rosward_output(), *args, event="message")
        return 0

    def _rosward_output(self):
        """The messages that one call of a callback gets."""
        return [unknown("message", "output of a message filter")]

    def signalMessage(self, *msg) -> None: ...


@creator
class Subscriber(SimpleFilter):
    def __init__(self, node, msg_type, topic, *args, **kwargs):
        self.node = node
        self.topic = topic
        self._rosward_type = msg_type
        kwargs.setdefault("qos_profile", 10)
        self.sub = node.create_subscription(msg_type, topic, self.callback, **kwargs)

    def _rosward_output(self):
        return [message(self._rosward_type, "message")]

    @reads_only
    def callback(self, msg) -> None: ...

    def getTopic(self):
        return self.topic


class Cache(SimpleFilter):
    def __init__(self, f, cache_size=1, allow_headerless=False):
        self.connectInput(f)

    def connectInput(self, f):
        self._rosward_input = f
        f.registerCallback(self.add)

    def _rosward_output(self):
        return self._rosward_input._rosward_output()

    @reads_only
    def add(self, msg) -> None: ...

    def getInterval(self, from_stamp, to_stamp):
        return [self._newest() for _ in unknown("message", "messages in the cache")]

    def getElemAfterTime(self, stamp):
        return self._newest() if unknown("message", "messages in the cache", "bool") else None

    def getElemBeforeTime(self, stamp):
        return self._newest() if unknown("message", "messages in the cache", "bool") else None

    @reads_only
    def getLastestTime(self): ...

    @reads_only
    def getOldestTime(self): ...

    def getLast(self):
        return either(None, self._newest())

    def _newest(self):
        for newest in self._rosward_output():
            return newest


class TimeSynchronizer(SimpleFilter):
    def __init__(self, fs, queue_size):
        self.connectInput(fs)
        self.queue_size = queue_size

    def connectInput(self, fs):
        self._rosward_inputs = fs

    def _rosward_output(self):
        return [output for f in self._rosward_inputs for output in f._rosward_output()]

    @reads_only
    def add(self, msg, my_queue, my_queue_index=None) -> None: ...


@reads_only
class ApproximateTimeSynchronizer(TimeSynchronizer):
    def __init__(self, fs, queue_size, slop, allow_headerless=False):
        TimeSynchronizer.__init__(self, fs, queue_size)
        self.slop = slop
        self.allow_headerless = allow_headerless

    def add(self, msg, my_queue, my_queue_index=None) -> None: ...
