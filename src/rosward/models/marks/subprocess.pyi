# SPDX-License-Identifier: Apache-2.0
"""`subprocess`: the pipes of a program, of which its model says nothing."""
from _rosward import sink, source

class _Pipe:
    @sink("process")
    def write(self, data, /): ...
    @sink("process")
    def writelines(self, lines, /): ...
    @source("process")
    def read(self, size=-1, /): ...
    @source("process")
    def readline(self, size=-1, /): ...
    @source("process")
    def readlines(self, hint=-1, /): ...
class Popen:
    stdin: _Pipe
    stdout: _Pipe
    stderr: _Pipe
