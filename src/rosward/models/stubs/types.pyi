# SPDX-License-Identifier: Apache-2.0
"""`types`: namespaces and names of kinds."""
from _rosward import native, reads_only

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
class FunctionType: ...
class LambdaType: ...
@reads_only
class ModuleType:
    def __init__(self, name, doc=None): ...
class TracebackType: ...
class GeneratorType: ...
class CoroutineType: ...
class BuiltinFunctionType: ...
class GenericAlias: ...
class UnionType: ...
NoneType = type(None)
