# SPDX-License-Identifier: Apache-2.0
"""`string`: its constants, and templates."""
from _rosward import native

@native
def _substitute(template, mapping, safe): ...

ascii_lowercase = 'abcdefghijklmnopqrstuvwxyz'
ascii_uppercase = 'ABCDEFGHIJKLMNOPQRSTUVWXYZ'
ascii_letters = 'abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ'
digits = '0123456789'
hexdigits = '0123456789abcdefABCDEF'
octdigits = '01234567'
punctuation = '!"#$%&\'()*+,-./:;<=>?@[\\]^_`{|}~'
whitespace = ' \t\n\r\x0b\x0c'
printable = digits + ascii_letters + punctuation + whitespace

class Template:
    def __init__(self, template):
        self.template = template
    def substitute(self, mapping={}, /, **kws):
        return _substitute(self.template, {**mapping, **kws}, False)
    def safe_substitute(self, mapping={}, /, **kws):
        return _substitute(self.template, {**mapping, **kws}, True)
class Formatter:
    def format(self, format_string, /, *args, **kwargs):
        return format_string.format(*args, **kwargs)
    def vformat(self, format_string, args, kwargs):
        return format_string.format(*args, **kwargs)
