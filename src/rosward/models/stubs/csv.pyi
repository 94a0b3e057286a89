# SPDX-License-Identifier: Apache-2.0
"""`csv`: rows of text that stands in the program, or in a file of the sources (models/python/std/tables.py)."""
from _rosward import ask, native, sink, unknown

@native
def _rows(lines, dialect, options): ...

QUOTE_MINIMAL = 0
QUOTE_ALL = 1
QUOTE_NONNUMERIC = 2
QUOTE_NONE = 3

class Error(Exception): ...
class Dialect: ...
class excel(Dialect): ...

class excel_tab(excel): ...
class unix_dialect(Dialect): ...

class _Reader:
    def __init__(self, rows):
        self._rows = iter(rows)
        self.line_num = 0
    def __iter__(self):
        return self
    def __next__(self):
        return next(self._rows)
def reader(iterable, dialect='excel', *args, **options):
    return _Reader(_rows(iterable, dialect, options))
class DictReader:
    def __init__(self, f, fieldnames=None, restkey=None, restval=None, dialect='excel', *args, **options):
        self._rows = iter(_rows(f, dialect, options))
        self._names = fieldnames
        self._restkey = restkey
        self._restval = restval
        self.line_num = 0
    @property
    def fieldnames(self):
        if self._names is None:
            self._names = next(self._rows, None)
        return self._names
    def __iter__(self):
        return self
    def __next__(self):
        names = self.fieldnames
        row = next(self._rows)
        while not row:
            row = next(self._rows)
        found = dict(zip(names, row))
        if len(names) < len(row):
            found[self._restkey] = row[len(names):]
        elif len(names) > len(row):
            for name in names[len(row):]:
                found[name] = self._restval
        return found
class _Writer:
    def __init__(self, f):
        self._file = f
    @sink("file")
    def writerow(self, row):
        ask(self._file, 'write', unknown('call', 'text that a library writes', 'str'))
        return unknown('call', 'what a writer returns')
    @sink("file")
    def writerows(self, rows):
        for row in rows:
            self.writerow(row)
    @sink("file")
    def writeheader(self):
        return self.writerow(())
def writer(fileobj, dialect='excel', *args, **kwargs):
    return _Writer(fileobj)
class DictWriter(_Writer):
    def __init__(self, f, fieldnames, restval='', extrasaction='raise', dialect='excel', *args, **kwds):
        _Writer.__init__(self, f)
        self.fieldnames = fieldnames
