# SPDX-License-Identifier: Apache-2.0
"""`io`: text and bytes in memory; files are those of `open` (models/python/std/files.py)."""
from _opened import TextFile
from _rosward import native, unknown

SEEK_SET = 0
SEEK_CUR = 1
SEEK_END = 2
DEFAULT_BUFFER_SIZE = 8192

@native
def open(file, mode='r', buffering=-1, encoding=None, errors=None, newline=None, closefd=True, opener=None): ...

class UnsupportedOperation(OSError, ValueError): ...
class IOBase: ...
class RawIOBase(IOBase): ...
class BufferedIOBase(IOBase): ...
class TextIOBase(IOBase): ...

class StringIO(TextFile):
    _filled = True  # who gets hold of it may write to it
    mode = 'w+'
    def __init__(self, initial_value='', newline='\n'):
        super().__init__(initial_value or self._nothing, 'text in memory')
        self._at_end = not initial_value
    def getvalue(self):
        return self._whole
    def write(self, text):
        self._whole = self._whole + text if self._at_end else unknown('operation', 'io.StringIO.write', 'str')
        self._ahead = self._nothing
        self._at_end = True
        return len(text)
    def writelines(self, lines):
        for line in lines:
            self.write(line)
    def read(self, size=-1):
        if size is None or size < 0:
            self._at_end = True
        else:
            self._at_end = False
        return super().read(size)
    def seek(self, offset, whence=0):
        self._at_end = whence == 2 and offset == 0
        return super().seek(offset, whence)
    def truncate(self, size=None):
        self._whole = '' if size == 0 else unknown('operation', 'io.StringIO.truncate', 'str')
        return size
    def writable(self):
        return True

class BytesIO(StringIO):
    _nothing = b''
    def __init__(self, initial_bytes=b''):
        super().__init__(initial_bytes)
    def _somewhere(self):
        return unknown('file', self.name, 'bytes')
    def getbuffer(self):
        return memoryview(self)
