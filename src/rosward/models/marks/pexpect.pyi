# SPDX-License-Identifier: Apache-2.0
"""pexpect: programs that are talked to."""

from _rosward import sink, source

@sink("process")
class spawn:
    @source("process")
    def expect(self, pattern, timeout=-1): ...
    @source("process")
    def read(self, size=-1): ...
    @source("process")
    def readline(self, size=-1): ...
