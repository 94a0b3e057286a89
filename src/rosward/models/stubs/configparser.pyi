# SPDX-License-Identifier: Apache-2.0
"""`configparser`: what text says that stands in the program, or in a file of the sources (models/python/std/tables.py), and what the program sets.

Once a text was read that is not known, there may be any section, and any value.
"""
from _rosward import ask, either, native, unknown
import functools
import re

DEFAULTSECT = 'DEFAULT'

@native
def _sections(text, allows_no_value): ...

class Error(Exception): ...
class NoSectionError(Error): ...
class NoOptionError(Error): ...
class DuplicateSectionError(Error): ...
class InterpolationError(Error): ...
class InterpolationDepthError(InterpolationError): ...
class InterpolationMissingOptionError(InterpolationError): ...
class InterpolationSyntaxError(InterpolationError): ...
class MissingSectionHeaderError(Error): ...
class ParsingError(Error): ...

_NOTHING = object()

def _put_in(value, sign, pattern, found):
    return re.sub(pattern, found, value) if isinstance(value, str) and sign in value else value

class Interpolation:
    def before_get(self, parser, section, option, value, defaults):
        return value
class BasicInterpolation(Interpolation):
    """`%(name)s`"""
    def before_get(self, parser, section, option, value, defaults):
        return _put_in(value, '%', r'%(?:\(([^)]+)\)s|%)', functools.partial(_basic, parser, section, defaults))
def _basic(parser, section, defaults, match):
    name = match.group(1)
    return '%' if name is None else _inner(parser, section, name, defaults)
class ExtendedInterpolation(Interpolation):
    """`${name}`, `${section:name}`"""
    def before_get(self, parser, section, option, value, defaults):
        return _put_in(value, '$', r'\$(?:\{([^}]+)\}|\$)', functools.partial(_extended, parser, section, defaults))
def _extended(parser, section, defaults, match):
    name = match.group(1)
    if name is None:
        return '$'
    other, colon, option = name.partition(':')
    return _inner(parser, other, option, None) if colon else _inner(parser, section, name, defaults)
def _inner(parser, section, name, defaults):
    """The value of another option, in which others may be put in turn."""
    return parser.get(section, name, vars=defaults, fallback=unknown('file', name, 'str'))

class SectionProxy:
    def __init__(self, parser, name):
        self._parser = parser
        self.parser = parser
        self.name = name
    def __getitem__(self, key):
        value = self._parser.get(self.name, key, fallback=_NOTHING)
        if value is _NOTHING:
            raise KeyError(key)
        return value
    def __setitem__(self, key, value):
        self._parser.set(self.name, key, value)
    def __contains__(self, key):
        return self._parser.has_option(self.name, key)
    def get(self, option, fallback=None, *, raw=False, vars=None, _impl=None, **kwargs):
        return self._parser.get(self.name, option, raw=raw, vars=vars, fallback=fallback)
    def getint(self, option, fallback=None, *, raw=False, vars=None, **kwargs):
        return self._parser.getint(self.name, option, vars=vars, fallback=fallback)
    def getfloat(self, option, fallback=None, *, raw=False, vars=None, **kwargs):
        return self._parser.getfloat(self.name, option, vars=vars, fallback=fallback)
    def getboolean(self, option, fallback=None, *, raw=False, vars=None, **kwargs):
        return self._parser.getboolean(self.name, option, vars=vars, fallback=fallback)
    def keys(self):
        return self._parser.options(self.name)
    def values(self):
        return [value for _, value in self._parser.items(self.name)]
    def items(self):
        return self._parser.items(self.name)
    def __iter__(self):
        return iter(self._parser.options(self.name))
    def __len__(self):
        return len(self._parser.options(self.name))

