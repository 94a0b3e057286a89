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
    """`_items` is what is in it, as long as nothing else runs, and then all that was in it since; `_own` is what a class keeps instead.

    As in Python, `put` and `get` ask `_put` and `_get` and so on, which a class may replace.
    """
    def __init__(self, maxsize=0):
        self.maxsize = maxsize
        self._items = []
        self._shared = False
        self._init(maxsize)
    def _init(self, maxsize):
        self._own = None
    def _is_exact(self):
        self._shared = self._shared or not _alone()
        return not self._shared
    @property
    def queue(self):
        return self._view() if self._own is None else self._own
    @queue.setter
    def queue(self, own):
        self._own = own
    def _view(self):
        found = deque()
        found._list = self._items
        return found
    def _qsize(self):
        return len(self._items if self._own is None else self._own)
    def _put(self, item):
        if self._own is None:
            self._items.append(item)
        else:
            self._own.append(item)
    def _get(self):
        if self._own is not None:
            return self._taken_of(self._own)
        if self._is_exact() and self._items:
            return self._taken_of(self._items)
        return _any(self._items)
    def _taken_of(self, items):
        return items.pop(0) if self._own is None else items.popleft()
    def put(self, item, block=True, timeout=None):
        if not self._is_exact():
            if self.maxsize > 0 and not block:
                _any(self._items)  # how many there are decides whether it is full
        elif not block and self.full():
            raise Full
        self._put(item)
    def put_nowait(self, item):
        self.put(item, False)
    def get(self, block=True, timeout=None):
        if not self._is_exact():
            spin()
        elif (not block or timeout is not None) and not self._qsize():
            raise Empty
        return self._get()
    def get_nowait(self):
        return self.get(False) if self._is_exact() else self._get()
    def qsize(self):
        return self._qsize() if self._is_exact() else unknown('live', 'queue.Queue.qsize', 'int')
    def empty(self):
        return not self._qsize() if self._is_exact() else unknown('live', 'queue.Queue.empty', 'bool')
    def full(self):
        if self.maxsize <= 0:
            return False
        return self._qsize() >= self.maxsize if self._is_exact() else unknown('live', 'queue.Queue.full', 'bool')
    @reads_only
    def task_done(self) -> None: ...
    def join(self):
        spin()

class LifoQueue(Queue):
    def _view(self):
        return self._items
    def _taken_of(self, items):
        return items.pop()
class PriorityQueue(Queue):
    def _view(self):
        return self._items
    def _taken_of(self, items):
        items.sort()
        return items.pop(0)
class SimpleQueue(Queue):
    def __init__(self):
        super().__init__()
