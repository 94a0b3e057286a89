# SPDX-License-Identifier: Apache-2.0
"""`collections`: over lists and dicts of the program."""
import sys
from _rosward import either, native, reads_only, unknown
from collections.abc import MutableMapping, MutableSequence, Sequence

def _writes_as_dict(instance):
    return type(instance).__setitem__ is dict.__setitem__

class OrderedDict(dict):
    """A dict that stores by `self[key] = value` whatever comes in, where a subclass says what that does."""
    def __init__(self, other=(), /, **kwargs):
        OrderedDict.update(self, other, **kwargs)
    def update(self, other=(), /, **kwargs):
        if _writes_as_dict(self):
            dict.update(self, other, **kwargs)
            return
        MutableMapping.update(self, other, **kwargs)
    def setdefault(self, key, default=None):
        if _writes_as_dict(self):
            return dict.setdefault(self, key, default)
        if key in self:
            return self[key]
        self[key] = default
        return default
    def copy(self):
        found = type(self)()
        for key in self:
            found[key] = self[key]
        return found
    def __copy__(self):
        return self.copy()
    def __or__(self, other):
        found = type(self)(self)
        OrderedDict.update(found, other)
        return found
    def __ror__(self, other):
        found = type(self)(other)
        OrderedDict.update(found, self)
        return found
    def __ior__(self, other):
        OrderedDict.update(self, other)
        return self
    def popitem(self, last=True):
        if not len(self):
            raise KeyError('dictionary is empty')
        key = list(dict.keys(self))[-1 if last else 0]
        return (key, dict.pop(self, key))
    def move_to_end(self, key, last=True):
        value = dict.pop(self, key)
        if last:
            dict.__setitem__(self, key, value)
        else:
            others = dict(dict.items(self))
            dict.clear(self)
            dict.__setitem__(self, key, value)
            dict.update(self, others)

@native
def _name_fields(cls): ...
@native
def _make_named_tuple(base, typename, field_names, defaults): ...
@native
def _fill(instance, args, keywords): ...
@native
def _items(instance): ...
@native
def _keys(instance): ...

class _NamedTuple:
    """What a named tuple does; its fields are found by the class."""
    def __new__(cls, *args, **kwargs):
        self = object.__new__(cls)
        _fill(self, args, kwargs)
        return self
    def __iter__(self):
        return iter(_items(self))
    def __len__(self):
        return len(_items(self))
    def __getitem__(self, index):
        return _items(self)[index]
    def __eq__(self, other):
        return _items(self) == (_items(other) if isinstance(other, _NamedTuple) else other)
    def __hash__(self):
        return hash(_items(self))
    def __lt__(self, other):
        return tuple(self) < tuple(other)
    def __contains__(self, value):
        return value in _items(self)
    def __add__(self, other):
        return _items(self) + tuple(other)
    @reads_only
    def __repr__(self) -> str: ...
    def _asdict(self):
        return dict(zip(_keys(self), _items(self)))
    def _replace(self, **kwargs):
        return _NamedTuple.__new__(type(self), **{**self._asdict(), **kwargs})
    @classmethod
    def _make(cls, iterable):
        return _NamedTuple.__new__(cls, *iterable)
    def index(self, value):
        return _items(self).index(value)
    def count(self, value):
        return _items(self).count(value)

def namedtuple(typename, field_names, *, rename=False, defaults=None, module=None):
    return _make_named_tuple(_NamedTuple, typename, field_names, defaults)

class _Dict:
    """A mapping over a dict of its own."""
    def __init__(self, *args, **kwargs):
        self._dict = dict(*args, **kwargs)
    def __getitem__(self, key):
        return self._dict[key]
    def __setitem__(self, key, value):
        self._dict[key] = value
    def __delitem__(self, key):
        del self._dict[key]
    def __contains__(self, key):
        return key in self._dict
    def __iter__(self):
        return iter(self._dict)
    def __len__(self):
        return len(self._dict)
    def __eq__(self, other):
        return self._dict == (other._dict if isinstance(other, _Dict) else other)
    def keys(self):
        return self._dict.keys()
    def values(self):
        return self._dict.values()
    def items(self):
        return self._dict.items()
    def get(self, key, default=None):
        return self._dict.get(key, default)
    def pop(self, key, *default):
        return self._dict.pop(key, *default)
    def popitem(self):
        return self._dict.popitem()
    def setdefault(self, key, default=None):
        return self._dict.setdefault(key, default)
    def update(self, *args, **kwargs):
        self._dict.update(*args, **kwargs)
    def clear(self):
        self._dict.clear()

