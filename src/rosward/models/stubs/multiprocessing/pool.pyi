# SPDX-License-Identifier: Apache-2.0
"""`multiprocessing.pool`: what is handed to a pool runs."""
from _rosward import beside, schedule
from multiprocessing import Pool as Pool, _Result as AsyncResult

ApplyResult = AsyncResult
MapResult = AsyncResult

class ThreadPool(Pool):
    def __init__(self, processes=None, initializer=None, initargs=()):
        beside()
        super().__init__(processes, initializer, initargs)
    def apply_async(self, func, args=(), kwds={}, callback=None, error_callback=None):
        later = _Later(func, args, kwds, callback)
        schedule(later._run, event='thread')
        return later
    def map_async(self, func, iterable, chunksize=None, callback=None, error_callback=None):
        return self.apply_async(self.map, (func, list(iterable)), {}, callback)
    def starmap_async(self, func, iterable, chunksize=None, callback=None, error_callback=None):
        return self.apply_async(self.starmap, (func, list(iterable)), {}, callback)

class _Later(AsyncResult):
    """What a thread of the pool works on."""
    def __init__(self, func, args, kwds, callback):
        self._func = func
        self._args = args
        self._kwds = kwds
        self._callback = callback
    def _run(self):
        value = self.get()
        if self._callback is not None:
            self._callback(value)
    def get(self, timeout=None):
        return self._func(*self._args, **self._kwds)
