# SPDX-License-Identifier: Apache-2.0
"""launch.substitutions.

Read from launch 3.7.0, with what humble had before it.
"""

from _rosward.launch import keep
from launch.substitution import Substitution


class SubstitutionFailure(RuntimeError): ...


class TextSubstitution(Substitution):
    def __init__(self, *, text):
        self.text = text
        keep(self, None, text=text)


class LaunchConfiguration(Substitution):
    def __init__(self, variable_name, *, default=None):
        self.variable_name = variable_name
        keep(self, None, name=variable_name, default=default)


class EnvironmentVariable(Substitution):
    def __init__(self, name, *, default_value=None):
        self.name = name
        keep(self, None, name=name, default=default_value)


class FindExecutable(Substitution):
    def __init__(self, *, name):
        self.name = name
        keep(self, None, name=name)


class AnonName(Substitution):
    def __init__(self, name):
        self.name = name
        keep(self, None, name=name)


class LocalSubstitution(Substitution):
    def __init__(self, expression, description=None):
        self.expression = expression
        keep(self, None, expression=expression)


class ThisLaunchFile(Substitution):
    def __init__(self):
        keep(self)


class ThisLaunchFileDir(Substitution):
    def __init__(self):
        keep(self)


class LaunchLogDir(Substitution):
    def __init__(self):
        keep(self)


class PythonExpression(Substitution):
    def __init__(self, expression, python_modules=["math"]):
        self.expression = expression
        keep(self, None, expression=expression, modules=python_modules)


class Command(Substitution):
    def __init__(self, command, *, on_stderr="fail"):
        self.command = command
        keep(self, None, command=command, on_stderr=on_stderr)


class FileContent(Substitution):
    def __init__(self, path):
        self.path = path
        keep(self, None, path=path)


class PathJoinSubstitution(Substitution):
    def __init__(self, substitutions):
        self.substitutions = substitutions
        keep(self, None, parts=substitutions)

    def __truediv__(self, other):
        return PathJoinSubstitution([*self.substitutions, other])


class PathSubstitution(PathJoinSubstitution):
    def __init__(self, path):
        super().__init__([path])


class StringJoinSubstitution(Substitution):
    def __init__(self, substitutions, delimiter=""):
        keep(self, None, parts=substitutions, delimiter=delimiter)


class NotSubstitution(Substitution):
    def __init__(self, value):
        self.value = value
        keep(self, None, value=value)


class _Both(Substitution):
    def __init__(self, left, right):
        self.left = left
        self.right = right
        keep(self, None, left=left, right=right)


class AndSubstitution(_Both): ...
class OrSubstitution(_Both): ...


class AnySubstitution(Substitution):
    def __init__(self, *args):
        self.args = args
        keep(self, None, parts=args)


class AllSubstitution(AnySubstitution): ...


class EqualsSubstitution(Substitution):
    def __init__(self, left, right):
        self.left = left
        self.right = right
        keep(self, None, left=left, right=right)


class NotEqualsSubstitution(EqualsSubstitution): ...


class IfElseSubstitution(Substitution):
    def __init__(self, condition, if_value="", else_value=""):
        keep(self, None, test=condition, then=if_value, otherwise=else_value)


class ForEachVar(Substitution):
    def __init__(self, name, *, default_value=None):
        keep(self, None, name=name, default=default_value)


class ForLoopIndex(Substitution):
    def __init__(self, name, *, default_value=None):
        keep(self, None, name=name, default=default_value)
