# SPDX-License-Identifier: Apache-2.0
"""`os`: the environment, paths, and programs that are started (also models/python/std/processes.py)."""
from _rosward import changes, default, either, environment, reads_only, sink, source, spins, unknown, unset
from _rosward.launch import removed, replaced, set_variable, variable, write_file
from os import path as path

reads_only(__name__)

class PathLike:
    def __class_getitem__(cls, item):
        return cls

_GONE = False  # no variable is

class _Environ:
    """`os.environ`: unknown until the user, the deployment or the program itself sets a variable."""
    def __init__(self):
        self._set = {}  # by the program,
        self._gone = {}  # or removed by it
    def _known(self, key):
        """What the variable is, `_GONE` where it is not set, None where that is not known."""
        launched = variable(key)
        if launched is not None:
            return launched
        if removed(key):
            return _GONE
        if key in self._set:
            return self._set[key]
        if key in self._gone:
            return _GONE
        return _GONE if unset(key) else environment(key)
    @source("env")
    def __getitem__(self, key):
        if key in self._set and variable(key) is None:
            return self._set[key]
        known = self._known(key)
        if known is _GONE:
            raise KeyError(key)
        return unknown('environment', key, 'str') if known is None else known
    @source("env")
    def get(self, key, default=None):
        if key in self._set and variable(key) is None:
            return self._set[key]
        known = self._known(key)
        if known is _GONE:
            return default
        return _read(key, default) if known is None else known
    def setdefault(self, key, default=None):
        value = self.get(key, default)
        self._set[key] = value
        self._gone.pop(key, None)
        return value
    def pop(self, key, *default):
        value = self.get(key, *default)
        self._remove(key)
        return value
    def _remove(self, key):
        self._set.pop(key, None)
        self._gone[key] = True
        set_variable(key, None)
    def __setitem__(self, key, value):
        self._set[key] = value
        self._gone.pop(key, None)
        set_variable(key, value)
    def __delitem__(self, key):
        self._remove(key)
    @source("env")
    def __contains__(self, key):
        known = self._known(key)
        return unknown('environment', key, 'bool') if known is None else known is not _GONE
    def update(self, *args, **kwargs):
        for key, value in dict(*args, **kwargs).items():
            self[key] = value
    def copy(self):
        return self
    def __iter__(self):
        return iter(unknown('environment', 'os.environ', 'list'))
    def keys(self):
        return unknown('environment', 'os.environ', 'list')
    def values(self):
        return unknown('environment', 'os.environ', 'list')
    def items(self):
        return [(unknown('live', 'os.environ', 'str'), unknown('live', 'os.environ', 'str'))]

def _read(key, value):
    if value is None:
        return either(None, unknown('environment', key, 'str'))
    return default('environment variable', key, value)

environ = _Environ()
environb = unknown('environment', 'os.environb', 'dict')

@source("env")
def getenv(key, default=None):
    return environ.get(key, default)
def putenv(name, value, /):
    environ[name] = value
def unsetenv(name, /) -> None: ...

name = 'posix'
sep = '/'
altsep = None
pathsep = ':'
linesep = '\n'
curdir = '.'
pardir = '..'
extsep = '.'
devnull = '/dev/null'
F_OK = 0
R_OK = 4
W_OK = 2
X_OK = 1
O_RDONLY = 0
O_WRONLY = 1
O_RDWR = 2
O_CREAT = 64
O_NONBLOCK = 2048
O_NOCTTY = 256

@sink("file")
def mkdir(path, mode=0o777, *, dir_fd=None) -> None: ...
@sink("file")
def makedirs(name, mode=0o777, exist_ok=False) -> None: ...
@sink("file")
def remove(path, *, dir_fd=None):
    write_file(path, None)
@sink("file")
def unlink(path, *, dir_fd=None):
    write_file(path, None)
@sink("file")
def rmdir(path, *, dir_fd=None) -> None: ...
@sink("file")
def removedirs(name) -> None: ...
@sink("file")
def rename(src, dst, *, src_dir_fd=None, dst_dir_fd=None):
    replaced(src, dst)
@sink("file")
def replace(src, dst, *, src_dir_fd=None, dst_dir_fd=None):
    replaced(src, dst)
@sink("file")
def symlink(src, dst, target_is_directory=False, *, dir_fd=None) -> None: ...
@sink("file")
def chmod(path, mode, *, dir_fd=None, follow_symlinks=True) -> None: ...
def chdir(path) -> None: ...
@source("file")
def access(path, mode, *, dir_fd=None, effective_ids=False, follow_symlinks=True) -> bool: ...
@source("file")
def stat(path, *, dir_fd=None, follow_symlinks=True): ...
@spins
@sink("process")
def kill(pid, signal, /) -> None: ...
@spins
@sink("process")
def killpg(pgid, signal, /) -> None: ...
def getpgid(pid) -> int: ...
def getlogin() -> str: ...
def getloadavg(): ...
def isatty(fd, /) -> bool: ...
def open(path, flags, mode=0o777, *, dir_fd=None):
    if flags != O_RDONLY:
        write_file(path, unknown("file", path, "str"))
    return unknown("file", path, "int")
def close(fd) -> None: ...
@source("file")
def read(fd, length, /) -> bytes: ...
@changes("fd")
@sink("file")
def write(fd, data, /) -> int: ...
def pipe(): ...
def nice(increment, /) -> int: ...
def uname(): ...
def setpgrp() -> None: ...
def setsid() -> None: ...
def sched_setaffinity(pid, mask, /) -> None: ...
def sched_getaffinity(pid, /): ...
def get_terminal_size(*args): ...
