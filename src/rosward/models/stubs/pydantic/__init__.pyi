# SPDX-License-Identifier: Apache-2.0
"""pydantic: models, their fields, and what becomes of values that they are given.

Read from pydantic 2.14 and 1.10. What a type that is not modelled here makes of a value (dates, addresses, constrained texts) is unknown.
"""
from _fields import body, bound, known, opaque, room, shapes, unknown_of
from _rosward import either, reads_only, unknown
import copy
import enum
import functools
import json
import os
import pathlib

from pydantic.fields import AliasChoices as AliasChoices
from pydantic.fields import AliasPath as AliasPath
from pydantic.fields import Field as Field
from pydantic.fields import FieldInfo
from pydantic.fields import MISSING as _MISSING
from pydantic.fields import PrivateAttr as PrivateAttr
from pydantic.fields import _Computed
from pydantic.fields import computed_field as computed_field
from pydantic.functional import AfterValidator as AfterValidator
from pydantic.functional import BeforeValidator as BeforeValidator
from pydantic.functional import InstanceOf as InstanceOf
from pydantic.functional import PlainSerializer as PlainSerializer
from pydantic.functional import PlainValidator as PlainValidator
from pydantic.functional import SkipValidation as SkipValidation
from pydantic.functional import StringConstraints as StringConstraints
from pydantic.functional import WrapValidator as WrapValidator
from pydantic.functional import _Marked
from pydantic.functional import field_serializer as field_serializer
from pydantic.functional import field_validator as field_validator
from pydantic.functional import model_serializer as model_serializer
from pydantic.functional import model_validator as model_validator
from pydantic.functional import root_validator as root_validator
from pydantic.functional import validate_call as validate_call
from pydantic.functional import validator as validator

class ValidationError(ValueError):
    def errors(self, **kwargs):
        return unknown('call', 'errors of a model', 'list')
    @reads_only
    def json(self, **kwargs) -> str: ...
    @reads_only
    def error_count(self) -> int: ...
class PydanticUserError(TypeError): ...

class ConfigDict(dict): ...
class Extra:
    allow = 'allow'
    ignore = 'ignore'
    forbid = 'forbid'

FilePath = DirectoryPath = NewPath = pathlib.Path
PositiveInt = NegativeInt = NonNegativeInt = NonPositiveInt = StrictInt = int
PositiveFloat = NegativeFloat = NonNegativeFloat = NonPositiveFloat = FiniteFloat = StrictFloat = float
StrictStr = EmailStr = str
StrictBool = bool

class _Info:
    """What validators are told of the field."""
    def __init__(self, cls, field_name, data):
        self.field_name = field_name
        self.data = data
        self.config = _config(cls)
        self.context = None
        self.mode = 'python'

def _order(cls):
    """The classes of the program that a model is made of, bases first."""
    return [base for base in reversed(cls.__mro__) if isinstance(base, type) and base is not object]

def _config(cls):
    found = {}
    for base in _order(cls):
        inside = body(base)
        if 'model_config' in inside:
            found.update(inside['model_config'])
        if 'Config' in inside:
            for name, value in body(inside['Config']).items():
                if not name.startswith('__'):
                    found[name] = value
    return found

def _known_as(info, name, config):
    """The keys under which a field may be given."""
    keys = info.keys()
    if not keys and 'alias_generator' in config:
        keys = [config['alias_generator'](name)]
    if not keys:
        return [name]
    by_name = config.get('populate_by_name') or config.get('validate_by_name') or config.get('allow_population_by_field_name')
    return keys + [name] if by_name else keys

def _fields(cls):
    """Each field with its shape and what is written of it, bases first, as they were found when the class was made."""
    found = body(cls).get('__pydantic_fields__')
    return _find_fields(cls) if found is None else found

def _is_whole(shape):
    """Whether all classes that an annotation names were there."""
    return shape[0] != 'other' and all([_is_whole(part) for part in shape[1:] if isinstance(part, tuple) and part])

def _find_fields(cls):
    found = {}
    for base in _order(cls):
        inside = body(base)
        for name, (type_, default) in inside.get('_created', {}).items():
            found[name] = default if isinstance(default, FieldInfo) else FieldInfo(default)
            found[name].shape = ('class', type_) if isinstance(type_, type) else ('other',)
        for name, shape in shapes(base).items():
            if name.startswith('_') or name == 'model_config' or shape[0] == 'classvar':
                continue
            written = inside.get(name, _MISSING)
            if isinstance(written, FieldInfo):
                info = written
            else:
                info = FieldInfo(written)
            if shape[0] == 'with':
                for extra in shape[2]:
                    if isinstance(extra, FieldInfo):
                        info = extra.over(info)
            info.shape = shape
            found[name] = info
        for name, written in inside.items():
            if name in found and name not in shapes(base) and not isinstance(written, (_Marked, _Computed)):
                found[name] = FieldInfo(written).like(found[name])
    return found

