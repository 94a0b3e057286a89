# SPDX-License-Identifier: Apache-2.0
"""`csv`: rows of a file, unknown."""
from _rosward import unknown

QUOTE_MINIMAL = 0
QUOTE_ALL = 1
QUOTE_NONNUMERIC = 2
QUOTE_NONE = 3

class Error(Exception): ...
class Dialect: ...
class excel(Dialect): ...

def reader(iterable, dialect='excel', *args, **kwargs):
    return iter([unknown('file', 'rows of a file', 'list') for _ in unknown('file', 'rows of a file', 'list')])
class DictReader:
    def __init__(self, f, fieldnames=None, restkey=None, restval=None, dialect='excel', *args, **kwds):
        self.fieldnames = unknown('file', 'rows of a file', 'list') if fieldnames is None else fieldnames
        self.line_num = unknown('file', 'rows of a file', 'int')
    def __iter__(self):
        return iter([unknown('file', 'rows of a file', 'dict') for _ in unknown('file', 'rows of a file', 'list')])
    def __next__(self):
        return unknown('file', 'rows of a file', 'dict')
class _Writer:
    def writerow(self, row) -> int: ...
    def writerows(self, rows) -> None: ...
    def writeheader(self) -> None: ...
def writer(fileobj, dialect='excel', *args, **kwargs):
    return _Writer()
class DictWriter(_Writer):
    def __init__(self, f, fieldnames, restval='', extrasaction='raise', dialect='excel', *args, **kwds):
        self.fieldnames = fieldnames
