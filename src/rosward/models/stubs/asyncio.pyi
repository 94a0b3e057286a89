# SPDX-License-Identifier: Apache-2.0
"""`asyncio`: a coroutine that is awaited runs in place, a task runs at any time from then on.

A future that is awaited gives its `result()`.
"""
from _rosward import native, pure, raises_nothing, reads_only, schedule, spin, tried, unknown, waits
from threading import Condition as Condition
from threading import Lock as Lock
from threading import Semaphore as Semaphore
from threading import BoundedSemaphore as BoundedSemaphore

@native
def _any(items): ...

async def _into(box, awaitable):
    box.append(await awaitable)
def _wait(awaitable):
    """Run a coroutine from a plain function; what it returns."""
    box = []
    for _ in _into(box, awaitable):
        pass
    return box[0]

FIRST_COMPLETED = 'FIRST_COMPLETED'
FIRST_EXCEPTION = 'FIRST_EXCEPTION'
ALL_COMPLETED = 'ALL_COMPLETED'

class CancelledError(BaseException): ...
class InvalidStateError(Exception): ...
class QueueEmpty(Exception): ...
class QueueFull(Exception): ...
TimeoutError = TimeoutError

@reads_only
class Future:
    def __init__(self, *, loop=None):
        self._result = None
        self._exception = None
    def set_result(self, result, /):
        self._result = result
    def set_exception(self, exception, /):
        self._exception = exception
    def result(self):
        spin()
        if self._exception is not None:
            raise self._exception
        return self._result if self._result is not None else unknown('live', 'asyncio.Future.result')
    def exception(self):
        return self._exception if self._exception is not None else unknown('live', 'asyncio.Future.exception')
    def add_done_callback(self, fn, /, *, context=None):
        schedule(fn, self, event='future')
    def remove_done_callback(self, fn, /) -> int: ...
    def cancel(self, msg=None) -> bool: ...
    def cancelled(self) -> bool: ...
    def done(self) -> bool: ...
    def get_loop(self):
        return _loop

class Task(Future):
    def __init__(self, coro, *, loop=None, name=None, context=None):
        super().__init__()
        self._coro = coro
        schedule(self._run, event='coroutine')
    def _run(self):
        self._result = _wait(self._coro)
    @raises_nothing
    @reads_only
    def get_name(self) -> str: ...
    @reads_only
    def set_name(self, value, /) -> None: ...
    def get_coro(self):
        return self._coro
    def result(self):
        return _wait(self._coro)

class _Executed(Future):
    """What a thread of a pool runs."""
    def __init__(self, func, args):
        super().__init__()
        self._func = func
        self._args = args
        schedule(self._run, event='thread')
    def _run(self):
        self._result = self._func(*self._args)
    def result(self):
        spin()
        return self._func(*self._args)

@reads_only
class Handle:
    def cancel(self) -> None: ...
    def cancelled(self) -> bool: ...
@reads_only
class TimerHandle(Handle):
    def when(self) -> float: ...

class AbstractEventLoop:
    def run_until_complete(self, future):
        return _wait(future)
    def run_forever(self):
        spin()
    def create_task(self, coro, *, name=None, context=None):
        return Task(coro)
    def create_future(self):
        return Future()
    def call_soon(self, callback, *args, context=None):
        schedule(callback, *args, event='loop')
        return Handle()
    def call_soon_threadsafe(self, callback, *args, context=None):
        schedule(callback, *args, event='loop')
        return Handle()
    def call_later(self, delay, callback, *args, context=None):
        schedule(callback, *args, event='loop')
        return TimerHandle()
    def call_at(self, when, callback, *args, context=None):
        schedule(callback, *args, event='loop')
        return TimerHandle()
    def run_in_executor(self, executor, func, *args):
        return _Executed(func, args)
    def add_reader(self, fd, callback, *args):
        schedule(callback, *args, event='loop')
    def add_writer(self, fd, callback, *args):
        schedule(callback, *args, event='loop')
    def add_signal_handler(self, sig, callback, *args):
        schedule(callback, *args, event='signal')
    @reads_only
    def remove_signal_handler(self, sig) -> bool: ...
    def set_exception_handler(self, handler):
        schedule(handler, self, unknown('live', 'context of an exception', 'dict'), event='loop')
    @reads_only
    def set_default_executor(self, executor) -> None: ...
    @reads_only
    def set_debug(self, enabled) -> None: ...
    @reads_only
    def stop(self) -> None: ...
    @reads_only
    def close(self) -> None: ...
    @reads_only
    def is_running(self) -> bool: ...
    @reads_only
    def is_closed(self) -> bool: ...
    def time(self):
        return unknown('random', 'asyncio loop time', 'float')
    @reads_only
    async def shutdown_asyncgens(self) -> None: ...

