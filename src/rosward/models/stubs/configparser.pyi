# SPDX-License-Identifier: Apache-2.0
"""`configparser`: what stands in the file is not known, unless the program sets it."""
from _rosward import either, unknown

class Error(Exception): ...
class NoSectionError(Error): ...
class NoOptionError(Error): ...

class SectionProxy:
    def __init__(self, parser, name):
        self._parser = parser
        self._name = name
        self.name = name
    def __getitem__(self, key):
        return self._parser.get(self._name, key)
    def __setitem__(self, key, value):
        self._parser.set(self._name, key, value)
    def __contains__(self, key) -> bool: ...
    def get(self, option, fallback=None, *, raw=False, vars=None, _impl=None, **kwargs):
        return either(fallback, self._parser.get(self._name, option))
    def getint(self, option, fallback=None, *, raw=False, vars=None, **kwargs):
        return either(fallback, unknown('file', self._name + '.' + option, 'int'))
    def getfloat(self, option, fallback=None, *, raw=False, vars=None, **kwargs):
        return either(fallback, unknown('file', self._name + '.' + option, 'float'))
    def getboolean(self, option, fallback=None, *, raw=False, vars=None, **kwargs):
        return either(fallback, unknown('file', self._name + '.' + option, 'bool'))
    def keys(self):
        return unknown('file', self._name, 'list')
    def items(self):
        return unknown('file', self._name, 'list')
    def __iter__(self):
        return iter(unknown('file', self._name, 'list'))

class RawConfigParser:
    def __init__(self, defaults=None, dict_type=dict, allow_no_value=False, **kwargs):
        self._set = {}
    def read(self, filenames, encoding=None):
        return unknown('file', filenames if isinstance(filenames, str) else '', 'list')
    def read_file(self, f, source=None) -> None: ...
    def read_string(self, string, source='<string>') -> None: ...
    def read_dict(self, dictionary, source='<dict>') -> None: ...
    def get(self, section, option, *, raw=False, vars=None, fallback=None, **kwargs):
        value = unknown('file', section + '.' + option, 'str')
        if (section, option) in self._set:
            value = either(value, self._set[(section, option)])
        return value if fallback is None else either(fallback, value)
    def getint(self, section, option, *, raw=False, vars=None, fallback=None, **kwargs):
        value = unknown('file', section + '.' + option, 'int')
        return value if fallback is None else either(fallback, value)
    def getfloat(self, section, option, *, raw=False, vars=None, fallback=None, **kwargs):
        value = unknown('file', section + '.' + option, 'float')
        return value if fallback is None else either(fallback, value)
    def getboolean(self, section, option, *, raw=False, vars=None, fallback=None, **kwargs):
        value = unknown('file', section + '.' + option, 'bool')
        return value if fallback is None else either(fallback, value)
    def set(self, section, option, value=None):
        self._set[(section, option)] = value
    def add_section(self, section) -> None: ...
    def has_section(self, section) -> bool: ...
    def has_option(self, section, option) -> bool: ...
    def sections(self):
        return [unknown('file', 'sections', 'str') for _ in unknown('file', 'sections', 'list')]
    def options(self, section):
        return [unknown('file', section, 'str') for _ in unknown('file', section, 'list')]
    def items(self, section=None, raw=False, vars=None):
        return unknown('file', '', 'list')
    def __getitem__(self, key):
        return SectionProxy(self, key)
    def __setitem__(self, key, value):
        for option in value:
            self._set[(key, option)] = value[option]
    def __contains__(self, key) -> bool: ...
    def __iter__(self):
        return iter(self.sections())
    def write(self, fp, space_around_delimiters=True) -> None: ...
class ConfigParser(RawConfigParser): ...
SafeConfigParser = ConfigParser
