# SPDX-License-Identifier: Apache-2.0
"""`argparse`: declared arguments become attributes of the namespace, by default or unknown; of known arguments, exactly."""
from _rosward import ask, default as only_default, reads_only, unknown
from _rosward import either, escape, native, unknown
import os
import sys

@native
def _dest(flags, prefix): ...
@native
def _shown(flags, dest): ...
@native
def _kind(nargs): ...
@native
def _exact(actions, arguments, some, prefix): ...
@native
def _is_typed(arguments): ...

SUPPRESS = '==SUPPRESS=='
OPTIONAL = '?'
ZERO_OR_MORE = '*'
ONE_OR_MORE = '+'
PARSER = 'A...'
REMAINDER = '...'

class ArgumentError(Exception):
    def __init__(self, argument, message):
        self.message = message
class ArgumentTypeError(Exception): ...

class HelpFormatter: ...
class RawDescriptionHelpFormatter(HelpFormatter): ...
class RawTextHelpFormatter(RawDescriptionHelpFormatter): ...
class ArgumentDefaultsHelpFormatter(HelpFormatter): ...
class MetavarTypeHelpFormatter(HelpFormatter): ...

@reads_only
class FileType:
    def __init__(self, mode='r', bufsize=-1, encoding=None, errors=None): ...
    def __call__(self, string):
        return open(string)

class Namespace:
    def __init__(self, **kwargs):
        for name in kwargs:
            setattr(self, name, kwargs[name])
    def __contains__(self, key):
        return hasattr(self, key)

@reads_only
class Action:
    """One declared argument."""
    def __init__(self, option_strings, dest, nargs=None, const=None, default=None, type=None, choices=None, required=False, help=None, metavar=None):
        self.option_strings = option_strings
        self.dest = dest
        self.nargs = nargs
        self.const = const
        self.default = default
        self.type = type
        self.choices = choices
        self.required = required
        self.help = help
        self.metavar = metavar
    def __call__(self, parser, namespace, values, option_string=None): ...

class BooleanOptionalAction(Action): ...

class _Declared(Action):
    """What add_argument makes."""
    def _start(self, action, given, prefix):
        self._prefix = prefix
        self._action = action
        self._given = given
        self._shown = _shown(self.option_strings, self.dest)
    def _positional(self):
        return self.option_strings[0][0] not in self._prefix if self.option_strings else True
    def _convert(self, value):
        if self.type is None or value is None:
            return value
        return self.type(value)
    def _of_default(self):
        if self.type is not None and isinstance(self.default, str):
            return self.type(self.default)
        return self.default
    def _of_command_line(self):
        """What is stored where the argument is given, with what is not known."""
        if self.choices is not None and self.nargs is None:
            return either(*self.choices)
        kind = _kind(self.nargs)
        if kind == 'str':
            return self._convert(unknown('argument', self._shown, 'str'))
        return [self._convert(unknown('argument', self._shown, 'str')) for _ in unknown('argument', self._shown, 'list')]
    def _store(self, parser, namespace, known):
        """Set the attribute; `known` holds what surely is given, None where the command line is not known."""
        if known is not None:
            if self.dest in known:
                setattr(namespace, self.dest, known[self.dest])
            elif self.default != SUPPRESS:
                setattr(namespace, self.dest, self._unset())
        elif self.default == SUPPRESS:
            if unknown('argument', self._shown, 'bool'):
                setattr(namespace, self.dest, self._of_command_line())
        else:
            setattr(namespace, self.dest, self._open())
            if not isinstance(self._action, str):
                self._custom(parser, namespace)
    def _store_beside(self, namespace, known, first):
        """`first` has the same attribute: its default counts. Where that may be given anything, this one gives nothing else."""
        if known is None and hasattr(namespace, self.dest):
            if self._action == 'store_const':
                setattr(namespace, self.dest, either(getattr(namespace, self.dest), self.const))
            elif self._action == 'store' and first._action != 'store':
                setattr(namespace, self.dest, either(getattr(namespace, self.dest), self._of_command_line()))
    def _unset(self):
        if self._action == 'store_true' and 'default' not in self._given:
            return False
        if self._action == 'store_false' and 'default' not in self._given:
            return True
        return self._of_default()
    def _open(self):
        if self._action == 'store_true' or self._action == 'store_false':
            return only_default('argument', self._shown, self._unset())
        value = self._of_default()
        if self._action == 'store_const':
            return either(value, self.const)
        if self._action == 'append' or self._action == 'extend' or self._action == 'append_const':
            return either(value, unknown('argument', self._shown, 'list'))
        if self._action == 'count':
            return only_default('argument', self._shown, value) if value is not None else either(None, unknown('argument', self._shown, 'int'))
        if self.required or (self._positional() and self.nargs != '?' and self.nargs != '*'):
            return self._of_command_line()
        if value is None:
            if self._action is BooleanOptionalAction:
                return either(None, True, False)
            return either(None, self._of_command_line())
        return only_default('argument', self._shown, value)
    def _custom(self, parser, namespace):
        if self._action is BooleanOptionalAction:
            return
        action = self._action(self.option_strings, self.dest, **self._given)
        action(parser, namespace, unknown('argument', self._shown), self._shown)

