# SPDX-License-Identifier: Apache-2.0
"""`functools`: partial application; decorators that keep the function. The rest is models/std_functional.py."""
from _rosward import either
import functools

WRAPPER_ASSIGNMENTS = ('__module__', '__name__', '__qualname__', '__doc__', '__annotations__')
WRAPPER_UPDATES = ('__dict__',)

class partialmethod:
    def __init__(self, func, /, *args, **keywords):
        self._func = func
        self._args = args
        self._keywords = keywords
    def __get__(self, obj, cls=None):
        return functools.partial(self._func, obj, *self._args, **self._keywords)

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
        return functools.partial(self, obj) if self._skip else self

def singledispatch(func):
    return _Dispatched(func, False)
def singledispatchmethod(func):
    return _Dispatched(func, True)
