# SPDX-License-Identifier: Apache-2.0
"""Attributes: which one `value.name` is.

Order as in Python: properties of the class, the instance's own attributes, the class along its mro, `__getattr__`.
What a class does not have is unknown with a reason, never an error: a write that the analysis did not see may have put it there.
"""

from __future__ import annotations

import builtins
from collections.abc import Callable
from types import MappingProxyType
from typing import TYPE_CHECKING, Final

from rosward.domain.choice import join, join_all
from rosward.domain.compound import BoundMethod, Descriptor, External, Native, Partial, Super, Tuple
from rosward.domain.heap import KIND, Obj
from rosward.domain.unknown import Cause, Reason
from rosward.domain.values import NONE, UNBOUND, Choice, Class, Const, Function, ModuleValue, Ref, Unknown, Value
from rosward.engine.calls.alternatives import each_apart
from rosward.engine.python import descriptors, modules
from rosward.engine.python.builtin_classes import of_native, of_value
from rosward.engine.python.functions import kept_table, of_function, of_partial
from rosward.engine.python.members import bind, classes_of, is_computed, lookup, of_native_class, type_name
from rosward.engine.python.metaclass_of import TYPE, in_metaclass, metaclass_of
from rosward.engine.python.namespaces import table_of
from rosward.models import message_fields
from rosward.models.interfaces import INTERFACE_NAMES, interface_name
from rosward.models.python.attribute_tables import TABLE, own_attribute
from rosward.models.python.builtins.attributes import is_open, may_hide
from rosward.models.python.containers.lists import ITERATOR, VIEW
from rosward.models.python.exceptions import MEMBERS, member_of
from rosward.models.python.std.annotations import of_class as annotated
from rosward.models.readers import decisive

if TYPE_CHECKING:
    from rosward.engine.machine import Engine


def load(machine: Engine, value: Value, name: str) -> Value:
    """value.name; UNBOUND where the path ends here."""
    if value.__class__ is Ref:
        return _of_object(machine, value, name)
    if value.__class__ is ModuleValue:
        if name == "__dict__":
            return table_of(machine, value.address)
        return modules.attribute(machine, value, name)
    if value.__class__ is Class:
        return _of_class(machine, value, name)
    if value.__class__ is External:
        return _of_external(machine, value, name)
    if value.__class__ is Choice:
        return _of_several(machine, [o for o in value.options if o != NONE], name)
    if value.__class__ is Unknown:
        return _of_unknown(machine, value, name)
    if value.__class__ is Super:
        return _of_super(machine, value, name)
    if value.__class__ is Function:
        return of_function(machine, value, name)
    if value.__class__ is BoundMethod:
        if name in ("__self__", "__func__"):
            return value.receiver if name == "__self__" else value.function
        return value if name == "__call__" else load(machine, value.function, name)
    if value.__class__ is Native:
        base = value.name.removeprefix("builtins.")
        if name == "__dict__" and isinstance(getattr(builtins, base, None), type):
            return machine.new_dict({Const(n): Native(f"{base}.{n}") for n in vars(getattr(builtins, base))})
        return of_native(machine, base, name)
    if value.__class__ is Descriptor:
        return descriptors.load(machine, value, name)
    if value.__class__ is Partial and name in ("func", "args", "keywords", "__call__"):
        return of_partial(machine, value, name)
    return _of_builtin(machine, value, name)


def _of_several(machine: Engine, several: list[Value], name: str) -> Value:
    """The attribute of each; where code runs for that, what it does is done for one of them."""
    if any(is_computed(machine, o, name) for o in several):
        return each_apart(machine, several, lambda o: load(machine, o, name))
    return join_all(load(machine, o, name) for o in several)


def _of_external(machine: Engine, value: External, name: str) -> Value:
    known = message_fields.constant(machine, value, name)
    if known is not None:
        return known
    if name in INTERFACE_NAMES and is_interface(value):
        return Const(interface_name(value.name, name))
    if name in machine.library.facts.node_methods and "." in value.name and not is_interface(value):
        return _of_unknown(machine, machine.unknown(Cause.MODULE, value.name), name)
    return External(f"{value.name}.{name}")


_OF_TYPE: Final = frozenset({"__new__", "__init__", "__call__", "__prepare__"})
_OBJECT: Final = Native("builtins.object")
_CLASS_METHODS: Final = {"dict.fromkeys": "from_keys"}
"""Class methods of builtins that make what they are asked of, and write to it as the program says."""


