# SPDX-License-Identifier: Apache-2.0
"""`json`: text that stands in the program is read, files are not (models/python/std/data.py)."""

from _opened import WrittenFile
from _rosward import ask, pure, reads_only, sink, unknown

import json

pure(__name__)

reads_only(__name__)

class JSONDecodeError(ValueError):
    def __init__(self, msg, doc, pos):
        self.msg = msg
        self.doc = doc
        self.pos = pos

@sink("file")
def dump(obj, fp, *, skipkeys=False, ensure_ascii=True, check_circular=True, allow_nan=True, cls=None, indent=None, separators=None,
         default=None, sort_keys=False, **kw):
    if isinstance(fp, WrittenFile):
        if cls is None and default is None:
            fp.write(json.dumps(obj, ensure_ascii=ensure_ascii, indent=indent, separators=separators, sort_keys=sort_keys))
        else:
            fp.write(json.dumps(obj, cls=cls, default=default))
        return
    text = json.dumps(obj, cls=cls, default=default)
    ask(fp, 'write', unknown('call', 'text that a library writes', 'str'))

class JSONEncoder:
    def __init__(self, *, skipkeys=False, ensure_ascii=True, check_circular=True, allow_nan=True, sort_keys=False, indent=None,
                 separators=None, default=None):
        if default is not None:
            self.default = default
    def default(self, o): ...
    def encode(self, o) -> str: ...
class JSONDecoder:
    def __init__(self, *, object_hook=None, parse_float=None, parse_int=None, parse_constant=None, strict=True, object_pairs_hook=None):
        self._hooks = (object_hook, parse_float, parse_int, parse_constant, object_pairs_hook)
    def decode(self, s, _w=None):
        object_hook, parse_float, parse_int, parse_constant, object_pairs_hook = self._hooks
        return json.loads(s, object_hook=object_hook, parse_float=parse_float, parse_int=parse_int, parse_constant=parse_constant,
                          object_pairs_hook=object_pairs_hook)
