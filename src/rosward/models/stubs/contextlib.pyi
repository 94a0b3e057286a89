# SPDX-License-Identifier: Apache-2.0
"""`contextlib`: what is entered, and what leaves."""
from _rosward import native, schedule

@native
def _enter(generator): ...

class AbstractContextManager:
    def __class_getitem__(cls, item):
        return cls
    def __enter__(self):
        return self
    def __exit__(self, exc_type, exc_value, traceback): ...
class AbstractAsyncContextManager:
    def __class_getitem__(cls, item):
        return cls
    async def __aenter__(self):
        return self
    async def __aexit__(self, exc_type, exc_value, traceback): ...
class ContextDecorator:
    def __call__(self, func):
        def inner(*args, **kwds):
            with self:
                return func(*args, **kwds)
        return inner

class _GeneratorContextManager(ContextDecorator):
    """The generator runs where the `with` begins."""
    def __init__(self, func, args, kwds):
        self._func = func
        self._args = args
        self._kwds = kwds
    def __enter__(self):
        return _enter(self._func(*self._args, **self._kwds))
    def __exit__(self, typ, value, traceback):
        return None
    async def __aenter__(self):
        return _enter(self._func(*self._args, **self._kwds))
    async def __aexit__(self, typ, value, traceback):
        return None

def contextmanager(func):
    def helper(*args, **kwds):
        return _GeneratorContextManager(func, args, kwds)
    return helper
def asynccontextmanager(func):
    def helper(*args, **kwds):
        return _GeneratorContextManager(func, args, kwds)
    return helper

class nullcontext:
    def __init__(self, enter_result=None):
        self.enter_result = enter_result
    def __enter__(self):
        return self.enter_result
    def __exit__(self, *excinfo): ...
    async def __aenter__(self):
        return self.enter_result
    async def __aexit__(self, *excinfo): ...

class closing:
    def __init__(self, thing):
        self.thing = thing
    def __enter__(self):
        return self.thing
    def __exit__(self, *exc_info):
        self.thing.close()
aclosing = closing

class suppress:
    def __init__(self, *exceptions):
        self._exceptions = exceptions
    def __enter__(self): ...
    def __exit__(self, exctype, excinst, exctb):
        return True

class redirect_stdout:
    def __init__(self, new_target):
        self._new_target = new_target
    def __enter__(self):
        return self._new_target
    def __exit__(self, exctype, excinst, exctb): ...
class redirect_stderr(redirect_stdout): ...
class chdir:
    def __init__(self, path): ...
    def __enter__(self): ...
    def __exit__(self, *excinfo): ...

class ExitStack:
    def __enter__(self):
        return self
    def __exit__(self, *exc_details): ...
    def enter_context(self, cm):
        return cm.__enter__()
    def push(self, exit):
        return exit
    def callback(self, callback, /, *args, **kwds):
        def run():
            callback(*args, **kwds)
        schedule(run, event='exit')
        return callback
    def pop_all(self):
        return self
    def close(self): ...
class AsyncExitStack(ExitStack):
    async def __aenter__(self):
        return self
    async def __aexit__(self, *exc_details): ...
    async def enter_async_context(self, cm):
        return await cm.__aenter__()
    async def aclose(self): ...
