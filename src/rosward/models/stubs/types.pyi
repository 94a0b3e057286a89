# SPDX-License-Identifier: Apache-2.0
"""`types`: namespaces and names of kinds."""
from _rosward import native, reads_only, unknown

class SimpleNamespace:
    def __init__(self, /, **kwargs):
        for name in kwargs:
            setattr(self, name, kwargs[name])

@native
def _method(function, instance): ...

class MethodType:
    def __new__(cls, function, instance, /):
        return _method(function, instance)
def MappingProxyType(mapping):
    return mapping
def new_class(name, bases=(), kwds=None, exec_body=None):
    given = dict(kwds or {})
    metaclass = given.pop('metaclass', type(bases[0]) if bases else type)
    names = metaclass.__prepare__(name, tuple(bases), **given)
    if exec_body is not None:
        exec_body(names)
    return metaclass(name, tuple(bases), names, **given)
@native
def _function(code, module, name, defaults, closure): ...

class FunctionType:
    def __new__(cls, code, globals, name=None, argdefs=None, closure=None, kwdefaults=None):
        return _function(code, globals, name, argdefs, closure)
LambdaType = FunctionType
class ModuleType:
    def __init__(self, name, doc=None):
        self.__name__ = name
        self.__doc__ = doc
    def __getattr__(self, name):
        own = self.__dict__
        if '__getattr__' in own:
            return own['__getattr__'](name)
        return unknown('call', f'types.ModuleType.{name}')
class TracebackType: ...
class GeneratorType: ...
class CoroutineType: ...
class BuiltinFunctionType: ...
class GenericAlias: ...
class UnionType: ...
NoneType = type(None)
