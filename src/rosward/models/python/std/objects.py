# SPDX-License-Identifier: Apache-2.0
"""Copies of objects, values merged over a container, context managers made of generators.

b = copy.deepcopy(a)               a new list, dict or instance of the same content
with opened('x') as f: …           the generator function runs at the `with`; f is what it yields first
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from typing import Final

from rosward.domain.choice import join, lift, options
from rosward.domain.compound import BoundMethod, External, Native, Partial, Tuple, function_behind
from rosward.domain.heap import Obj
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, UNBOUND, Class, Const, Function, ModuleValue, Ref, Unknown, Value
from rosward.models.interfaces import is_known_interface
from rosward.models.message_fields import made_all
from rosward.models.native import NativeCall, NativeFunction
from rosward.models.python.contents import CONTENTS, contents
from rosward.models.python.plain import EXCEPTION_HINT
from rosward.models.python.std.support import class_obj, joined_elements, unknown_from

_COPIED: Final = frozenset({"list", "set", "dict", "instance"})
_MAX_DEPTH: Final = 40
_COPY_OF: Final = "copy of"


def _shallow(call: NativeCall) -> Value:
    def one(value: Value) -> Value:
        if not isinstance(value, Ref) or call.machine.obj(value).kind not in _COPIED:
            return value
        hook = _hook(call, value, "__copy__")
        if hook is not None:
            return call.machine.call(hook, (value,))
        made_all(call.machine, value)  # of a message, which makes what it holds when it is asked for
        made = _reduced(call, value, lambda part: part)
        return _again(call, value) if made is None else made

    return lift(one, call.args[0]) if call.args else NONE


_REDUCE: Final = ("__reduce_ex__", "__reduce__")
_KEPT: Final = 2
"""How many parts of what `__reduce__` gives are followed: what is called, its arguments, and the state."""


def _reduced(call: NativeCall, value: Ref, copied: Callable[[Value], Value]) -> Value | None:
    """A copy as the program's `__reduce__`, `__getstate__`, `__setstate__` make it; None where it has none of them."""
    machine = call.machine
    reduce = next((h for h in (_own_hook(call, value, name) for name in _REDUCE) if h is not None), None)
    getter, setter = _own_hook(call, value, "__getstate__"), _own_hook(call, value, "__setstate__")
    if reduce is None and getter is None and setter is None:
        return None
    state: Value = NONE
    if reduce is not None:
        given = machine.call(reduce, (value, Const(4)) if _own_hook(call, value, "__reduce_ex__") else (value,))
        if not isinstance(given, Tuple) or len(given.items) < _KEPT:
            return machine.unknown(Cause.CALL, "copy")
        arguments = machine.iterate(given.items[1])
        made = machine.call(given.items[0], tuple(copied(a) for a in arguments.known))
        state = given.items[_KEPT] if len(given.items) > _KEPT else NONE
    else:
        made = _placed(call, machine.obj(value).replace(many=False, attrs={}), value.address)
        state = machine.call(getter, (value,)) if getter is not None else machine.load_attr(value, "__dict__")
    if state == NONE or made is UNBOUND or state is UNBOUND:
        return made
    state = copied(state)
    restore = _own_hook(call, made, "__setstate__") if isinstance(made, Ref) else None
    if restore is not None:
        machine.call(restore, (made, state))
    else:
        machine.call(machine.load_attr(machine.load_attr(made, "__dict__"), "update"), (state,))
    return made


def _own_hook(call: NativeCall, value: Value, name: str) -> Value | None:
    """A special method that the program defines for an object."""
    cls = call.machine.obj(value).cls if isinstance(value, Ref) else None
    for base in cls.mro if isinstance(cls, Class) else ():
        if isinstance(base, Class) and not base.stub and name in (attrs := call.machine.obj(class_obj(base)).attrs):
            return attrs[name]
    return None


_MOST_APART: Final = 3
"""So many copies of one object, in the hands of one call that copies them once more, are told apart."""
_MOST_PLACED: Final = 100
"""So many objects that one call copies are told apart. Beyond, copies of copies are one object for each class: where what was copied is
put into what is copied next, they would grow in number for long."""


def _placed(
    call: NativeCall, obj: Obj, source: int, others: Counter[object] | None = None, *, apart: bool = True
) -> Ref:
    """A copy of the object at an address. A copy of a copy stands where one of the first object would stand:

    self.history.append(deepcopy(self.state)); self.state = deepcopy(self.history[-1])      else each round would make further ones, for ever

    `others`: of what the same call has made copies, and how many.
    """
    first: dict[object, object] = call.machine.log.remembered
    origin = first.get((_COPY_OF, source), source)
    before = 0 if others is None else others[origin]
    site: object = (origin, min(before, _MOST_APART)) if before else origin
    if not apart and origin != source:
        site = _COPY_OF
    ref = call.machine.allocate(obj, site, counted=False)
    if others is not None:
        others[origin] += 1
    first.setdefault((_COPY_OF, ref.address), origin)
    return ref


