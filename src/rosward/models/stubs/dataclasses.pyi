# SPDX-License-Identifier: Apache-2.0
"""`dataclasses`: see models/python/std/records.py."""

from _rosward import reads_only

reads_only(__name__)

MISSING = object()
KW_ONLY = object()

class FrozenInstanceError(AttributeError): ...
class InitVar:
    def __class_getitem__(cls, item):
        return cls
class Field: ...

def make_dataclass(cls_name, fields, *, bases=(), namespace=None, init=True, repr=True, eq=True, order=False, unsafe_hash=False, frozen=False,
                   match_args=True, kw_only=False, slots=False, weakref_slot=False): ...
