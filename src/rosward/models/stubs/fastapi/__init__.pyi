# SPDX-License-Identifier: Apache-2.0
"""fastapi: what is registered for a path runs with what its dependencies give; all else of a request is unknown.

Read from fastapi 0.115. What only says how a request is read, shown or answered is not here: it is unknown.
"""
from _rosward import awaited, either, schedule, spin, unknown
import contextlib
import functools
import inspect
import types

_apps = []

class Depends:
    """What an endpoint wants to be called with."""
    def __init__(self, dependency=None, *, use_cache=True):
        self.dependency = dependency
class Security(Depends):
    def __init__(self, dependency=None, *, scopes=None, use_cache=True):
        super().__init__(dependency, use_cache=use_cache)

class _Connection:
    @property
    def app(self):
        return either(*_apps)
class Request(_Connection): ...
class WebSocket(_Connection): ...

class BackgroundTasks:
    """What runs once the answer has been sent."""
    def __init__(self, tasks=None):
        self.tasks = []
    def add_task(self, func, *args, **kwargs):
        schedule(_runs, func, args, kwargs, event='request')
def _runs(function, args, kwargs):
    awaited(function(*args, **kwargs))

class HTTPException(Exception):
    def __init__(self, status_code=None, detail=None, headers=None):
        super().__init__(status_code, detail)
        self.status_code = status_code
        self.detail = detail
        self.headers = headers
class WebSocketException(Exception):
    def __init__(self, code=None, reason=None):
        super().__init__(code, reason)
        self.code = code
        self.reason = reason
class WebSocketDisconnect(Exception):
    def __init__(self, code=1000, reason=None):
        super().__init__(code, reason)
        self.code = code
        self.reason = reason

def _wanted(default, annotation):
    """What is called for a parameter: what its default says, or what stands beside its type; None where nothing does."""
    one = inspect._instance(Depends, default, getattr(annotation, '__metadata__', ()))
    if one is not None and one.dependency is None:  # the type itself
        return annotation if one is default else annotation.__origin__
    return None if one is None else one.dependency
def _value(function, default, annotation):
    wanted = _wanted(default, annotation)
    if wanted is not None:
        return _depended(wanted)
    if annotation is Request or annotation is WebSocket or annotation is BackgroundTasks:
        return annotation()
    return unknown('input', 'request')
def _called(function):
    """A request comes, or what an endpoint depends on is wanted for one."""
    return inspect._filled(function, _value)
def _asked(function):
    awaited(_called(function))
def _depended(dependency):
    if _yields(dependency):
        made = _called(dependency)
        schedule(_left, made, event='request')
        return contextlib._begin(made)
    return awaited(_called(dependency))
def _yields(dependency):
    if not (inspect.isclass(dependency) or inspect.isroutine(dependency) or isinstance(dependency, functools.partial)):
        dependency = dependency.__call__
    return inspect.isgeneratorfunction(dependency) or inspect.isasyncgenfunction(dependency)
def _left(generator):
    """The answer has been sent."""
    contextlib._end(generator, None)
async def _lives(lifespan, app):
    async with lifespan(app):
        spin()  # requests come

def _before(options):
    """What runs before an endpoint, for what it does alone."""
    for one in options.get('dependencies') or ():
        schedule(_depended, one.dependency, event='request')
def _registers(**options):
    _before(options)
    def register(function):
        schedule(_asked, function, event='request')
        return function
    return register

class APIRouter:
    def __init__(self, *args, lifespan=None, on_startup=None, on_shutdown=None, **options):
        _before(options)
        for function in (*(on_startup or ()), *(on_shutdown or ())):
            schedule(function, event='lifespan')
        if lifespan is not None:
            schedule(_lives, lifespan, self, event='lifespan')
    def get(self, path, **options):
        return _registers(**options)
    def put(self, path, **options):
        return _registers(**options)
    def post(self, path, **options):
        return _registers(**options)
    def delete(self, path, **options):
        return _registers(**options)
    def options(self, path, **options):
        return _registers(**options)
    def head(self, path, **options):
        return _registers(**options)
    def patch(self, path, **options):
        return _registers(**options)
    def trace(self, path, **options):
        return _registers(**options)
    def api_route(self, path, **options):
        return _registers(**options)
    def route(self, path, methods=None, name=None, include_in_schema=True):
        return _registers()
    def websocket(self, path, name=None, **options):
        return _registers(**options)
    def websocket_route(self, path, name=None):
        return _registers()
    def add_api_route(self, path, endpoint, **options):
        _registers(**options)(endpoint)
    def add_api_websocket_route(self, path, endpoint, name=None, **options):
        _registers(**options)(endpoint)
    def include_router(self, router, **options):
        _before(options)
    def on_event(self, event_type):
        def register(function):
            schedule(function, event='lifespan')
            return function
        return register
    def add_event_handler(self, event_type, func):
        schedule(func, event='lifespan')

class FastAPI(APIRouter):
    def __init__(self, **kwargs):
        self.state = types.SimpleNamespace()
        self.router = self
        self.dependency_overrides = {}
        _apps.append(self)
        super().__init__(**kwargs)
    def middleware(self, middleware_type):
        def register(function):
            schedule(function, Request(), _next, event='request')
            return function
        return register
    def exception_handler(self, exc_class_or_status_code):
        def register(function):
            schedule(function, Request(), unknown('input', 'exception of an endpoint'), event='request')
            return function
        return register
    def add_exception_handler(self, exc_class_or_status_code, handler):
        schedule(handler, Request(), unknown('input', 'exception of an endpoint'), event='request')
    def add_middleware(self, middleware_class, *args, **kwargs):
        return None
    def mount(self, path, app, name=None):
        return None
async def _next(request):
    return unknown('input', 'response of an endpoint')
