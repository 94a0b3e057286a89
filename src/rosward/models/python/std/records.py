# SPDX-License-Identifier: Apache-2.0
"""Classes made of their fields: `@dataclass`, `namedtuple`, `NamedTuple`.

    @dataclass
    class Topic:
        name: str                  Topic('/scan').name == '/scan', .depth == 10
        depth: int = 10

`dataclasses.dataclass` leaves the fields in an attribute of the class and
`Native('dataclasses.init')` as `__init__`: a native in a class is bound like a function, the instance comes first.
"""

from __future__ import annotations

from typing import Final, NamedTuple

from rosward.domain.choice import join, join_all, options
from rosward.domain.compound import Descriptor, External, Native, Partial, Tuple
from rosward.domain.heap import Obj
from rosward.domain.unknown import Cause
from rosward.domain.values import FALSE, NONE, TRUE, UNBOUND, Class, Const, Ref, Value
from rosward.models.native import Machine, NativeCall, NativeFunction
from rosward.models.python.plain import text_of
from rosward.models.python.std.support import class_obj, exact_dict, exact_list, place_dict, place_list
from rosward.models.python.strings.formatting import joined, represent

FIELDS: Final = "_rosward_fields"
"""Where a class keeps what is known of its fields; the program sees `__dataclass_fields__`, a dict of them."""
FROZEN: Final = Native("dataclasses.refuse")
"""`__setattr__` of a frozen class."""
HOOK: Final = "__post_init__"
"""What a generated `__init__` calls at its end, if the class has it where it is decorated."""
FIELD: Final = External("dataclasses.Field")
_ABSENT: Final = Tuple(())


class _Field(NamedTuple):
    """One field; default and factory are UNBOUND where there is none."""

    name: str
    kind: str  # 'field' or 'initvar'
    init: bool
    kw_only: bool
    default: Value
    factory: Value
    metadata: Value = UNBOUND
    compared: bool = True
    shown: bool = True

    def pack(self) -> Value:
        def some(value: Value) -> Value:
            return _ABSENT if value is UNBOUND else Tuple((value,))

        flags = (Const(self.init), Const(self.kw_only), Const(self.compared), Const(self.shown))
        return Tuple(
            (Const(self.name), Const(self.kind), *flags, some(self.default), some(self.factory), some(self.metadata))
        )


def _unpack(value: Value) -> list[_Field]:
    found: list[_Field] = []
    for one in value.items if isinstance(value, Tuple) else ():
        if isinstance(one, Tuple) and len(one.items) == 9:
            name, kind, init, kw_only, compared, shown, *rest = one.items
            default, factory, metadata = (t.items[0] if isinstance(t, Tuple) and t.items else UNBOUND for t in rest)
            flags = (init == TRUE, kw_only == TRUE)
            told = (default, factory, metadata)
            found.append(
                _Field(text_of(name) or "", text_of(kind) or "field", *flags, *told, compared == TRUE, shown == TRUE)
            )
    return found


def fields_of(machine: Machine, cls: Value) -> list[_Field] | None:
    """The fields of a dataclass, bases first; None for any other class."""
    if isinstance(cls, Class):
        for base in cls.mro:
            if isinstance(base, Class):
                found = machine.obj(class_obj(base)).attrs.get(FIELDS)
                if found is not None:
                    return _unpack(found)
    return None


def class_of(machine: Machine, value: Value) -> Value | None:
    """The class of an instance (a class stands for itself)."""
    if isinstance(value, Class):
        return value
    return machine.obj(value).cls if isinstance(value, Ref) else None


