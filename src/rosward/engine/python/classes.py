# SPDX-License-Identifier: Apache-2.0
"""Classes: making them (C3 order, `__init_subclass__`, enums), making instances, and asking what is an instance of what."""

from __future__ import annotations

from collections import Counter
from typing import TYPE_CHECKING, Final

from rosward.domain.choice import join_all, options
from rosward.domain.compound import BoundMethod, Descriptor, External, Native, Tuple
from rosward.domain.heap import Obj
from rosward.domain.unknown import Cause
from rosward.domain.values import UNBOUND, Choice, Class, Const, Function, Ref, Unknown, Value
from rosward.engine.calls.alternatives import each_apart
from rosward.engine.python import abstract, attributes, contents, hidden_fields, members, metaclasses, subclass_hooks
from rosward.engine.python.metaclass_of import TYPE
from rosward.engine.python.own_methods import own_methods
from rosward.engine.running.frame import Frame, own_frame
from rosward.engine.unknown.escape import BY_BASE, BY_WINDOW, name_of, tell_type
from rosward.ir import ops
from rosward.ir.program import CodeKind
from rosward.location import Place
from rosward.models.python.exceptions import builtin_base, own_class
from rosward.models.readers import creates_nothing, decisive

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

NO_KEYWORDS: Final[dict[str, Value]] = {}
_MAX_COMBINATIONS: Final = 16
_IMPLICIT_CLASSMETHODS: Final = ("__init_subclass__", "__class_getitem__")


def make(machine: Engine, op: ops.MakeClass, frame: Frame) -> Value:
    """Run a class statement: a class for each combination of bases that it may have."""
    written, keywords = _bases(machine, op, frame)
    return each_apart(
        machine, _combinations(machine, written), lambda bases: _make(machine, op, frame, bases, dict(keywords))
    )


def _combinations(machine: Engine, written: list[Value]) -> list[Value]:
    """The bases that a class may have, each combination a tuple: the first class, then those that differ from it."""
    found: list[tuple[Value, ...]] = [()]
    for base in written:
        alternatives = _alternatives(base)
        if len(found) * len(alternatives) > _MAX_COMBINATIONS:
            machine.report("RW206", "a class with too many alternative bases: only the first is analysed")
            alternatives = alternatives[:1]
        found = [(*bases, each) for bases in found for each in alternatives]
    plain = Native("builtins.object")
    return [Tuple(tuple(b for b in bases if b != plain)) for bases in found]


def _alternatives(base: Value) -> list[Value]:
    """What a base may be. Of `try: from a import B / except ImportError: B = object` it is the class that is known."""
    if base.__class__ is not Choice:
        return [base]
    for wanted in (Class, External):
        found: list[Value] = [o for o in options(base) if o.__class__ is wanted]
        if found:
            return found
    return list(options(base))[:1]


def _make(machine: Engine, op: ops.MakeClass, frame: Frame, combination: Value, keywords: dict[str, Value]) -> Value:
    assert isinstance(combination, Tuple)
    bases = combination.items
    code = op.code
    place = Place(code.file, op.line, op.column)
    meta = metaclasses.chosen(machine, keywords.pop("metaclass", None), bases)
    prepared = metaclasses.prepare(machine, meta, code.name, combination, keywords)
    # A class is one object for each place, chain of calls and bases; the module's own classes are there once.
    address = machine.place_at(("class", frame.context, code.key, bases), Obj("class", Native("builtins.type")))
    record = machine.at(address)
    if record.many and frame.code.kind is CodeKind.MODULE:
        machine.put(address, Obj("class", Native("builtins.type")))
    cls = Class(address, code.name, code.qualname, frame.module.name, bases, _linearise(bases), place, frame.stub)
    body = Frame(code, [UNBOUND] * code.registers, (), frame.module, frame.context, frame.stub)
    captured = tuple([frame.cells[c] for c in op.captures])
    body.cells = (
        *machine.new_cells(code, machine.context(frame.context, frame.code.key, op.number, "class", bases)),
        *captured,
    )
    body.namespace = address
    if not frame.stub:
        machine.put(address, machine.at(address).with_attr("__doc__", Const(code.doc)))
    for name, value in prepared.items():
        machine.put(address, machine.at(address).with_attr(name, value))
    machine.frames.append(body)
    try:
        machine.run(code.ops, body)
    finally:
        machine.frames.pop()
    _seal(machine, cls, body)
    if isinstance(meta, Class):
        return metaclasses.finish(machine, cls, meta, combination, keywords, complete)
    return complete(machine, cls, keywords)


