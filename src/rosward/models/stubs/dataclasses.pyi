# SPDX-License-Identifier: Apache-2.0
"""`dataclasses`: see models/python/std/records.py."""

MISSING = object()
KW_ONLY = object()

class FrozenInstanceError(AttributeError): ...
class InitVar:
    def __class_getitem__(cls, item):
        return cls
class Field: ...
