# SPDX-License-Identifier: Apache-2.0
"""`click`: a command calls its function with what its options declare."""
from _rosward import ask, either, escape, reads_only, unknown
import argparse
import sys

class _Optioned:
    """A function with options, before @command()."""
    def __init__(self, callback, container):
        self.callback = callback
        self._container = container
    def __call__(self, *args, **kwargs):
        return self.callback(*args, **kwargs)

class _Container(argparse._ActionsContainer):
    def __init__(self):
        self._actions = []
        self._defaults = {}
        self._callbacks = []

def _declare(function, flags, default, type, required, multiple, is_flag, nargs, expose_value=True, callback=None):
    target = function if isinstance(function, (_Optioned, Command)) else _Optioned(function, _Container())
    if not expose_value:
        if callback is not None:
            escape(callback)
        return target
    if is_flag:
        action = target._container.add_argument(*flags, action='store_true')
    else:
        many = '*' if multiple or nargs == -1 else None
        action = target._container.add_argument(*flags, default=default, type=type if callable(type) else None, required=required, nargs=many)
    if callback is not None:
        target._container._callbacks.append((action, callback))
    return target

def option(*param_decls, cls=None, default=None, type=None, required=False, multiple=False, is_flag=False, nargs=1, expose_value=True, callback=None, **attrs):
    def decorate(function):
        return _declare(function, param_decls, default, type, required, multiple, is_flag, nargs, expose_value, callback)
    return decorate
def argument(*param_decls, cls=None, default=None, type=None, required=True, nargs=1, expose_value=True, callback=None, **attrs):
    def decorate(function):
        return _declare(function, param_decls, default, type, required and default is None, False, False, nargs, expose_value, callback)
    return decorate

class Context:
    """Not followed."""

def pass_context(f):
    def with_context(*args, **kwargs):
        return f(Context(), *args, **kwargs)
    return with_context

class Command:
    def __init__(self, name=None, callback=None, container=None):
        self.name = name
        self.callback = callback
        self._container = _Container() if container is None else container
        self._commands = []
    def __call__(self, *args, **kwargs):
        return self.main(*args, **kwargs)
    def main(self, args=None, prog_name=None, complete_var=None, standalone_mode=True, **extra):
        namespace = argparse.Namespace()
        for action in self._container._actions:
            action._store(None, namespace, None)
        for action, callback in self._container._callbacks:
            value = callback(Context(), unknown('call', 'a parameter of click'), getattr(namespace, action.dest))
            setattr(namespace, action.dest, value)
        result = self.callback(**vars(namespace))
        if self._commands:
            either(*self._commands)()
        return result
    def add_command(self, cmd, name=None):
        self._commands.append(cmd)
    def command(self, *args, **kwargs):
        def decorate(function):
            made = _command(function)
            self._commands.append(made)
            return made
        if args and callable(args[0]):
            return decorate(args[0])
        return decorate
    def group(self, *args, **kwargs):
        return self.command(*args, **kwargs)

Group = Command

def _command(function):
    if isinstance(function, _Optioned):
        return Command(None, function.callback, function._container)
    return Command(None, function)
def command(name=None, cls=None, **attrs):
    if callable(name):
        return _command(name)
    return _command
def group(name=None, cls=None, **attrs):
    if callable(name):
        return _command(name)
    return _command
def echo(message=None, file=None, nl=True, err=False, color=None):
    ask(file, 'write', unknown('call', 'text that a library writes', 'str'))
def secho(message=None, file=None, nl=True, err=False, color=None, **styles):
    ask(file, 'write', unknown('call', 'text that a library writes', 'str'))
@reads_only
def style(text, **styles) -> str: ...
def prompt(text, **kwargs):
    return unknown('input', 'click.prompt', 'str')
def confirm(text, **kwargs):
    return unknown('input', 'click.confirm', 'bool')
