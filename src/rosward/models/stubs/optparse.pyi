# SPDX-License-Identifier: Apache-2.0
"""`optparse`: as `argparse`, with options only."""
from _rosward import ask, reads_only, unknown
import argparse
import sys

@reads_only
class Values(argparse.Namespace):
    def __init__(self, defaults=None): ...
    def ensure_value(self, attr, value):
        return getattr(self, attr, value)

_TYPES = {'int': int, 'long': int, 'float': float, 'complex': complex, 'string': str, 'choice': str}

class Option:
    def __init__(self, *args, **kwargs):
        self._args = args
        self._keywords = kwargs
make_option = Option

class OptionContainer(argparse._ActionsContainer):
    def add_option(self, *args, **kwargs):
        if args and isinstance(args[0], Option):
            return self.add_option(*args[0]._args, **args[0]._keywords)
        if kwargs.get('type') in _TYPES:
            kwargs['type'] = _TYPES[kwargs['type']]
        made = self.add_argument(*args, **kwargs)
        for other in self._actions:  # the last default that is written counts
            if other is not made and other.dest == made.dest:
                if 'default' in kwargs:
                    other.default = made.default
                else:
                    made.default = other.default
        return made
    def add_options(self, option_list):
        for option in option_list:
            self.add_option(*option._args, **option._keywords)

class OptionGroup(OptionContainer):
    def __init__(self, parser, title, description=None):
        self._actions = parser._actions
        self._defaults = parser._defaults

class OptionParser(OptionContainer):
    def __init__(self, usage=None, option_list=None, option_class=None, version=None, conflict_handler='error', description=None,
                 formatter=None, add_help_option=True, prog=None, epilog=None):
        self._actions = []
        self._defaults = {}
        self._sub = []
        self._mixed = True
        self.usage = usage
        self.add_options(option_list or ())
    def disable_interspersed_args(self):
        self._mixed = False
    def enable_interspersed_args(self):
        self._mixed = True
    def add_option_group(self, *args, **kwargs):
        return args[0] if args else None
    def parse_args(self, args=None, values=None):
        target = Values() if values is None else values
        arguments = sys.argv[1:] if args is None else args
        found = argparse._exact(self._actions, arguments, True, '-') if self._mixed else None
        if found is not None:
            argparse.ArgumentParser._fill(self, target, found[0], False)
            return target, found[1]
        argparse.ArgumentParser._fill(self, target, None, False)
        if not argparse._is_typed(arguments):
            argparse.ArgumentParser._loosen(self, target)
        return target, unknown('argument', 'sys.argv', 'list')
    def print_help(self, file=None):
        ask(file, 'write', unknown('call', 'text that a library writes', 'str'))
    def print_usage(self, file=None):
        ask(file, 'write', unknown('call', 'text that a library writes', 'str'))
    def error(self, msg):
        sys.exit(2)
