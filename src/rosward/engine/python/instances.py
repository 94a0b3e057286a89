# SPDX-License-Identifier: Apache-2.0
"""What is an instance of what? True, False, or None where both may be.

isinstance([1], collections.abc.Sequence)      Python itself is asked: True
isinstance(self, Runs)                         a Protocol: whether each of its members is there
isinstance(x, Base)                            Base.register, __subclasshook__, __instancecheck__ of its metaclass
isinstance(x, library.Thing)                   not known
"""

from __future__ import annotations

import builtins
import collections.abc
import contextlib
import numbers
import os
import types
from typing import TYPE_CHECKING, Final

from rosward.domain.choice import options
from rosward.domain.compound import BoundMethod, Descriptor, External, Native, Partial, Range, Slice, Tuple
from rosward.domain.heap import CLASSES
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, UNBOUND, Choice, Class, Const, Function, ModuleValue, Ref, Text, Unknown, Value
from rosward.engine.python import members, metaclasses
from rosward.engine.python.metaclass_of import metaclass_of
from rosward.engine.python.specials import NOT_IMPLEMENTED
from rosward.models.interfaces import is_known_interface, same_interface
from rosward.models.python.asked import REGISTERED
from rosward.models.python.builtins.attributes import has_attribute, of_python
from rosward.models.python.containers.lists import ITERATOR, VIEW
from rosward.models.python.plain import LOOSE_HINTS
from rosward.models.python.std.annotations import WRITTEN_IN

if TYPE_CHECKING:
    from rosward.engine.machine import Engine


_ABSTRACT: Final = {"collections.abc": collections.abc, "numbers": numbers, "os": os, "contextlib": contextlib}
"""Modules of Python whose abstract classes decide by themselves what belongs to them."""

_STRUCTURAL: Final[dict[str, tuple[str, ...]]] = {
    "Hashable": ("__hash__",), "Awaitable": ("__await__",), "AsyncIterable": ("__aiter__",),
    "AsyncIterator": ("__anext__", "__aiter__"), "Iterable": ("__iter__",), "Iterator": ("__next__", "__iter__"),
    "Reversible": ("__reversed__", "__iter__"), "Sized": ("__len__",), "Container": ("__contains__",),
    "Collection": ("__len__", "__iter__", "__contains__"), "Callable": ("__call__",), "Buffer": ("__buffer__",),
    "Generator": ("__iter__", "__next__", "send", "throw", "close"),
    "Coroutine": ("__await__", "send", "throw", "close"),
    "AsyncGenerator": ("__aiter__", "__anext__", "asend", "athrow", "aclose"),
    "PathLike": ("__fspath__",), "AbstractContextManager": ("__enter__", "__exit__"),
    "AbstractAsyncContextManager": ("__aenter__", "__aexit__"),
}  # fmt: skip
"""Abstract classes to which whatever has these methods belongs."""

_SUSPENDED: Final = ("GeneratorType", "CoroutineType", "AsyncGeneratorType")
_KINDS: Final[dict[type, tuple[str, ...]]] = {
    Function: ("FunctionType", "LambdaType"),
    BoundMethod: ("MethodType",),
    ModuleValue: ("ModuleType",),
}
"""The classes of module `types` that values belong to."""


def type_of(machine: Engine, value: Value) -> Value | None:
    """The class of a value; None where it is not known."""
    if value.__class__ is Ref:
        obj = machine.obj(value)
        # a generator, a coroutine, what `iter` gives, a view of a dict
        unclear = obj.kind == "generator" or obj.payload in (ITERATOR, VIEW)
        return None if unclear else obj.attrs.get(CLASSES, obj.cls)
    if value.__class__ in (Const, Text, Tuple, Range, Slice):
        return Native(f"builtins.{members.type_name(value)}")
    if value.__class__ is Unknown and value.hint and value.hint not in LOOSE_HINTS:
        return Native(f"builtins.{value.hint}")
    if value.__class__ is Class:
        return metaclass_of(machine, value)
    if value.__class__ is Native:
        found = of_python(value.name)
        if isinstance(found, type):
            return Native("builtins.type")
        return None if found is None else Native("builtins.builtin_function_or_method")
    if value.__class__ in (Function, BoundMethod, Partial):
        return Native("builtins.function")
    if value.__class__ is ModuleValue:
        return Native("builtins.module")
    if value.__class__ is External and is_known_interface(machine, value):
        return Native("builtins.type")
    if value.__class__ is Descriptor and value.kind != "cached_property":
        return Native(f"builtins.{value.kind}")
    return None


def is_instance(machine: Engine, value: Value, wanted: Value) -> bool | None:
    """isinstance(value, wanted)."""
    answers = {_is_instance(machine, v, w) for v in options(value) for w in options(wanted)}
    return answers.pop() if len(answers) == 1 else None