def _hooks(cls, kind):
    """The decorated functions of a model, as they were found when its class was made."""
    found = body(cls).get('__pydantic_decorators__')
    return _find_hooks(cls, kind) if found is None else found[kind]

_KINDS = ('field', 'model', 'serializer', 'model serializer')

def _find_hooks(cls, kind):
    found = {}
    for base in _order(cls):
        for name, written in body(base).items():
            if isinstance(written, _Marked) and written.kind == kind:
                found[name] = (written, base)
            elif name in found:
                found.pop(name)
    return [written for written, _ in found.values()]

def _asked(function, value, info):
    """A validator is given what it has room for."""
    return function(value) if room(function) == 1 else function(value, info)

def _take(shape, value, config):
    """What becomes of a value by its annotation."""
    kind = shape[0]
    if kind == 'any':
        return value
    if kind == 'other':
        return either(value, unknown('call', 'what pydantic makes of a value'))
    if opaque(value):
        if not _fits(shape, value) and unknown('call', 'whether pydantic takes a value', 'bool'):
            raise ValidationError('refused')
        return _any(shape, unknown_of(value), 0)
    value = known(value)
    if kind == 'class':
        return _as(shape[1], value, config)
    if kind == 'none':
        if value is not None:
            raise ValidationError('not None')
        return value
    if kind == 'union':
        return _one_of(shape[1:], value, config)
    if kind == 'with':
        return _annotated(shape, value, config)
    if kind == 'literal':
        if value not in shape[1:]:
            raise ValidationError('none of the values')
        return value
    if kind == 'final' and len(shape) > 1:
        return _take(shape[1], value, config)
    if kind == 'list of tuple':
        return tuple(_take(shape[1], item, config) for item in value)
    if kind == 'tuple':
        return tuple(_take(part, item, config) for part, item in zip(shape[1:], value))
    if kind == 'set':
        return {_take(shape[1], item, config) for item in value}
    if kind == 'list':
        if isinstance(value, (str, dict)):
            raise ValidationError('no list')
        return [_take(shape[1], item, config) for item in value]
    if kind == 'dict':
        if not isinstance(value, dict):
            raise ValidationError('no dict')
        return {_take(shape[1], key, config): _take(shape[2], item, config) for key, item in value.items()}
    return value

_DEEPEST = 4

def _any(shape, value, depth):
    """What may become of a value of which nothing is known: so that it is not followed on each way through the models."""
    kind = shape[0]
    if depth > _DEEPEST:
        return value
    if kind == 'with':
        return _any(shape[1], value, depth)
    if kind == 'union':
        found = _any(shape[1], value, depth)
        for part in shape[2:]:
            found = either(found, _any(part, value, depth))
        return found
    if kind == 'none':
        return None
    if kind == 'list' and len(shape) > 1:
        inside = _any(shape[1], value, depth + 1)
        return [inside for _ in unknown('call', 'what pydantic is given', 'list')]
    if kind == 'dict' and len(shape) > 2:
        inside = _any(shape[2], value, depth + 1)
        return {_any(shape[1], value, depth + 1): inside for _ in unknown('call', 'what pydantic is given', 'list')}
    if kind == 'class' and shape[1] is str:
        return str(value)
    if kind == 'class' and isinstance(shape[1], type) and issubclass(shape[1], BaseModel):
        return _any_model(shape[1], value, depth)
    if kind == 'class' and isinstance(shape[1], type) and issubclass(shape[1], enum.Enum):
        return shape[1](value)
    return value

def _any_model(cls, value, depth):
    made = cls.__new__(cls)
    fields = _fields(cls)
    for name, info in fields.items():
        default = info.made({})
        given = _any(info.shape, value, depth + 1)
        object.__setattr__(made, name, given if default is _MISSING else either(default, given))
    object.__setattr__(made, 'model_extra', unknown('call', 'what pydantic is given', 'dict'))
    object.__setattr__(made, 'model_fields_set', unknown('call', 'what pydantic is given', 'set'))
    _private(made, cls)
    made.model_post_init(None)
    _finish(made, cls, made.__dict__)
    return made

