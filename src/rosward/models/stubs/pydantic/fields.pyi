# SPDX-License-Identifier: Apache-2.0
"""pydantic.fields: what a program says of a field.

Read from pydantic 2.14 and 1.10.
"""
from _fields import bound, room
from _rosward import unknown
import copy

class _Missing: ...
MISSING = _Missing()
PydanticUndefined = MISSING

class AliasPath:
    def __init__(self, first_arg, *args):
        self.path = [first_arg, *args]
class AliasChoices:
    def __init__(self, first_choice, *choices):
        self.choices = [first_choice, *choices]

class FieldInfo:
    def __init__(self, default=MISSING, default_factory=None, alias=None, validation_alias=None, serialization_alias=None, exclude=None, options=None):
        self.default = MISSING if default is ... else default
        self.default_factory = default_factory
        self.alias = alias
        self.validation_alias = validation_alias
        self.serialization_alias = serialization_alias
        self.exclude = exclude
        self.options = options or {}
        self.validate_default = self.options.get('validate_default')
        self.description = self.options.get('description')
        self.title = self.options.get('title')
        self.json_schema_extra = self.options.get('json_schema_extra')
        self.shape = ('any',)
    def over(self, written):
        """This of an annotation, with the default that the class body gives."""
        default = self.default if written.default is MISSING else written.default
        return FieldInfo(default, self.default_factory, self.alias, self.validation_alias, self.serialization_alias, self.exclude, self.options)
    def like(self, other):
        """Another default of a field that a base class has."""
        self.shape = other.shape
        return self
    def keys(self):
        found = self.validation_alias if self.validation_alias is not None else self.alias
        if found is None:
            return []
        if isinstance(found, AliasChoices):
            return [choice if isinstance(choice, str) else unknown('call', 'pydantic.AliasPath', 'str') for choice in found.choices]
        return [found] if isinstance(found, str) else [unknown('call', 'pydantic.AliasPath', 'str')]
    def is_required(self):
        return self.default is MISSING and self.default_factory is None
    def get_default(self, *, call_default_factory=False, **kwargs):
        return self.made({}) if call_default_factory or self.default_factory is None else None
    def made(self, values):
        """The default; MISSING where there is none."""
        if self.default_factory is not None:
            return self.default_factory(values) if room(self.default_factory) == 1 and not isinstance(self.default_factory, type) else self.default_factory()
        if isinstance(self.default, (list, dict, set)):
            return copy.deepcopy(self.default)
        return self.default
    def applied(self, value):
        """What options that change texts make of one."""
        if isinstance(value, str):
            if self.options.get('strip_whitespace'):
                value = value.strip()
            if self.options.get('to_lower'):
                value = value.lower()
            if self.options.get('to_upper'):
                value = value.upper()
        return value

def Field(default=MISSING, *, default_factory=None, alias=None, validation_alias=None, serialization_alias=None, exclude=None, **extra):
    return FieldInfo(default, default_factory, alias, validation_alias, serialization_alias, exclude, extra)
def PrivateAttr(default=MISSING, *, default_factory=None, init=False):
    return FieldInfo(default, default_factory)

class _Computed:
    def __init__(self, wrapped):
        self.wrapped = wrapped
    def __get__(self, instance, owner=None):
        if instance is None:
            return self
        found = bound(self.wrapped, owner, instance)
        return found() if callable(found) and not isinstance(self.wrapped, property) else found
def computed_field(func=None, /, **options):
    return _Computed if func is None else _Computed(func)