def _is_instance(machine: Engine, value: Value, wanted: Value) -> bool | None:
    if wanted.__class__ is Tuple:
        return _any([is_instance(machine, value, w) for w in wanted.items])
    if wanted.__class__ is not Class:
        cls = type_of(machine, value)
        return None if cls is None else is_subclass(machine, cls, wanted)
    checked = _by_metaclass(machine, wanted, "__instancecheck__", value)
    if checked is not UNBOUND:
        return machine.truth(checked)
    members = _members(machine, wanted)
    if members is not None:
        found = [has_attribute(machine, value, name) for name in members]
        return False if False in found else (None if None in found else True)
    if wanted.module == "types" and wanted.stub:
        return _of_kind(machine, value, wanted.name)
    if wanted.name == "Callable" and value.__class__ in (Function, BoundMethod, Partial, Class, Native):
        return True
    cls = type_of(machine, value)
    return None if cls is None else is_subclass(machine, cls, wanted)


def _of_kind(machine: Engine, value: Value, name: str) -> bool | None:
    """isinstance with a class of module `types`."""
    if isinstance(value, Ref):
        kind = machine.obj(value).kind
        cls = type_of(machine, value)
        named = isinstance(cls, Class) and any(isinstance(b, Class) and b.name == name for b in cls.mro)
        return named if kind != "generator" else (None if name in _SUSPENDED else False)
    if value.__class__ is BoundMethod and value.function.__class__ is Native:
        return None  # a method of Python's own, or one that a model does in code
    if value.__class__ in _KINDS:
        return name in _KINDS[value.__class__]
    return False if value.__class__ in (Const, Text, Tuple, Class) or is_known_interface(machine, value) else None


def is_subclass(machine: Engine, cls: Value, wanted: Value) -> bool | None:
    """issubclass(cls, wanted)."""
    answers = {_is_subclass(machine, c, w) for c in options(cls) for w in options(wanted)}
    return answers.pop() if len(answers) == 1 else None


def _is_subclass(machine: Engine, cls: Value, wanted: Value) -> bool | None:
    if wanted.__class__ is Tuple:
        return _any([is_subclass(machine, cls, w) for w in wanted.items])
    if cls == wanted or wanted == Native("builtins.object"):
        return True
    if wanted.__class__ is Native and cls.__class__ is Native:
        return _of_python(cls.name, _python_class(wanted.name))
    if cls.__class__ is External and wanted.__class__ is External:
        return same_interface(machine, cls, wanted)
    if is_known_interface(machine, wanted):
        return _any([_is_interface(machine, b, wanted) for b in (cls.mro if cls.__class__ is Class else (cls,))])
    # what the class of an interface derives from, and nothing else
    known = Native("builtins.object") if is_known_interface(machine, cls) else cls
    if known.__class__ not in (Native, Class) or wanted.__class__ not in (Native, Class):
        return None
    if wanted.__class__ is Class:
        decided = _by_metaclass(machine, wanted, "__subclasscheck__", cls)
        if decided is UNBOUND:
            decided = _by_hook(machine, wanted, cls)
        if decided is not UNBOUND:
            return machine.truth(decided)
        if cls.__class__ is Class and wanted in cls.mro:
            return True
        abstract = _abstract(wanted)
        if known is not cls and abstract is collections.abc.Hashable:
            return None  # a message has no hash, a service has one
        if abstract is not None:
            return _any([_of_abstract(machine, known, abstract), _registered(machine, cls, wanted)])
        return _any([_nominal(known, wanted), _registered(machine, cls, wanted)])
    return _nominal(known, wanted)


def _is_interface(machine: Engine, base: Value, wanted: Value) -> bool | None:
    """Whether one base of a class is the class of an interface."""
    if base.__class__ is External:
        return same_interface(machine, base, wanted)
    return False if base.__class__ in (Native, Class) else None


def _any(answers: list[bool | None]) -> bool | None:
    return True if True in answers else (None if None in answers else False)


def _nominal(cls: Value, wanted: Value) -> bool | None:
    """By the bases that are written."""
    if cls.__class__ is not Class:
        return False  # of a class of Python only another one is a base
    mro = cls.mro
    reals = [(base, real) for base in mro if (real := _modelled(base)) is not None]
    inside = {b for base, _ in reals if isinstance(base, Class) for b in base.mro if b.__class__ is Native}
    if wanted in mro and wanted not in inside:
        return True
    natives: list[bool | None] = []
    if wanted.__class__ is Native:
        theirs = _python_class(wanted.name)
        natives = [_of_python(b.name, theirs) for b in mro if b.__class__ is Native and b not in inside]
        natives += [isinstance(theirs, type) and issubclass(real, theirs) for _, real in reals]
    unknown = any(b.__class__ in (External, Unknown) for b in mro)
    return _any([*natives, None if unknown else False])


def _of_python(name: str, theirs: object) -> bool | None:
    """The order of classes of Python, asked of Python itself (exceptions, bool of int, abstract classes)."""
    ours = _python_class(name)
    if isinstance(ours, type) and isinstance(theirs, type):
        return issubclass(ours, theirs)
    return None


def _python_class(name: str) -> object:
    return _PYTHON.get(name, getattr(builtins, name.removeprefix("builtins."), None))