_TRUE = ('true', '1', 'yes', 'on', 't', 'y')
_FALSE = ('false', '0', 'no', 'off', 'f', 'n')

def _as(cls, value, config):
    if cls is str:
        if isinstance(value, enum.Enum):
            value = value.value
        if not isinstance(value, str):
            if config.get('coerce_numbers_to_str') and isinstance(value, (int, float)):
                return str(value)
            raise ValidationError('no text')
        if config.get('str_strip_whitespace'):
            value = value.strip()
        if config.get('str_to_lower'):
            value = value.lower()
        if config.get('str_to_upper'):
            value = value.upper()
        return value
    if cls is bool:
        return _as_bool(value)
    if cls is int or cls is float:
        if not isinstance(value, (str, int, float)):
            raise ValidationError('no number')
        if isinstance(value, cls):
            return cls(value)
        try:
            number = float(value)
        except ValueError:
            raise ValidationError('no number')
        if cls is int and number != int(number):
            raise ValidationError('no whole number')
        return cls(number)
    if cls is list or cls is tuple or cls is set:
        return cls(value)
    if cls is dict or cls is object or not isinstance(cls, type):
        return value
    if issubclass(cls, BaseModel):
        return cls.model_validate(value)
    if issubclass(cls, enum.Enum):
        found = value if isinstance(value, cls) else _member(cls, value)
        return found.value if config.get('use_enum_values') else found
    if issubclass(cls, pathlib.PurePath):
        return cls(value)
    if isinstance(value, cls):
        return value
    if isinstance(value, dict) and hasattr(cls, '__dataclass_fields__'):
        return cls(**value)
    return either(value, unknown('call', 'what pydantic makes of a value'))

def _member(cls, value):
    try:
        return cls(value)
    except ValueError:
        raise ValidationError('no member')

def _as_bool(value):
    if isinstance(value, bool):
        return value
    if isinstance(value, (int, float)):
        if value == 0 or value == 1:
            return value == 1
        raise ValidationError('no bool')
    if isinstance(value, str):
        if value.lower() in _TRUE:
            return True
        if value.lower() in _FALSE:
            return False
    raise ValidationError('no bool')

def _fits(shape, value):
    """Whether a value is of a shape as it is."""
    kind = shape[0]
    if kind == 'none':
        return value is None
    if kind == 'class':
        return isinstance(value, shape[1]) and not (shape[1] in (int, float) and isinstance(value, bool))
    if kind == 'list':
        return isinstance(value, list)
    if kind == 'dict':
        return isinstance(value, dict)
    return False

def _one_of(shapes, value, config):
    for shape in shapes:
        if _fits(shape, value):
            return _take(shape, value, config)
    for shape in shapes:
        try:
            return _take(shape, value, config)
        except ValueError:
            pass
    raise ValidationError('none of a union')

def _annotated(shape, value, config):
    after = []
    for extra in shape[2]:
        if isinstance(extra, BeforeValidator):
            value = _asked(extra.func, value, None)
        elif isinstance(extra, PlainValidator):
            return _asked(extra.func, value, None)
        elif isinstance(extra, WrapValidator):
            return extra.func(value, functools.partial(_take_of, shape[1], config))
    value = _take(shape[1], value, config)
    for extra in shape[2]:
        if isinstance(extra, AfterValidator):
            value = _asked(extra.func, value, None)
        elif isinstance(extra, (StringConstraints, FieldInfo)):
            value = extra.applied(value)
    return value

def _take_of(shape, config, value):
    return _take(shape, value, config)

def _checked(cls, name, info, value, config, data):
    """What a field becomes of a value: validators before, the annotation, validators behind."""
    hooks = [(hook, bound(hook.function, cls, None)) for hook in _hooks(cls, 'field') if name in hook.fields or '*' in hook.fields]
    if not hooks:
        return info.applied(_take(info.shape, value, config))
    told = _Info(cls, name, data)
    for hook, function in hooks:
        if hook.mode == 'before':
            value = _tried(function, value, told.data if hook.old else told)
    plain = [function for hook, function in hooks if hook.mode == 'plain']
    wrapped = [function for hook, function in hooks if hook.mode == 'wrap']
    if plain:
        value = _tried(plain[-1], value, told)
    elif wrapped:
        handler = functools.partial(_take_of, info.shape, config)
        value = wrapped[-1](value, handler) if room(wrapped[-1]) == 2 else wrapped[-1](value, handler, told)
    else:
        value = _take(info.shape, value, config)
    value = info.applied(value)
    for hook, function in hooks:
        if hook.mode == 'after':
            value = _tried(function, value, told.data if hook.old else told)
    return value

