# SPDX-License-Identifier: Apache-2.0
"""`contextlib`: what is entered, what leaves, and what is swallowed on the way."""
from _rosward import ask, native, raises_nothing, reads_only, schedule, unknown
import sys

raises_nothing(__name__)

@native
def _begin(generator): ...
@native
def _end(generator, value): ...
@native
def _unwind(exits, value): ...

class AbstractContextManager:
    def __class_getitem__(cls, item):
        return cls
    def __enter__(self):
        return self
    @reads_only
    def __exit__(self, exc_type, exc_value, traceback) -> None: ...
class AbstractAsyncContextManager:
    def __class_getitem__(cls, item):
        return cls
    async def __aenter__(self):
        return self
    @reads_only
    async def __aexit__(self, exc_type, exc_value, traceback) -> None: ...
class ContextDecorator:
    def _recreate_cm(self):
        return self
    def __call__(self, func):
        def inner(*args, **kwds):
            with self._recreate_cm():
                return func(*args, **kwds)
        return inner
class AsyncContextDecorator:
    def _recreate_cm(self):
        return self
    def __call__(self, func):
        async def inner(*args, **kwds):
            async with self._recreate_cm():
                return await func(*args, **kwds)
        return inner

class _GeneratorContextManager(ContextDecorator, AbstractContextManager):
    """The generator runs to its `yield` where the `with` begins, and on from there where it ends."""
    def __init__(self, func, args, kwds):
        self.gen = func(*args, **kwds)
        self.func, self.args, self.kwds = func, args, kwds
    def _recreate_cm(self):
        return _GeneratorContextManager(self.func, self.args, self.kwds)
    def __enter__(self):
        return _begin(self.gen)
    def __exit__(self, typ, value, traceback):
        return _end(self.gen, value)
class _AsyncGeneratorContextManager(AsyncContextDecorator, AbstractAsyncContextManager):
    def __init__(self, func, args, kwds):
        self.gen = func(*args, **kwds)
        self.func, self.args, self.kwds = func, args, kwds
    def _recreate_cm(self):
        return _AsyncGeneratorContextManager(self.func, self.args, self.kwds)
    async def __aenter__(self):
        return _begin(self.gen)
    async def __aexit__(self, typ, value, traceback):
        return _end(self.gen, value)

def contextmanager(func):
    def helper(*args, **kwds):
        return _GeneratorContextManager(func, args, kwds)
    return helper
def asynccontextmanager(func):
    def helper(*args, **kwds):
        return _AsyncGeneratorContextManager(func, args, kwds)
    return helper

class nullcontext(AbstractContextManager, AbstractAsyncContextManager):
    def __init__(self, enter_result=None):
        self.enter_result = enter_result
    def __enter__(self):
        return self.enter_result
    @reads_only
    def __exit__(self, *excinfo) -> None: ...
    async def __aenter__(self):
        return self.enter_result
    @reads_only
    async def __aexit__(self, *excinfo) -> None: ...

class closing(AbstractContextManager):
    def __init__(self, thing):
        self.thing = thing
    def __enter__(self):
        return self.thing
    def __exit__(self, *exc_info):
        self.thing.close()
class aclosing(AbstractAsyncContextManager):
    def __init__(self, thing):
        self.thing = thing
    async def __aenter__(self):
        return self.thing
    async def __aexit__(self, *exc_info):
        await self.thing.aclose()

class suppress(AbstractContextManager):
    def __init__(self, *exceptions):
        self._exceptions = exceptions
    @reads_only
    def __enter__(self): pass
    def __exit__(self, exctype, excinst, exctb):
        return exctype is not None and issubclass(exctype, self._exceptions)

class redirect_stdout(AbstractContextManager):
    def __init__(self, new_target):
        self._new_target = new_target
    def __enter__(self):
        schedule(ask, self._new_target, 'write', unknown('call', 'text that a library writes', 'str'), event='print')
        self._old = sys.stdout
        sys.stdout = self._new_target
        return self._new_target
    def __exit__(self, exctype, excinst, exctb):
        sys.stdout = self._old
class redirect_stderr(redirect_stdout):
    def __enter__(self):
        schedule(ask, self._new_target, 'write', unknown('call', 'text that a library writes', 'str'), event='print')
        self._old = sys.stderr
        sys.stderr = self._new_target
        return self._new_target
    def __exit__(self, exctype, excinst, exctb):
        sys.stderr = self._old
@reads_only
class chdir(AbstractContextManager):
    def __init__(self, path):
        self.path = path
    def __enter__(self): pass
    def __exit__(self, *excinfo) -> None: ...

class _BaseExitStack:
    """`_exits` holds pairs: what is called with the exception, and whether its result is awaited."""
    def __init__(self):
        self._exits = []
    def pop_all(self):
        new = type(self)()
        new._exits = self._exits
        self._exits = []
        return new
    def push(self, exit):
        if hasattr(exit, '__exit__'):
            self._exits.append((exit.__exit__, False))
        else:
            self._exits.append((exit, False))
        return exit
    def enter_context(self, cm):
        result = cm.__enter__()
        self._exits.append((cm.__exit__, False))
        return result
    def callback(self, callback, /, *args, **kwds):
        def run(typ, value, traceback):
            callback(*args, **kwds)
        self._exits.append((run, False))
        return callback
    def _leave(self, value):
        exits = self._exits
        self._exits = []
        return _unwind(exits, value)
class ExitStack(_BaseExitStack, AbstractContextManager):
    def __enter__(self):
        return self
    def __exit__(self, typ, value, traceback):
        return self._leave(value)
    def close(self):
        self._leave(None)
class AsyncExitStack(_BaseExitStack, AbstractAsyncContextManager):
    async def enter_async_context(self, cm):
        result = await cm.__aenter__()
        self._exits.append((cm.__aexit__, True))
        return result
    def push_async_exit(self, exit):
        if hasattr(exit, '__aexit__'):
            self._exits.append((exit.__aexit__, True))
        else:
            self._exits.append((exit, True))
        return exit
    def push_async_callback(self, callback, /, *args, **kwds):
        async def run(typ, value, traceback):
            await callback(*args, **kwds)
        self._exits.append((run, True))
        return callback
    async def __aenter__(self):
        return self
    async def __aexit__(self, typ, value, traceback):
        return self._leave(value)
    async def aclose(self):
        self._leave(None)
