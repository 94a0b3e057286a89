# SPDX-License-Identifier: Apache-2.0
"""`functools`: partial application; decorators that keep the function."""
from _rosward import either, native

WRAPPER_ASSIGNMENTS = ('__module__', '__name__', '__qualname__', '__doc__', '__annotations__')
WRAPPER_UPDATES = ('__dict__',)

@native
def partial(func, /, *args, **keywords): ...
@native
def wraps(wrapped, assigned=WRAPPER_ASSIGNMENTS, updated=WRAPPER_UPDATES): ...
@native
def update_wrapper(wrapper, wrapped, assigned=WRAPPER_ASSIGNMENTS, updated=WRAPPER_UPDATES): ...
@native
def total_ordering(cls): ...
@native
def lru_cache(maxsize=128, typed=False): ...
@native
def cache(user_function, /): ...
@native
def cmp_to_key(mycmp): ...
@native
def cached_property(func): ...
@native
def reduce(function, iterable, initial=None, /): ...
@native
def _same(value): ...

class partialmethod:
    def __init__(self, func, /, *args, **keywords):
        self._func = func
        self._args = args
        self._keywords = keywords
    def __get__(self, obj, cls=None):
        return partial(self._func, obj, *self._args, **self._keywords)

class _Dispatched:
    """A function with one body for each type of its first argument; any of them may run."""
    def __init__(self, func, skip):
        self._functions = [func]
        self._skip = skip
    def register(self, cls, func=None):
        if func is not None:
            self._functions.append(func)
            return func
        if isinstance(cls, type):
            return self._add
        return self._add(cls)
    def _add(self, func):
        self._functions.append(func)
        return func
    def dispatch(self, cls):
        return either(*self._functions)
    def __call__(self, *args, **kwargs):
        return either(*self._functions)(*args, **kwargs)
    def __get__(self, obj, cls=None):
        return partial(self, obj) if self._skip else self

def singledispatch(func):
    return _Dispatched(func, False)
def singledispatchmethod(func):
    return _Dispatched(func, True)
