# SPDX-License-Identifier: Apache-2.0
"""fastapi: what is registered for a path runs with what its dependencies give; all else of a request is unknown.

Read from fastapi 0.115. What only says how a request is read, shown or answered is not here: it is unknown.
"""
from _rosward import awaited, either, schedule, unknown
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
    for one in inspect._instances(Depends, default, getattr(annotation, '__metadata__', ())):
        return one.dependency
    return None
def _value(default, annotation):
    wanted = _wanted(default, annotation)
    if wanted is not None:
        return _depended(wanted)
    if annotation is Request or annotation is WebSocket:
        return annotation()
    return unknown('input', 'request')
def _called(function):
    """A request comes, or what an endpoint depends on is wanted for one."""
    rows, _ = inspect._parameters(function, None, True)
    given, names, values = (), (), ()
    for name, kind, default, annotation in rows:
        if kind < 2:
            given = given + (_value(default, annotation),)
        elif kind == 3:
            names = names + (name,)
            values = values + (_value(default, annotation),)
    return inspect._call_with(function, given, names, values)
def _asked(function):
    awaited(_called(function))
def _depended(dependency):
    if inspect.isgeneratorfunction(dependency):
        return next(_called(dependency))
    if inspect.isasyncgenfunction(dependency):
        return awaited(_first(_called(dependency)))
    return awaited(_called(dependency))
async def _first(generator):
    async for one in generator:
        return one
async def _lives(lifespan, app):
    async with lifespan(app):
        pass

def _registers(*args, **kwargs):
    def register(function):
        schedule(_asked, function, event='request')
        return function
    return register

class APIRouter:
    def __init__(self, *args, dependencies=None, lifespan=None, on_startup=None, on_shutdown=None, **kwargs):
        for one in dependencies or ():
            schedule(_depended, one.dependency, event='request')
        for function in (*(on_startup or ()), *(on_shutdown or ())):
            schedule(function, event='lifespan')
        if lifespan is not None:
            schedule(_lives, lifespan, self, event='lifespan')
    def get(self, path, **kwargs):
        return _registers()
    def put(self, path, **kwargs):
        return _registers()
    def post(self, path, **kwargs):
        return _registers()
    def delete(self, path, **kwargs):
        return _registers()
    def options(self, path, **kwargs):
        return _registers()
    def head(self, path, **kwargs):
        return _registers()
    def patch(self, path, **kwargs):
        return _registers()
    def trace(self, path, **kwargs):
        return _registers()
    def api_route(self, path, **kwargs):
        return _registers()
    def route(self, path, methods=None, name=None, include_in_schema=True):
        return _registers()
    def websocket(self, path, name=None, *, dependencies=None):
        return _registers()
    def websocket_route(self, path, name=None):
        return _registers()
    def add_api_route(self, path, endpoint, **kwargs):
        schedule(_asked, endpoint, event='request')
    def add_api_websocket_route(self, path, endpoint, name=None, *, dependencies=None):
        schedule(_asked, endpoint, event='request')
    def include_router(self, router, **kwargs):
        for one in kwargs.get('dependencies') or ():
            schedule(_depended, one.dependency, event='request')
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