def complete(machine: Engine, cls: Class, keywords: dict[str, Value]) -> Class:
    """A class that has its names is told to its members and to its bases."""
    machine.log.defined(cls)
    if not cls.stub and "__getattribute__" in machine.at(cls.address).attrs:
        machine.hooked = True
    _tell_members(machine, cls)
    if any(b.__class__ is Class and b.enumeration for b in cls.bases):
        machine.call_native("enum.make_members", (cls,))
    hook = subclass_hooks.inherited(machine, cls)
    if hook is not None:
        function = hook.getter if hook.__class__ is Descriptor else hook
        machine.call(BoundMethod(cls, function), (), keywords)
    abstract.mark(machine, cls)
    return cls


def make_by_call(machine: Engine, meta: Value, args: tuple[Value, ...], keywords: dict[str, Value]) -> Value:
    """`type.__new__(metaclass, name, bases, names)`: the class whose body was just run, or one without a body."""
    name, bases, names = args[:3]
    pending = machine.making[-1] if machine.making else None
    plain = _plain_bases(machine, bases)
    if pending is not None and name == Const(pending.name):
        cls = pending
        if plain != pending.bases:
            cls = Class(cls.address, cls.name, cls.qualname, cls.module, plain, _linearise(plain), cls.place, cls.stub)
        if isinstance(meta, Class):  # its `__new__` may have called another metaclass
            machine.put(cls.address, machine.at(cls.address).replace(cls=meta))
    else:
        label = name.value if isinstance(name, Const) else "class made by type()"
        address = machine.place_at(("type", machine.place, name, plain), Obj("class", meta))
        frame = own_frame(machine.frames)
        module = "" if frame is None else frame.module.name
        cls = Class(address, str(label), str(label), module, plain, _linearise(plain), machine.place, False)
    metaclasses.fill(machine, cls, names)
    return complete(machine, cls, keywords)


def make_by_type(machine: Engine, args: tuple[Value, ...], keywords: dict[str, Value]) -> Value:
    """`type(name, bases, names)`: a metaclass that one of the bases has makes the class."""
    meta = metaclasses.chosen(machine, None, _plain_bases(machine, args[1]))
    if meta.__class__ is Class:
        return machine.call(meta, args, keywords)
    return make_by_call(machine, TYPE, args, keywords)


def _plain_bases(machine: Engine, bases: Value) -> tuple[Value, ...]:
    known = bases.items if isinstance(bases, Tuple) else machine.iterate(bases).known
    return tuple(b for b in known if b.__class__ in (Class, External, Native) and b != Native("builtins.object"))


def _tell_members(machine: Engine, cls: Class) -> None:
    """`__set_name__` of the objects in a class body."""
    for name, value in list(machine.at(cls.address).attrs.items()):
        if isinstance(value, Ref) and machine.obj(value).kind == "instance":
            hook = attributes.method(machine, value, "__set_name__")
            if hook is not None:
                machine.call(hook, (cls, Const(name)))


def _bases(machine: Engine, op: ops.MakeClass, frame: Frame) -> tuple[list[Value], dict[str, Value]]:
    """The base classes as written, and the keywords."""
    bases: list[Value] = []
    keywords: dict[str, Value] = {}
    for argument in op.arguments:
        value = frame.registers[argument.register]
        if argument.kind == "keyword":
            keywords[argument.name] = value
            continue
        several = machine.iterate(value).known if argument.kind == "star" else (value,)
        for each in several:
            entries = _entries(machine, each, tuple(several))
            if entries is not None:
                bases.extend(entries)
                continue
            base = each
            if base.__class__ in (Class, External, Native, Unknown, Choice):
                bases.append(base)
            else:
                bases.append(machine.unknown(Cause.OPERATION, "base class"))
    return bases, keywords