def _again(call: NativeCall, ref: Ref, others: Counter[object] | None = None, *, apart: bool = True) -> Ref:
    made = _placed(call, call.machine.obj(ref).replace(many=False), ref.address, others, apart=apart)
    held = contents(call.machine, ref)
    if isinstance(held, Ref):
        copied = call.machine.allocate(
            call.machine.obj(held).replace(many=False), ("contents", made.address), counted=False
        )
        call.machine.update(made, call.machine.obj(made).with_attr(CONTENTS, copied))
    return made


def _hook(call: NativeCall, ref: Ref, name: str) -> Value | None:
    cls = call.machine.obj(ref).cls
    for base in cls.mro if isinstance(cls, Class) else ():
        if isinstance(base, Class) and name in (attrs := call.machine.obj(class_obj(base)).attrs):
            return attrs[name]
    return None


_HOLDING: Final = frozenset((Ref, Tuple))
"""Values of which a copy may be another one."""


def _deep(call: NativeCall) -> Value:
    """copy.deepcopy: what is reached more than once is copied once."""
    machine = call.machine
    made: dict[int, Ref] = {}
    others: Counter[object] = Counter()

    def copied(value: Value, depth: int) -> Value:
        if all(option.__class__ not in _HOLDING for option in options(value)):
            return value  # most of what is copied
        return lift(lambda option: one(option, depth), value)

    def one(value: Value, depth: int) -> Value:
        if isinstance(value, Tuple):
            return Tuple(tuple(copied(v, depth + 1) for v in value.items))
        if not isinstance(value, Ref) or depth > _MAX_DEPTH:
            return value
        if value.address in made:
            return made[value.address]
        obj = machine.obj(value)
        if obj.kind not in _COPIED:
            return value
        hook = _hook(call, value, "__deepcopy__")
        if hook is not None:
            return machine.call(hook, (value, machine.new_dict({})))
        reduced = _reduced(call, value, lambda part: copied(part, depth + 1)) if obj.kind == "instance" else None
        if reduced is not None:
            return reduced
        ref = made[value.address] = _again(call, value, others, apart=len(made) < _MOST_PLACED)
        machine.update(
            ref,
            machine.obj(ref).replace(
                attrs={k: copied(v, depth + 1) for k, v in obj.attrs.items()},
                items=None if obj.items is None else tuple(copied(v, depth + 1) for v in obj.items),
                rest=None if obj.rest is None else copied(obj.rest, depth + 1),
                ends=None if obj.ends is None else obj.ends.mapped(lambda v: copied(v, depth + 1)),
                entries={k: copied(v, depth + 1) for k, v in obj.entries.items()},
            ),
        )
        return ref

    return copied(call.args[0], 0) if call.args else NONE


def _begin(call: NativeCall) -> Value:
    """contextlib._begin(generator): runs it to its `yield`, gives what it yields."""
    return call.machine.next_of(call.args[0], "next", NONE)


_STOPPED: Final = Native("contextlib.stopped")


def _end(call: NativeCall) -> Value:
    """contextlib._end(generator, exception): runs it on from there. True where it swallows the exception; one that it raises goes outward.

    A generator that yields once more is a RuntimeError.
    """
    generator, exception = call.exactly(2)
    machine = call.machine
    answer = machine.next_of(generator, "next" if exception == NONE else "throw", exception, _STOPPED)
    if answer is UNBOUND:
        return answer
    stopped = _STOPPED in options(answer)
    if answer != _STOPPED and isinstance(generator, Ref) and not machine.obj(generator).many:
        message = "generator didn't stop" if exception == NONE else "generator didn't stop after throw()"
        if not stopped:
            machine.close_generator(generator)
        machine.throw(machine.call_native("builtins.RuntimeError", (Const(message),)))
        if not stopped:
            return UNBOUND
    return Const(exception != NONE)


def _or_any(call: NativeCall, known: Value) -> Value:
    """The exceptions that are known to be uncaught, or any other one (an interrupt, say)."""
    return join(known, call.machine.unknown(Cause.LIVE, "exception", EXCEPTION_HINT))


def _unwind(call: NativeCall) -> Value:
    """contextlib._unwind(exits, exception): what leaving a stack of context managers does, the last first."""
    exits, exception = call.exactly(2)
    items = call.machine.iterate(exits)
    if items.rest is None:
        return call.machine.unwind(items.known, exception)
    further = join(items.rest, NONE)
    return call.machine.unwind((*items.known, *(further,) * min(len(options(items.rest)), _MOST_EXITS)), exception)


_MOST_EXITS: Final = 3
"""So many of those are called one after another of which nobody knows how many there are."""


def _any_of(call: NativeCall) -> Value:
    """queue._any(items): one of them; what another thread may put, where there are none."""
    found = joined_elements(call, call.args[0])
    return call.machine.unknown(Cause.CALL, call.name.replace("._any", ".Queue.get")) if found is UNBOUND else found


def _alone(call: NativeCall) -> Value:
    """queue._alone(): whether nothing else runs that could put or take something, now or before."""
    return Const(not call.machine.schedule_book.entries and not call.machine.in_callback)


