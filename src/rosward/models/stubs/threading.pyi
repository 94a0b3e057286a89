# SPDX-License-Identifier: Apache-2.0
"""`threading`: what a thread runs may run at any time from its start on."""
from _rosward import either, native, raises_nothing, reads_only, schedule, spin, spins, unknown
from queue import _alone

reads_only(__name__)

TIMEOUT_MAX = 9223372036.0

class ThreadError(RuntimeError): ...
class BrokenBarrierError(RuntimeError): ...

class Thread:
    def __init__(self, group=None, target=None, name=None, args=(), kwargs=None, *, daemon=None):
        self._target = target
        self._args = args
        self._kwargs = {} if kwargs is None else kwargs
        self.name = unknown('random', 'name of a thread', 'str') if name is None else name
        self.daemon = False if daemon is None else daemon
        self.ident = unknown('random', 'threading.Thread.ident', 'int')
        self.native_id = unknown('random', 'threading.Thread.native_id', 'int')
    def start(self):
        _started.append(self)
        schedule(self.run, event='thread')
        schedule(_end, event='end of a thread')
    def run(self):
        if self._target is not None:
            self._target(*self._args, **self._kwargs)
    def join(self, timeout=None):
        spin()
    def is_alive(self) -> bool: ...
    def isAlive(self) -> bool: ...
    def setDaemon(self, daemonic):
        self.daemon = daemonic
    def isDaemon(self):
        return self.daemon
    def setName(self, name):
        self.name = name
    def getName(self):
        return self.name

class Timer(Thread):
    def __init__(self, interval, function, args=None, kwargs=None):
        super().__init__(None, function, None, () if args is None else args, kwargs)
        self.interval = interval
        self.function = function
    def cancel(self): ...

@native
def _uncaught(): ...

class ExceptHookArgs:
    def __init__(self, iterable=(), /):
        self.exc_type, self.exc_value, self.exc_traceback, self.thread = iterable

def excepthook(args, /) -> None: ...
__excepthook__ = excepthook
def _end():
    """What an exception runs that a thread does not catch."""
    error = _uncaught()
    excepthook(ExceptHookArgs((type(error), error, error.__traceback__, unknown('live', 'thread'))))

class _Lock:
    def acquire(self, blocking=True, timeout=-1) -> bool: ...
    def release(self) -> None: ...
    def locked(self) -> bool: ...
    def __enter__(self):
        return True
    def __exit__(self, *args) -> None: ...
    async def __aenter__(self):
        return True
    async def __aexit__(self, *args) -> None: ...

def Lock():
    return _Lock()
def RLock(*args, **kwargs):
    return _Lock()
class Semaphore(_Lock):
    def __init__(self, value=1): ...
    def release(self, n=1) -> None: ...
class BoundedSemaphore(Semaphore): ...
class Condition(_Lock):
    def __init__(self, lock=None): ...
    def wait(self, timeout=None):
        spin()
        return unknown('live', 'threading.Condition', 'bool')
    def wait_for(self, predicate, timeout=None):
        spin()
        return predicate()
    def notify(self, n=1) -> None: ...
    def notify_all(self) -> None: ...
    def notifyAll(self) -> None: ...
class Event:
    @raises_nothing
    def is_set(self) -> bool: ...
    def isSet(self) -> bool: ...
    def set(self) -> None: ...
    def clear(self) -> None: ...
    def wait(self, timeout=None):
        spin()
        return unknown('live', 'threading.Event', 'bool')
class Barrier:
    def __init__(self, parties, action=None, timeout=None):
        if action is not None:
            schedule(action, event='thread')
    @spins
    def wait(self, timeout=None) -> int: ...
    def reset(self) -> None: ...
    def abort(self) -> None: ...

class local:
    """Each thread has attributes of its own: one object stands for all, so what one thread sets may be there, and what was there before."""
    _rosward_hidden = ()
    def __setattr__(self, name, value):
        if unknown('live', 'thread', 'bool'):
            object.__setattr__(self, name, value)
    def __delattr__(self, name):
        if unknown('live', 'thread', 'bool'):
            object.__delattr__(self, name)

_main = Thread(name='MainThread')
_started = []

def current_thread():
    """The main one, as long as nothing runs beside it; later any other may ask, those of a pool among them."""
    return either(_main, Thread(), *_started) if _started or not _alone() else _main
def currentThread():
    return current_thread()
def main_thread():
    return _main
def active_count() -> int: ...
def activeCount() -> int: ...
def enumerate():
    found = [_main]
    for one in _started:
        if one.is_alive():
            found.append(one)
    if not _alone() and unknown('live', 'thread', 'bool'):
        found.append(Thread())
    return found
def settrace(func): ...
def setprofile(func): ...
def stack_size(size=0, /) -> int: ...
