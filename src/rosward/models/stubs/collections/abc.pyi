# SPDX-License-Identifier: Apache-2.0
"""`collections.abc`: the methods that a class has from them, as the library reference lists them, over those that it writes itself."""

from abc import ABCMeta

class _Abstract(metaclass=ABCMeta):
    def __class_getitem__(cls, item):
        return cls
class Awaitable(_Abstract): ...
class Coroutine(Awaitable):
    def close(self):
        try:
            self.throw(GeneratorExit)
        except (GeneratorExit, StopIteration):
            pass
class AsyncIterable(_Abstract): ...
class AsyncIterator(AsyncIterable):
    def __aiter__(self):
        return self
class AsyncGenerator(AsyncIterator):
    async def __anext__(self):
        return await self.asend(None)
class Hashable(_Abstract): ...
class Iterable(_Abstract): ...
class Iterator(Iterable):
    def __iter__(self):
        return self
class Generator(Iterator):
    def __next__(self):
        return self.send(None)
    def close(self):
        try:
            self.throw(GeneratorExit)
        except (GeneratorExit, StopIteration):
            pass
class Reversible(Iterable): ...
class Sized(_Abstract): ...
class Container(_Abstract): ...
class Callable(_Abstract): ...
class Collection(Sized, Iterable, Container): ...

class Sequence(Reversible, Collection):
    def __iter__(self):
        for number in range(len(self)):
            yield self[number]
    def __reversed__(self):
        for number in reversed(range(len(self))):
            yield self[number]
    def __contains__(self, value):
        for each in self:
            if each is value or each == value:
                return True
        return False
    def index(self, value, start=0, stop=None):
        if start == 0 and stop is None:
            return list(self).index(value)
        return list(self).index(value, start, len(self) if stop is None else stop)
    def count(self, value):
        return list(self).count(value)

class MutableSequence(Sequence):
    def append(self, value):
        self.insert(len(self), value)
    def clear(self):
        for _ in range(len(self)):
            self.pop()
    def reverse(self):
        values = list(self)
        for number in range(len(values)):
            self[number] = values[-1 - number]
    def extend(self, values):
        for value in list(values) if values is self else values:
            self.append(value)
    def pop(self, index=-1):
        value = self[index]
        del self[index]
        return value
    def remove(self, value):
        del self[self.index(value)]
    def __iadd__(self, values):
        self.extend(values)
        return self

class Set(Collection):
    @classmethod
    def _from_iterable(cls, it):
        return cls(it)
    def __le__(self, other):
        return len(self) <= len(other) and all(value in other for value in self)
    def __lt__(self, other):
        return len(self) < len(other) and all(value in other for value in self)
    def __ge__(self, other):
        return len(self) >= len(other) and all(value in self for value in other)
    def __gt__(self, other):
        return len(self) > len(other) and all(value in self for value in other)
    def __eq__(self, other):
        return len(self) == len(other) and all(value in other for value in self)
    def __and__(self, other):
        return self._from_iterable(value for value in other if value in self)
    def __rand__(self, other):
        return self._from_iterable(value for value in other if value in self)
    def __or__(self, other):
        return self._from_iterable([*self, *other])
    def __ror__(self, other):
        return self._from_iterable([*self, *other])
    def __sub__(self, other):
        return self._from_iterable(value for value in self if value not in other)
    def __rsub__(self, other):
        return self._from_iterable(value for value in other if value not in self)
    def __xor__(self, other):
        return (self - other) | self._from_iterable(value for value in other if value not in self)
    def __rxor__(self, other):
        return self ^ other
    def isdisjoint(self, other):
        return not any(value in self for value in other)

class MutableSet(Set):
    def remove(self, value):
        if value not in self:
            raise KeyError(value)
        self.discard(value)
    def pop(self):
        for value in self:
            self.discard(value)
            return value
        raise KeyError
    def clear(self):
        for value in list(self):
            self.discard(value)
    def __ior__(self, values):
        for value in values:
            self.add(value)
        return self
    def __iand__(self, values):
        for value in list(self):
            if value not in values:
                self.discard(value)
        return self
    def __isub__(self, values):
        for value in list(values):
            self.discard(value)
        return self

class Mapping(Collection):
    def __contains__(self, key):
        try:
            self[key]
        except KeyError:
            return False
        return True
    def get(self, key, default=None):
        try:
            return self[key]
        except KeyError:
            return default
    def keys(self):
        return dict.fromkeys(self).keys()
    def values(self):
        return [self[key] for key in self]
    def items(self):
        return [(key, self[key]) for key in self]
    def __eq__(self, other):
        return isinstance(other, (dict, Mapping)) and dict(self.items()) == dict(other.items())

_NOTHING = object()

class MutableMapping(Mapping):
    def pop(self, key, default=_NOTHING):
        try:
            value = self[key]
        except KeyError:
            if default is _NOTHING:
                raise
            return default
        del self[key]
        return value
    def popitem(self):
        for key in self:
            value = self[key]
            del self[key]
            return key, value
        raise KeyError
    def clear(self):
        for key in list(self):
            del self[key]
    def update(self, other=(), /, **kwds):
        if hasattr(other, 'keys'):
            for key in other.keys():
                self[key] = other[key]
        else:
            for key, value in other:
                self[key] = value
        for key, value in kwds.items():
            self[key] = value
    def setdefault(self, key, default=None):
        try:
            return self[key]
        except KeyError:
            self[key] = default
        return default

class MappingView(Sized): ...
class KeysView(MappingView, Set): ...
class ItemsView(MappingView, Set): ...
class ValuesView(MappingView, Collection): ...
class ByteString(Sequence): ...
class Buffer(_Abstract): ...