class UserDict(MutableMapping):
    def __init__(self, dict=None, /, **kwargs):
        self.data = {}
        if dict is not None:
            self.update(dict)
        if kwargs:
            self.update(kwargs)
    def __len__(self):
        return len(self.data)
    def __getitem__(self, key):
        if key in self.data:
            return self.data[key]
        return self.__missing__(key)
    def __missing__(self, key):
        raise KeyError(key)
    def __setitem__(self, key, value):
        self.data[key] = value
    def __delitem__(self, key):
        del self.data[key]
    def __iter__(self):
        return iter(self.data)
    def __contains__(self, key):
        return key in self.data
    def get(self, key, default=None):
        if key in self or sys.version_info < (3, 12):  # before that, the one of Mapping: it asks `__missing__`
            try:
                return self[key]
            except KeyError:
                return default
        return default
    def __or__(self, other):
        return type(self)(self.data | (other.data if isinstance(other, UserDict) else other))
    def __ior__(self, other):
        self.data |= other.data if isinstance(other, UserDict) else other
        return self
    def copy(self):
        found = type(self).__new__(type(self))
        found.__dict__.update(self.__dict__)
        found.data = self.data.copy()
        return found
    @classmethod
    def fromkeys(cls, iterable, value=None):
        found = cls()
        for key in iterable:
            found[key] = value
        return found

class defaultdict(_Dict):
    def __new__(cls, *args, **kwargs):
        self = object.__new__(cls)
        self.default_factory = None
        self._dict = {}
        return self
    def __init__(self, default_factory=None, /, *args, **kwargs):
        self.default_factory = default_factory
        self._dict = dict(*args, **kwargs)
    def __getitem__(self, key):
        if key not in self._dict:
            return self.__missing__(key)
        return self._dict[key]
    def __missing__(self, key):
        if self.default_factory is None:
            raise KeyError(key)
        self._dict[key] = self.default_factory()
        return self._dict[key]
    def copy(self):
        return defaultdict(self.default_factory, self._dict)

class Counter(_Dict):
    def __new__(cls, *args, **kwargs):
        self = object.__new__(cls)
        self._dict = {}
        return self
    def __init__(self, iterable=None, /, **kwds):
        self._dict = {}
        self._count(iterable, 1)
        self._count(kwds, 1)
    def __getitem__(self, key):
        return self._dict.get(key, 0)
    def _count(self, iterable, sign):
        if iterable is None:
            return
        if hasattr(iterable, 'keys'):
            for key in iterable.keys():
                self._dict[key] = self._dict.get(key, 0) + sign * iterable[key]
        else:
            for key in iterable:
                self._dict[key] = self._dict.get(key, 0) + sign
    def update(self, iterable=None, /, **kwds):
        self._count(iterable, 1)
        self._count(kwds, 1)
    def subtract(self, iterable=None, /, **kwds):
        self._count(iterable, -1)
        self._count(kwds, -1)
    def elements(self):
        return iter([key for key in self._dict for _ in range(self._dict[key])])
    def total(self):
        return sum(self._dict.values())
    def most_common(self, n=None):
        found = sorted(self._dict.items(), key=lambda pair: pair[1], reverse=True)
        return found if n is None else found[:n]
    def copy(self):
        return Counter(self)
    def _with(self, other, combine):
        found = Counter()
        for key in [*self._dict, *[key for key in other if key not in self._dict]]:
            count = combine(self[key], other[key])
            if count > 0:
                found._dict[key] = count
        return found
    def __add__(self, other):
        return self._with(other, lambda a, b: a + b)
    def __sub__(self, other):
        return self._with(other, lambda a, b: a - b)
    def __or__(self, other):
        return self._with(other, lambda a, b: max(a, b))
    def __and__(self, other):
        return self._with(other, lambda a, b: min(a, b))
    def __pos__(self):
        return self._with(Counter(), lambda a, b: a)

