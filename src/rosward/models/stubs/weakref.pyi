# SPDX-License-Identifier: Apache-2.0
"""`weakref`: a reference is the object that it refers to, or None: how long that lives is not known."""

from _rosward import either, reads_only, schedule

class ref:
    def __init__(self, o, callback=None, /):
        self._object = o
        if callback is not None:
            schedule(callback, self, event="end of an object")
    def __class_getitem__(cls, item):
        return cls
    def __call__(self):
        return either(self._object, None)
class WeakMethod(ref): ...
ReferenceType = ref

def proxy(object, callback=None, /):
    if callback is not None:
        schedule(callback, object, event="end of an object")
    return object
class finalize:
    def __init__(self, obj, func, /, *args, **kwargs):
        self._func = func
        self._args = args
        self._kwargs = kwargs
        schedule(self, event="end of an object")
    def __call__(self, _=None):
        return self._func(*self._args, **self._kwargs)
    @reads_only
    def detach(self): ...
WeakValueDictionary = dict
WeakKeyDictionary = dict
WeakSet = set
