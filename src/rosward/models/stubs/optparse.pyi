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

class OptionContainer(argparse._ActionsContainer):
    def add_option(self, *args, **kwargs):
        return self.add_argument(*args, **kwargs)

class OptionGroup(OptionContainer):
    def __init__(self, parser, title, description=None):
        self._actions = parser._actions
        self._defaults = parser._defaults

class OptionParser(OptionContainer):
    def __init__(self, usage=None, option_list=None, option_class=None, version=None, conflict_handler='error', description=None,
                 formatter=None, add_help_option=True, prog=None, epilog=None):
        self._actions = []
        self._defaults = {}
        self.usage = usage
    def add_option_group(self, *args, **kwargs):
        return args[0] if args else None
    def parse_args(self, args=None, values=None):
        target = Values() if values is None else values
        for action in self._actions:
            action._store(self, target, None)
        for name in self._defaults:
            setattr(target, name, self._defaults[name])
        return target, unknown('argument', 'sys.argv', 'list')
    def print_help(self, file=None):
        ask(file, 'write', unknown('call', 'text that a library writes', 'str'))
    def print_usage(self, file=None):
        ask(file, 'write', unknown('call', 'text that a library writes', 'str'))
    def error(self, msg):
        sys.exit(2)
