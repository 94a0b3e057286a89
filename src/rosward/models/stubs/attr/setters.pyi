# SPDX-License-Identifier: Apache-2.0
"""attr.setters.

Read from attrs 26.1.
"""
from _rosward import reads_only

reads_only(__name__)

NO_OP = object()
def pipe(*setters): ...
def frozen(_, __, ___): ...
def validate(instance, attrib, new_value):
    return new_value
def convert(instance, attrib, new_value):
    return new_value