def _tried(function, value, info):
    """What a validator gives; what it raises is part of a ValidationError."""
    alone = room(function) == 1
    try:
        return function(value) if alone else function(value, info)
    except (ValueError, AssertionError):
        raise ValidationError('refused')

def _private(self, cls):
    for base in _order(cls):
        inside = body(base)
        for name in shapes(base):
            written = inside.get(name, _MISSING)
            if name.startswith('_') and not name.startswith('__') and written is not _MISSING:
                object.__setattr__(self, name, written.made({}) if isinstance(written, FieldInfo) else copy.deepcopy(written))
        for name, written in inside.items():
            if isinstance(written, FieldInfo) and name.startswith('_') and name not in shapes(base):
                object.__setattr__(self, name, written.made({}))

def _fill(self, data, given=None):
    """What `__init__` of a model does."""
    cls = type(self)
    config = _config(cls)
    for hook in _hooks(cls, 'model'):
        if hook.mode == 'before':
            function = bound(hook.function, cls, None)
            data = _asked(function, data, _Info(cls, None, {}))
        elif hook.mode == 'wrap':
            object.__setattr__(self, '_opaque', unknown('call', 'a validator around the model'))
    if isinstance(data, cls):
        data = data.__dict__
    if not isinstance(data, dict):
        raise ValidationError('no dict')
    fields = _fields(cls)
    values = {}
    seen = set()
    extra = dict(data)
    for name, info in fields.items():
        key = None
        for known in _known_as(info, name, config):
            if key is None and known in data:
                key = known
        if key is not None:
            extra.pop(key, None)
            seen.add(name)
            value = _checked(cls, name, info, data[key], config, values)
        elif given is not None and (found := given(cls, name, info, config)) is not _MISSING:
            value = _checked(cls, name, info, found, config, values)
        else:
            value = info.made(values)
            if value is _MISSING:
                # pydantic 1, which Ubuntu has up to 24.04, takes None for what may be None
                if info.shape[0] != 'union' or ('none',) not in info.shape[1:] or unknown('call', 'whether pydantic is of version 1', 'bool'):
                    raise ValidationError(name)
                value = None
            if info.validate_default or config.get('validate_default') or _always(cls, name):
                value = _checked(cls, name, info, value, config, values)
        values[name] = value
        object.__setattr__(self, name, value)
    if extra and config.get('extra') == 'forbid':
        raise ValidationError('extra')
    if config.get('extra') == 'allow':
        for name, value in extra.items():
            object.__setattr__(self, name, value)
            seen.add(name)
    object.__setattr__(self, 'model_extra', extra if config.get('extra') == 'allow' else None)
    object.__setattr__(self, 'model_fields_set', seen)
    _private(self, cls)
    self.model_post_init(None)
    _finish(self, cls, values)

def _finish(self, cls, values):
    """What the program's functions for the whole model do behind that."""
    for hook in _hooks(cls, 'model'):
        if hook.mode == 'after':
            if hook.old:
                for name, value in bound(hook.function, cls, None)(values).items():
                    object.__setattr__(self, name, value)
            else:
                function = bound(hook.function, cls, self)
                alone, told = room(function) == 0, _Info(cls, None, {})
                try:
                    function() if alone else function(told)
                except (ValueError, AssertionError):
                    raise ValidationError('refused')

def _always(cls, name):
    return any(hook.always and name in hook.fields for hook in _hooks(cls, 'field'))

def _dumped(value, options):
    if isinstance(value, BaseModel):
        return value.model_dump(**options)
    if isinstance(value, list):
        return [_dumped(item, options) for item in value]
    if isinstance(value, tuple):
        return tuple(_dumped(item, options) for item in value)
    if isinstance(value, dict):
        return {key: _dumped(item, options) for key, item in value.items()}
    if isinstance(value, enum.Enum) and options.get('mode') == 'json':
        return value.value
    if isinstance(value, pathlib.PurePath) and options.get('mode') == 'json':
        return str(value)
    return value

class _Fields:
    """`model_fields` of a class and of its objects."""
    def __get__(self, instance, owner=None):
        return _fields(owner if instance is None else type(instance))
class _ComputedFields:
    def __get__(self, instance, owner=None):
        cls = owner if instance is None else type(instance)
        return {name: written for base in _order(cls) for name, written in body(base).items() if isinstance(written, _Computed)}

