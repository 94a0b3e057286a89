# SPDX-License-Identifier: Apache-2.0
"""`multiprocessing`: a process is a thread that shares nothing."""
from _rosward import beside, either, raises_nothing, reads_only, schedule, spin, unknown
from queue import Queue as _Queue
from threading import Thread, Timer, Condition, Event, Semaphore, BoundedSemaphore, Barrier, Lock, RLock

_started = []

class ProcessError(Exception): ...
class TimeoutError(ProcessError): ...

@reads_only
class Process(Thread):
    def __init__(self, group=None, target=None, name=None, args=(), kwargs={}, *, daemon=None):
        super().__init__(group, target, name, args, kwargs, daemon=daemon)
        self.pid = unknown('random', 'multiprocessing.Process.pid', 'int')
        self.exitcode = unknown('live', 'multiprocessing.Process.exitcode', 'int')
    def start(self):
        _started.append(self)
        schedule(self.run, event='process')
    def terminate(self) -> None: ...
    def kill(self) -> None: ...
    def close(self) -> None: ...

@reads_only
class _Result:
    def __init__(self, value):
        self._value = value
    def get(self, timeout=None):
        return self._value
    def wait(self, timeout=None) -> None: ...
    def ready(self) -> bool: ...
    def successful(self) -> bool: ...

class Pool:
    def __init__(self, processes=None, initializer=None, initargs=(), maxtasksperchild=None, context=None):
        _started.append(Process())
        if initializer is not None:
            initializer(*initargs)
    def apply(self, func, args=(), kwds={}):
        return func(*args, **kwds)
    def apply_async(self, func, args=(), kwds={}, callback=None, error_callback=None):
        value = func(*args, **kwds)
        if callback is not None:  # in a thread of the program
            beside()
            callback(value)
        return _Result(value)
    def map(self, func, iterable, chunksize=None):
        return [func(value) for value in iterable]
    def map_async(self, func, iterable, chunksize=None, callback=None, error_callback=None):
        value = [func(value) for value in iterable]
        if callback is not None:
            beside()
            callback(value)
        return _Result(value)
    def imap(self, func, iterable, chunksize=1):
        return iter([func(value) for value in iterable])
    def imap_unordered(self, func, iterable, chunksize=1):
        return iter([func(value) for value in iterable])
    def starmap(self, func, iterable, chunksize=None):
        return [func(*value) for value in iterable]
    def starmap_async(self, func, iterable, chunksize=None, callback=None, error_callback=None):
        value = [func(*value) for value in iterable]
        if callback is not None:
            beside()
            callback(value)
        return _Result(value)
    @reads_only
    def close(self) -> None: ...
    @reads_only
    def terminate(self) -> None: ...
    @reads_only
    def join(self) -> None: ...
    def __enter__(self):
        return self
    @reads_only
    def __exit__(self, exc_type, exc_val, exc_tb) -> None: ...

def Queue(maxsize=0):
    return _Queue(maxsize)
def JoinableQueue(maxsize=0):
    return _Queue(maxsize)
def SimpleQueue():
    return _Queue()

class _Shared:
    def __init__(self, value):
        self.value = value
        self.raw = value
    def get_lock(self):
        return Lock()
    def get_obj(self):
        return self

def Value(typecode_or_type, *args, lock=True):
    return _Shared(args[0] if args else 0)
def RawValue(typecode_or_type, *args):
    return _Shared(args[0] if args else 0)
def Array(typecode_or_type, size_or_initializer, *, lock=True):
    return unknown('live', 'multiprocessing.Array', 'list')

class _Connection:
    def __init__(self, items):
        self._items = items
    def send(self, obj):
        self._items.append(obj)
    def recv(self):
        spin()
        return unknown('live', 'multiprocessing.Pipe')
    @reads_only
    def poll(self, timeout=0.0) -> bool: ...
    @reads_only
    def close(self) -> None: ...
def Pipe(duplex=True):
    items = []
    return (_Connection(items), _Connection(items))

class _Manager:
    def dict(self, *args, **kwargs):
        return dict(*args, **kwargs)
    def list(self, *args):
        return list(*args)
    def Queue(self, maxsize=0):
        return _Queue(maxsize)
    def Event(self):
        return Event()
    def Lock(self):
        return Lock()
    def RLock(self):
        return RLock()
    def Value(self, typecode, value):
        return _Shared(value)
    @reads_only
    def Namespace(self): ...
    @raises_nothing
    @reads_only
    def start(self) -> None: ...
    @reads_only
    def shutdown(self) -> None: ...
    def __enter__(self):
        return self
    @reads_only
    def __exit__(self, exc_type, exc_val, exc_tb) -> None: ...
def Manager():
    return _Manager()

class _Context:
    Process = Process
    Pool = Pool
    Event = Event
    Condition = Condition
    def Queue(self, maxsize=0):
        return _Queue(maxsize)
    def Lock(self):
        return Lock()
    def Value(self, typecode_or_type, *args, lock=True):
        return _Shared(args[0] if args else 0)
    def Pipe(self, duplex=True):
        return Pipe(duplex)
def get_context(method=None):
    return _Context()
@reads_only
def set_start_method(method, force=False) -> None: ...
@reads_only
def get_start_method(allow_none=False) -> str: ...
@reads_only
def freeze_support() -> None: ...
def current_process():
    main = Process(name='MainProcess')
    return either(main, *_started) if _started else main
def parent_process():
    return either(None, Process(name='MainProcess')) if _started else None
def active_children():
    found = []
    for one in _started:
        if one.is_alive():
            found.append(one)
    return found
