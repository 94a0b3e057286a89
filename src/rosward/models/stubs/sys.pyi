# SPDX-License-Identifier: Apache-2.0
"""`sys`: the command line, the end of the program, the standard streams (`exit`: models/python/std/processes.py)."""
from _rosward import native, reads_only, sink, source, unknown

reads_only(__name__)

@native
def _argv(): ...
@native
def _read(): ...

class _Input:
    """Standard input."""
    name = '<stdin>'
    @source("stdin")
    def read(self, size=-1, /) -> str: return _read()
    @source("stdin")
    def readline(self, size=-1, /) -> str: return _read()
    @source("stdin")
    def readlines(self, hint=-1, /): return unknown('input', 'standard input', 'list')
    def __iter__(self): return iter(unknown('input', 'standard input', 'list'))
    def fileno(self) -> int: ...
    def isatty(self) -> bool: ...
    def close(self) -> None: ...

class _Output:
    """Standard output and error."""
    @sink("stdout")
    def write(self, text, /) -> int: ...
    @sink("stdout")
    def writelines(self, lines, /) -> None: ...
    def flush(self) -> None: ...
    def fileno(self) -> int: ...
    def isatty(self) -> bool: ...
    def close(self) -> None: ...

class _Version(tuple):
    """Some Python 3."""
    major = 3
    minor = unknown('live', 'sys.version_info', 'int')
    micro = unknown('live', 'sys.version_info', 'int')
    releaselevel = 'final'
    serial = 0

class _Hooks:
    """What nobody looks at twice."""

argv = _argv()
path = [*unknown('live', 'sys.path', 'list')]
modules = {unknown('live', 'sys.modules', 'str'): unknown('live', 'sys.modules')}
executable = unknown('live', 'sys.executable', 'str')
platform = 'linux'
byteorder = 'little'
maxsize = 9223372036854775807
version = unknown('live', 'sys.version', 'str')
version_info = _Version((3, unknown('live', 'sys.version_info', 'int'), unknown('live', 'sys.version_info', 'int'), 'final', 0))
hexversion = unknown('live', 'sys.version_info', 'int')
stdin = _Input()
stdout = _Output()
stderr = _Output()
__stdin__ = stdin
__stdout__ = stdout
__stderr__ = stderr
flags = _Hooks()
float_info = _Hooks()

@native
def _handled(): ...

def exc_info():
    error = _handled()
    if error is None:
        return (None, None, None)
    return (type(error), error, error.__traceback__)
def exception():
    return _handled()

@native
def _uncaught(): ...

def excepthook(exctype, value, traceback, /) -> None: ...
__excepthook__ = excepthook
def _end():
    """What an uncaught exception runs, any one that may end the program."""
    error = _uncaught()
    excepthook(type(error), error, error.__traceback__)
def _getframe(depth=0, /): ...
def settrace(function, /) -> None: ...
def setprofile(function, /) -> None: ...
def getsizeof(*args, **kwargs) -> int: ...
def getrefcount(object, /) -> int: ...
def getrecursionlimit() -> int: ...
def setrecursionlimit(limit, /) -> None: ...
def setswitchinterval(interval, /) -> None: ...
def getdefaultencoding() -> str: ...
def getfilesystemencoding() -> str: ...
def intern(string, /): return string
