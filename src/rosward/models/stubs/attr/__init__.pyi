# SPDX-License-Identifier: Apache-2.0
"""attr and attrs: classes that are made of their fields.

Read from attrs 26.1. Slots and hashes are left out.
"""
from _fields import body, shapes
import copy

from attr import converters as converters
from attr import exceptions as exceptions
from attr import filters as filters
from attr import setters as setters
from attr import validators as validators
from attr.exceptions import FrozenInstanceError

class _Nothing:
    def __bool__(self):
        return False
NOTHING = _Nothing()

class Factory:
    def __init__(self, factory, takes_self=False):
        self.factory = factory
        self.takes_self = takes_self
class Converter:
    def __init__(self, converter, *, takes_self=False, takes_field=False):
        self.converter = converter
        self.takes_self = takes_self
        self.takes_field = takes_field

class Attribute:
    """One field: what `field(…)` leaves in the class body, and what `fields(cls)` tells of it."""
    def __init__(self, default=NOTHING, validator=None, init=True, metadata=None, converter=None, kw_only=None, alias=None, on_setattr=None, eq=True, order=True):
        self.eq = eq
        self.order = order
        self.default = default
        self.validator = validator
        self.init = init
        self.metadata = metadata or {}
        self.converter = converter
        self.kw_only = kw_only
        self.alias = alias
        self.on_setattr = on_setattr
        self.name = None
        self.type = None
        self._validators = []
        self._of = None
    def validator_of(self, method):
        self._validators.append(method)
        return method
    def default_of(self, method):
        self.default = Factory(method, takes_self=True)
        return method
    def evolve(self, **changes):
        made = copy.copy(self)
        for name, value in changes.items():
            setattr(made, name, value)
        return made

class _Writing:
    """A field in a class body, where `@name.default` and `@name.validator` decorate methods."""
    def __init__(self, attribute):
        self._attribute = attribute
        self.default = attribute.default_of
        self.validator = attribute.validator_of

def attrib(default=NOTHING, validator=None, repr=True, cmp=None, hash=None, init=True, metadata=None, type=None, converter=None, factory=None,
           kw_only=None, eq=None, order=None, on_setattr=None, alias=None):
    if factory is not None:
        default = Factory(factory)
    compared = True if cmp is None and eq is None else bool(cmp if cmp is not None else eq)
    ordered = compared if order is None else bool(order)
    return _Writing(Attribute(default, validator, init, metadata, converter, kw_only, alias, on_setattr, compared, ordered))
def field(*, default=NOTHING, validator=None, repr=True, hash=None, init=True, metadata=None, type=None, converter=None, factory=None, kw_only=None,
          eq=None, order=None, on_setattr=None, alias=None):
    return attrib(default, validator, repr, None, hash, init, metadata, type, converter, factory, kw_only, eq, order, on_setattr, alias)

def _collected(cls, annotated, these, kw_only):
    """The fields in the body of a class, in order."""
    inside = body(cls)
    if these is not None:
        written = {name: each for name, each in these.items()}
    else:
        shaped = {name: shape for name, shape in shapes(cls).items() if shape[0] != 'classvar'}
        bare = [name for name, each in inside.items() if isinstance(each, _Writing) and name not in shapes(cls)]
        if annotated is None:
            annotated = not bare
        written = {name: inside.get(name, NOTHING) for name in shaped} if annotated else {
            name: each for name, each in inside.items() if isinstance(each, _Writing)}
    found = {}
    for name, each in written.items():
        attribute = each._attribute if isinstance(each, _Writing) else Attribute(each)
        attribute.name = name
        if attribute.alias is None:
            attribute.alias = name.lstrip('_')
        if attribute.kw_only is None:
            attribute.kw_only = kw_only
        attribute._of = cls
        found[name] = attribute
    return found

def _fields_of(cls):
    return list(cls.__attrs_attrs__)

def _converted(self, attribute, value):
    given = attribute.converter
    for one in given if isinstance(given, (list, tuple)) else [] if given is None else [given]:
        if isinstance(one, Converter):
            extra = ([self] if one.takes_self else []) + ([attribute] if one.takes_field else [])
            value = one.converter(value, *extra)
        else:
            value = one(value)
    return value

