# SPDX-License-Identifier: Apache-2.0
"""Builtins and models in code: containers keep their elements apart; all others only compute.

names.append(x)     x is among the elements, and the number of elements depends on what decides that control is here
state.get('a', 0)   what stands under 'a', or the default
sorted(values)      a new list of the same elements
int(text)           whatever the text depends on
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.domain.compound import BoundMethod, External, Native
from rosward.domain.values import Value
from rosward.effects.flows import Source
from rosward.engine.arguments import ANY, LOOSE, ORDER
from rosward.engine.running.seen import refs_of
from rosward.flow import implicit, library
from rosward.flow.marks import CANCELLED, FUNCTIONS, HANDLED, NOTHING, Mark, decided, demoted, of_library
from rosward.flow.native import containers, frames, parameters, partials
from rosward.flow.native.constructed import attributes, fill, initialise
from rosward.flow.native.native_call import NativeCall
from rosward.flow.native.waited import select
from rosward.flow.outside import out
from rosward.flow.reading import arising, elements, of_classes, owners_of
from rosward.flow.site import callees
from rosward.flow.stored.content import Content
from rosward.ir import ops
from rosward.ir.ops import Call
from rosward.models.interfaces import message_name

if TYPE_CHECKING:
    from collections.abc import Iterator

    from rosward.engine.running.seen import Performed, Seen
    from rosward.flow.body import Body
    from rosward.flow.walker import Walker


def apply(walker: Walker, op: ops.Call, body: Body, seen: Seen, callee: Value, marks: list[Mark]) -> Mark:
    """What a native, or a function of a library, gives and does."""
    function = body.registers[op.func]
    if isinstance(callee, External):
        if message_name(callee.name) is not None:
            return _message(NativeCall(walker, op, body, seen, callee.name, marks, op.arguments))
        marks = implicit.under_given(walker, callee.name, marks, unseen=not walker.shape.is_native(callee.name))
        if walker.shape.is_native(callee.name):
            return _native(NativeCall(walker, op, body, seen, callee.name, marks, op.arguments))
        named = Mark(function.mask, frozenset((of_library(callee.name),)))
        return library.unknown(walker, op, body, named, marks, op.arguments)
    if isinstance(callee, BoundMethod):
        assert isinstance(callee.function, Native)
        name = callee.function.name
        receiver, *marks = implicit.under_given(walker, name, (_receiver(walker, seen, callee, function), *marks))
        return _native(NativeCall(walker, op, body, seen, name, [receiver, *marks], op.arguments, receiver))
    assert isinstance(callee, Native)
    marks = implicit.under_given(walker, callee.name, marks)
    return _native(NativeCall(walker, op, body, seen, callee.name, marks, op.arguments))


def perform(
    walker: Walker, op: ops.Op, body: Body, seen: Seen, native: Performed, marks: list[Mark], named: dict[str, Mark]
) -> Mark:
    """The same for one that the operation does not call as it is written, and is given this."""
    called = getattr(native.callee, "name", "")
    is_known = isinstance(native.callee, (Native, External)) and walker.shape.is_native(called)
    all_marks = implicit.under_given(walker, called, (*marks, *named.values()), unseen=not is_known)
    arguments = [ops.Argument("positional", ops.NO_REGISTER)] * len(marks)
    arguments += [ops.Argument("star" if n in (LOOSE, ORDER, ANY) else "keyword", ops.NO_REGISTER, n) for n in named]
    if not isinstance(native.callee, (Native, External)):
        return library.unknown(walker, op, body, all_marks[0], all_marks[1:], arguments[1:])
    name = native.callee.name
    call = NativeCall(walker, op, body, seen, name, all_marks, arguments, keys=native.keys, within=not native.written)
    if isinstance(native.callee, External):
        if message_name(name) is not None:
            return _message(call)
        if not walker.shape.is_native(name):
            named_mark = Mark(0, frozenset((of_library(name),)))
            return library.unknown(walker, op, body, named_mark, all_marks, arguments)
    return _native(call)


def _receiver(walker: Walker, seen: Seen, callee: BoundMethod, function: Mark) -> Mark:
    """What a method is bound to: one of several objects, where it was seen to be bound to several."""
    roots = {r for f in seen.functions for r in receivers_of(f, callee.function)}
    roots.update(refs_of(callee.receiver))
    return Mark(function.mask, frozenset(map(walker.shape.owner, roots)) | owners_of(function))


def receivers_of(value: Value, function: Value) -> Iterator[int]:
    """The objects to which a method is bound, also one in a partial function."""
    for callee in callees((value,)):
        if isinstance(callee, BoundMethod) and callee.function == function:
            yield from refs_of(callee.receiver)


def _message(call: NativeCall) -> Mark:
    """A new message, or part of a service or action, with the fields that are given."""
    slots: dict[object, Mark] = {}
    rest = NOTHING
    for argument, mark in call.given():
        written = mark.under(call.pc)
        if argument.kind == "keyword":
            slots[argument.name] = written
        else:
            rest = rest.joined(elements(call.walker, written))
    return call.new(Content(0, rest, call.pc, slots))


def _native(call: NativeCall) -> Mark:
    name = call.name.removeprefix("builtins.")
    done = _KNOWN.get(name)
    if done is None:
        kind, _, method = name.rpartition(".")
        if kind in containers.CONTAINERS:
            done = _METHODS.get(method) or (None if method in containers.READING else containers.change)
    mask = call.pc
    for mark in call.marks:
        mask |= call.walker.memory.deep(mark)
    given = library.perform(call.walker, call.name.removeprefix("builtins."), mask, call.pc)
    if done is not None:
        return done(call).under(given)
    if name in library.OPENING:  # what is done to the file later is told by its name
        library.may_be_missing(call.walker)
        return Mark(mask | given, frozenset((call.walker.shape.made(call.body.activation, call.op.number, name),)))
    return call.computed(mask | given)


def by_name(walker: Walker, op: ops.Op, body: Body, seen: Seen, name: str, marks: list[Mark]) -> Mark | None:
    """What a function does that a model only declares, where more is known of it than that."""
    done = _KNOWN.get(name)
    if done is None or not isinstance(op, Call):
        return None
    return done(NativeCall(walker, op, body, seen, name, marks))


def _variables(call: NativeCall) -> Mark:
    """The attributes of an object; without one, the variables of the function that runs, as they are now."""
    if call.marks or call.within:
        return _pass(call)
    found = frames.variables(call.walker, call.body)
    owners = frozenset(map(call.walker.shape.owner, call.seen.refs))
    return call.new(Content(0, found, call.pc)) if owners == frozenset(call.seen.refs) else Mark(call.pc, owners)


def _get_attribute(call: NativeCall) -> Mark:
    memory, owner = call.walker.memory, call.mark(0)
    key = call.key(1)
    roots = owner.roots or frozenset((FUNCTIONS,))
    found = memory.read_all(roots) if not isinstance(key, str) else memory.read(roots, key)
    if not isinstance(key, str) and call.mark(1).mask:
        out(call.walker, "method", call.mark(1).mask)
        if any(isinstance(root, int) for root in owner.roots) and call.seen.reasons and not call.seen.refs:
            call.walker.lost = True  # any method may be called
    return found.joined(call.mark(2)).under(call.pc | owner.mask | call.mark(1).mask)


def _set_attribute(call: NativeCall) -> Mark:
    memory, owner = call.walker.memory, call.mark(0)
    key = call.key(1)
    written = call.mark(2).under(call.pc | call.mark(1).mask | demoted(owner.mask))
    if isinstance(key, str):
        memory.set_attribute(owner.roots, key, written)
    else:
        memory.write_any(owner.roots or frozenset((FUNCTIONS,)), written, call.pc)
    return Mark(call.pc)


def _object_attribute(call: NativeCall) -> Mark:
    """`object.__getattribute__(self, name)`, `object.__setattr__(self, name, value)` and the like, bound or not."""
    memory, owner, (name, *value) = call.walker.memory, call.mark(0), call.marks[1:] or [NOTHING]
    key = call.key(1)
    mask = call.pc | name.mask | demoted(owner.mask)
    if call.name.endswith("__getattribute__"):
        found = memory.read(owner.roots, key) if isinstance(key, str) else memory.read_all(owner.roots)
        return found.under(mask | owner.mask)
    written = value[0].under(mask) if value else Mark(mask)
    if isinstance(key, str):
        memory.write(owner.roots, key, written)
    else:
        memory.write_any(owner.roots, written, mask)
    return Mark(call.pc)


def _pass(call: NativeCall) -> Mark:
    found = NOTHING
    for mark in call.marks:
        found = found.joined(mark)
    return found.under(call.pc)


def _view(call: NativeCall) -> Mark:
    """`memoryview(raw)`: what is written to it stands in what it is a view of, in any attribute of an object."""
    given, view = call.mark(0), call.computed(0).roots
    call.walker.memory.write_any((r for r in given.roots if isinstance(r, int)), Mark(0, view))
    return Mark(call.pc | given.mask, given.roots | view)


def _nothing(call: NativeCall) -> Mark:
    return Mark(call.pc)


def _parameter(call: NativeCall) -> Mark:
    """The value of a parameter: of which one, the interpretation says with the value, unless that is a list."""
    name = call.key(1)
    mask = call.pc | call.mark(1).mask | parameters.kept(call.walker, call.mark(0).roots, name)
    if not isinstance(name, str) or not arising(call.walker, call.seen):
        mask |= call.walker.sources.data(Source("parameter", name if isinstance(name, str) else "*"))
    return Mark(mask)


def _declare_parameter(call: NativeCall) -> Mark:
    """Its default is its value where nobody sets it."""
    _set_parameter(call)
    return _parameter(call)


def _set_parameter(call: NativeCall) -> Mark:
    """Declared, set or undeclared."""
    parameters.keep(call.walker, call.mark(0).roots, call.key(1), call.mark(2).under(call.mark(1).mask), call.pc)
    return Mark(call.pc)


def _has_parameter(call: NativeCall) -> Mark:
    return Mark(call.pc | call.mark(1).mask | parameters.declared(call.walker, call.mark(0).roots))


def _of_library(call: NativeCall) -> Mark:
    """`_rosward.unknown(…)`: what a library makes of all that it was given."""
    mask = call.pc | _given_to_library(call)
    if call.key(1) == "cancel request":
        call.walker.ask((CANCELLED,))
        mask = call.pc | call.walker.arrives_here("cancel") | call.walker.stopped.get(CANCELLED, 0)
    elif call.key(1) == "answer to a goal":
        mask = call.pc | call.walker.arrives_here("result")
    return call.computed(mask)


def _given_to_library(call: NativeCall) -> int:
    """All that the function of a library was given that runs here."""
    mask, nodes = 0, call.walker.shape.nodes
    for body in reversed(call.walker.bodies):
        if not body.activation.code.file.startswith("models:"):
            break
        for mark in dict.fromkeys((*body.arguments, *body.registers)):
            mask |= call.walker.memory.deep(Mark(mark.mask, mark.roots - nodes))
        mask |= implicit.given_by(call.walker, body.arguments, unseen=True)
    return mask


def _send_into(call: NativeCall) -> Mark:
    """`generator.send(value)`."""
    for activation in call.seen.callees:
        call.walker.memory.write_any([("sent", activation.code.key)], call.mark(1).under(call.pc))
    return Mark(call.pc | call.mark(0).mask)


def _throw_into(call: NativeCall) -> Mark:
    """`generator.throw(error)`, and `contextlib._end(generator, error)`."""
    for activation in call.seen.callees:
        for raised in call.marks[1:]:
            call.walker.memory.write_any([("thrown", activation.code.key)], raised.under(call.pc))
    return Mark(call.pc | call.mark(0).mask)


def _arrives(call: NativeCall) -> Mark:
    """`_rosward.message(type, kind)`: something that somebody sent arrives here, to the object whose method this is."""
    kind = str(call.key(1) or "message")
    mask = call.pc
    known = _ARRIVING.get(kind)
    if known is not None:
        mask |= call.walker.arrives_here(known)
    elif kind in _MADE:
        mask |= _given_to_library(call)
    for root in call.seen.refs:
        call.walker.memory.place(root, Content(base=mask))
    return Mark(mask if not call.seen.refs else call.pc, frozenset(call.seen.refs))


_MADE: Final = frozenset(("serialized message", "made from an array"))
"""What is no arrival, but made of what a library is given."""
_ARRIVING: Final = {
    "response": "response",
    "feedback": "feedback",
    "result": "result",
    "goal": "goal",
    "message": "topic",
}


def _identity(call: NativeCall) -> Mark:
    """Which object it is, or of which class."""
    mask = call.pc
    for mark in call.marks:
        mask |= mark.mask
    return Mark(mask)


def _exists(call: NativeCall) -> Mark:
    """Whether an attribute is there depends on what decides that it is written, not on what is written."""
    memory, owner, key = call.walker.memory, call.mark(0), call.key(1)
    found = memory.read(owner.roots, key) if isinstance(key, str) else memory.read_all(owner.roots)
    return Mark(_identity(call).mask | decided(found.mask))


def _type(call: NativeCall) -> Mark:
    """Of which class an object is; with three arguments, a new class with these attributes."""
    attributes(call.walker.memory, frozenset(call.seen.refs), call.mark(2), call.pc)
    return _identity(call)


def _format(call: NativeCall) -> Mark:
    """`'{0.x}'.format(a)`: a field may ask for an attribute, which the class of an object may have."""
    mask = call.pc | of_classes(call.walker, call.marks)
    for mark in call.marks:
        mask |= call.walker.memory.deep(mark)
    return call.computed(mask)


def _run_code(call: NativeCall) -> Mark:
    """Code that is known at run time only may do anything."""
    if call.name.endswith("exec") or call.seen.opaque:
        call.walker.lost = True
    mask = call.pc
    for mark in call.marks:
        mask |= call.walker.memory.deep(mark)
    return call.computed(mask)


def _everything(call: NativeCall) -> Mark:
    """Gives all objects that there are, or tells a function of everything that happens."""
    call.walker.lost = True
    return Mark(call.pc)


def _handled(call: NativeCall) -> Mark:
    """The exception that is being handled; which one that is, is not told apart."""
    found = call.walker.memory.of(HANDLED).whole
    return Mark(call.pc | call.walker.memory.deep(found), found.roots | frozenset(call.seen.refs))


_METHODS: Final[dict[str, containers.Handler]] = {
    **containers.METHODS,
    "send": _send_into,
    "throw": _throw_into,
    "close": _nothing,
}
_KNOWN: Final[dict[str, containers.Handler]] = {
    **containers.KNOWN,
    **dict.fromkeys(("isinstance", "issubclass", "id", "callable", "super", "object"), _identity),
    **dict.fromkeys(("exec", "eval"), _run_code),
    **dict.fromkeys(
        (
            "gc.get_objects",
            "gc.get_referrers",
            "sys.settrace",
            "sys.setprofile",
            "threading.settrace",
            "threading.setprofile",
        ),
        _everything,
    ),
    **dict.fromkeys(("sys._handled", "sys._uncaught", "threading._uncaught", "traceback.format_exc"), _handled),
    **dict.fromkeys(("str.format", "str.format_map"), _format),
    "type": _type,
    "hasattr": _exists,
    "getattr": _get_attribute,
    "setattr": _set_attribute,
    **dict.fromkeys(
        ("delattr", "object.__getattribute__", "object.__setattr__", "object.__delattr__"), _object_attribute
    ),
    **dict.fromkeys(("_rosward.either", "_rosward.default", "_rosward.awaited"), _pass),
    **dict.fromkeys(("vars", "locals"), _variables),
    **dict.fromkeys(
        (
            *("_rosward.schedule", "_rosward.ask", "_rosward.overridden", "_rosward.opaque", "_rosward.escape"),
            *("_rosward.fail_unless", "_rosward.spin", "_rosward.report", "_rosward.create", "_rosward.create_node"),
            *("_rosward.may_refuse", "_rosward.sender", "_rosward.node_name", "_rosward.node_namespace"),
            *("_rosward.node_fqn", "_rosward.resolve_name", "_rosward.declare_own", "_rosward.needs_parameter"),
            *("_rosward.is_unset", "_rosward.send", "queue._alone"),
        ),
        _nothing,
    ),
    "_rosward.unknown": _of_library,
    "_rosward.declare_parameter": _declare_parameter,
    "_rosward.parameter": _parameter,
    **dict.fromkeys(("_rosward.set_parameter", "_rosward.undeclare_parameter"), _set_parameter),
    **dict.fromkeys(("_rosward.is_given", "rclpy.node.Node.has_parameter"), _has_parameter),
    "functools.partial": partials.make,
    "inspect.currentframe": frames.current,
    "inspect.stack": frames.stack,
    "sys._getframe": frames.any_of,
    "memoryview": _view,
    "select.select": select,
    "collections._fill": fill,
    **dict.fromkeys(("dataclasses.init", "dataclasses.init_alone"), initialise),
    "contextlib._end": _throw_into,
    "_rosward.message": _arrives,
}
