# SPDX-License-Identifier: Apache-2.0
"""`inspect`: questions only."""
from enum import IntEnum
from _rosward import native, reads_only

reads_only(__name__)

@native
def _kind_of(object): ...

@native
def _yields_awaited(function): ...
@native
def _yields(function) -> bool: ...
@native
def _awaits(function) -> bool: ...

def isclass(object):
    return _kind_of(object) == 'class'
def isfunction(object):
    return _kind_of(object) == 'function'
def ismethod(object):
    return _kind_of(object) == 'method'
def isroutine(object):
    return _kind_of(object) in ('function', 'method', 'builtin')
def ismodule(object):
    return _kind_of(object) == 'module'
def isgenerator(object) -> bool: ...
def iscoroutine(object) -> bool: ...
def iscoroutinefunction(obj):
    return _kind_of(obj) in ('function', 'method', 'partial') and _awaits(obj)
def isgeneratorfunction(obj):
    return _kind_of(obj) in ('function', 'method', 'partial') and _yields(obj)
def isasyncgenfunction(obj):
    return _kind_of(obj) in ('function', 'method', 'partial') and _yields_awaited(obj)
def isasyncgen(object) -> bool: ...
def isdatadescriptor(object) -> bool: ...
def ismethoddescriptor(object) -> bool: ...
def isawaitable(object) -> bool: ...
def isabstract(object) -> bool: ...
def isbuiltin(object):
    return _kind_of(object) == 'builtin'
def getmembers(object, predicate=None):
    found = []
    for name in dir(object):
        member = getattr(object, name)
        if predicate is None or predicate(member):
            found.append((name, member))
    return found
@native
def _filled(function, fill): ...
@native
def _instance(cls, value, beside): ...
@native
def _parameters(obj, empty, follow, evaluate): ...

class _empty: ...

class _ParameterKind(IntEnum):
    POSITIONAL_ONLY = 0
    POSITIONAL_OR_KEYWORD = 1
    VAR_POSITIONAL = 2
    KEYWORD_ONLY = 3
    VAR_KEYWORD = 4
    def __str__(self):
        return self.name

class Parameter:
    empty = _empty
    POSITIONAL_ONLY = _ParameterKind.POSITIONAL_ONLY
    POSITIONAL_OR_KEYWORD = _ParameterKind.POSITIONAL_OR_KEYWORD
    VAR_POSITIONAL = _ParameterKind.VAR_POSITIONAL
    KEYWORD_ONLY = _ParameterKind.KEYWORD_ONLY
    VAR_KEYWORD = _ParameterKind.VAR_KEYWORD
    def __init__(self, name, kind, *, default=_empty, annotation=_empty):
        self.name = name
        self.kind = kind
        self.default = default
        self.annotation = annotation
    @reads_only
    def replace(self, **changes): ...

class Signature:
    empty = _empty
    def __init__(self, parameters=None, *, return_annotation=_empty, __validate_parameters__=True):
        self.parameters = {one.name: one for one in parameters or ()}
        self.return_annotation = return_annotation
    @reads_only
    def bind(self, *args, **kwargs): ...
    @reads_only
    def bind_partial(self, *args, **kwargs): ...
    @reads_only
    def replace(self, **changes): ...

def signature(obj, *, follow_wrapped=True, globals=None, locals=None, eval_str=False):
    rows, result = _parameters(obj, _empty, follow_wrapped, eval_str)
    made = [Parameter(name, _ParameterKind(kind), default=default, annotation=note) for name, kind, default, note in rows]
    return Signature(made, return_annotation=result)
def getfullargspec(func): ...
def getmro(cls):
    return cls.__mro__
def unwrap(func, *, stop=None):
    while hasattr(func, '__wrapped__') and not (stop is not None and stop(func)):
        func = func.__wrapped__
    return func
def getsource(object) -> str: ...
def getsourcefile(object) -> str: ...
def getfile(object) -> str: ...
def getmodule(object, _filename=None): ...
def getdoc(object) -> str: ...
def stack(context=1): ...
def currentframe(): ...
def getframeinfo(frame, context=1): ...