def _checked(self, attribute, value):
    given = attribute.validator
    for one in given if isinstance(given, (list, tuple)) else [] if given is None else [given]:
        one(self, attribute, value)
    for one in attribute._validators:
        one(self, attribute, value)

def _start(self, *args, **keywords):
    """`__init__` of such a class; `__attrs_init__` where the program has its own."""
    cls = type(self)
    if hasattr(cls, '__attrs_pre_init__'):
        self.__attrs_pre_init__()
    fields = _fields_of(cls)
    positional = [each for each in fields if each.init and not each.kw_only]
    if len(args) > len(positional):
        raise TypeError('__init__() takes fewer positional arguments')
    given = dict(keywords)
    for each, value in zip(positional, args):
        given[each.alias] = value
    known = [each.alias for each in fields if each.init]
    for name in given:
        if name not in known:
            raise TypeError('__init__() got an unexpected keyword argument')
    checked = []
    for each in fields:
        if each.init and each.alias in given:
            value = given[each.alias]
        elif each.default is NOTHING:
            if each.init:
                raise TypeError('__init__() missing a required argument')
            continue
        elif isinstance(each.default, Factory):
            value = each.default.factory(self) if each.default.takes_self else each.default.factory()
        else:
            value = each.default
        value = _converted(self, each, value)
        object.__setattr__(self, each.name, value)
        checked.append((each, value))
    for each, value in checked:
        _checked(self, each, value)
    if hasattr(cls, '__attrs_post_init__'):
        self.__attrs_post_init__()

def _equal(self, other):
    if type(self) is not type(other):
        return NotImplemented
    return _compared(self) == _compared(other)
def _compared(inst):
    return tuple([getattr(inst, each.name) for each in _fields_of(type(inst)) if each.eq])
def _ordered(inst):
    return tuple([getattr(inst, each.name) for each in _fields_of(type(inst)) if each.order])
def _less(self, other):
    return _ordered(self) < _ordered(other)
def _more(self, other):
    return _ordered(self) > _ordered(other)
def _least(self, other):
    return _ordered(self) <= _ordered(other)
def _most(self, other):
    return _ordered(self) >= _ordered(other)

def _refuse(self, name, value):
    raise FrozenInstanceError('cannot assign to field')
def _assign(self, name, value):
    """`__setattr__`: what runs for what is assigned: of `define`, converters and validators, unless something else is given."""
    for each in _fields_of(type(self)):
        if each.name == name:
            hooks = each.on_setattr if each.on_setattr is not None else type(self).__attrs_hooks__
            for hook in hooks if isinstance(hooks, (list, tuple)) else [hooks]:
                value = hook(self, each, value)
    object.__setattr__(self, name, value)

def _make(cls, annotated, these, frozen, init, eq, order, kw_only, assigns):
    own = _collected(cls, annotated, these, kw_only)
    fields = {}
    for base in reversed(cls.__mro__[1:]):
        if '__attrs_attrs__' in body(base):
            for each in body(base)['__attrs_attrs__']:
                if each._of is base:
                    fields.pop(each.name, None)
                    fields[each.name] = each
    for name, each in own.items():
        fields.pop(name, None)
        fields[name] = each
    inside = body(cls)
    for name, each in own.items():
        if name in inside:
            delattr(cls, name)
    cls.__attrs_attrs__ = tuple(fields.values())
    cls.__match_args__ = tuple([each.name for each in fields.values() if each.init and not each.kw_only])
    cls.__attrs_init__ = _start
    if init is not False and not (init is None and '__init__' in inside):
        cls.__init__ = _start
    if eq is not False and '__eq__' not in inside:
        cls.__eq__ = _equal
    if order:
        cls.__lt__ = _less
        cls.__gt__ = _more
        cls.__le__ = _least
        cls.__ge__ = _most
    if frozen:
        cls.__setattr__ = _refuse
    elif '__setattr__' not in inside:
        if any(each.on_setattr is not None or each.converter is not None or each.validator is not None or each._validators for each in fields.values()):
            cls.__attrs_hooks__ = assigns
            cls.__setattr__ = _assign
    return cls