_PYTHON: Final[dict[str, type]] = {
    "builtins.generator": type(_ for _ in ()),
    "builtins.function": type(_of_python),
    "builtins.builtin_function_or_method": type(len),
    "builtins.method": types.MethodType,
    "builtins.module": types.ModuleType,
    "builtins.NoneType": type(None),
}


_MODELLED: Final = {"collections": collections, "types": types}
"""Modules of Python whose classes have models that are made of others: a `deque` is no list."""


def _modelled(base: Value) -> type | None:
    """The class of Python that a model stands for."""
    module = _MODELLED.get(base.module) if base.__class__ is Class and base.stub else None
    if module is None or not isinstance(base, Class):
        return None
    found = tuple if base.name == "_NamedTuple" else getattr(module, base.name, None)
    return found if isinstance(found, type) else None


def _abstract(wanted: Class) -> type | None:
    """The abstract class of Python that a model stands for."""
    module = _ABSTRACT.get(wanted.module) if wanted.stub else None
    found = getattr(module, wanted.name, None) if module is not None else None
    return found if isinstance(found, type) and type(found).__name__ == "ABCMeta" else None


def _of_abstract(machine: Engine, cls: Value, abstract: type) -> bool | None:
    if cls.__class__ is Native:
        return _of_python(cls.name, abstract)
    assert isinstance(cls, Class)
    by_base: list[bool | None] = []
    inside: set[Value] = set()  # what the models of classes of Python are made of
    for base in cls.mro:
        real = _modelled(base)
        if real is not None and isinstance(base, Class):
            by_base.append(issubclass(real, abstract))
            inside.update(base.mro)
        if base in inside:
            continue
        if base.__class__ is Native:
            by_base.append(_of_python(base.name, abstract))
        elif base.__class__ is Class:
            theirs = _abstract(base)
            by_base.append(theirs is not None and issubclass(theirs, abstract))
        else:
            by_base.append(None)
    methods = _STRUCTURAL.get(abstract.__name__)
    if methods is not None:
        by_base.append(_has_methods(machine, cls, methods))
    return _any(by_base)


def _has_methods(machine: Engine, cls: Class, methods: tuple[str, ...]) -> bool | None:
    """Whether a class has each method, and None in the place of none (`__hash__ = None`)."""
    answers: list[bool | None] = []
    for name in methods:
        found = members.lookup(machine, cls, name)
        if found is None:
            answers.append(name == "__hash__" and members.lookup(machine, cls, "__eq__") is None)
        else:
            answers.append(None if found.__class__ in (Unknown, Choice) else found != NONE)
    return False if False in answers else (None if None in answers else True)


def _by_metaclass(machine: Engine, wanted: Value, name: str, value: Value) -> Value:
    """What `__instancecheck__` or `__subclasscheck__` of a metaclass says; UNBOUND where no program has one."""
    found = metaclasses.method(machine, wanted, name)
    return UNBOUND if found is None else machine.call(found, (value,))


def _by_hook(machine: Engine, wanted: Class, cls: Value) -> Value:
    """What `__subclasshook__` says; UNBOUND where there is none, or it leaves the answer to the rules."""
    hook = members.lookup(machine, wanted, "__subclasshook__")
    if hook.__class__ is not Descriptor:
        return UNBOUND
    found = machine.call(BoundMethod(wanted, hook.getter), (cls,))
    if found == NOT_IMPLEMENTED or found is UNBOUND:
        return UNBOUND
    if NOT_IMPLEMENTED in options(found):
        return machine.unknown(Cause.OPERATION, "issubclass", "bool")
    return found


def _registered(machine: Engine, cls: Value, wanted: Class) -> bool | None:
    """Whether a class was given to `register` of an abstract one, or of one derived from it."""
    given = machine.at(wanted.address).attrs.get(REGISTERED)
    if given is None:
        return False
    answers: list[bool | None] = []
    for option in options(given):
        answers += [is_subclass(machine, cls, each) for each in getattr(option, "items", ())]
    found = _any(answers)
    return found if given.__class__ is Tuple else (None if found else found)


def _members(machine: Engine, wanted: Class) -> list[str] | None:
    """What a Protocol asks for; None where the class is none."""
    if wanted.stub or not any(_is_protocol(b) for b in wanted.bases):
        return None
    names: dict[str, None] = {}
    for base in wanted.mro:
        if isinstance(base, Class) and not base.stub:
            attrs = machine.at(base.address).attrs
            table = attrs.get("__annotations__")
            annotated = machine.obj(table).entries if isinstance(table, Ref) else {}
            written = [*attrs, *(k.value for k in annotated if isinstance(k, Const))]
            names.update(dict.fromkeys(str(n) for n in written if n not in _OF_CLASSES))
    return list(names)


_OF_CLASSES: Final = frozenset(
    {
        "__doc__",
        "__module__",
        "__qualname__",
        "__annotations__",
        "__slots__",
        "__init__",
        "__dict__",
        "__weakref__",
        REGISTERED,
        WRITTEN_IN,
    }
)


def _is_protocol(base: Value) -> bool:
    return isinstance(base, Class) and base.stub and base.name == "Protocol"
