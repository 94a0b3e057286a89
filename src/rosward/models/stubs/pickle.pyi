# SPDX-License-Identifier: Apache-2.0
"""`pickle`: bytes of anything; what is read is unknown."""
from _rosward import ask, reads_only, sink, source, unknown

HIGHEST_PROTOCOL = 5
DEFAULT_PROTOCOL = 4

class PickleError(Exception): ...
class UnpicklingError(PickleError): ...
@reads_only
def dumps(obj, protocol=None, *, fix_imports=True, buffer_callback=None) -> bytes: ...
@sink("file")
def dump(obj, file, protocol=None, *, fix_imports=True, buffer_callback=None):
    ask(file, 'write', unknown('call', 'pickled data', 'bytes'))
class Pickler:
    def __init__(self, file, protocol=None, fix_imports=True, buffer_callback=None):
        self._file = file
    @sink("file")
    def dump(self, obj):
        ask(self._file, 'write', unknown('call', 'pickled data', 'bytes'))
    @reads_only
    def clear_memo(self) -> None: ...
class Unpickler:
    def __init__(self, file, *, fix_imports=True, encoding='ASCII', errors='strict', buffers=()):
        self._file = file
    @sink("pickle")
    @source("file")
    def load(self):
        ask(self._file, 'read')
        return unknown('file', 'pickled data')
@sink("pickle")
@source("file")
def load(file, *, fix_imports=True, encoding='ASCII', errors='strict', buffers=()):
    return unknown('file', 'pickled data')
@sink("pickle")
def loads(data, /, *, fix_imports=True, encoding='ASCII', errors='strict', buffers=()):
    return unknown('file', 'pickled data')
