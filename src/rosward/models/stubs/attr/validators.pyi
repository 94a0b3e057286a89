# SPDX-License-Identifier: Apache-2.0
"""attr.validators: what refuses a value. A value that is not known is taken as it is.

Read from attrs 26.1.
"""
from _rosward import unknown

def _passes(instance, attribute, value):
    return None
def instance_of(type):
    def check(instance, attribute, value):
        if not isinstance(value, type):
            raise TypeError('wrong type')
    return check
def in_(options):
    def check(instance, attribute, value):
        if value not in options:
            raise ValueError('none of the values')
    return check
def optional(validator):
    def check(instance, attribute, value):
        if value is not None:
            for one in validator if isinstance(validator, (list, tuple)) else [validator]:
                one(instance, attribute, value)
    return check
def and_(*validators):
    def check(instance, attribute, value):
        for one in validators:
            one(instance, attribute, value)
    return check
def or_(*validators):
    return _passes if unknown('call', 'attr.validators.or_', 'bool') else _refuses
def not_(validator, *, msg=None, exc_types=()):
    return _passes if unknown('call', 'attr.validators.not_', 'bool') else _refuses
def _refuses(instance, attribute, value):
    raise ValueError('refused')
def matches_re(regex, flags=0, func=None):
    return _passes if unknown('call', 'attr.validators.matches_re', 'bool') else _refuses
def deep_iterable(member_validator, iterable_validator=None):
    return _passes
def deep_mapping(key_validator=None, value_validator=None, mapping_validator=None):
    return _passes
def is_callable():
    return _passes
def subclass_of(type_):
    return _passes
def lt(val):
    def check(instance, attribute, value):
        if not value < val:
            raise ValueError('too large')
    return check
def le(val):
    def check(instance, attribute, value):
        if not value <= val:
            raise ValueError('too large')
    return check
def ge(val):
    def check(instance, attribute, value):
        if not value >= val:
            raise ValueError('too small')
    return check
def gt(val):
    def check(instance, attribute, value):
        if not value > val:
            raise ValueError('too small')
    return check
def max_len(length):
    def check(instance, attribute, value):
        if len(value) > length:
            raise ValueError('too long')
    return check
def min_len(length):
    def check(instance, attribute, value):
        if len(value) < length:
            raise ValueError('too short')
    return check
class disabled:
    def __enter__(self):
        return None
    def __exit__(self, exc_type, exc_val, exc_tb):
        return None
def set_disabled(disabled):
    return None
def get_disabled():
    return False
