# SPDX-License-Identifier: Apache-2.0
"""`http.client`."""

from _rosward import sink, source

class HTTPConnection:
    @sink("network")
    def request(self, method, url, body=None, headers={}): ...
    @sink("network")
    def send(self, data): ...
    @source("network")
    def getresponse(self) -> HTTPResponse: ...

class HTTPSConnection(HTTPConnection): ...

class HTTPResponse:
    @source("network")
    def read(self, amt=None): ...
