# SPDX-License-Identifier: Apache-2.0
"""`functools`: partial application; decorators that keep the function. The rest is models/python/std/functional.py."""
from _rosward import either, native, reads_only
import functools

WRAPPER_ASSIGNMENTS = ('__module__', '__name__', '__qualname__', '__doc__', '__annotations__')
WRAPPER_UPDATES = ('__dict__',)

class partialmethod:
    def __init__(self, func, /, *args, **keywords):
        nested = isinstance(func, partialmethod)
        self.func = func.func if nested else func
        self.args = func.args + args if nested else args
        self.keywords = {**func.keywords, **keywords} if nested else keywords
    def __get__(self, obj, cls=None):
        bound = self.func.__get__(obj, cls) if hasattr(self.func, '__get__') else self.func
        if bound is not self.func:
            return functools.partial(bound, *self.args, **self.keywords)
        return self._call if obj is None else functools.partial(self._call, obj)
    def _call(self, first, /, *args, **keywords):
        return self.func(first, *self.args, *args, **{**self.keywords, **keywords})

class _Cached:
    """A function that is run once for each list of arguments, as long as its result is kept."""
    def __init__(self, func, maxsize):
        self._results = {}
        self._most = maxsize
        self.__wrapped__ = func
        self.__name__ = func.__name__
        self.__qualname__ = func.__qualname__
        self.__module__ = func.__module__
        self.__doc__ = func.__doc__
    def __call__(self, *args, **kwargs):
        if self._most == 0:
            return self.__wrapped__(*args, **kwargs)
        key = (args, tuple(kwargs.items()))
        if key in self._results:
            found = self._results.pop(key)
        else:
            found = self.__wrapped__(*args, **kwargs)
            if self._most is not None and len(self._results) >= self._most:
                del self._results[next(iter(self._results))]
        self._results[key] = found
        return found
    def __get__(self, obj, cls=None):
        return self if obj is None else functools.partial(self, obj)
    def cache_clear(self):
        self._results = {}
    @reads_only
    def cache_info(self): ...
    @reads_only
    def cache_parameters(self) -> dict: ...

def cache(user_function, /):
    return _Cached(user_function, None)
def lru_cache(maxsize=128, typed=False):
    if callable(maxsize):
        return _Cached(maxsize, 128)
    return functools.partial(_kept, maxsize)
def _kept(maxsize, func):
    return _Cached(func, maxsize)

class _Key:
    """What objects are ordered by: a function of two of them."""
    def __init__(self, mycmp, obj):
        self._compare = mycmp
        self.obj = obj
    def __lt__(self, other):
        return self._compare(self.obj, other.obj) < 0
    def __gt__(self, other):
        return self._compare(self.obj, other.obj) > 0
    def __eq__(self, other):
        return self._compare(self.obj, other.obj) == 0
    def __le__(self, other):
        return self._compare(self.obj, other.obj) <= 0
    def __ge__(self, other):
        return self._compare(self.obj, other.obj) >= 0
def cmp_to_key(mycmp):
    return functools.partial(_Key, mycmp)

@native
def _classes(cls, skip): ...
@native
def _choose(registered, functions, value): ...

class _Dispatched:
    """A function with one body for each type of its first argument; `_registered` are pairs of class and function."""
    def __init__(self, func, skip):
        self._registered = [(object, func)]
        self._functions = [func]
        self._skip = skip
        self.func = func
        self.__name__ = func.__name__
        self.__doc__ = func.__doc__
    def register(self, cls, func=None):
        if func is None and isinstance(cls, type):
            return functools.partial(self.register, cls)
        if func is None:
            func = cls
        for one in _classes(cls, self._skip):
            self._registered.append((one, func))
        self._functions.append(func)
        return func
    def dispatch(self, cls):
        return either(*self._functions)
    def __call__(self, *args, **kwargs):
        return _choose(self._registered, self._functions, args[0])(*args, **kwargs)

class _DispatchedMethod(_Dispatched):
    def __get__(self, obj, cls=None):
        def method(*args, **kwargs):
            return _choose(self._registered, self._functions, args[0])(obj, *args, **kwargs)
        return method

def singledispatch(func):
    return _Dispatched(func, False)
def singledispatchmethod(func):
    return _DispatchedMethod(func, True)
