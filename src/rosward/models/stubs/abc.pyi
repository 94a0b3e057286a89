# SPDX-License-Identifier: Apache-2.0
"""`abc`: a class with a method that is marked as abstract has no objects."""

from _rosward import register

class ABCMeta(type):
    def register(cls, subclass):
        register(cls, subclass)
        return subclass
class ABC(metaclass=ABCMeta): ...

def abstractmethod(funcobj):
    funcobj.__isabstractmethod__ = True
    return funcobj
def abstractproperty(fget=None, fset=None, fdel=None, doc=None):
    return property(abstractmethod(fget))
def abstractclassmethod(funcobj):
    return classmethod(abstractmethod(funcobj))
def abstractstaticmethod(funcobj):
    return staticmethod(abstractmethod(funcobj))
def update_abstractmethods(cls):
    return cls
