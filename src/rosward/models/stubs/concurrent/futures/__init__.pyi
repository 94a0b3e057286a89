# SPDX-License-Identifier: Apache-2.0
"""`concurrent.futures`: what is submitted runs in a thread; its result is what the function returns."""
from _rosward import beside, reads_only, schedule, unknown

FIRST_COMPLETED = 'FIRST_COMPLETED'
FIRST_EXCEPTION = 'FIRST_EXCEPTION'
ALL_COMPLETED = 'ALL_COMPLETED'

class CancelledError(Exception): ...
class BrokenExecutor(RuntimeError): ...
TimeoutError = TimeoutError

@reads_only
class Future:
    def __init__(self):
        self._call = None
        self._result = None
        self._exception = None
    def _run(self):
        self._result = self._call()
    def result(self, timeout=None):
        if self._exception is not None:
            raise self._exception
        if self._call is None:
            return self._result if self._result is not None else unknown('live', 'concurrent.futures.Future.result')
        return self._call()
    def exception(self, timeout=None):
        if self._exception is not None:
            return self._exception
        if self._call is not None:
            try:
                self._call()
            except BaseException as error:
                return error
        return unknown('live', 'concurrent.futures.Future.exception')
    def add_done_callback(self, fn):
        schedule(fn, self, event='future')
    def set_result(self, result):
        self._result = result
    def set_exception(self, exception):
        self._exception = exception
    def set_running_or_notify_cancel(self) -> bool: ...
    def cancel(self) -> bool: ...
    def cancelled(self) -> bool: ...
    def running(self) -> bool: ...
    def done(self) -> bool: ...

class Executor:
    def submit(self, fn, /, *args, **kwargs):
        future = Future()
        def call():
            return fn(*args, **kwargs)
        future._call = call
        schedule(future._run, event='thread')
        return future
    def map(self, fn, *iterables, timeout=None, chunksize=1):
        return iter([fn(*values) for values in zip(*iterables)])
    @reads_only
    def shutdown(self, wait=True, *, cancel_futures=False) -> None: ...
    def __enter__(self):
        return self
    @reads_only
    def __exit__(self, exc_type, exc_val, exc_tb) -> None: ...

class ThreadPoolExecutor(Executor):
    def __init__(self, max_workers=None, thread_name_prefix='', initializer=None, initargs=()):
        beside()
        if initializer is not None:
            initializer(*initargs)
class ProcessPoolExecutor(Executor):
    def __init__(self, max_workers=None, mp_context=None, initializer=None, initargs=(), *, max_tasks_per_child=None):
        if initializer is not None:
            initializer(*initargs)

def as_completed(fs, timeout=None):
    return iter(list(fs))
def wait(fs, timeout=None, return_when=ALL_COMPLETED):
    return (set(fs), set(fs))
