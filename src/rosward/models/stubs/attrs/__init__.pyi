# SPDX-License-Identifier: Apache-2.0
"""attrs: the newer names of `attr`.

Read from attrs 26.1.
"""
from attr import (
    NOTHING as NOTHING, Attribute as Attribute, Converter as Converter, Factory as Factory, asdict as asdict, assoc as assoc, astuple as astuple,
    define as define, evolve as evolve, field as field, fields as fields, fields_dict as fields_dict, frozen as frozen, has as has,
    make_class as make_class, mutable as mutable, resolve_types as resolve_types, validate as validate,
)
from attr import converters as converters
from attr import exceptions as exceptions
from attr import filters as filters
from attr import setters as setters
from attr import validators as validators
