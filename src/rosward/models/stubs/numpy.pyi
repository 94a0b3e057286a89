# SPDX-License-Identifier: Apache-2.0
"""numpy: an array of known items can be iterated and indexed; all arithmetic is unknown."""
from _rosward import either, native, pure, reads_only, unknown

pure(__name__)

@native
def _elements(items, dtype): ...

pi = 3.141592653589793
e = 2.718281828459045
inf = float('inf')
Inf = inf
nan = float('nan')
NaN = nan
newaxis = None

def _wrap(value):
    return _made(value) if isinstance(value, (list, tuple)) else value

def _made(items):
    array = object.__new__(ndarray)
    array._items = items
    return array

@pure
def _over(shape, dtype, buffer): ...

class ndarray:
    """Made by numpy's functions; written to, it is not known. Made by itself, it has a shape, and what stood in its buffer."""
    def __new__(cls, shape, dtype=float, buffer=None, offset=0, strides=None, order=None):
        if cls is ndarray:
            return _over(shape, dtype, buffer)
        array = object.__new__(cls)
        array._items = unknown('call', 'numpy.ndarray', 'list')
        return array
    def __iter__(self):
        return iter([_wrap(value) for value in self._items])
    def __len__(self):
        return len(self._items)
    def __getitem__(self, index):
        if isinstance(index, int):
            return _wrap(self._items[index])
        return _unknown()
    def __setitem__(self, index, value):
        self._items = unknown('operation', 'item of an array', 'list')
    @reads_only
    def __contains__(self, value) -> bool: ...
    def _changed(self):
        self._items = unknown('operation', 'items of an array', 'list')
        return self
    def fill(self, value): self._changed()
    def put(self, indices, values, mode='raise'): self._changed()
    def sort(self, axis=-1, kind=None, order=None): self._changed()
    def itemset(self, *args): self._changed()
    def tolist(self):
        return self._items
    def copy(self, order='C'):
        return _made(self._items)
    def __array__(self):
        return self
    def __add__(self, other): return _unknown()
    def __radd__(self, other): return _unknown()
    def __iadd__(self, other): return self._changed()
    def __sub__(self, other): return _unknown()
    def __rsub__(self, other): return _unknown()
    def __isub__(self, other): return self._changed()
    def __mul__(self, other): return _unknown()
    def __rmul__(self, other): return _unknown()
    def __imul__(self, other): return self._changed()
    def __truediv__(self, other): return _unknown()
    def __rtruediv__(self, other): return _unknown()
    def __itruediv__(self, other): return self._changed()
    def __floordiv__(self, other): return _unknown()
    def __mod__(self, other): return _unknown()
    def __pow__(self, other): return _unknown()
    def __matmul__(self, other): return _unknown()
    def __rmatmul__(self, other): return _unknown()
    def __neg__(self): return _unknown()
    def __abs__(self): return _unknown()
    def __and__(self, other): return _unknown()
    def __or__(self, other): return _unknown()
    def __xor__(self, other): return _unknown()
    def __invert__(self): return _unknown()
    def __eq__(self, other): return _unknown()
    def __ne__(self, other): return _unknown()
    def __lt__(self, other): return _unknown()
    def __le__(self, other): return _unknown()
    def __gt__(self, other): return _unknown()
    def __ge__(self, other): return _unknown()
    @reads_only
    def __bool__(self) -> bool: ...
    @reads_only
    def __float__(self) -> float: ...
    @reads_only
    def __int__(self) -> int: ...

def _unknown():
    return unknown('operation', 'arithmetic on arrays')

def array(object, dtype=None, **kwargs):
    if isinstance(object, (list, tuple)):
        return _made(_elements(object, dtype))
    return object if isinstance(object, ndarray) else _unknown()
def asarray(a, dtype=None, **kwargs):
    return array(a, dtype)
