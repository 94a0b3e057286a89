# SPDX-License-Identifier: Apache-2.0
"""`multiprocessing.pool`: what is handed to a pool runs."""
from _rosward import beside
from multiprocessing import Pool as Pool, _Result as AsyncResult

ApplyResult = AsyncResult
MapResult = AsyncResult

class ThreadPool(Pool):
    def __init__(self, processes=None, initializer=None, initargs=()):
        beside()
        super().__init__(processes, initializer, initargs)
