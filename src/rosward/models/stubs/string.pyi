# SPDX-License-Identifier: Apache-2.0
"""`string`: its constants, and templates."""
from _rosward import ask, either, native, overridden, pure, reads_only, unknown

pure(__name__)

@native
def _substitute(template, mapping, safe, delimiter, idpattern, braceidpattern, flags, pattern): ...
@native
def _fields(template, delimiter, idpattern, braceidpattern, flags, pattern): ...
@native
def _parsed(format_string): ...

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
    delimiter = '$'
    idpattern = '(?a:[_a-z][_a-z0-9]*)'
    braceidpattern = None
    flags = 2
    pattern = None
    def __init__(self, template):
        self.template = template
    def _form(self):
        return (self.delimiter, self.idpattern, self.braceidpattern, self.flags, self.pattern)
    def substitute(self, mapping={}, /, **kws):
        return _substitute(self.template, {**mapping, **kws}, False, *self._form())
    def safe_substitute(self, mapping={}, /, **kws):
        return _substitute(self.template, {**mapping, **kws}, True, *self._form())
    def is_valid(self):
        return unknown('operation', 'string.Template.is_valid', 'bool')
    def get_identifiers(self):
        return _fields(self.template, *self._form())
@reads_only
class Formatter:
    def format(self, format_string, /, *args, **kwargs):
        return self.vformat(format_string, args, kwargs)
    def vformat(self, format_string, args, kwargs):
        if overridden(self, 'parse', 'get_field', 'get_value', 'check_unused_args', 'format_field', 'convert_field'):
            name, spec = unknown('input', 'field of a format', 'str'), unknown('input', 'format of a field', 'str')
            ask(self, 'parse', format_string)
            ask(self, 'get_field', name, args, kwargs)
            value = either(ask(self, 'get_value', name, args, kwargs), unknown('input', 'value of a field'))
            ask(self, 'convert_field', value, spec)
            ask(self, 'format_field', value, spec)
            ask(self, 'check_unused_args', set(), args, kwargs)
            return unknown('call', 'string.Formatter', 'str')
        return format_string.format(*args, **kwargs)
    def parse(self, format_string):
        return iter(_parsed(format_string))
    def get_field(self, field_name, args, kwargs): ...
    def get_value(self, key, args, kwargs): ...
    def check_unused_args(self, used_args, args, kwargs) -> None: ...
    def format_field(self, value, format_spec):
        return format(value, format_spec)
    def convert_field(self, value, conversion): ...
