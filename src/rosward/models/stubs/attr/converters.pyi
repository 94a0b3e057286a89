# SPDX-License-Identifier: Apache-2.0
"""attr.converters.

Read from attrs 26.1.
"""
import attr

def optional(converter):
    def convert(value):
        return None if value is None else converter(value)
    return convert
def default_if_none(default=None, factory=None):
    def convert(value):
        if value is not None:
            return value
        if factory is not None:
            return factory()
        return default.factory() if isinstance(default, attr.Factory) else default
    return convert
def pipe(*converters):
    def convert(value):
        for one in converters:
            value = one(value)
        return value
    return convert
def to_bool(val):
    if isinstance(val, str):
        val = val.lower()
    if val in (True, 'true', 't', 'yes', 'y', 'on', '1', 1):
        return True
    if val in (False, 'false', 'f', 'no', 'n', 'off', '0', 0):
        return False
    raise ValueError('cannot convert value to bool')
