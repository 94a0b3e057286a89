# SPDX-License-Identifier: Apache-2.0
"""pydantic.dataclasses: classes of dataclasses whose fields are converted to their annotations.

Read from pydantic 2.14.
"""
from pydantic.fields import FieldInfo
import dataclasses
import pydantic

def _started(start, self, *args, **keywords):
    start(self, *args, **keywords)
    cls = type(self)
    config = pydantic._config(cls)
    values = {}
    for name, info in pydantic._fields(cls).items():
        value = getattr(self, name)
        if isinstance(value, FieldInfo):
            value = value.made(values)
        values[name] = pydantic._checked(cls, name, info, value, config, values)
        object.__setattr__(self, name, values[name])

def dataclass(_cls=None, *, config=None, validate_on_init=None, **options):
    def decorate(cls):
        made = dataclasses.dataclass(cls, **options)
        start = made.__init__
        def __init__(self, *args, **keywords):
            _started(start, self, *args, **keywords)
        made.__init__ = __init__
        if config is not None:
            made.model_config = config
        return made
    return decorate if _cls is None else decorate(_cls)