def _of_builtin(machine: Engine, value: Value, name: str) -> Value:
    kind = type_name(value)
    held = of_value(value, name)
    if held is not None:
        return held
    if name == "__class__":
        return Native(f"builtins.{kind}")
    if isinstance(value, Const) and value == NONE:
        said = Const(f"'NoneType' object has no attribute '{name}'")
        return machine.die("AttributeError", f"attribute {name} of None", (said,), sure=not value.origins)
    if not machine.library.native(f"{kind}.{name}") and not hasattr(getattr(builtins, kind, value), name):
        if kind in ("tuple", "bytes") and name in message_fields.ARRAY_NAMES:
            return machine.unknown(Cause.ERROR, f"no attribute {name} of {kind}")
        return machine.die("AttributeError", f"no attribute {name} of {kind}", sure=True)
    return BoundMethod(value, Native(f"{kind}.{name}"))


def _of_unknown(machine: Engine, value: Unknown, name: str) -> Value:
    of_nodes = _of_nodes(machine, value, name)
    if of_nodes is not None:
        return of_nodes
    if value.hint in ("str", "list", "dict", "set", "int", "float", "bytes", "tuple") and machine.library.native(
        f"{value.hint}.{name}"
    ):
        return BoundMethod(value, Native(f"{value.hint}.{name}"))
    if any(r.cause is not Cause.MESSAGE for r in value.reasons):  # what a message holds is plain data
        machine.trace.asked.add(("", "", name))
    if not any(r.cause is Cause.MESSAGE for r in value.reasons):
        return Unknown(value.reasons)
    reasons = tuple(
        Reason(Cause.MESSAGE, f"{r.subject}.{name}", r.place) if r.cause is Cause.MESSAGE and len(r.subject) < 80 else r
        for r in value.reasons
    )
    return Unknown(reasons)


def _of_nodes(machine: Engine, receiver: Value, name: str) -> Value | None:
    """The method of a node, of something of which nothing else is known; None where not only nodes have one of that name."""
    if name not in machine.library.facts.node_methods:
        return None
    found = [lookup(machine, cls, name) for cls in machine.library.node_classes]
    bound = [BoundMethod(receiver, method) for method in found if method is not None]
    return join_all(bound) if bound else None


def method(machine: Engine, value: Value, name: str) -> Value | None:
    """A method of an object's class, bound; None where it has none."""
    if value.__class__ is Ref:
        obj = machine.part(value, KIND)
        if obj.kind == "instance":
            found = lookup(machine, obj.cls, name)
            return None if found is None else bind(machine, found, value, obj.cls)
        return BoundMethod(value, Native(f"{obj.kind}.{name}"))
    if value.__class__ in (External, Unknown):
        return None
    return BoundMethod(value, Native(f"{type_name(value)}.{name}"))


def _of_object(machine: Engine, ref: Ref, name: str) -> Value:
    obj = machine.part(ref, name)
    if obj.kind != "instance":
        if name == "__class__":
            unclear = obj.payload in (ITERATOR, VIEW)  # a list in models only
            return machine.unknown(Cause.CALL, name) if unclear else obj.cls
        if obj.kind == "generator" and name.partition("_")[0] in ("gi", "cr", "ag"):
            return machine.unknown(Cause.LIVE, f"generator.{name}")
        if _lacks(machine, obj, name):
            return machine.die("AttributeError", f"no attribute {name} of {obj.kind}", sure=True)
        return BoundMethod(ref, Native(f"{obj.kind}.{name}"))
    if machine.hooked:
        hook = lookup(machine, obj.cls, "__getattribute__")
        if hook.__class__ is Function:
            return _computed(machine, ref, name, lambda: machine.call(hook, (ref, Const(name))))
    return plain_attribute(machine, ref, name)


_CONTAINERS: Final = MappingProxyType({"list": list, "dict": dict, "set": set})


def _lacks(machine: Engine, obj: Obj, name: str) -> bool:
    """Whether an object is surely a container of Python's own, which has no such attribute."""
    cls = _CONTAINERS.get(obj.kind)
    if cls is None or obj.payload in (ITERATOR, VIEW) or obj.cls != Native(f"builtins.{obj.kind}"):
        return False
    if cls is list and name in message_fields.ARRAY_NAMES:
        return False
    return not hasattr(cls, name) and machine.library.native(f"{obj.kind}.{name}") is None