def dataclass(call: NativeCall) -> Value:
    """@dataclass, @dataclass(frozen=True): the class, with fields and `__init__`."""
    if not call.args or call.args[0] == NONE:
        return Partial(Native("dataclasses.dataclass"), (), tuple(sorted(call.keywords.items())))
    cls = call.args[0]
    if not isinstance(cls, Class):
        return cls
    machine = call.machine
    attrs = machine.obj(class_obj(cls)).attrs
    fields: dict[str, _Field] = {}
    for base in reversed(cls.mro[1:]):
        for field in fields_of(machine, base) or ():
            fields[field.name] = field
    kw_only = machine.truth(call.keywords.get("kw_only", FALSE)) is True
    for name, annotation in annotations_of(machine, cls).items():
        text = annotation.strip("'\" ")
        if text.rpartition(".")[2] == "KW_ONLY":
            kw_only = True
        elif text.split("[")[0].rpartition(".")[2] != "ClassVar":
            fields[name] = _field(machine, cls, name, text, written=attrs.get(name, UNBOUND), kw_only=kw_only)
    machine.store_attr(cls, FIELDS, Tuple(tuple(f.pack() for f in fields.values())))
    table: dict[Value, Value] = {Const(f.name): _told(machine, f) for f in fields.values()}
    machine.store_attr(cls, "__dataclass_fields__", machine.new_dict(table))
    positional = tuple(Const(f.name) for f in fields.values() if f.init and not f.kw_only)
    if "__match_args__" not in attrs:
        machine.store_attr(cls, "__match_args__", Tuple(positional))
    own_init = "init_alone" if _own_method(machine, cls, HOOK) is None else "init"
    for name, option, made in (("init", "__init__", own_init), ("eq", "__eq__", "eq"), ("repr", "__repr__", "repr")):
        if option not in attrs and machine.truth(call.keywords.get(name, TRUE)) is not False:
            machine.store_attr(cls, option, Native(f"dataclasses.{made}"))
    if machine.truth(call.keywords.get("order", FALSE)) is True:
        for option in _ORDERS:
            machine.store_attr(cls, option, Native(f"dataclasses.{option}"))
    if machine.truth(call.keywords.get("frozen", FALSE)) is True:
        machine.store_attr(cls, "__setattr__", FROZEN)
    if machine.truth(call.keywords.get("slots", FALSE)) is True:
        machine.store_attr(cls, "__slots__", Tuple(tuple(map(Const, annotations_of(machine, cls)))))
    return cls


def annotations_of(machine: Machine, cls: Class) -> dict[str, str]:
    """The annotations in the body of a class, in order."""
    found = machine.obj(class_obj(cls)).attrs.get("__annotations__")
    entries = exact_dict(machine, found) if found is not None else None
    return {text_of(k) or "": text_of(v) or "" for k, v in (entries or {}).items()}


def _field(machine: Machine, cls: Class, name: str, annotation: str, *, written: Value, kw_only: bool) -> _Field:
    kind = "initvar" if annotation.split("[", maxsplit=1)[0].rpartition(".")[2] == "InitVar" else "field"
    obj = machine.obj(written) if isinstance(written, Ref) else None
    if obj is None or obj.cls != FIELD:
        return _Field(name, kind, True, kw_only, written, UNBOUND)
    given = obj.attrs
    default, factory = given.get("default", UNBOUND), given.get("default_factory", UNBOUND)
    if default is not UNBOUND:
        machine.store_attr(cls, name, default)
    init = machine.truth(given.get("init", TRUE)) is not False
    only = machine.truth(given["kw_only"]) is True if "kw_only" in given else kw_only
    compared, shown = (machine.truth(given.get(o, TRUE)) is not False for o in ("compare", "repr"))
    return _Field(name, kind, init, only, default, factory, given.get("metadata", UNBOUND), compared, shown)


def _make_field(call: NativeCall) -> Value:
    """dataclasses.field(...): what was given of it."""
    return call.machine.allocate(Obj("instance", FIELD, dict(call.keywords)))


def _make(call: NativeCall) -> Value:
    """make_dataclass(name, fields, bases=(), namespace=None, ...): a class with these annotations, and the decorator for it."""
    machine = call.machine
    given = call.arg(1, "fields")
    rows = exact_list(machine, given) if given is not None else None
    bases, own = call.keywords.get("bases", Tuple(())), call.keywords.get("namespace", NONE)
    names = {} if own == NONE else exact_dict(machine, own)
    notes: dict[Value, Value] = {}
    for row in rows or ():
        parts = (row,) if text_of(row) is not None else exact_list(machine, row) or ()
        name = text_of(parts[0]) if parts else None
        if name is None or names is None:
            return machine.unknown(Cause.CALL, call.name)
        notes[Const(name)] = Const("object")
        if len(parts) > 2:
            names[Const(name)] = parts[2]
    if rows is None or names is None:
        return machine.unknown(Cause.CALL, call.name)
    body = machine.new_dict({**names, Const("__annotations__"): machine.new_dict(notes)})
    cls = machine.call(Native("builtins.type"), (call.arg(0, "cls_name") or NONE, bases, body))
    options = {
        k: v for k, v in call.keywords.items() if k not in ("cls_name", "fields", "bases", "namespace", "module")
    }
    return machine.call(Native("dataclasses.dataclass"), (cls,), options)


def _default(machine: Machine, field: _Field) -> Value:
    if field.factory is not UNBOUND:
        return machine.call(field.factory, ())
    return field.default


def init(call: NativeCall) -> Value:
    """dataclasses.init(instance, *args, **keywords): the generated `__init__`, with `__post_init__` behind it."""
    return _init(call, hooked=True)


