# SPDX-License-Identifier: Apache-2.0
"""Calls: what a callable value does with arguments.

A call of a function is interpreted with its own arguments, in its own context. The result is remembered where the call wrote nothing, so that
call trees do not explode; recursion beyond a few levels is solved by a fixpoint over one summary of the function.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.domain.choice import join_all, lost_behaviour, options, reasons_of
from rosward.domain.compound import BoundMethod, Descriptor, External, Native, Partial, Super, Tuple
from rosward.domain.heap import Obj
from rosward.domain.series import Series, concatenated
from rosward.domain.suspended import Suspension
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, UNBOUND, Choice, Class, Const, Function, Ref, Unknown, Value
from rosward.engine.arguments import ANY, LOOSE, MAYBE, ORDER
from rosward.engine.calls import activation
from rosward.engine.calls.alternatives import each_apart
from rosward.engine.python import (
    assignment,
    attributes,
    classes,
    decorating,
    descriptors,
    members,
    native_calls,
    object_methods,
)
from rosward.engine.python.binding import BadCallError, bind_arguments
from rosward.engine.python.metaclass_of import metaclass_of
from rosward.engine.running.catcher import LIBRARY
from rosward.engine.throwing import note, note_call
from rosward.engine.unknown import declared, outside
from rosward.engine.unknown.escape import escape, name_of
from rosward.ir.ops import Argument
from rosward.models.python.comparing.equal_objects import member_value
from rosward.models.python.containers.dicts import is_mapping
from rosward.models.python.contents import bare
from rosward.models.python.exceptions import is_exception

if TYPE_CHECKING:
    from rosward.engine.machine import Engine
    from rosward.engine.running.frame import Frame

Arguments = tuple[Value, ...]
Keywords = dict[str, Value]


def call_with(machine: Engine, function: Value, arguments: tuple[Argument, ...], registers: list[Value]) -> Value:
    """A call as written, with starred and named arguments."""
    keywords: Keywords = {}
    several: list[Series] = []
    loose: list[Value] = []
    for argument in arguments:
        value = registers[argument.register]
        if argument.kind == "positional":
            several.append(Series((value,)))
        elif argument.kind == "keyword":
            keywords[argument.name] = value
        elif argument.kind == "star":
            several.append(machine.series(value))
        else:
            loose.extend(_spread(machine, value, keywords))
    args = concatenated(several)
    behind = args.behind_head()  # what stands there may be any parameter that the head does not reach
    if args.middle is not None and behind is not None:
        if not loose:
            keywords[ORDER] = Tuple((args.middle, *args.tail))
        loose.append(behind)
    if loose:
        keywords[LOOSE] = join_all(loose)  # further arguments, of unknown number and name
    return machine.language.call(machine, function, args.head, keywords)


def _spread(machine: Engine, value: Value, keywords: Keywords) -> list[Value]:
    """Merge `**value` into keywords; returns the values whose names are not known."""
    loose: list[Value] = []
    tables: list[Keywords] = []
    unsure: set[str] = set()
    for option in options(bare(machine, value)):
        if is_mapping(machine, option):
            option = machine.call_native("builtins.dict", (option,))  # noqa: PLW2901 - what it says that it holds
        if option.__class__ is Ref and machine.obj(option).kind == "dict":
            obj = machine.obj(option)
            table: Keywords = {}
            for written, item in obj.entries.items():
                key = member_value(machine, written) or written
                if key.__class__ is Const and isinstance(key.value, str):
                    table[key.value] = item
                    if written in obj.maybe:
                        unsure.add(key.value)
                else:
                    loose.append(item)
            tables.append(table)
            if obj.rest is not None:
                loose.append(obj.rest)
        elif option != NONE:
            loose.append(machine.unknown(Cause.OPERATION, "**", ""))
    for name in dict.fromkeys(n for t in tables for n in t):
        joined = join_all(t[name] for t in tables if name in t)
        if name in unsure or not all(name in t for t in tables):
            keywords[MAYBE + name] = joined  # binding joins it with the default
        else:
            keywords[name] = joined
    return loose


def call(machine: Engine, function: Value, args: Arguments, keywords: Keywords) -> Value:
    """function(*args, **keywords); UNBOUND where it never returns."""
    if function.__class__ is Function:
        language = machine.language
        if function.code.language != language.name:
            language = machine.languages[function.code.language]
        return language.call_function(machine, function, args, keywords)
    if function.__class__ is BoundMethod:
        return call(machine, function.function, (function.receiver, *args), keywords)
    if function.__class__ is Class:
        return classes.instantiate(machine, function, args, keywords)
    if function.__class__ is Native:
        return call_native(machine, function.name, args, keywords)
    if function.__class__ is Partial:
        merged = {**dict(function.keywords), **keywords} if function.keywords else keywords
        return call(machine, function.function, (*function.arguments, *args), merged)
    if function.__class__ is Choice:
        return _call_choice(machine, function, args, keywords)
    if function.__class__ is External:
        return _call_external(machine, function, args, keywords)
    if function.__class__ is Ref:
        return _call_object(machine, function, args, keywords)
    if function.__class__ is Descriptor:
        return call(machine, function.getter, args, keywords)
    if function.__class__ is Unknown:
        note_call(machine)
        if lost_behaviour(function):
            machine.report("RW201", "too many alternatives for what is called here: none of them is analysed")
        made = decorating.hand(machine, function, args, keywords)
        if made is not None:
            return made
        escape(machine, (*args, *keywords.values()), name_of(function), function)
        return Unknown(function.reasons)
    escape(machine, (*args, *keywords.values()), name_of(function))
    return machine.unknown(Cause.ERROR, "call of something that is not callable")


def _call_choice(machine: Engine, function: Choice, args: Arguments, keywords: Keywords) -> Value:
    """Each alternative from the same state, results and states joined."""
    callees = [o for o in function.options if o != NONE] or list(function.options)

    def one(option: Value) -> Value:
        machine.choosing = len(callees)
        try:
            return call(machine, option, args, keywords)
        finally:
            machine.choosing = 0

    if len(callees) == 1:
        return call(machine, callees[0], args, keywords)
    before = len(machine.refused)
    found = each_apart(machine, callees, one)
    told, machine.refused = machine.refused[before:], machine.refused[:before]
    if len(told) == len(callees):  # none of them takes the arguments
        machine.report("RW209", told[0])
    return found


def _call_object(machine: Engine, ref: Ref, args: Arguments, keywords: Keywords) -> Value:
    obj = machine.obj(ref)
    method = members.lookup(machine, obj.cls, "__call__") if obj.kind == "instance" else None
    if method is not None:
        return call(machine, members.bind(machine, method, ref, obj.cls), args, keywords)
    made = decorating.hand(machine, ref, args, keywords)
    if made is not None:
        return made
    name = obj.cls.name if isinstance(obj.cls, (Class, External)) else obj.kind
    escape(machine, (*args, *keywords.values()), name)
    return machine.unknown(Cause.CALL, name)


def _call_external(machine: Engine, function: External, args: Arguments, keywords: Keywords) -> Value:
    """Something of a library that is not modelled: its callable arguments may be called; an interface type makes a message."""
    if attributes.is_interface(function):
        named = {k.lstrip(MAYBE): v for k, v in keywords.items() if k not in (LOOSE, ORDER, ANY)}
        return machine.allocate(Obj("instance", function, attrs=named))
    if machine.library.native(function.name):
        return call_native(machine, function.name, args, keywords)
    note_call(machine)
    outside.note(machine, function)
    made = decorating.hand(machine, function, args, keywords)
    if made is not None:
        return made
    escape(machine, (*args, *keywords.values()), function.name, function)
    return machine.unknown(Cause.CALL, function.name)


def call_native(machine: Engine, name: str, args: Arguments, keywords: Keywords) -> Value:
    """A builtin, or a model in code."""
    if name.startswith(("type.", "builtins.type")):
        made = _of_type(machine, name.removeprefix("builtins."), args, keywords)
        if made is not None:
            return made
    native = machine.library.native(name)
    if native is not None:
        return native_calls.invoke(machine, native, name, args, keywords)
    args, keywords = native_calls.flattened(args, keywords)
    short = name.removeprefix("builtins.")
    if short == "super":
        return _super(machine, args)
    if "." not in short:
        if is_exception(short):
            return classes.exception_object(machine, Native(name), args, keywords)
    if short == "object" or name.startswith("object."):
        return object_methods.call(machine, short, args)
    if short.endswith(".__new__") and args and args[0].__class__ is Class:
        return classes.new_instance(machine, args[0], args[1:], keywords)
    if short.startswith("descriptor."):
        return descriptors.call(machine, short, args)
    escape(machine, (*args, *keywords.values()), short, Native(name))
    return machine.unknown(Cause.CALL, short)


def _of_type(machine: Engine, name: str, args: Arguments, keywords: Keywords) -> Value | None:
    """The methods that every metaclass has from `type`; None for any other use of it."""
    known = {k: v for k, v in keywords.items() if k not in (LOOSE, ANY) and k[0] != MAYBE}
    if name == "type.__new__" and len(args) >= 4:
        return classes.make_by_call(machine, args[0], args[1:], known)
    if name == "type" and len(args) == 3:
        return classes.make_by_type(machine, args, known)
    if name == "type.__call__" and args and args[0].__class__ is Class:
        return classes.make_instance(machine, args[0], args[1:], keywords)
    if name == "type.__init__":
        return NONE
    if name == "type.__prepare__":
        return machine.new_dict({})
    return None


def _super(machine: Engine, args: Arguments) -> Value:
    """`super()` in any of its forms."""
    if len(args) >= 2:
        return join_all(_super_of(machine, args[0], receiver) for receiver in options(args[1]))
    for frame in reversed(machine.frames):
        code = frame.code
        if "__class__" in code.free and frame.registers:
            cell = frame.cells[len(code.cells) + code.free.index("__class__")]
            cls = machine.at(cell).attrs.get("value", UNBOUND)
            receiver = _first_argument(machine, frame)
            if cls is not UNBOUND and receiver is not UNBOUND:
                return join_all(_super_of(machine, cls, each) for each in options(receiver))
        if not frame.stub:
            break
    return machine.unknown(Cause.ERROR, "super() outside of a method")


def _first_argument(machine: Engine, frame: Frame) -> Value:
    """The first parameter of a function, also where an inner function shares it."""
    code = frame.code
    names = code.parameters.names
    if names and names[0] in code.cells:
        return machine.at(frame.cells[code.cells.index(names[0])]).attrs.get("value", UNBOUND)
    return frame.registers[0]


def _super_of(machine: Engine, after: Value, receiver: Value) -> Value:
    """`super(after, receiver)`: where `after` is one of several classes, those that the receiver has. Python refuses the others."""
    cls = machine.obj(receiver).cls if receiver.__class__ is Ref else receiver
    order: Arguments = cls.mro if cls.__class__ is Class else ()
    for other in members.classes_of(machine, receiver):
        order = (*order, *other.mro)
    meta = metaclass_of(machine, receiver)
    if receiver.__class__ is Class and meta.__class__ is Class:  # a method of a metaclass
        order = (*order, *meta.mro)
    fitting = [Super(each, receiver) for each in options(after) if each in order]
    if fitting:
        return join_all(fitting)
    open_ = [each for each in (*options(after), *order, cls) if each.__class__ in (Unknown, External)]
    if open_:  # what stands behind the class is not known
        return Unknown(reasons_of(open_[0]) or machine.unknown(Cause.CALL, name_of(open_[0])).reasons)
    return machine.unknown(Cause.ERROR, "super(): the object is not of that class")


def call_method(machine: Engine, value: Value, name: str, args: Arguments) -> Value:
    """value.name(*args), NONE where a value of unknown or builtin type has no such method."""
    method = attributes.load(machine, value, name)
    return call(machine, method, args, {})


_FEW_CALLEES: Final = 4
"""Of so many functions that may be meant, it is told which do not take the arguments; of more, only that none does. What gets them from a
table gives each its own."""


def call_function(machine: Engine, function: Function, args: Arguments, keywords: Keywords) -> Value:
    """A function of the program or of a model."""
    code = function.code
    try:
        registers = bind_arguments(machine, function, args, keywords)
    except BadCallError as error:
        keywords = {k: v for k, v in keywords.items() if k in code.parameters.names}
        missing = _missing_argument(machine, function, error)
        registers = bind_arguments(machine, function, args, {**keywords, ANY: missing})
    if machine.catchers and declared.may_raise(machine, function, registers):
        note(machine, LIBRARY)
    if function.effects:
        answer = declared.apply(machine, function, registers)
        if answer is not None:
            return answer
    if code.is_stub and declared.is_model(function):
        return declared.result(machine, function, registers)
    if code.is_generator or code.is_coroutine:
        return machine.make_generator(function, registers)
    return activation.invoke(machine, function, registers)


def _missing_argument(machine: Engine, function: Function, error: BadCallError) -> Value:
    """What a parameter holds where the arguments do not fit: what a decorator gives it, which may be called with others; else the program fails.

    What follows then is followed all the same: when the call is mended it is what runs.
    """
    note(machine)
    if assignment.is_replaced(machine, function):
        return machine.unknown(Cause.CALL, f"decorator of {function.code.qualname}")
    exact = not declared.is_model(function) or function.module.name.startswith(machine.library.facts.exact)
    message = (
        f"this call of {function.code.qualname} {'may raise' if machine.choosing else 'raises'} TypeError: {error}"
    )
    if exact and machine.choosing > _FEW_CALLEES:
        machine.refused.append(message)
    elif exact:
        machine.report("RW209", message)
    return machine.unknown(Cause.ERROR, str(error))


def wait_for(machine: Engine, value: Value) -> Value:
    """`await value`."""
    if value.__class__ is Choice:
        return each_apart(machine, value.options, lambda o: wait_for(machine, o))
    if value.__class__ is Ref:
        obj = machine.obj(value)
        if obj.kind == "generator":
            points = obj.payload.points if isinstance(obj.payload, Suspension) else ()
            if any(p.function.code.is_generator for p in points):  # it yields to who runs the coroutine
                machine.waits(suspended=True)
            return machine.run_out(value)[1]
        machine.waits(suspended=True)
        for name in ("__await__", "result"):
            method = attributes.method(machine, value, name) if obj.kind == "instance" else None
            if method is not None:
                result = call(machine, method, (), {})
                return wait_for(machine, result) if name == "__await__" and result != value else result
    else:
        machine.waits(suspended=True)
    return value if value.__class__ is Unknown else machine.unknown(Cause.CALL, "await")
