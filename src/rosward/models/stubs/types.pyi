# SPDX-License-Identifier: Apache-2.0
"""`types`: namespaces and names of kinds."""
from _rosward import reads_only
from functools import partial

class SimpleNamespace:
    def __init__(self, /, **kwargs):
        for name in kwargs:
            setattr(self, name, kwargs[name])

def MethodType(function, instance, /):
    return partial(function, instance)
def MappingProxyType(mapping):
    return mapping
def new_class(name, bases=(), kwds=None, exec_body=None):
    body = {}
    if exec_body is not None:
        exec_body(body)
    return type(name, tuple(bases), body)
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