def _entries(machine: Engine, base: Value, bases: tuple[Value, ...]) -> list[Value] | None:
    """What an object that stands for bases (`__mro_entries__`) gives; None for any other."""
    if base.__class__ is not Ref or machine.obj(base).kind != "instance":
        return None
    hook = attributes.method(machine, base, "__mro_entries__")
    return None if hook is None else list(machine.iterate(machine.call(hook, (Tuple(bases),))).known)


def _seal(machine: Engine, cls: Class, body: Frame) -> None:
    """Fill the `__class__` cell of the body and the names that Python gives attributes."""
    if "__class__" in body.code.cells:
        cell = Ref(body.cells[body.code.cells.index("__class__")])
        machine.update(cell, machine.obj(cell).with_attr("value", cls))
    record = machine.at(cls.address)
    changed = {
        name: Descriptor("classmethod", record.attrs[name], None, None)
        for name in _IMPLICIT_CLASSMETHODS
        if record.attrs.get(name).__class__ is Function
    }
    if changed:
        attrs: dict[str, Value] = {**record.attrs, **changed}
        machine.put(cls.address, record.replace(attrs=attrs))


def _linearise(bases: tuple[Value, ...]) -> tuple[Value, ...]:
    """The C3 merge of the bases' orders; where Python would refuse them, a plain depth-first order."""
    orders = [b.mro if isinstance(b, Class) else (b,) for b in bases]
    if len(orders) == 1:
        return orders[0]
    sequences = [list(order[::-1]) for order in (*orders, bases)]  # the next of each stands last
    waiting = Counter(cls for sequence in sequences for cls in sequence[:-1])  # how often a class stands behind another
    result: list[Value] = []
    while sequences := [s for s in sequences if s]:
        head = next((s[-1] for s in sequences if not waiting[s[-1]]), None)
        if head is None:
            return tuple(dict.fromkeys(c for order in orders for c in order))
        result.append(head)
        for sequence in sequences:
            if sequence[-1] == head:
                sequence.pop()
                if sequence:
                    waiting[sequence[-1]] -= 1
    return tuple(result)


def _is_enum_base(base: Value) -> bool:
    return base.__class__ is Class and base.module == "enum" and base.stub


def is_enum(_machine: Engine, cls: Class) -> bool:
    """Whether a class is an enumeration with members of its own."""
    return cls.enumeration and not _is_enum_base(cls)


def new_instance(
    machine: Engine, cls: Class, args: tuple[Value, ...] | None = None, keywords: dict[str, Value] = NO_KEYWORDS
) -> Ref:
    """An object of a class, before `__init__`; an exception has its arguments by then."""
    machine.trace.instantiated.add(cls.place)
    if args is not None and builtin_base(cls) is not None:
        return machine.allocate(Obj("instance", cls, attrs={"args": Tuple(args)}), cls.address)
    ref = machine.allocate(Obj("instance", cls), cls.address)
    if not is_enum(machine, cls):
        contents.give(machine, cls, ref, args, keywords)
    return ref


def instantiate(machine: Engine, cls: Class, args: tuple[Value, ...], keywords: dict[str, Value]) -> Value:
    """cls(*args, **keywords)."""
    caller = metaclasses.method(machine, cls, "__call__")
    if caller is not None:
        return machine.call(caller, args, keywords)
    return make_instance(machine, cls, args, keywords)


