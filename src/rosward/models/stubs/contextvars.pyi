# SPDX-License-Identifier: Apache-2.0
"""`contextvars`: a variable has the value that was set last; once there are several contexts or threads, any that was ever set."""
from _rosward import either
from queue import _alone

_MISSING = object()

class _Contexts:
    several = False

class Token:
    MISSING = _MISSING
    def __init__(self, var, old_value):
        self.var = var
        self.old_value = old_value

class ContextVar:
    def __init__(self, name, *, default=_MISSING):
        self.name = name
        self._default = default
        self._value = _MISSING
        self._all = []
    def __class_getitem__(cls, item):
        return cls
    def get(self, default=_MISSING, /):
        unset = self._default if default is _MISSING else default
        if _Contexts.several or not _alone():
            found = [*self._all] if unset is _MISSING else [*self._all, unset]
            if found:
                return either(*found)
        if self._value is not _MISSING:
            return self._value
        if unset is not _MISSING:
            return unset
        raise LookupError(self)
    def set(self, value, /):
        token = Token(self, self._value)
        self._value = value
        self._all.append(value)
        return token
    def reset(self, token, /):
        self._value = token.old_value

class Context:
    def run(self, callable, *args, **kwargs):
        _Contexts.several = True
        return callable(*args, **kwargs)
    def copy(self):
        return Context()

def copy_context():
    return Context()
