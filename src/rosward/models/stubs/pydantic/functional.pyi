# SPDX-License-Identifier: Apache-2.0
"""The decorators of pydantic, and what may stand beside a type in `Annotated`.

Read from pydantic 2.14 and 1.10 (functional_validators, functional_serializers, class_validators).
"""
from _fields import bound
import functools

class _Marked:
    """A function of a model that pydantic calls."""
    def __init__(self, function, kind, fields, mode, old, always):
        self.function = function
        self.kind = kind
        self.fields = fields
        self.mode = mode
        self.old = old
        self.always = always
    def __get__(self, instance, owner=None):
        return bound(self.function, owner, instance)

def _marked(kind, fields, mode, old, always, function):
    return _Marked(function, kind, fields, mode, old, always)

def field_validator(field, /, *fields, mode='after', **options):
    return functools.partial(_marked, 'field', (field, *fields), mode, False, False)
def validator(*fields, pre=False, always=False, **options):
    return functools.partial(_marked, 'field', fields, 'before' if pre else 'after', True, always)
def model_validator(*, mode):
    return functools.partial(_marked, 'model', (), mode, False, False)
def root_validator(*args, pre=False, **options):
    if args:
        return _marked('model', (), 'after', True, False, args[0])
    return functools.partial(_marked, 'model', (), 'before' if pre else 'after', True, False)
def field_serializer(*fields, mode='plain', **options):
    return functools.partial(_marked, 'serializer', fields, mode, False, False)
def model_serializer(f=None, /, *, mode='plain', **options):
    if f is not None:
        return _marked('model serializer', (), mode, False, False, f)
    return functools.partial(_marked, 'model serializer', (), mode, False, False)
def validate_call(func=None, /, **options):
    def decorate(function):
        return function
    return decorate if func is None else func

class AfterValidator:
    def __init__(self, func):
        self.func = func
class BeforeValidator:
    def __init__(self, func, json_schema_input_type=None):
        self.func = func
class PlainValidator:
    def __init__(self, func, json_schema_input_type=None):
        self.func = func
class WrapValidator:
    def __init__(self, func, json_schema_input_type=None):
        self.func = func
class PlainSerializer:
    def __init__(self, func, return_type=None, when_used='always'):
        self.func = func
class SkipValidation:
    def __class_getitem__(cls, item):
        return item
class InstanceOf:
    def __class_getitem__(cls, item):
        return item
class StringConstraints:
    def __init__(self, *, strip_whitespace=None, to_upper=None, to_lower=None, strict=None, min_length=None, max_length=None, pattern=None):
        self._strips = strip_whitespace
        self._upper = to_upper
        self._lower = to_lower
    def applied(self, value):
        if self._strips:
            value = value.strip()
        if self._lower:
            value = value.lower()
        return value.upper() if self._upper else value