def plain_attribute(machine: Engine, ref: Ref, name: str) -> Value:
    """What `object.__getattribute__` gives."""
    obj = machine.part(ref, name)
    cls = obj.cls
    own, sure = own_attribute(machine, obj, name)
    in_class = lookup(machine, cls, name)
    if in_class.__class__ is Descriptor and in_class.kind == "property":
        return _computed(machine, ref, name, lambda: bind(machine, in_class, ref, cls))
    if setter_of(machine, in_class) is not None:  # a data descriptor goes before what the object holds itself
        return _computed(machine, ref, name, lambda: bind(machine, in_class or NONE, ref, cls))
    if own is not None and own is not UNBOUND:
        if sure:
            return own
        if cls.__class__ is External:
            return message_fields.load_field(machine, ref, name, own) or own
        if in_class is not None:
            return join(own, bind(machine, in_class, ref, cls))
        fallback = lookup(machine, cls, "__getattr__") if name in obj.partial or TABLE in obj.attrs else None
        return own if fallback is None else join(own, machine.call(fallback, (ref, Const(name))))
    if in_class is not None:
        if in_class.__class__ is Function:
            return BoundMethod(ref, in_class)
        value = _computed(machine, ref, name, lambda: bind(machine, in_class, ref, cls))
        if in_class.__class__ is Descriptor and in_class.kind == "cached_property" and value is not UNBOUND:
            machine.update(ref, machine.obj(ref).with_attr(name, value))
        return value
    if name == "__class__":
        return cls
    if name == "__dict__":
        return table_of(machine, ref.address)
    if name == "__module__" and cls.__class__ is Class:
        return Const(cls.module)
    if name in MEMBERS:
        member = member_of(machine, obj, name)
        if member is not None:
            return member
    fallback = lookup(machine, cls, "__getattr__")
    if fallback is not None:
        return machine.call(fallback, (ref, Const(name)))
    return _missing(machine, ref, cls, name)


def _computed(machine: Engine, ref: Ref, name: str, read: Callable[[], Value]) -> Value:
    """What code of the program gives for an attribute; where it raises AttributeError, `__getattr__` is asked."""
    fallback = lookup(machine, machine.part(ref, KIND).cls, "__getattr__")
    if fallback is None:
        return read()
    found, failed = machine.guarded(read, "AttributeError", unseen=False)
    return join(found, machine.call(fallback, (ref, Const(name)))) if failed else found


def _missing(machine: Engine, ref: Ref, cls: Value, name: str) -> Value:
    """An attribute that no class we know has."""
    if cls.__class__ is External:
        if is_interface(cls):
            field = message_fields.load_field(machine, ref, name, None)
            return message_fields.missing(machine, machine.obj(ref), name) if field is None else field
        return machine.unknown(Cause.CALL, f"{cls.name}.{name}")
    if cls.__class__ is not Class:
        return machine.unknown(Cause.ERROR, f"no attribute {name}")
    outside = [b for b in cls.mro if b.__class__ in (External, Unknown)]
    of_nodes = _of_nodes(machine, ref, name) if outside else None
    if of_nodes is not None:
        machine.log.assumed_node(machine, ref, outside[0])
        return of_nodes
    base = decisive(outside)
    if base is not None:
        subject = f"{base.name}.{name}" if base.__class__ is External else name
        return machine.unknown(Cause.MODULE, subject)
    if any(b.__class__ is Class and may_hide(machine, b, name) for b in cls.mro):
        return machine.unknown(Cause.CALL, f"{cls.dotted}.{name}")
    if name.startswith("__") and hasattr(object, name):
        return BoundMethod(ref, Native(f"object.{name}"))
    if is_open(machine, cls):
        return machine.unknown(Cause.CALL, f"{cls.dotted}.{name}")
    return machine.unknown(Cause.ERROR, f"no attribute {name} in {cls.name}")


def is_interface(value: Value) -> bool:
    """Whether an external name is that of a message, service or action type or a part of one."""
    if value.__class__ is not External:
        return False
    parts = value.name.split(".")
    return len(parts) >= 3 and parts[1] in ("msg", "srv", "action") and parts[-1][:1].isupper()


def _of_class(machine: Engine, cls: Class, name: str) -> Value:
    meta = in_metaclass(machine, cls, name)
    if meta.__class__ is Descriptor and meta.kind == "property":
        return bind(machine, meta, cls, metaclass_of(machine, cls))
    if name == "__annotations__" and not cls.stub:
        written = annotated(machine, cls)
        if written is not None:
            return kept_table(machine, cls, written.items())
    found = lookup(machine, cls, name)
    if found is not None:
        if found.__class__ is Native and found.name in _CLASS_METHODS:
            return BoundMethod(cls, machine.load_attr(machine.load_module("_lazy"), _CLASS_METHODS[found.name]))
        return descriptors.through_class(machine, found, cls)
    if meta is not None:
        return bind(machine, meta, cls, metaclass_of(machine, cls))
    own = _of_every_class(machine, cls, name) if name.startswith("__") or name == "mro" else None
    if own is not None:
        return own
    for base in cls.mro:
        if base.__class__ is External:
            return External(f"{base.name}.{name}")
    fallback = in_metaclass(machine, cls, "__getattr__")
    if fallback is not None:
        return machine.call(bind(machine, fallback, cls, metaclass_of(machine, cls)), (Const(name),))
    if name in _OF_TYPE and TYPE in cls.mro:
        return Native(f"type.{name}")
    if name.startswith("__") and name != "__doc__" and name in vars(object):
        return Native(f"object.{name}")
    if hasattr(type, name) or is_open(machine, cls):
        return machine.unknown(Cause.CALL, f"{cls.dotted}.{name}")
    return machine.unknown(Cause.ERROR, f"no attribute {name} in {cls.name}")