class ChainMap(_Dict):
    def __init__(self, *maps):
        self.maps = list(maps) or [{}]
    @property
    def _dict(self):
        merged = {}
        for one in reversed(self.maps):
            merged.update(one)
        return merged
    def __setitem__(self, key, value):
        self.maps[0][key] = value
    def new_child(self, m=None, **kwargs):
        return ChainMap({} if m is None else m, *self.maps)
    @property
    def parents(self):
        return ChainMap(*self.maps[1:])

class deque:
    def __new__(cls, *args, **kwargs):
        self = object.__new__(cls)
        self.maxlen = None
        self._list = []
        return self
    def __init__(self, iterable=(), maxlen=None):
        self.maxlen = maxlen
        self._list = list(iterable)
        deque._drop(self)
    def append(self, x, /):
        self._list.append(x)
        if self.maxlen is not None and len(self._list) > self.maxlen:
            self._list.pop(0)
    def appendleft(self, x, /):
        self._list.insert(0, x)
        if self.maxlen is not None and len(self._list) > self.maxlen:
            self._list.pop()
    def _drop(self):
        if self.maxlen is not None:
            del self._list[:max(0, len(self._list) - self.maxlen)]
    def extend(self, iterable, /):
        self._list.extend(iterable)
        deque._drop(self)
    def extendleft(self, iterable, /):
        for value in iterable:
            deque.appendleft(self, value)
    def pop(self):
        return self._list.pop()
    def popleft(self):
        return self._list.pop(0)
    def insert(self, i, x, /):
        self._list.insert(i, x)
    def remove(self, value, /):
        self._list.remove(value)
    def rotate(self, n=1, /):
        if self._list:
            split = -n % len(self._list)
            self._list = self._list[split:] + self._list[:split]
    def reverse(self):
        self._list.reverse()
    def clear(self):
        self._list.clear()
    def copy(self):
        return deque(self._list, self.maxlen)
    def count(self, value, /):
        return self._list.count(value)
    def index(self, value, *args):
        return self._list.index(value, *args)
    def __getitem__(self, index):
        return self._list[index]
    def __setitem__(self, index, value):
        self._list[index] = value
    def __delitem__(self, index):
        del self._list[index]
    def __iter__(self):
        return iter(self._list)
    def __reversed__(self):
        return reversed(self._list)
    def __len__(self):
        return len(self._list)
    def __contains__(self, value):
        return value in self._list
    def __eq__(self, other):
        return isinstance(other, deque) and self._list == other._list
    def __add__(self, other):
        return deque(self._list + list(other), self.maxlen)
    def __iadd__(self, other):
        self.extend(other)
        return self

def _data(value):
    return value.data if isinstance(value, (UserList, UserString)) else value

class UserList(MutableSequence):
    def __init__(self, initlist=None):
        self.data = []
        if initlist is not None:
            self.data = list(_data(initlist))
    def __repr__(self):
        return repr(self.data)
    def __eq__(self, other):
        return self.data == _data(other)
    def __lt__(self, other):
        return self.data < _data(other)
    def __le__(self, other):
        return self.data <= _data(other)
    def __gt__(self, other):
        return self.data > _data(other)
    def __ge__(self, other):
        return self.data >= _data(other)
    def __contains__(self, item):
        return item in self.data
    def __len__(self):
        return len(self.data)
    def __iter__(self):
        if type(self).__getitem__ is UserList.__getitem__:
            return iter(self.data)
        return MutableSequence.__iter__(self)
    def __getitem__(self, i):
        return type(self)(self.data[i]) if isinstance(i, slice) else self.data[i]
    def __setitem__(self, i, item):
        self.data[i] = item
    def __delitem__(self, i):
        del self.data[i]
    def __add__(self, other):
        return type(self)(self.data + list(_data(other)))
    def __radd__(self, other):
        return type(self)(list(_data(other)) + self.data)
    def __iadd__(self, other):
        self.data += _data(other)
        return self
    def __mul__(self, n):
        return type(self)(self.data * n)
    __rmul__ = __mul__
    def __imul__(self, n):
        self.data *= n
        return self
    def append(self, item):
        self.data.append(item)
    def insert(self, i, item):
        self.data.insert(i, item)
    def pop(self, i=-1):
        return self.data.pop(i)
    def remove(self, item):
        self.data.remove(item)
    def clear(self):
        self.data.clear()
    def copy(self):
        return type(self)(self)
    def count(self, item):
        return self.data.count(item)
    def index(self, item, *args):
        return self.data.index(item, *args)
    def reverse(self):
        self.data.reverse()
    def sort(self, /, *args, **kwds):
        self.data.sort(*args, **kwds)
    def extend(self, other):
        self.data.extend(_data(other))

