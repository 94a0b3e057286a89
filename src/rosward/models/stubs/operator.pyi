# SPDX-License-Identifier: Apache-2.0
"""`operator`: the operators as functions; most of them in models/python/std/numbers.py."""
from _rosward import pure, reads_only, unknown

pure(__name__)

def neg(a, /):
    return -a
def pos(a, /):
    return +a
@reads_only
def abs(a, /): ...
@reads_only
def index(a, /) -> int: ...
def setitem(a, b, c, /):
    a[b] = c
def delitem(a, b, /):
    del a[b]
@reads_only
def countOf(a, b, /) -> int: ...
@reads_only
def indexOf(a, b, /) -> int: ...
def iadd(a, b, /):
    a += b
    return a
def iconcat(a, b, /):
    a += b
    return a
def isub(a, b, /):
    a -= b
    return a
def imul(a, b, /):
    a *= b
    return a
def itruediv(a, b, /):
    a /= b
    return a
def ifloordiv(a, b, /):
    a //= b
    return a
def imod(a, b, /):
    a %= b
    return a
def ipow(a, b, /):
    a **= b
    return a
def imatmul(a, b, /):
    a @= b
    return a
def iand(a, b, /):
    a &= b
    return a
def ior(a, b, /):
    a |= b
    return a
def ixor(a, b, /):
    a ^= b
    return a
def ilshift(a, b, /):
    a <<= b
    return a
def irshift(a, b, /):
    a >>= b
    return a

class itemgetter:
    def __init__(self, item, /, *items):
        self._items = (item,) + items
    def __call__(self, obj, /):
        if len(self._items) == 1:
            return obj[self._items[0]]
        return tuple([obj[i] for i in self._items])

class attrgetter:
    def __init__(self, attr, /, *attrs):
        self._attrs = (attr,) + attrs
    def _get(self, obj, path):
        for name in path.split('.'):
            obj = getattr(obj, name)
        return obj
    def __call__(self, obj, /):
        if len(self._attrs) == 1:
            return self._get(obj, self._attrs[0])
        return tuple([self._get(obj, a) for a in self._attrs])

class methodcaller:
    def __init__(self, name, /, *args, **kwargs):
        self._name = name
        self._args = args
        self._kwargs = kwargs
    def __call__(self, obj, /):
        return getattr(obj, self._name)(*self._args, **self._kwargs)