def attrs(maybe_cls=None, these=None, repr_ns=None, repr=None, cmp=None, hash=None, init=None, slots=False, frozen=False, weakref_slot=True, str=False,
          auto_attribs=False, kw_only=False, cache_hash=False, auto_exc=False, eq=None, order=None, auto_detect=False, **options):
    def decorate(cls):
        start = (None if auto_detect else True) if init is None else init
        compared = cmp if cmp is not None else eq
        return _make(cls, auto_attribs, these, frozen, start, compared, compared is not False if order is None else order, kw_only,
                     options.get('on_setattr') or ())
    return decorate if maybe_cls is None else decorate(maybe_cls)
def define(maybe_cls=None, *, these=None, repr=None, unsafe_hash=None, hash=None, init=None, slots=True, frozen=False, weakref_slot=True, str=False,
           auto_attribs=None, kw_only=False, cache_hash=False, auto_exc=True, eq=None, order=False, auto_detect=True, on_setattr=None, **options):
    def decorate(cls):
        return _make(cls, auto_attribs, these, frozen, init, eq, order, kw_only, (setters.convert, setters.validate) if on_setattr is None else on_setattr)
    return decorate if maybe_cls is None else decorate(maybe_cls)
def frozen(maybe_cls=None, **options):
    return define(maybe_cls, frozen=True, **options)
def dataclass(maybe_cls=None, **options):
    return attrs(maybe_cls, auto_attribs=True, **options)
mutable = define
s = attributes = attrs
ib = attr = attrib

def make_class(name, attrs, bases=(object,), class_body=None, **attributes_arguments):
    these = dict(attrs) if isinstance(attrs, dict) else {each: attrib() for each in attrs}
    made = type(name, bases, dict(class_body or {}))
    return _make(made, False, these, attributes_arguments.get('frozen', False), True, None, False, attributes_arguments.get('kw_only', False), ())

class _Table(tuple):
    def __getattr__(self, name):
        for each in self:
            if each.name == name:
                return each
        raise AttributeError(name)
def fields(cls):
    return _Table(_fields_of(cls))
def fields_dict(cls):
    return {each.name: each for each in _fields_of(cls)}
def has(cls):
    return hasattr(cls, '__attrs_attrs__')
def resolve_types(cls, globalns=None, localns=None, attribs=None, include_extras=True):
    return cls

def _plain(value, filter, factory, serializer, as_dict):
    if hasattr(type(value), '__attrs_attrs__'):
        return asdict(value, True, filter, factory, True, serializer) if as_dict else astuple(value, True, filter)
    if isinstance(value, list):
        return [_plain(each, filter, factory, serializer, as_dict) for each in value]
    if isinstance(value, tuple):
        return tuple([_plain(each, filter, factory, serializer, as_dict) for each in value])
    if isinstance(value, dict):
        return {key: _plain(each, filter, factory, serializer, as_dict) for key, each in value.items()}
    return value
def asdict(inst, recurse=True, filter=None, dict_factory=dict, retain_collection_types=False, value_serializer=None):
    found = {}
    for each in _fields_of(type(inst)):
        value = getattr(inst, each.name)
        if filter is not None and not filter(each, value):
            continue
        if value_serializer is not None:
            value = value_serializer(inst, each, value)
        found[each.name] = _plain(value, filter, dict_factory, value_serializer, True) if recurse else value
    return found if dict_factory is dict else dict_factory(found.items())
def astuple(inst, recurse=True, filter=None, tuple_factory=tuple, retain_collection_types=False):
    found = []
    for each in _fields_of(type(inst)):
        value = getattr(inst, each.name)
        if filter is None or filter(each, value):
            found.append(_plain(value, filter, None, None, False) if recurse else value)
    return tuple(found) if tuple_factory is tuple else tuple_factory(found)
def evolve(inst, **changes):
    for each in _fields_of(type(inst)):
        if each.init and each.alias not in changes:
            changes[each.alias] = getattr(inst, each.name)
    return type(inst)(**changes)
def assoc(inst, **changes):
    return evolve(inst, **changes)
def validate(inst):
    for each in _fields_of(type(inst)):
        _checked(inst, each, getattr(inst, each.name))