class _ActionsContainer:
    """What arguments are added to: a parser or a group of one."""
    _prefix = '-'
    _unset = None
    def add_argument(self, *name_or_flags, action='store', dest=None, nargs=None, const=None, default=None, type=None, choices=None,
                     required=False, help=None, metavar=None, version=None, **kwargs):
        target = dest if dest is not None else _dest(name_or_flags, self._prefix)
        given = {}
        if default is None:
            default = self._unset
        if default is not None:
            given['default'] = default
        if nargs is not None:
            given['nargs'] = nargs
        made = _Declared(name_or_flags, target, nargs, const, default, type, choices, required, help, metavar)
        made._start(action, given, self._prefix)
        if action != 'help' and action != 'version':
            self._actions.append(made)
        return made
    def add_argument_group(self, *args, **kwargs):
        return _Group(self)
    def add_mutually_exclusive_group(self, *, required=False):
        return _Group(self)
    def set_defaults(self, **kwargs):
        self._defaults.update(kwargs)
    def get_default(self, dest):
        if dest in self._defaults:
            return self._defaults[dest]
        for action in self._actions:
            if action.dest == dest:
                return action.default
        return None
    @reads_only
    def register(self, registry_name, value, object): ...

class _Group(_ActionsContainer):
    def __init__(self, container):
        self._prefix = container._prefix
        self._unset = container._unset
        self._actions = container._actions
        self._defaults = container._defaults

def _holds(target, name):
    return name in vars(target) if isinstance(target, Namespace) else hasattr(target, name)

class _SubParsers:
    def __init__(self, parent, dest, required):
        self._parent = parent
        self._parsers = []
        self._names = []
        self.dest = dest
        self.required = required
    def add_parser(self, name, *, help=None, aliases=(), parser_class=None, **kwargs):
        parser = ArgumentParser(**({'prog': f'{self._parent.prog} {name}'} | kwargs))
        self._parsers.append(parser)
        self._names.append(name)
        return parser
    def _store(self, namespace):
        if self.dest is not None:
            value = either(*self._names) if self._names else None
            if not self.required:
                value = either(None, value)
            setattr(namespace, self.dest, value)
        for parser in self._parsers:
            parser._fill(namespace, None, True)

class ArgumentParser(_ActionsContainer):
    def __init__(self, prog=None, usage=None, description=None, epilog=None, parents=[], formatter_class=HelpFormatter, prefix_chars='-',
                 fromfile_prefix_chars=None, argument_default=None, conflict_handler='error', add_help=True, allow_abbrev=True, exit_on_error=True):
        self.prog = os.path.basename(sys.argv[0]) if prog is None else prog
        self.usage = usage
        self.description = description
        self.epilog = epilog
        self._prefix = prefix_chars
        self._unset = argument_default
        self._actions = []
        self._defaults = {}
        self._sub = []
        for parent in parents:
            self._actions.extend(parent._actions)
            self._defaults.update(parent._defaults)
    def add_subparsers(self, *, title=None, description=None, prog=None, parser_class=None, action=None, option_string=None, dest=None,
                       required=False, help=None, metavar=None, **kwargs):
        made = _SubParsers(self, dest, required)
        self._sub.append(made)
        return made
    def _fill(self, namespace, known, weak):
        stored = {}
        for action in self._actions:
            if action.dest in stored:
                action._store_beside(namespace, known, stored[action.dest])
            else:
                action._store(self, namespace, known)
                stored[action.dest] = action
        for name in self._defaults:
            value = self._defaults[name]
            if weak and hasattr(namespace, name):
                value = either(getattr(namespace, name), value)
            elif known is None or name not in known:
                for action in self._actions:
                    if known is None and action.dest == name:
                        value = only_default('argument', action._shown, value)
            else:
                value = known[name]
            setattr(namespace, name, value)
        for sub in self._sub:
            sub._store(namespace)
    def _loosen(self, namespace):
        """The program itself gives words that are not known."""
        for action in self._actions:
            if hasattr(namespace, action.dest):
                setattr(namespace, action.dest, either(getattr(namespace, action.dest), unknown('call', 'argparse')))
        for sub in self._sub:
            for parser in sub._parsers:
                parser._loosen(namespace)
    def _parse(self, args, namespace, some):
        arguments = sys.argv[1:] if args is None else args
        target = Namespace() if namespace is None else namespace
        names = [] if namespace is None else [*[action.dest for action in self._actions], *self._defaults]
        before = {name: getattr(target, name) for name in names if _holds(target, name)}
        found = _exact(self._actions, arguments, some, self._prefix) if not self._sub else None
        if found is None:
            self._fill(target, None, False)
            if not _is_typed(arguments):
                self._loosen(target)
        else:
            self._fill(target, found[0], False)
        for name in before:  # no default replaces what is there
            setattr(target, name, either(before[name], getattr(target, name)))
        return target, unknown('argument', 'sys.argv', 'list') if found is None else found[1]
    def parse_args(self, args=None, namespace=None):
        return self._parse(args, namespace, False)[0]
    def parse_known_args(self, args=None, namespace=None):
        return self._parse(args, namespace, True)
    def parse_intermixed_args(self, args=None, namespace=None):
        return self._parse(args, namespace, False)[0]
    def parse_known_intermixed_args(self, args=None, namespace=None):
        return self._parse(args, namespace, True)
    def print_help(self, file=None):
        ask(file, 'write', unknown('call', 'text that a library writes', 'str'))
    def print_usage(self, file=None):
        ask(file, 'write', unknown('call', 'text that a library writes', 'str'))
    @reads_only
    def format_help(self) -> str: ...
    @reads_only
    def format_usage(self) -> str: ...
    def exit(self, status=0, message=None):
        sys.exit(status)
    def error(self, message):
        sys.exit(2)
