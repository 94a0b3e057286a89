# SPDX-License-Identifier: Apache-2.0
"""`sched`: an event calls its action."""
from _rosward import reads_only, schedule, spin

class Event: ...
class scheduler:
    @reads_only
    def __init__(self, timefunc=None, delayfunc=None): ...
    def _add(self, action, argument, kwargs):
        def run():
            action(*argument, **kwargs)
        schedule(run, event='timer')
        return Event()
    def enter(self, delay, priority, action, argument=(), kwargs={}):
        return self._add(action, argument, kwargs)
    def enterabs(self, time, priority, action, argument=(), kwargs={}):
        return self._add(action, argument, kwargs)
    @reads_only
    def cancel(self, event) -> None: ...
    @reads_only
    def empty(self) -> bool: ...
    def run(self, blocking=True):
        spin()
