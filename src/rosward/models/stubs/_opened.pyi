# SPDX-License-Identifier: Apache-2.0
"""A file of the analysed packages that `open` has opened to be read as text (models/python/std/files.py)."""
from _rosward import reads_only, unknown
from _rosward.launch import write_file

class TextFile:
    """`_ahead` is what is still to be read: text, or (lines,), an iterator, once lines are asked for: who goes through them, and whoever else reads, share it."""
    closed = False
    mode = 'r'
    encoding = 'utf-8'
    _nothing = ''
    def __init__(self, text, name):
        self._whole = text
        self._ahead = text
        self.name = name
    def read(self, size=-1):
        ahead = self._ahead
        if size is None or size < 0:
            self._ahead = self._nothing
            return self._nothing.join(ahead[0]) if isinstance(ahead, tuple) else ahead
        self._ahead = self._somewhere()
        return self._somewhere()
    def readlines(self, hint=-1):
        if hint is None or hint <= 0:
            return self.read().splitlines(True)
        taken = []
        size = 0
        for line in self.__iter__():
            taken.append(line)
            size += len(line)
            if size > hint:
                break
        return taken
    def readline(self, size=-1):
        return next(self.__iter__(), self._nothing)
    def __iter__(self):
        ahead = self._ahead
        if not isinstance(ahead, tuple):
            ahead = (iter(ahead.splitlines(True)),)
        self._ahead = ahead
        return ahead[0]
    def __next__(self):
        return next(self.__iter__())
    def _somewhere(self):
        return unknown('file', self.name, 'str')
    def __enter__(self):
        return self
    @reads_only
    def __exit__(self, kind, value, trace) -> None: ...
    @reads_only
    def close(self): ...
    @reads_only
    def flush(self): ...
    def seek(self, offset, whence=0):
        self._ahead = self._whole if offset == 0 and whence == 0 else self._somewhere()
        return offset
    @reads_only
    def tell(self) -> int: ...
    @reads_only
    def fileno(self) -> int: ...
    def readable(self):
        return True
    def writable(self):
        return False
    def seekable(self):
        return True

class BinaryFile(TextFile):
    """The same, opened to be read as bytes."""
    mode = 'rb'
    encoding = None
    _nothing = b''
    def _somewhere(self):
        return unknown('file', self.name, 'bytes')

class WrittenFile:
    """A file that Python code of a launch file writes. What it holds is known at once, not only when it is closed."""
    closed = False
    mode = 'w'
    encoding = 'utf-8'
    def __init__(self, name):
        self.name = name
        self._whole = ''
        write_file(name, '')
    def write(self, text):
        self._whole += text.decode() if isinstance(text, bytes) else text
        write_file(self.name, self._whole)
        return len(text)
    def writelines(self, lines):
        self.write(''.join(lines))
    def read(self, size=-1):
        return unknown('file', self.name, 'str')
    def seek(self, offset, whence=0):
        self._whole = unknown('file', self.name, 'str')
        return offset
    def truncate(self, size=None):
        self._whole = unknown('file', self.name, 'str')
    def __enter__(self):
        return self
    @reads_only
    def __exit__(self, kind, value, trace) -> None: ...
    @reads_only
    def close(self): ...
    @reads_only
    def flush(self): ...
    @reads_only
    def fileno(self) -> int: ...
    def writable(self):
        return True

class TemporaryFile(WrittenFile):
    """It is removed when it is closed, or left."""
    def __init__(self, name, delete=True, delete_on_close=True):
        self._deleted = delete
        self._at_once = delete_on_close
        WrittenFile.__init__(self, name)
    def __exit__(self, kind, value, trace):
        if self._deleted:
            write_file(self.name, None)
    def close(self):
        if self._deleted and self._at_once:
            write_file(self.name, None)
