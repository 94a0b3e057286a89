# SPDX-License-Identifier: Apache-2.0
"""`toml`: text that stands in the program, or in a file of the sources, is read.

Read from toml 0.10.2.
"""
from _rosward import ask, reads_only
import os
import tomllib

class TomlDecodeError(ValueError): ...

def loads(s, _dict=dict, decoder=None):
    return tomllib.loads(s)
def load(f, _dict=dict, decoder=None):
    if isinstance(f, (str, os.PathLike)):
        return tomllib.loads(open(f).read())
    if isinstance(f, list):
        found = {}
        for name in f:
            found.update(load(name))
        return found
    return tomllib.loads(f.read())
@reads_only
def dumps(o, encoder=None) -> str: ...
def dump(o, f, encoder=None):
    text = dumps(o)
    ask(f, 'write', text)
    return text
