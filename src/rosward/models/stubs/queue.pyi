# SPDX-License-Identifier: Apache-2.0
"""`queue`: what is taken out is any of what was put in."""
from _rosward import native, reads_only, spin

@native
def _any(items): ...

class Empty(Exception): ...
class Full(Exception): ...

class Queue:
    def __init__(self, maxsize=0):
        self.maxsize = maxsize
        self._items = []
    def put(self, item, block=True, timeout=None):
        self._items.append(item)
    def put_nowait(self, item):
        self._items.append(item)
    def get(self, block=True, timeout=None):
        spin()
        return _any(self._items)
    def get_nowait(self):
        return _any(self._items)
    @reads_only
    def qsize(self) -> int: ...
    @reads_only
    def empty(self) -> bool: ...
    @reads_only
    def full(self) -> bool: ...
    @reads_only
    def task_done(self) -> None: ...
    def join(self):
        spin()

class LifoQueue(Queue): ...
class PriorityQueue(Queue): ...
class SimpleQueue(Queue):
    def __init__(self):
        super().__init__()
