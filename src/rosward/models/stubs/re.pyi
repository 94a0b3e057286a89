# SPDX-License-Identifier: Apache-2.0
"""`re`: exact for short patterns on short constants (see models/python/std/texts.py), else unknown."""
from _rosward import native, pure, raises_nothing, reads_only, unknown

@native
def _find(how, pattern, flags, text, pos, endpos): ...
@native
def _find_all(pattern, flags, text, pos, endpos): ...
@native
def _split(pattern, flags, text, maxsplit): ...
@native
def _sub(pattern, flags, repl, text, count): ...
@native
def _sub_by(pattern, function, text, count): ...
@native
def _expanded(template, groups): ...
@raises_nothing
@native
def _is_doubtful(pattern): ...
@pure
@reads_only
def _refuse(pattern) -> None: ...

A = ASCII = 256
I = IGNORECASE = 2
L = LOCALE = 4
M = MULTILINE = 8
S = DOTALL = 16
U = UNICODE = 32
X = VERBOSE = 64
T = TEMPLATE = 1
DEBUG = 128
NOFLAG = 0

class error(Exception): ...
PatternError = error

class Match:
    def __init__(self, groups, re, string):
        self._groups = groups
        self.re = re
        self.string = string
    def __class_getitem__(cls, item):
        return cls
    def __getitem__(self, group):
        return self._groups[group]
    def group(self, *args):
        if not args:
            return self._groups[0]
        if len(args) == 1:
            return self._groups[args[0]]
        return tuple([self._groups[one] for one in args])
    def groups(self, default=None):
        return tuple([default if self._groups[key] is None else self._groups[key] for key in self._groups if isinstance(key, int) and key != 0])
    def groupdict(self, default=None):
        return {key: default if self._groups[key] is None else self._groups[key] for key in self._groups if isinstance(key, str) and key != ''}
    def span(self, group=0, /):
        return tuple(self._groups[''][group])
    def start(self, group=0, /):
        return self._groups[''][group][0]
    def end(self, group=0, /):
        return self._groups[''][group][1]
    def expand(self, template):
        return _expanded(template, self._groups)

def _made(found, pattern, string):
    if found is None:
        return None
    return Match(found, pattern, string)

class Pattern:
    def __init__(self, pattern, flags):
        self.pattern = pattern
        self.flags = flags
    def __class_getitem__(cls, item):
        return cls
    def match(self, string, pos=0, endpos=9223372036854775807):
        return _made(_find('match', self.pattern, self.flags, string, pos, endpos), self, string)
    def fullmatch(self, string, pos=0, endpos=9223372036854775807):
        return _made(_find('fullmatch', self.pattern, self.flags, string, pos, endpos), self, string)
    def search(self, string, pos=0, endpos=9223372036854775807):
        return _made(_find('search', self.pattern, self.flags, string, pos, endpos), self, string)
    def split(self, string, maxsplit=0):
        return _split(self.pattern, self.flags, string, maxsplit)
    def findall(self, string, pos=0, endpos=9223372036854775807):
        return [_found(groups) for groups in _find_all(self.pattern, self.flags, string, pos, endpos)]
    def finditer(self, string, pos=0, endpos=9223372036854775807):
        return iter([Match(groups, self, string) for groups in _find_all(self.pattern, self.flags, string, pos, endpos)])
    def sub(self, repl, string, count=0):
        if callable(repl):
            return _sub_by(self, repl, string, count)
        return _sub(self.pattern, self.flags, repl, string, count)
    def subn(self, repl, string, count=0):
        number = len(_find_all(self.pattern, self.flags, string, 0, 9223372036854775807))
        return (self.sub(repl, string, count), min(number, count) if count else number)

def _found(groups):
    if not isinstance(groups, dict):
        return unknown('operation', 're.findall')
    parts = [groups[key] for key in groups if isinstance(key, int) and key != 0]
    if not parts:
        return groups[0]
    if len(parts) == 1:
        return parts[0]
    return tuple(parts)

def compile(pattern, flags=0):
    if _is_doubtful(pattern):
        _refuse(pattern)
    return pattern if isinstance(pattern, Pattern) else Pattern(pattern, flags)
def match(pattern, string, flags=0):
    return compile(pattern, flags).match(string)
def fullmatch(pattern, string, flags=0):
    return compile(pattern, flags).fullmatch(string)
def search(pattern, string, flags=0):
    return compile(pattern, flags).search(string)
def split(pattern, string, maxsplit=0, flags=0):
    return compile(pattern, flags).split(string, maxsplit)
def findall(pattern, string, flags=0):
    return compile(pattern, flags).findall(string)
def finditer(pattern, string, flags=0):
    return compile(pattern, flags).finditer(string)
def sub(pattern, repl, string, count=0, flags=0):
    return compile(pattern, flags).sub(repl, string, count)
def subn(pattern, repl, string, count=0, flags=0):
    return compile(pattern, flags).subn(repl, string, count)
@reads_only
def purge() -> None: ...
