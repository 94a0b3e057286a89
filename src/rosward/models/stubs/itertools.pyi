# SPDX-License-Identifier: Apache-2.0
"""`itertools`: exact on known inputs; those that never end are lists of unknown length. The rest is models/python/std/functional.py."""
import operator
from _rosward import native, unknown

@native
def _followed(iterables): ...

class chain:
    def __init__(self, *iterables):
        self._items = _flat(iterables)
    def __iter__(self):
        return self._items
    def __next__(self):
        return next(self._items)
    @classmethod
    def from_iterable(cls, iterable):
        return _flat(iterable)

def _flat(iterable):
    if _followed(iterable):
        return _one_by_one(iterable)
    found = []
    for one in iterable:
        found += one
    return iter(found)

def _one_by_one(iterable):
    for one in iterable:
        yield from one

def count(start=0, step=1):
    while True:
        yield start
        start = start + step

def accumulate(iterable, func=None, *, initial=None):
    total = initial
    first = initial is None
    if not first:
        yield total
    for value in iterable:
        if first:
            total = value
            first = False
        else:
            total = total + value if func is None else func(total, value)
        yield total

def starmap(function, iterable, /):
    for args in iterable:
        yield function(*args)

def filterfalse(predicate, iterable, /):
    for value in iterable:
        if not (value if predicate is None else predicate(value)):
            yield value

def compress(data, selectors):
    for value, selected in zip(data, selectors):
        if selected:
            yield value

def takewhile(predicate, iterable, /):
    for value in iterable:
        if not predicate(value):
            break
        yield value

def dropwhile(predicate, iterable, /):
    dropping = True
    for value in iterable:
        if dropping and predicate(value):
            continue
        dropping = False
        yield value

def groupby(iterable, key=None):
    groups = []
    for value in iterable:
        this = value if key is None else key(value)
        if groups and groups[-1][0] == this:
            groups[-1][1].append(value)
        else:
            groups.append((this, [value]))
    yield from groups

_END = object()

def tee(iterable, n=2, /):
    shared = []
    iterator = iter(iterable)
    return tuple([_shared(iterator, shared) for _ in range(n)])

def _shared(iterator, shared):
    number = 0
    while True:
        if number == len(shared):
            value = next(iterator, _END)
            if value is _END:
                return
            shared.append(value)
        yield shared[number]
        number = number + 1

if unknown('live', 'sys.version_info', 'bool'):  # since 3.12
    def batched(iterable, n):
        batch = []
        for value in iterable:
            batch.append(value)
            if len(batch) == n:
                yield tuple(batch)
                batch = []
        if batch:
            yield tuple(batch)
