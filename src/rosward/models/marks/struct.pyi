# SPDX-License-Identifier: Apache-2.0
"""`struct`: values as bytes."""

from _rosward import changes, pure

pure(__name__)

@changes("buffer")
def pack_into(format, buffer, offset, *values): ...

class Struct:
    @changes("buffer")
    def pack_into(self, buffer, offset, *values): ...