def _init_alone(call: NativeCall) -> Value:
    """The one of a class that had no `__post_init__` when it was decorated: none that it is given later is called."""
    return _init(call, hooked=False)


def _init(call: NativeCall, *, hooked: bool) -> Value:
    machine, instance, given = call.machine, call.args[0], call.args[1:]
    cls = class_of(machine, instance)
    fields = (fields_of(machine, cls) if cls is not None else None) or []
    positional = [f for f in fields if f.init and not f.kw_only]
    if len(given) > len(positional):
        return machine.die(
            "TypeError", f"__init__() takes {len(positional) + 1} positional arguments but {len(given) + 1} were given"
        )
    values = {f.name: v for f, v in zip(positional, given, strict=False)}
    wrong = [k for k in call.keywords if k in values or not any(f.name == k and f.init for f in fields)]
    if wrong:
        return machine.die("TypeError", f"__init__() got an unexpected keyword argument '{wrong[0]}'")
    values.update(call.keywords)
    passed: list[Value] = []
    for field in fields:
        value = values[field.name] if field.name in values else _default(machine, field)
        if value is UNBOUND:
            if field.init:
                return machine.die("TypeError", f"__init__() missing 1 required positional argument: '{field.name}'")
            continue
        if field.kind == "initvar":
            passed.append(value)
        else:
            _set(machine, instance, field.name, value)
    hook = _own_method(machine, cls, HOOK) if hooked else None
    if hook is not None:
        machine.call(hook, (instance, *passed))
    return NONE


def _set(machine: Machine, instance: Value, name: str, value: Value) -> None:
    """Set past `__setattr__`, as a frozen class does; properties of the class are kept."""
    if isinstance(instance, Ref):
        cls = machine.obj(instance).cls
        if _own_method(machine, cls, "__setattr__") in (None, FROZEN) and not isinstance(
            _own_method(machine, cls, name), Descriptor
        ):
            obj = machine.obj(instance)
            machine.update(
                instance, obj.with_attr(name, join(obj.attrs[name], value) if obj.many and name in obj.attrs else value)
            )
            return
    machine.store_attr(instance, name, value)


def _refuse(call: NativeCall) -> Value:
    """dataclasses.refuse(instance, name, value): an attribute of a frozen object is set."""
    machine = call.machine
    cls = machine.load_attr(machine.load_module("dataclasses"), "FrozenInstanceError")
    machine.throw(machine.call(cls, (machine.unknown(Cause.LIVE, "message of an exception", "str"),)))
    return UNBOUND


def _own_method(machine: Machine, cls: Value | None, name: str) -> Value | None:
    for base in cls.mro if isinstance(cls, Class) else ():
        if isinstance(base, Class):
            found = machine.obj(class_obj(base)).attrs.get(name)
            if found is not None:
                return found
    return None


def _eq(call: NativeCall) -> Value:
    """dataclasses.eq(a, b): field by field."""
    pair = _compared(call)
    if pair is None:
        right = call.args[1]
        return FALSE if isinstance(right, (Const, Ref)) else call.machine.unknown(Cause.OPERATION, "==", "bool")
    return call.machine.compare("==", *pair)


def _repr(call: NativeCall) -> Value:
    """dataclasses.repr(instance): `Topic(name='/scan', depth=10)`."""
    machine, instance = call.machine, call.args[0]
    cls = class_of(machine, instance)
    shown = [f.name for f in fields_of(machine, cls or NONE) or () if f.kind == "field" and f.shown]
    pieces: list[Value] = [Const(f"{cls.qualname}(" if isinstance(cls, Class) else "(")]
    for number, name in enumerate(shown):
        pieces += [Const(f"{', ' if number else ''}{name}="), represent(machine, machine.load_attr(instance, name))]
    return joined(machine, [*pieces, Const(")")])


_ORDERS: Final = {"__lt__": "<", "__le__": "<=", "__gt__": ">", "__ge__": ">="}


def _order(call: NativeCall) -> Value:
    """dataclasses.__lt__(a, b) and the like, of a class with an order: field by field."""
    operator = _ORDERS[call.name.rpartition(".")[2]]
    pair = _compared(call)
    if pair is None:
        return call.machine.unknown(Cause.OPERATION, operator, "bool")
    return call.machine.compare(operator, *pair)


