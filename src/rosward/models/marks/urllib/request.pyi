# SPDX-License-Identifier: Apache-2.0
"""`urllib.request`."""

from _rosward import sink, source

class _Response:
    @source("network")
    def read(self, amt=None): ...

@sink("network")
@source("network")
def urlopen(url, data=None, timeout=None) -> _Response: ...
@sink("network")
def Request(url, data=None, headers={}): ...