class RawConfigParser:
    def __init__(self, defaults=None, dict_type=dict, allow_no_value=False, *, default_section='DEFAULT', interpolation=_NOTHING, **kwargs):
        self.default_section = default_section
        self._interpolation = self._usual() if interpolation is _NOTHING else Interpolation() if interpolation is None else interpolation
        self._allows = allow_no_value
        self._known = {default_section: {}}
        self._open = False
        self._texts = []
        for name in defaults or {}:
            self._known[default_section][self.optionxform(name)] = defaults[name]
    def _usual(self):
        return Interpolation()
    def optionxform(self, optionstr):
        return optionstr.lower()
    def _take(self, text):
        found = _sections(text, self._allows)
        if found is None:
            self._open = True
            self._texts.append(text)
        else:
            for section, name, value in found:
                if section not in self._known:
                    self._known[section] = {}
                if name is not None:
                    self._known[section][self.optionxform(name)] = value
    def read(self, filenames, encoding=None):
        for name in [filenames] if isinstance(filenames, str) or not isinstance(filenames, (list, tuple, set)) else filenames:
            self._take(open(name).read())
        return unknown('file', filenames if isinstance(filenames, str) else '', 'list')
    def read_file(self, f, source=None):
        self._take(''.join(f))
    readfp = read_file
    def read_string(self, string, source='<string>'):
        self._take(string)
    def read_dict(self, dictionary, source='<dict>'):
        for section in dictionary:
            if section not in self._known:
                self._known[section] = {}
            for name in dictionary[section]:
                self._known[section][self.optionxform(name)] = str(dictionary[section][name])
    def _of(self, section):
        return {**self._known[self.default_section], **self._known.get(section, {})}
    def get(self, section, option, *, raw=False, vars=None, fallback=_NOTHING, **kwargs):
        known, name = self._of(section), self.optionxform(option)
        for each in vars or {}:
            known[self.optionxform(each)] = vars[each]
        if name in known:
            value = known[name] if raw else self._interpolation.before_get(self, section, option, known[name], vars)
            return either(value, unknown('file', section + '.' + option, 'str')) if self._open else value
        if self._open:
            value = unknown('file', section + '.' + option, 'str')
            return value if fallback is _NOTHING else either(fallback, value)
        if fallback is not _NOTHING:
            return fallback
        if section not in self._known:
            raise NoSectionError(section)
        raise NoOptionError(option, section)
    def _as(self, convert, section, option, fallback, vars):
        value = self.get(section, option, vars=vars, fallback=_NOTHING if fallback is _NOTHING else None)
        return fallback if value is None else convert(value)
    def getint(self, section, option, *, raw=False, vars=None, fallback=_NOTHING, **kwargs):
        return self._as(int, section, option, fallback, vars)
    def getfloat(self, section, option, *, raw=False, vars=None, fallback=_NOTHING, **kwargs):
        return self._as(float, section, option, fallback, vars)
    def getboolean(self, section, option, *, raw=False, vars=None, fallback=_NOTHING, **kwargs):
        return self._as(lambda value: value.lower() in ('1', 'yes', 'true', 'on'), section, option, fallback, vars)
    def set(self, section, option, value=None):
        if section not in self._known:
            if not self._open:
                raise NoSectionError(section)
            self._known[section] = {}
        self._known[section][self.optionxform(option)] = value
    def add_section(self, section):
        if section in self._known and not self._open:
            raise DuplicateSectionError(section)
        self._known[section] = {}
    def has_section(self, section):
        return section in self._known and section != self.default_section or (unknown('file', section, 'bool') if self._open else False)
    def has_option(self, section, option):
        return self.optionxform(option) in self._of(section) or (unknown('file', section, 'bool') if self._open else False)
    def remove_section(self, section):
        return self._known.pop(section, None) is not None
    def remove_option(self, section, option):
        return self._known.get(section, {}).pop(self.optionxform(option), None) is not None
    def sections(self):
        found = [name for name in self._known if name != self.default_section]
        if self._open:
            found += [unknown('file', 'sections', 'str') for _ in unknown('file', 'sections', 'list')]
        return found
    def options(self, section):
        found = list(self._of(section))
        if self._open:
            found += [unknown('file', section, 'str') for _ in unknown('file', section, 'list')]
        return found
    def items(self, section=None, raw=False, vars=None):
        if section is None:
            return [(name, SectionProxy(self, name)) for name in [self.default_section, *self.sections()]]
        found = [(name, value if raw else self._interpolation.before_get(self, section, name, value, vars)) for name, value in self._of(section).items()]
        if self._open:
            found += [(unknown('file', section, 'str'), unknown('file', section, 'str')) for _ in unknown('file', section, 'list')]
        return found
    def keys(self):
        return [self.default_section, *self.sections()]
    def values(self):
        return [SectionProxy(self, name) for name in self.keys()]
    def defaults(self):
        return self._known[self.default_section]
    def __getitem__(self, key):
        if key not in self._known and not self._open:
            raise KeyError(key)
        return SectionProxy(self, key)
    def __setitem__(self, key, value):
        self._known[key] = {}
        for option in value:
            self._known[key][self.optionxform(option)] = value[option]
    def __delitem__(self, key):
        del self._known[key]
    def __contains__(self, key):
        return key == self.default_section or self.has_section(key)
    def __iter__(self):
        return iter(self.keys())
    def __len__(self):
        return len(self.keys())
    def write(self, fp, space_around_delimiters=True):
        ask(fp, 'write', unknown('call', 'text that a library writes', 'str'))
class ConfigParser(RawConfigParser):
    def _usual(self):
        return BasicInterpolation()
SafeConfigParser = ConfigParser
