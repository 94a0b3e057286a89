# SPDX-License-Identifier: Apache-2.0
"""attr.setters: what runs when an attribute is assigned.

Read from attrs 26.1.
"""
from attr.exceptions import FrozenAttributeError
import attr

def NO_OP(instance, attrib, new_value):
    return new_value
def pipe(*setters):
    def assign(instance, attrib, new_value):
        for one in setters:
            new_value = one(instance, attrib, new_value)
        return new_value
    return assign
def frozen(_, __, ___):
    raise FrozenAttributeError()
def validate(instance, attrib, new_value):
    attr._checked(instance, attrib, new_value)
    return new_value
def convert(instance, attrib, new_value):
    return attr._converted(instance, attrib, new_value)