class UserString(Sequence):
    def __init__(self, seq):
        self.data = str(_data(seq))
    def __str__(self):
        return self.data
    def __repr__(self):
        return repr(self.data)
    def __hash__(self):
        return hash(self.data)
    def __int__(self):
        return int(self.data)
    def __float__(self):
        return float(self.data)
    def __eq__(self, other):
        return self.data == _data(other)
    def __lt__(self, other):
        return self.data < _data(other)
    def __contains__(self, part):
        return _data(part) in self.data
    def __len__(self):
        return len(self.data)
    def __iter__(self):
        return map(type(self), self.data)
    def __getitem__(self, i):
        return type(self)(self.data[i])
    def __add__(self, other):
        return type(self)(self.data + str(_data(other)))
    def __radd__(self, other):
        return type(self)(str(_data(other)) + self.data)
    def __mul__(self, n):
        return type(self)(self.data * n)
    __rmul__ = __mul__
    def __mod__(self, args):
        return type(self)(self.data % args)
    def format(self, /, *args, **kwds):
        return self.data.format(*args, **kwds)
    def encode(self, encoding='utf-8', errors='strict'):
        return self.data.encode(encoding, errors)
    def join(self, seq):
        return self.data.join(seq)
    def split(self, sep=None, maxsplit=-1):
        return self.data.split(sep, maxsplit)
    def rsplit(self, sep=None, maxsplit=-1):
        return self.data.rsplit(sep, maxsplit)
    def splitlines(self, keepends=False):
        return self.data.splitlines(keepends)
    def partition(self, sep):
        return self.data.partition(sep)
    def rpartition(self, sep):
        return self.data.rpartition(sep)
    def startswith(self, prefix, start=0, end=sys.maxsize):
        return self.data.startswith(prefix, start, end)
    def endswith(self, suffix, start=0, end=sys.maxsize):
        return self.data.endswith(suffix, start, end)
    def find(self, sub, start=0, end=sys.maxsize):
        return self.data.find(_data(sub), start, end)
    def index(self, sub, start=0, end=sys.maxsize):
        return self.data.index(_data(sub), start, end)
    def count(self, sub, start=0, end=sys.maxsize):
        return self.data.count(_data(sub), start, end)
    def isdigit(self):
        return self.data.isdigit()
    def isalpha(self):
        return self.data.isalpha()
    def isidentifier(self):
        return self.data.isidentifier()
    def replace(self, old, new, maxsplit=-1):
        return type(self)(self.data.replace(_data(old), _data(new), maxsplit))
    def lower(self):
        return type(self)(self.data.lower())
    def upper(self):
        return type(self)(self.data.upper())
    def title(self):
        return type(self)(self.data.title())
    def capitalize(self):
        return type(self)(self.data.capitalize())
    def strip(self, chars=None):
        return type(self)(self.data.strip(chars))
    def lstrip(self, chars=None):
        return type(self)(self.data.lstrip(chars))
    def rstrip(self, chars=None):
        return type(self)(self.data.rstrip(chars))
    def zfill(self, width):
        return type(self)(self.data.zfill(width))
