# SPDX-License-Identifier: Apache-2.0
"""`abc`: abstract methods are methods."""

from _rosward import register

class ABCMeta(type):
    def register(cls, subclass):
        register(cls, subclass)
        return subclass
class ABC(metaclass=ABCMeta): ...

def abstractmethod(funcobj):
    return funcobj
def abstractproperty(fget=None, fset=None, fdel=None, doc=None):
    return property(fget)
def abstractclassmethod(funcobj):
    return classmethod(funcobj)
def abstractstaticmethod(funcobj):
    return staticmethod(funcobj)
def update_abstractmethods(cls):
    return cls
