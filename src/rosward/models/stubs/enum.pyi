# SPDX-License-Identifier: Apache-2.0
"""`enum`: see models/python/std/enums.py for how members are made and found. Up to Python 3.10, of humble and iron, they are written otherwise."""
from _rosward import native, reads_only

@native
def _make_class(base, name, names, kind, start): ...

@native
def _since(distro) -> bool:
    """Whether the analysis is for `distro` or a later one."""
@native
def auto(value=None): ...
def unique(enumeration):
    return enumeration
def verify(*conditions):
    return unique
property = property
class member:
    def __init__(self, value):
        self.value = value
class nonmember:
    def __init__(self, value):
        self.value = value

@native
def _item(cls, name): ...
@native
def _iterate(cls): ...
@native
def _length(cls): ...
@native
def _lookup(cls, value): ...

class EnumType(type):
    """What a metaclass of the program may ask for by `super()`; of enumerations without one, the engine asks the models itself."""
    def __bool__(cls):
        return True
    def __call__(cls, value, *args, **kwds):
        return _lookup(cls, value)
    def __contains__(cls, value):
        return value in _iterate(cls)
    def __getitem__(cls, name):
        return _item(cls, name)
    def __iter__(cls):
        return iter(_iterate(cls))
    def __len__(cls):
        return _length(cls)
    def __reversed__(cls):
        return reversed(_iterate(cls))
EnumMeta = EnumType

class Enum(metaclass=EnumType):
    def __new__(cls, value, names=None, *, module=None, qualname=None, type=None, start=1, boundary=None):
        return _make_class(cls, value, names, type, start)
    def __str__(self):
        return type(self).__name__ + '.' + self.name
    def __repr__(self):
        return '<' + type(self).__name__ + '.' + self._name_ + ': ' + repr(self._value_) + '>'
    @reads_only
    def __hash__(self) -> int: ...
    def __copy__(self):
        return self
    def __deepcopy__(self, memo):
        return self
    def __format__(self, spec):
        if not _since('jazzy') and isinstance(self, (int, str, float, bytes)) and type(self).__str__ in _SHOW:
            return format(self._value_, spec)
        return format(str(self), spec)
class ReprEnum(Enum):
    def __str__(self):
        return str(self._value_) if _since('jazzy') else Enum.__str__(self)
    def __format__(self, spec):
        if not _since('jazzy'):
            return Enum.__format__(self, spec)
        return format(self._value_, spec) if spec else str(self)
class IntEnum(ReprEnum, int): ...
class StrEnum(ReprEnum, str):
    def __str__(self):
        return self._value_
@reads_only
class Flag(Enum):
    def __iter__(self):
        for member in type(self):
            if member._value_ & self._value_:
                yield member
    def __repr__(self) -> str: ...
    def __contains__(self, other):
        return other._value_ & self._value_ == other._value_
    def __invert__(self): ...
@reads_only
class IntFlag(ReprEnum, Flag, int):
    def __contains__(self, other):
        return Flag.__contains__(self, other)
    def __invert__(self) -> int: ...

_SHOW = (Enum.__str__, ReprEnum.__str__)
CONTINUOUS = 'no skipped integer values'
NAMED_FLAGS = 'multi-flag aliases may not contain unnamed flags'
UNIQUE = 'one name per value'