def _assign(self, name, value):
    """`__setattr__` of a model that checks what is assigned, or refuses it."""
    cls = type(self)
    config, fields = _config(cls), _fields(cls)
    if config.get('frozen') and name in fields:
        raise ValidationError('frozen')
    if name in fields and config.get('validate_assignment'):
        value = _checked(cls, name, fields[name], value, config, self.__dict__)
    object.__setattr__(self, name, value)

class BaseModel:
    model_config = {}
    model_fields = _Fields()
    __fields__ = _Fields()
    model_computed_fields = _ComputedFields()
    def __init_subclass__(cls, **kwargs):
        if kwargs:
            cls.model_config = {**_config(cls), **kwargs}
        cls.__pydantic_decorators__ = {kind: _find_hooks(cls, kind) for kind in _KINDS}
        fields = _find_fields(cls)
        if all([_is_whole(info.shape) for info in fields.values()]):
            cls.__pydantic_fields__ = fields
        config = _config(cls)
        if config.get('validate_assignment') or config.get('frozen'):
            cls.__setattr__ = _assign
        cls.__pydantic_init_subclass__(**kwargs)
    @classmethod
    def __pydantic_init_subclass__(cls, **kwargs):
        return None
    def __class_getitem__(cls, item):
        return cls
    def __init__(self, /, **data):
        _fill(self, data)
    def model_post_init(self, context, /):
        return None
    def __iter__(self):
        for name in type(self).model_fields:
            yield (name, getattr(self, name))
        for name, value in (self.model_extra or {}).items():
            yield (name, value)
    def __eq__(self, other):
        return type(self) is type(other) and self.model_dump() == other.model_dump()
    @classmethod
    def model_validate(cls, obj, **kwargs):
        if opaque(obj):
            return _take(('class', cls), obj, {})
        obj = known(obj)
        if isinstance(obj, cls):
            return obj
        config = _config(cls)
        if not isinstance(obj, dict) and (kwargs.get('from_attributes') or config.get('from_attributes') or config.get('orm_mode')):
            obj = {name: getattr(obj, name) for name in _fields(cls) if hasattr(obj, name)}
        if isinstance(obj, dict):
            return cls(**obj)
        made = cls.__new__(cls)
        _fill(made, obj)
        return made
    @classmethod
    def model_validate_json(cls, json_data, **kwargs):
        try:
            found = json.loads(json_data)
        except ValueError as error:
            raise ValidationError(str(error))
        return cls.model_validate(found)
    @classmethod
    def model_validate_strings(cls, obj, **kwargs):
        return cls.model_validate(obj)
    @classmethod
    def model_construct(cls, _fields_set=None, **values):
        made = cls.__new__(cls)
        for name, info in _fields(cls).items():
            value = values[name] if name in values else info.made(values)
            if value is not _MISSING:
                object.__setattr__(made, name, value)
        object.__setattr__(made, 'model_fields_set', set(values))
        _private(made, cls)
        made.model_post_init(None)
        return made
    def model_copy(self, *, update=None, deep=False):
        made = copy.deepcopy(self) if deep else copy.copy(self)
        if update:
            for name, value in update.items():
                object.__setattr__(made, name, value)
        return made
    def model_dump(self, *, mode='python', include=None, exclude=None, context=None, by_alias=False, exclude_unset=False, exclude_defaults=False,
                   exclude_none=False, **kwargs):
        cls = type(self)
        options = {'mode': mode, 'by_alias': by_alias, 'exclude_unset': exclude_unset, 'exclude_defaults': exclude_defaults, 'exclude_none': exclude_none}
        whole = _hooks(cls, 'model serializer')
        if whole:
            function = bound(whole[-1].function, cls, self)
            return function() if room(function) == 0 else unknown('call', 'a serializer around the model')
        found = {}
        special = _hooks(cls, 'serializer')
        named = [(name, info) for name, info in _fields(cls).items()] + [(name, FieldInfo()) for name in cls.model_computed_fields]
        if self.model_extra:
            named += [(name, FieldInfo()) for name in self.model_extra]
        for name, info in named:
            value = getattr(self, name)
            if include is not None and name not in include or exclude is not None and name in exclude and exclude[name] is True:
                continue
            if exclude is not None and not isinstance(exclude, dict) and name in exclude:
                continue
            if info.exclude or exclude_none and value is None:
                continue
            if exclude_unset and name not in self.model_fields_set or exclude_defaults and value == info.default:
                continue
            key = name
            if by_alias:
                if info.serialization_alias or info.alias:
                    key = info.serialization_alias or info.alias
                elif 'alias_generator' in _config(cls):
                    key = _config(cls)['alias_generator'](name)
            hooks = [hook for hook in special if name in hook.fields or '*' in hook.fields]
            if hooks:
                function = bound(hooks[-1].function, cls, self)
                found[key] = function(value) if room(function) == 1 else function(value, unknown('call', 'info of a serializer'))
            else:
                found[key] = _dumped(value, options)
        return found
    def model_dump_json(self, *, indent=None, **kwargs):
        return json.dumps(self.model_dump(mode='json', **kwargs), indent=indent, separators=None if indent else (',', ':'))
    @classmethod
    @reads_only
    def model_json_schema(cls, *args, **kwargs) -> dict: ...
    @classmethod
    def model_rebuild(cls, **kwargs):
        return None
    def dict(self, **kwargs):
        return self.model_dump(**kwargs)
    def json(self, **kwargs):
        return self.model_dump_json(**kwargs)
    def copy(self, *, include=None, exclude=None, update=None, deep=False):
        return self.model_copy(update=update, deep=deep)
    @classmethod
    def parse_obj(cls, obj):
        return cls.model_validate(obj)
    @classmethod
    def parse_raw(cls, b, **kwargs):
        return cls.model_validate_json(b)
    @classmethod
    def parse_file(cls, path, **kwargs):
        return cls.model_validate_json(open(path).read())
    @classmethod
    def construct(cls, _fields_set=None, **values):
        return cls.model_construct(_fields_set, **values)
    @classmethod
    def from_orm(cls, obj):
        return cls.model_validate(obj, from_attributes=True)
    @classmethod
    def update_forward_refs(cls, **kwargs):
        return None

