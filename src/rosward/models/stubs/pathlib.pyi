# SPDX-License-Identifier: Apache-2.0
"""`pathlib`: a path is its text."""
from _rosward import native, reads_only, sink, source, unknown
from _rosward.launch import replaced, write_file
import os

@native
def _join(parts): ...
@native
def _dirname(path): ...
@native
def _parents(path): ...
@native
def _basename(path): ...
@native
def _splitext(path): ...
@native
def _absolute(path): ...
@native
def _expanduser(path): ...
@native
def _read_text(path): ...
@native
def _glob(path): ...

class PurePath:
    """A path; all kinds are POSIX paths here."""
    def __init__(self, *args):
        self._text = _join(args)
    def __str__(self):
        return self._text
    def __fspath__(self):
        return self._text
    def as_posix(self):
        return self._text
    def __repr__(self):
        return "PosixPath('" + self._text + "')"
    def __format__(self, spec):
        return format(self._text, spec)
    def __truediv__(self, key):
        return Path(self._text, key)
    def __rtruediv__(self, key):
        return Path(key, self._text)
    def joinpath(self, *args):
        return Path(self._text, *args)
    def __eq__(self, other):
        return isinstance(other, PurePath) and self._text == other._text
    def __hash__(self):
        return hash(self._text)
    def __lt__(self, other):
        return self._text < other._text
    @property
    def parent(self):
        return Path(_dirname(self._text))
    @property
    def parents(self):
        return tuple(map(Path, _parents(self._text)))
    @property
    def parts(self):
        return tuple((['/'] if self._text.startswith('/') else []) + [p for p in self._text.split('/') if p])
    @property
    def name(self):
        return _basename(self._text)
    @property
    def stem(self):
        return _splitext(_basename(self._text))[0]
    @property
    def suffix(self):
        return _splitext(_basename(self._text))[1]
    @property
    def suffixes(self):
        return ['.' + part for part in self.name.lstrip('.').split('.')[1:]]
    @property
    def anchor(self):
        return '/' if self._text.startswith('/') else ''
    @property
    def root(self):
        return '/' if self._text.startswith('/') else ''
    @property
    def drive(self):
        return ''
    def with_name(self, name):
        return Path(_dirname(self._text), name)
    def with_stem(self, stem):
        return Path(_dirname(self._text), stem + self.suffix)
    def with_suffix(self, suffix):
        return Path(_splitext(self._text)[0] + suffix)
    def is_absolute(self):
        return os.path.isabs(self._text)
    def relative_to(self, other, *_deprecated):
        return Path(os.path.relpath(self._text, other))
    @reads_only
    def is_relative_to(self, other, *_deprecated) -> bool: ...
    @reads_only
    def match(self, path_pattern) -> bool: ...
    def as_uri(self):
        return 'file://' + self._text

class Path(PurePath):
    """What is asked of the file system is unknown."""
    @classmethod
    def cwd(cls):
        return Path(os.getcwd())
    @classmethod
    def home(cls):
        return Path(_expanduser('~'))
    def absolute(self):
        return Path(_absolute(self._text))
    def resolve(self, strict=False):
        return Path(_absolute(self._text))
    def expanduser(self):
        return Path(_expanduser(self._text))
    @source("file")
    def readlink(self):
        return Path(unknown('file', self._text, 'str'))
    def exists(self):
        return os.path.exists(self._text)
    def is_file(self):
        return os.path.isfile(self._text)
    def is_dir(self):
        return os.path.isdir(self._text)
    def is_symlink(self):
        return os.path.islink(self._text)
    @reads_only
    def samefile(self, other_path) -> bool: ...
    def open(self, mode='r', buffering=-1, encoding=None, errors=None, newline=None):
        return open(self._text, mode)
    @source("file")
    def read_text(self, encoding=None, errors=None):
        return _read_text(self._text)
    @source("file")
    def read_bytes(self):
        return unknown('file', self._text, 'bytes')
    @sink("file")
    def write_text(self, data, encoding=None, errors=None, newline=None):
        write_file(self._text, data)
        return len(data)
    @sink("file")
    def write_bytes(self, data):
        write_file(self._text, data.decode())
        return len(data)
    def _below(self):
        for name in os.listdir(self._text):
            yield Path(self._text, name)
    def iterdir(self):
        return self._below()
    def glob(self, pattern):
        for name in _glob(_join((self._text, pattern))):
            yield Path(name)
    def rglob(self, pattern):
        return self._below()
    @reads_only
    @source("file")
    def stat(self, *, follow_symlinks=True): ...
    @reads_only
    @source("file")
    def lstat(self): ...
    @reads_only
    @source("file")
    def owner(self) -> str: ...
    @reads_only
    @sink("file")
    def mkdir(self, mode=0o777, parents=False, exist_ok=False) -> None: ...
    @reads_only
    @sink("file")
    def rmdir(self) -> None: ...
    @reads_only
    @sink("file")
    def touch(self, mode=0o666, exist_ok=True) -> None: ...
    @sink("file")
    def unlink(self, missing_ok=False):
        write_file(self._text, None)
    @reads_only
    @sink("file")
    def chmod(self, mode, *, follow_symlinks=True) -> None: ...
    @reads_only
    @sink("file")
    def symlink_to(self, target, target_is_directory=False) -> None: ...
    @reads_only
    @sink("file")
    def hardlink_to(self, target) -> None: ...
    @sink("file")
    def rename(self, target):
        replaced(self._text, target)
        return Path(target)
    @sink("file")
    def replace(self, target):
        replaced(self._text, target)
        return Path(target)

PosixPath = Path
PurePosixPath = PurePath
WindowsPath = Path
PureWindowsPath = PurePath