def _elements(call: NativeCall) -> Value:
    """numpy._elements(items, dtype): the items where an array keeps them as they are, else unknown ones."""
    machine = call.machine
    items, dtype = call.exactly(2)
    found = machine.iterate(items)
    kinds = {_kind(call, v) for v in found.known}
    if found.rest is None and len(kinds) == 1 and dtype == NONE and kinds <= {"int", "str", "list", "tuple"}:
        return machine.new_list(found.known)
    element = unknown_from(call, "", found.known)
    if found.rest is None:
        return machine.new_list([element] * len(found.known))
    return machine.new_list((), element)


def _kind(call: NativeCall, value: Value) -> str:
    if isinstance(value, Ref):
        return call.machine.obj(value).kind
    if isinstance(value, Tuple):
        return "tuple"
    return type(getattr(value, "value", None)).__name__


_KINDS: Final[dict[type, str]] = {
    Class: "class", Function: "function", BoundMethod: "method", ModuleValue: "module", Native: "builtin",
    Partial: "partial",
}  # fmt: skip


def _kind_of(call: NativeCall) -> Value:
    """inspect._kind_of(object): what the predicates of inspect tell apart."""

    def one(value: Value) -> Value:
        if isinstance(value, BoundMethod) and isinstance(value.function, Native):
            return Const("builtin")
        if is_known_interface(call.machine, value):
            return Const("class")
        if isinstance(value, (External, Unknown)):
            return unknown_from(call, "str", (value,))
        return Const(_KINDS.get(value.__class__, "value"))

    return lift(one, call.args[0]) if call.args else NONE


def _yields(call: NativeCall) -> Value:
    """inspect._yields(function): whether it is a generator function."""
    found = function_behind(call.args[0]) if call.args else None
    return _kinds_known(call) if found is None else Const(found.code.is_generator and not found.code.is_coroutine)


def _yields_awaited(call: NativeCall) -> Value:
    """inspect._yields_awaited(function): whether it is an asynchronous generator function."""
    found = function_behind(call.args[0]) if call.args else None
    return _kinds_known(call) if found is None else Const(found.code.is_generator and found.code.is_coroutine)


def _awaits(call: NativeCall) -> Value:
    """inspect._awaits(function): whether it is a coroutine function."""
    found = function_behind(call.args[0]) if call.args else None
    return _kinds_known(call) if found is None else Const(found.code.is_coroutine and not found.code.is_generator)


def _kinds_known(call: NativeCall) -> Value:
    return call.machine.unknown(Cause.CALL, call.name, "bool")


def _method(call: NativeCall) -> Value:
    """types.MethodType(function, object): the function, bound to the object."""
    return lift(lambda function: BoundMethod(call.args[1], function), call.args[0])


def _function(call: NativeCall) -> Value:
    """types.FunctionType(code, globals, …): the function that the code was asked of, with other defaults and other captured variables,
    and with a cell that nobody reads: by that it is another object, with attributes of its own."""
    code, names, name, defaults, closure = call.args
    of = _shown_by(call, code)
    cells = [_shown_by(call, c) for c in closure.items] if isinstance(closure, Tuple) else []
    known = defaults == NONE or isinstance(defaults, Tuple)
    if isinstance(of, Function) and known and all(isinstance(c, int) for c in cells) and _sees(call, names, of):
        given = defaults.items if isinstance(defaults, Tuple) else ()
        own = call.machine.allocate(Obj("cell", NONE), "types.FunctionType").address
        made = Function(of.code, of.module, (*(c for c in cells if isinstance(c, int)), own), given, (), of.effects)
        if name != NONE:
            call.machine.store_attr(made, "__name__", name)
        return made
    call.machine.report("RW203", "a function is made of code that is not known")
    return unknown_from(call, "types.FunctionType", call.args)


def _shown_by(call: NativeCall, value: Value) -> object:
    """Of which function a code object is, and which cell is shown by one of `__closure__`."""
    return call.machine.obj(value).payload if isinstance(value, Ref) else None


def _sees(call: NativeCall, names: Value, function: Function) -> bool:
    """Whether the global names that are given are those of the function's own module."""
    return _shown_by(call, names) == Ref(function.module.address)


NATIVES: Final[dict[str, NativeFunction]] = {
    "types._method": _method,
    "types._function": _function,
    "copy.copy": _shallow,
    "copy.deepcopy": _deep,
    "contextlib._begin": _begin,
    "contextlib._end": _end,
    "contextlib._unwind": _unwind,
    "sys._handled": lambda call: call.machine.handled,
    "sys._uncaught": lambda call: _or_any(call, call.machine.schedule_book.main_raised),
    "threading._uncaught": lambda call: _or_any(call, call.machine.schedule_book.threads_raised),
    "inspect._awaits": _awaits,
    "inspect._kind_of": _kind_of,
    "inspect._yields": _yields,
    "inspect._yields_awaited": _yields_awaited,
    "queue._any": _any_of,
    "queue._alone": _alone,
    "asyncio._any": _any_of,
    "numpy._elements": _elements,
}