_loop = AbstractEventLoop()
BaseEventLoop = AbstractEventLoop
SelectorEventLoop = AbstractEventLoop

def get_event_loop():
    if tried() and unknown('live', 'event loop', 'bool'):
        raise RuntimeError('There is no current event loop')
    return _loop
def get_running_loop():
    if tried() and unknown('live', 'event loop', 'bool'):
        raise RuntimeError('no running event loop')
    return _loop
def new_event_loop():
    return _loop
@reads_only
def set_event_loop(loop) -> None: ...
@reads_only
def set_event_loop_policy(policy) -> None: ...

def run(main, *, debug=None):
    result = _wait(main)
    return result
@reads_only
class Runner:
    def __init__(self, *, debug=None, loop_factory=None): ...
    def __enter__(self):
        return self
    def __exit__(self, exc_type, exc_val, exc_tb) -> None: ...
    def run(self, coro, *, context=None):
        return _wait(coro)
    def get_loop(self):
        return _loop
    def close(self) -> None: ...

def create_task(coro, *, name=None, context=None):
    return Task(coro)
def ensure_future(coro_or_future, *, loop=None):
    return coro_or_future if isinstance(coro_or_future, Future) else Task(coro_or_future)
def run_coroutine_threadsafe(coro, loop):
    return Task(coro)
def wrap_future(future, *, loop=None):
    return future
@reads_only
def current_task(loop=None): ...
@reads_only
def all_tasks(loop=None): ...
@reads_only
def iscoroutine(obj) -> bool: ...
@reads_only
def iscoroutinefunction(func) -> bool: ...
@reads_only
def isfuture(obj) -> bool: ...

@reads_only
@waits
@pure
def _pause() -> None: ...
async def sleep(delay, result=None):
    _pause()
    return result
async def gather(*coros_or_futures, return_exceptions=False):
    tasks = [ensure_future(one) for one in coros_or_futures]
    spin()
    if return_exceptions:
        return [await _outcome(one) for one in tasks]
    return [await one for one in tasks]
async def _outcome(task):
    """What a task returns, or the exception that it ends with."""
    try:
        return await task
    except (Exception, CancelledError) as error:
        return error
async def wait(fs, *, timeout=None, return_when=ALL_COMPLETED):
    tasks = {ensure_future(one) for one in fs}
    spin()
    return (tasks, tasks)
async def wait_for(fut, timeout):
    return await fut
def shield(arg):
    return ensure_future(arg)
def as_completed(fs, *, timeout=None):
    return iter([ensure_future(one) for one in fs])
async def to_thread(func, /, *args, **kwargs):
    return func(*args, **kwargs)
@reads_only
class timeout:
    def __init__(self, delay): ...
    async def __aenter__(self):
        return self
    async def __aexit__(self, exc_type, exc_val, exc_tb) -> None: ...
class TaskGroup:
    async def __aenter__(self):
        return self
    @reads_only
    async def __aexit__(self, et, exc, tb) -> None: ...
    def create_task(self, coro, *, name=None, context=None):
        return Task(coro)

@reads_only
class Event:
    @raises_nothing
    def is_set(self) -> bool: ...
    def set(self) -> None: ...
    def clear(self) -> None: ...
    async def wait(self):
        spin()
        return True

class Queue:
    """What is taken out is any of what was put in: between the two, others may run."""
    def __init__(self, maxsize=0):
        self.maxsize = maxsize
        self._init(maxsize)
    def _init(self, maxsize):
        self._queue = []
    def _put(self, item):
        self._queue.append(item)
    def _get(self):
        return _any(self._queue)
    async def put(self, item):
        self._put(item)
    def put_nowait(self, item):
        self._put(item)
    async def get(self):
        spin()
        return self._get()
    def get_nowait(self):
        return self._get()
    async def join(self):
        spin()
    @reads_only
    def qsize(self) -> int: ...
    @reads_only
    def empty(self) -> bool: ...
    @reads_only
    def full(self) -> bool: ...
    @reads_only
    def task_done(self) -> None: ...
class LifoQueue(Queue): ...
class PriorityQueue(Queue): ...