class RootModel(BaseModel):
    def __init__(self, /, root=_MISSING, **data):
        given = data if root is _MISSING else root
        if 'root' in _fields(type(self)):
            _fill(self, {'root': given} if data or root is not _MISSING else {})
        else:  # the type stands among the bases
            object.__setattr__(self, 'root', _as_is(given))
    @classmethod
    def model_validate(cls, obj, **kwargs):
        return obj if isinstance(obj, cls) else cls(obj)
    def model_dump(self, *, mode='python', **kwargs):
        return _dumped(self.root, {'mode': mode})

def _as_is(value):
    """What a type that is not known here makes of a value."""
    if isinstance(value, list):
        return [_as_is(item) for item in value]
    if isinstance(value, dict):
        return {key: _as_is(item) for key, item in value.items()}
    return either(value, unknown('call', 'what pydantic makes of a value'))

class TypeAdapter:
    def __init__(self, type, *, config=None, **kwargs):
        self._type = type
    def validate_python(self, object, /, **kwargs):
        if isinstance(self._type, type) and issubclass(self._type, BaseModel):
            return self._type.model_validate(object)
        return _as_is(object)
    def validate_json(self, data, /, **kwargs):
        return self.validate_python(json.loads(data))
    def dump_python(self, instance, /, **kwargs):
        return _dumped(instance, {})

def create_model(model_name, /, *, __config__=None, __base__=None, __validators__=None, **field_definitions):
    bases = __base__ if isinstance(__base__, tuple) else (BaseModel if __base__ is None else __base__,)
    names = {'_created': {name: given if isinstance(given, tuple) else (given, _MISSING) for name, given in field_definitions.items()}}
    if __config__ is not None:
        names['model_config'] = __config__
    return type(model_name, bases, {**names, **(__validators__ or {})})
def parse_obj_as(type_, obj):
    return TypeAdapter(type_).validate_python(obj)

class BaseSettings(BaseModel):
    """A model whose fields the environment may give."""
    def __init__(self, /, **data):
        _fill(self, {name: value for name, value in data.items() if not name.startswith('_')}, _of_environment)

def _of_environment(cls, name, info, config):
    if info.shape[0] == 'class' and info.shape[1] not in (str, int, float, bool) and not issubclass(info.shape[1], enum.Enum):
        return _MISSING
    default = info.made({})
    keys = info.keys() or [config.get('env_prefix', '') + name]
    value = _MISSING
    for key in keys:
        if value is _MISSING:
            if config.get('case_sensitive'):
                value = os.environ.get(key, _MISSING)
            else:
                value = os.environ.get(key.upper(), os.environ.get(key.lower(), _MISSING) if key.lower() in os.environ._set else default)
    return value
