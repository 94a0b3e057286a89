# SPDX-License-Identifier: Apache-2.0
"""PyYAML: text that stands in the program is read, files are not (models/python/std/data.py)."""

from _opened import WrittenFile
from _rosward import ask, native, reads_only, sink, unknown

reads_only(__name__)

class YAMLError(Exception): ...
class MarkedYAMLError(YAMLError): ...

class _Loader:
    @classmethod
    def add_constructor(cls, tag, constructor) -> None: ...
    @classmethod
    def add_implicit_resolver(cls, tag, regexp, first) -> None: ...
class _Dumper:
    @classmethod
    def add_representer(cls, data_type, representer) -> None: ...
class BaseLoader(_Loader): ...
class SafeLoader(_Loader): ...
class FullLoader(_Loader): ...
class UnsafeLoader(_Loader): ...
class Loader(_Loader): ...
class CSafeLoader(_Loader): ...
class CLoader(_Loader): ...
class SafeDumper(_Dumper): ...
class Dumper(_Dumper): ...

@native
def _dumped(data, **options): ...

def _written(stream, text=None):
    if isinstance(stream, WrittenFile) and text is not None:
        stream.write(text)
        return
    ask(stream, 'write', unknown('call', 'text that a library writes', 'str'))
@sink("file")
def dump(data, stream=None, *args, **kwds):
    if stream is None:
        return _dumped(data, **kwds, **({'Dumper': args[0]} if args else {}))
    _written(stream, _dumped(data, **kwds, **({'Dumper': args[0]} if args else {})) if isinstance(stream, WrittenFile) else None)
@sink("file")
def safe_dump(data, stream=None, *args, **kwds):
    return dump(data, stream, *args, **kwds)
@sink("file")
def dump_all(documents, stream=None, *args, **kwds):
    if stream is None:
        return unknown('call', 'text of documents', 'str')
    _written(stream)
@sink("file")
def safe_dump_all(documents, stream=None, *args, **kwds):
    if stream is None:
        return unknown('call', 'text of documents', 'str')
    _written(stream)

def add_constructor(tag, constructor, Loader=None) -> None: ...
def add_representer(data_type, representer, Dumper=None) -> None: ...
