# SPDX-License-Identifier: Apache-2.0
"""What builtins and itertools do with iterators, item by item: they ask for the next one only when they are asked themselves.

The natives of the same names (models/python/builtins/sequences.py, std/functional.py) hand over to these where an argument is an iterator that is
followed step by step, or where a function of the program is called.
"""

def map(function, iterable):
    for value in iterable:
        yield function(value)

def map_rows(function, *iterables):
    for row in zip(*iterables):
        yield function(*row)

def filter(function, iterable):
    for value in iterable:
        if value if function is None else function(value):
            yield value

def enumerate(iterable, start=0):
    for value in iterable:
        yield (start, value)
        start = start + 1

_END = object()

def zip(*iterables, strict=False):
    iterators = [iter(one) for one in iterables]
    while iterators:
        row = []
        for iterator in iterators:
            value = next(iterator, _END)
            if value is _END:
                if strict and not row:  # whether the others end, too
                    for other in iterators[1:]:
                        next(other, _END)
                return
            row.append(value)
        yield tuple(row)

def iter_calls(function, sentinel):
    while True:
        value = function()
        if value == sentinel:
            return
        yield value

def any(iterable):
    for value in iterable:
        if value:
            return True
    return False

def all(iterable):
    for value in iterable:
        if not value:
            return False
    return True

def contains(iterable, wanted):
    found = False
    for value in iterable:
        found = value is wanted or bool(value == wanted)
        if found:
            break
    return found

def from_keys(cls, iterable, value=None):
    found = cls()
    for key in iterable:
        found[key] = value
    return found

def islice(iterable, start, stop, step):
    number = 0
    if stop is None or stop > 0:
        for value in iterable:
            if number >= start and (number - start) % step == 0:
                yield value
            number = number + 1
            if stop is not None and number >= stop:
                return

def zip_longest(*iterables, fillvalue=None):
    iterators = [iter(one) for one in iterables]
    ended = set()
    while True:
        row = []
        for number in range(len(iterators)):
            if number in ended:
                row.append(fillvalue)
                continue
            value = next(iterators[number], _END)
            if value is _END:
                ended.add(number)
                value = fillvalue
            row.append(value)
        if len(ended) == len(iterators):
            return
        yield tuple(row)

def pairwise(iterable):
    first = True
    before = None
    for value in iterable:
        if not first:
            yield (before, value)
        first = False
        before = value

def cycle(iterable):
    saved = []
    for value in iterable:
        yield value
        saved.append(value)
    while saved:
        for value in saved:
            yield value