def _compared(call: NativeCall) -> tuple[Value, Value] | None:
    """The fields of two objects that are compared; None where they are not of one class."""
    machine, (left, right) = call.machine, call.exactly(2)
    cls = class_of(machine, left)
    fields = fields_of(machine, cls or NONE)
    if fields is None or cls != class_of(machine, right):
        return None
    names = [f.name for f in fields if f.kind == "field" and f.compared]
    first, second = (Tuple(tuple(machine.load_attr(v, n) for n in names)) for v in (left, right))
    return first, second


def _field_names(machine: Machine, value: Value) -> list[str] | None:
    fields = fields_of(machine, class_of(machine, value) or NONE)
    return None if fields is None else [f.name for f in fields if f.kind == "field"]


def _as(call: NativeCall) -> Value:
    """asdict, astuple: fields that are dataclasses, or lists and dicts of such, are converted too."""
    if "dict_factory" in call.keywords or "tuple_factory" in call.keywords:
        return call.machine.unknown(Cause.CALL, call.name)
    return _convert(call.machine, call.args[0], call.name.endswith("asdict"), ("as",))


def _convert(machine: Machine, value: Value, as_dict: bool, path: tuple[object, ...]) -> Value:
    if len(path) > 20 or not isinstance(value, (Ref, Tuple)):
        return value
    if isinstance(value, Tuple):
        return Tuple(tuple(_convert(machine, v, as_dict, (*path, i)) for i, v in enumerate(value.items)))
    names = _field_names(machine, value)
    if names is not None:
        parts = [_convert(machine, machine.load_attr(value, n), as_dict, (*path, n)) for n in names]
        if not as_dict:
            return Tuple(tuple(parts))
        return place_dict(machine, {Const(n): v for n, v in zip(names, parts, strict=True)}, path)
    obj = machine.obj(value)
    if obj.kind == "list" and obj.items is not None:
        return place_list(machine, [_convert(machine, v, as_dict, (*path, i)) for i, v in enumerate(obj.items)], path)
    if obj.kind == "dict" and obj.rest is None and not obj.maybe:
        entries = {k: _convert(machine, v, as_dict, (*path, i)) for i, (k, v) in enumerate(obj.entries.items())}
        return place_dict(machine, entries, path)
    return value


def _replace(call: NativeCall) -> Value:
    """replace(instance, **changes): a new instance through `__init__`."""
    machine, instance = call.machine, call.args[0]
    cls = class_of(machine, instance)
    fields = fields_of(machine, cls) if cls is not None else None
    if cls is None or fields is None:
        return machine.unknown(Cause.CALL, call.name)
    keywords = {f.name: machine.load_attr(instance, f.name) for f in fields if f.init and f.kind == "field"}
    return machine.call(cls, (), {**keywords, **call.keywords})


def _fields(call: NativeCall) -> Value:
    machine = call.machine
    found = fields_of(machine, class_of(machine, call.args[0]) or NONE)
    if found is None:
        return machine.unknown(Cause.CALL, call.name, "tuple")
    return Tuple(tuple(_told(machine, field) for field in found if field.kind == "field"))


def _told(machine: Machine, field: _Field) -> Value:
    """A field as the program sees it."""
    missing = machine.load_attr(machine.load_module("dataclasses"), "MISSING")
    attrs: dict[str, Value] = {
        "name": Const(field.name),
        "init": Const(field.init),
        "kw_only": Const(field.kw_only),
        "default": missing if field.default is UNBOUND else field.default,
        "default_factory": missing if field.factory is UNBOUND else field.factory,
        "metadata": machine.new_dict({}) if field.metadata is UNBOUND else field.metadata,
        "type": machine.unknown(Cause.CALL, "dataclasses.Field.type"),
    }
    return machine.allocate(Obj("instance", FIELD, attrs), field.name)


def _is_dataclass(call: NativeCall) -> Value:
    found = [class_of(call.machine, o) for o in options(call.args[0])]
    answers = [Const(fields_of(call.machine, c) is not None) for c in found if c is not None]
    return join_all(answers) if len(answers) == len(found) else call.machine.unknown(Cause.OPERATION, call.name, "bool")


NATIVES: Final[dict[str, NativeFunction]] = {
    "dataclasses.dataclass": dataclass,
    "dataclasses.make_dataclass": _make,
    "dataclasses.field": _make_field,
    "dataclasses.init": init,
    "dataclasses.init_alone": _init_alone,
    "dataclasses.eq": _eq,
    "dataclasses.repr": _repr,
    **{f"dataclasses.{name}": _order for name in _ORDERS},
    "dataclasses.refuse": _refuse,
    "dataclasses.asdict": _as,
    "dataclasses.astuple": _as,
    "dataclasses.replace": _replace,
    "dataclasses.fields": _fields,
    "dataclasses.is_dataclass": _is_dataclass,
}