def _of_every_class(machine: Engine, cls: Class, name: str) -> Value | None:
    """What each class has from `type`."""
    if name in ("__name__", "__qualname__"):
        return Const(cls.name if name == "__name__" else cls.qualname)
    if name == "__module__":
        return Const(cls.module)
    if name in ("__mro__", "mro"):
        order = Tuple((*(b for b in cls.mro if b != _OBJECT), _OBJECT))
        return order if name == "__mro__" else Partial(Native("builtins.list"), (order,), ())
    if name == "__class__":
        return metaclass_of(machine, cls)
    if name == "__subclasses__":
        below = Tuple(tuple(c for c in machine.log.classes if cls in c.bases))
        return Partial(Native("builtins.list"), (below,), ())
    if name == "__bases__":
        return Tuple(cls.bases or (_OBJECT,))
    if name == "__base__" and len(cls.bases) < 2:  # of several, the one that decides how objects look in memory
        return cls.bases[0] if cls.bases else _OBJECT
    if name == "__dict__":
        return table_of(machine, cls.address)
    return None


def _of_super(machine: Engine, value: Super, name: str) -> Value:
    receiver = value.receiver
    cls = machine.obj(receiver).cls if receiver.__class__ is Ref else receiver
    if cls.__class__ is Class and receiver is cls and value.after not in cls.mro:
        cls = metaclass_of(machine, cls)
    mro: tuple[Value, ...] = cls.mro if cls.__class__ is Class else ()
    if value.after not in mro:
        mro = next((c.mro for c in classes_of(machine, receiver) if value.after in c.mro), mro)
    if name == "__class__":
        return Native("builtins.super")
    perhaps: Value = UNBOUND
    behind = mro[mro.index(value.after) + 1 :] if value.after in mro else ()
    for number, base in enumerate(behind):
        if base.__class__ is Class:
            record = machine.at(base.address)
            found = record.attrs.get(name)
            if found is not None and found is not UNBOUND:
                bound = _through_super(machine, found, receiver, cls, name)
                if name not in record.partial:
                    return join(perhaps, bound)
                perhaps = join(perhaps, bound)  # where this class has none, that of the next one
        elif base.__class__ in (External, Unknown):
            outside = decisive(behind[number:])
            if outside.__class__ is Unknown:
                return join(perhaps, Unknown(outside.reasons))
            return join(perhaps, Partial(External(f"{getattr(outside, 'name', '')}.{name}"), (), ()))
        elif base.__class__ is Native:
            if base == TYPE and name in _OF_TYPE:
                made = Native(f"type.{name}")
                return made if name == "__new__" else BoundMethod(receiver, made)
            inherited = of_native_class(machine, base.name, name)
            if inherited is not None:
                return join(perhaps, inherited if name == "__new__" else BoundMethod(receiver, inherited))
    if name == "__new__":
        return join(perhaps, Native("object.__new__"))
    if value.after in mro and not hasattr(object, name) and all(_tells_all(machine, base, name) for base in behind):
        said = Const(f"'super' object has no attribute '{name}'")
        sure = perhaps is UNBOUND
        return join(perhaps, machine.die("AttributeError", f"no attribute {name} in any base", (said,), sure=sure))
    return join(perhaps, BoundMethod(receiver, Native(f"object.{name}")))


def _tells_all(machine: Engine, base: Value, name: str) -> bool:
    """Whether it is known of a base, behind which none has this attribute, that it has none either."""
    return base == _OBJECT or (base.__class__ is Class and not may_hide(machine, base, name))


def _through_super(machine: Engine, found: Value, receiver: Value, cls: Value, name: str) -> Value:
    """What an attribute of a base becomes when it is read through `super()`."""
    if name == "__new__":  # a static method, without being called one
        return found.getter if found.__class__ is Descriptor else found
    if receiver is cls and found.__class__ in (Function, Descriptor, Ref):
        return descriptors.through_class(machine, found, cls)
    return bind(machine, found, receiver, cls)


def setter_of(machine: Engine, in_class: Value | None) -> Value | None:
    """`__set__` of a descriptor that a class of the program defines."""
    if not isinstance(in_class, Ref) or machine.obj(in_class).kind != "instance":
        return None
    return lookup(machine, machine.obj(in_class).cls, "__set__")
