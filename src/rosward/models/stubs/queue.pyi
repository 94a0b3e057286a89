# SPDX-License-Identifier: Apache-2.0
"""`queue`: what is taken out is what was put in; once something else runs, any of it."""
from _rosward import native, reads_only, spin, unknown
from collections import deque

@native
def _any(items): ...
@native
def _alone(): ...

class Empty(Exception): ...
class Full(Exception): ...

class Queue:
    """`_items` is what is in it, as long as nothing else runs; `_all` is all that ever was."""
    def __init__(self, maxsize=0):
        self.maxsize = maxsize
        self._items = []
        self._all = []
        self._shared = False
    def _is_exact(self):
        self._shared = self._shared or not _alone()
        return not self._shared
    @property
    def queue(self):
        found = deque()
        found._list = self._contents()
        return found
    def _contents(self):
        return self._items if self._is_exact() else self._all
    def put(self, item, block=True, timeout=None):
        if not self._is_exact():
            if self.maxsize > 0 and not block:
                _any(self._all)  # how many there are decides whether it is full
        elif not block and self.full():
            raise Full
        self._items.append(item)
        self._all.append(item)
    def put_nowait(self, item):
        self.put(item, False)
    def _take(self):
        return self._items.pop(0)
    def get(self, block=True, timeout=None):
        if not self._is_exact():
            spin()
            return _any(self._all)
        if self._items:
            return self._take()
        if not block or timeout is not None:
            raise Empty
        return _any(self._all)
    def get_nowait(self):
        if not self._is_exact():
            return _any(self._all)
        return self.get(False)
    def qsize(self):
        return len(self._items) if self._is_exact() else unknown('live', 'queue.Queue.qsize', 'int')
    def empty(self):
        return not self._items if self._is_exact() else unknown('live', 'queue.Queue.empty', 'bool')
    def full(self):
        if self.maxsize <= 0:
            return False
        return len(self._items) >= self.maxsize if self._is_exact() else unknown('live', 'queue.Queue.full', 'bool')
    @reads_only
    def task_done(self) -> None: ...
    def join(self):
        spin()

class LifoQueue(Queue):
    @property
    def queue(self):
        return self._contents()
    def _take(self):
        return self._items.pop()
class PriorityQueue(Queue):
    @property
    def queue(self):
        return self._contents()
    def _take(self):
        self._items.sort()
        return self._items.pop(0)
class SimpleQueue(Queue):
    def __init__(self):
        super().__init__()
