# SPDX-License-Identifier: Apache-2.0
"""`pprint`: prints, no more."""

from _rosward import ask, reads_only, sink, unknown

@sink("stdout")
def pprint(object, stream=None, *args, **kwargs):
    ask(stream, 'write', unknown('call', 'text that a library writes', 'str'))
def pp(object, stream=None, *args, **kwargs):
    ask(stream, 'write', unknown('call', 'text that a library writes', 'str'))
@reads_only
def pformat(object, *args, **kwargs) -> str: ...
class PrettyPrinter:
    def __init__(self, indent=1, width=80, depth=None, stream=None, **kwargs):
        self._stream = stream
    def pprint(self, object):
        ask(self._stream, 'write', unknown('call', 'text that a library writes', 'str'))
    @reads_only
    def pformat(self, object) -> str: ...