def make_instance(machine: Engine, cls: Class, args: tuple[Value, ...], keywords: dict[str, Value]) -> Value:
    """What `type.__call__` does: `__new__`, then `__init__`."""
    if is_enum(machine, cls) and args:
        return machine.call_native("enum.lookup", (cls, args[0]))
    maker = members.lookup(machine, cls, "__new__")
    if maker is not None and maker.__class__ in (Function, Descriptor):
        function = maker.getter if maker.__class__ is Descriptor else maker
        made = machine.call(function, (cls, *args), keywords)
        machine.trace.instantiated.add(cls.place)
        initialised: list[Value] = []
        for option in options(made):
            if isinstance(option, Ref) and machine.obj(option).kind == "instance" and _has(machine, option, cls):
                if _initialise(machine, cls, option, args, keywords) is not UNBOUND:
                    initialised.append(option)
            elif option is not UNBOUND:
                metaclasses.start(machine, cls, option, args, keywords)
                initialised.append(option)
        for option in initialised:
            if isinstance(option, Ref) and not cls.stub:
                _framework(machine, cls, option, args)
        return join_all(initialised)
    if len(args) > 2 and TYPE in cls.mro:
        machine.trace.instantiated.add(cls.place)
        made = make_by_call(machine, cls, args, keywords)
        return metaclasses.start(machine, cls, made, args, keywords)
    if abstract.refused(machine, cls):
        machine.trace.instantiated.add(cls.place)
        return UNBOUND
    base, initialiser = builtin_base(cls), members.lookup(machine, cls, "__init__")
    # OSError leaves it to an `__init__` to give it its arguments
    own = base is not None and issubclass(base, OSError) and initialiser.__class__ is Function
    ref = new_instance(machine, cls, () if own else args, keywords)
    if base is not None and _hidden(initialiser):
        said = machine.unknown(Cause.CALL, f"{cls.dotted}.args", "tuple")
        machine.update(ref, machine.obj(ref).with_attr("args", said))
    if _initialise(machine, cls, ref, args, keywords) is UNBOUND:
        return UNBOUND
    if not cls.stub:
        _framework(machine, cls, ref, args)
    return ref


def _hidden(constructor: Value | None) -> bool:
    """Whether a model does not show what a constructor does."""
    return (
        constructor.__class__ is Function and constructor.code.is_stub and constructor.code.file.startswith("models:")
    )


def _has(machine: Engine, ref: Ref, cls: Class) -> bool:
    found = machine.obj(ref).cls
    return found.__class__ is Class and cls in found.mro


def _initialise(machine: Engine, cls: Class, ref: Ref, args: tuple[Value, ...], keywords: dict[str, Value]) -> Value:
    """Run `__init__`; a base that is not known gets the arguments."""
    for base in cls.mro:
        if base.__class__ is Class:
            found = machine.at(base.address).attrs.get("__init__")
            if found is not None and found is not UNBOUND:
                start = members.bind(machine, found, ref, cls) if found.__class__ is Ref else BoundMethod(ref, found)
                return machine.call(start, args, keywords)
        elif base.__class__ in (External, Unknown):
            outside = decisive(cls.mro) or base
            machine.escape((*args, *keywords.values()), name_of(outside), outside)
            hidden_fields.give(machine, cls, ref, args, keywords)
            return ref
        else:
            filled = contents.initialiser(machine, base)
            if filled is not None:
                return machine.call(BoundMethod(ref, filled), args, keywords)
    if members.lookup(machine, cls, "__new__") is None and builtin_base(cls) is None:
        hidden_fields.give(machine, cls, ref, args, keywords)
    return ref


def _framework(machine: Engine, cls: Class, ref: Ref, args: tuple[Value, ...]) -> None:
    """A class whose base is not known may be called by it: any method of its own, with anything. What the class says, the base may read."""
    outside = [b for b in cls.mro if b.__class__ in (External, Unknown)]
    if not outside:
        return
    said = [
        value
        for base in cls.mro
        if base.__class__ is Class and not base.stub
        for name, value in machine.at(base.address).attrs.items()
        if not name.startswith("__")
    ]
    base = decisive(outside) or outside[0]
    tell_type(machine, (*said, *args), name_of(base), base)
    machine.trace.handed.setdefault(ref, machine.place)
    event = BY_WINDOW if all(creates_nothing(b) for b in outside) else BY_BASE
    for name, method in own_methods(machine, cls, ref):
        if not name.startswith("__"):
            machine.schedule(method, None, event)


def exception_object(
    machine: Engine, cls: Native, args: tuple[Value, ...], keywords: dict[str, Value] | None = None
) -> Value:
    """An instance of a builtin exception class."""
    return machine.allocate(Obj("instance", own_class(cls, args), attrs={"args": Tuple(args), **(keywords or {})}))
