# SPDX-License-Identifier: Apache-2.0
"""`typing`: without effect when the program runs; annotations are kept as text."""
from _rosward import native, reads_only
from collections import _NamedTuple, _make_named_tuple, _name_fields
from collections import OrderedDict as OrderedDict
from collections import defaultdict as DefaultDict
from collections import deque as Deque
from collections import Counter as Counter
from collections import ChainMap as ChainMap

TYPE_CHECKING = False

@native
def _form_of(tp): ...

class _Form:
    """Anything that is only subscripted, called or combined."""
    def __class_getitem__(cls, item):
        return cls
    def __getitem__(self, item):
        return self
    def __or__(self, other):
        return Union[self, other]
    def __ror__(self, other):
        return Union[other, self]
    def __call__(self, *args, **kwargs):
        return self

class _Annotated(_Form):
    """`Annotated[…]` that stands behind a name."""
    def __init__(self, origin, metadata):
        self.__origin__ = origin
        self.__metadata__ = metadata
class _MakesAnnotated(_Form):
    def __getitem__(self, item):
        if _form_of(item[0]) == '_Annotated':
            return _Annotated(item[0].__origin__, (*item[0].__metadata__, *item[1:]))
        return _Annotated(item[0], item[1:])
class _Union(_Form):
    """`Union[…]` or `Optional[…]`, with what is in the brackets."""
    def __init__(self, origin, args):
        self.__origin__ = origin
        self.__args__ = args
    def __eq__(self, other):
        return _form_of(other) == _form_of(self) and set(other.__args__) == set(self.__args__)
class _Literal(_Union):
    """`Literal[…]`, with what is in the brackets."""
def _flat(item, form):
    """What is in the brackets, with what is in those of its own kind there."""
    found = []
    for each in item if isinstance(item, tuple) else (item,):
        found += each.__args__ if _form_of(each) == form else (each,)
    return found
class _MakesLiteral(_Form):
    def __getitem__(self, item):
        found = []
        for each in _flat(item, '_Literal'):
            if not any([type(each) is type(other) and each == other for other in found]):
                found.append(each)
        return _Literal(self, tuple(found))
class _MakesUnion(_Form):
    def __getitem__(self, item):
        found = []
        for each in _flat(item, '_Union'):
            each = type(None) if each is None else each
            if each not in found:
                found.append(each)
        return _Union(self, tuple(found)) if len(found) > 1 else found[0]
class _MakesOptional(_Form):
    def __getitem__(self, item):
        return Union[item, None]

class Generic:
    def __class_getitem__(cls, item):
        return cls
class Protocol:
    def __class_getitem__(cls, item):
        return cls

class NamedTuple(_NamedTuple):
    def __init_subclass__(cls):
        if NamedTuple in cls.__bases__:
            _name_fields(cls)
    def __new__(cls, *args, **kwargs):
        if cls is NamedTuple:
            return _make_named_tuple(_NamedTuple, args[0], args[1] if len(args) > 1 else list(kwargs), None)
        return _NamedTuple.__new__(cls, *args, **kwargs)

class TypedDict:
    def __new__(cls, *args, **kwargs):
        return dict(*args, **kwargs)

def TypeVar(name, *constraints, bound=None, covariant=False, contravariant=False):
    return _Form()
def ParamSpec(name, *, bound=None, covariant=False, contravariant=False):
    return _Form()
def TypeVarTuple(name):
    return _Form()
def NewType(name, tp):
    return tp
def cast(typ, val):
    return val
def overload(func):
    return func
def final(f):
    return f
def override(method, /):
    return method
def no_type_check(arg):
    return arg
def runtime_checkable(cls):
    return cls
def assert_type(val, typ, /):
    return val
def reveal_type(obj, /):
    return obj
@reads_only
def assert_never(arg, /): ...
@native
def _hints(obj, extras): ...
@reads_only
def _other_hints(obj) -> dict: ...
def get_type_hints(obj, globalns=None, localns=None, include_extras=False):
    return _other_hints(obj) if globalns or localns else _hints(obj, include_extras)
@reads_only
def _origin(tp): ...
def get_origin(tp):
    form = _form_of(tp)
    if form == '_Annotated':
        return Annotated
    if form in ('_Union', '_Literal'):
        return tp.__origin__
    return None if form == 'bare' else _origin(tp)
@reads_only
def _args(tp): ...
def get_args(tp):
    form = _form_of(tp)
    if form == '_Annotated':
        return (tp.__origin__, *tp.__metadata__)
    if form in ('_Union', '_Literal'):
        return tp.__args__
    return () if form == 'bare' else _args(tp)
def dataclass_transform(*, eq_default=True, order_default=False, kw_only_default=False, field_specifiers=(), **kwargs):
    def decorate(cls):
        return cls
    return decorate

Dict = dict
List = list
Set = set
FrozenSet = frozenset
Tuple = tuple
Type = type
Text = str
Any = _Form()
Optional = _MakesOptional()
Union = _MakesUnion()
Callable = _Form()
Iterable = _Form()
Iterator = _Form()
Sequence = _Form()
Mapping = _Form()
MutableMapping = _Form()
MutableSequence = _Form()
Generator = _Form()
AsyncGenerator = _Form()
AsyncIterator = _Form()
AsyncIterable = _Form()
Awaitable = _Form()
Coroutine = _Form()
Literal = _MakesLiteral()
ClassVar = _Form()
Final = _Form()
Annotated = _MakesAnnotated()
Self = _Form()
Never = _Form()
NoReturn = _Form()
LiteralString = _Form()
Concatenate = _Form()
TypeAlias = _Form()
TypeGuard = _Form()
Required = _Form()
NotRequired = _Form()
Unpack = _Form()
IO = _Form()
TextIO = _Form()
BinaryIO = _Form()
AnyStr = _Form()
Hashable = _Form()
Sized = _Form()
Collection = _Form()
Container = _Form()
Reversible = _Form()
SupportsInt = _Form()
SupportsFloat = _Form()
SupportsIndex = _Form()
SupportsAbs = _Form()
ContextManager = _Form()
AsyncContextManager = _Form()
AbstractSet = _Form()
MutableSet = _Form()
KeysView = _Form()
ValuesView = _Form()
ItemsView = _Form()
Pattern = _Form()
Match = _Form()
ByteString = _Form()
