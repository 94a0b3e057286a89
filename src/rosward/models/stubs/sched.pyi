# SPDX-License-Identifier: Apache-2.0
"""`sched`: an event calls its action."""
from _rosward import schedule, spin

class Event: ...
class scheduler:
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
    def cancel(self, event) -> None: ...
    def empty(self) -> bool: ...
    def run(self, blocking=True):
        spin()
