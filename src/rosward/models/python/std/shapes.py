# SPDX-License-Identifier: Apache-2.0
"""The shape of an annotation, for libraries that convert what they are given to it (stubs/_fields.pyi).

    depth: int                        ('class', int)
    names: Annotated[list[str], F]    ('with', ('list', ('class', str)), (F,))
    mode: Mode | None                 ('union', ('class', Mode), ('none',))
    side: Literal['l', 'r']           ('literal', 'l', 'r')
    anything: Any                     ('any',)
    what is not known                 ('other',)

Annotations are kept as text, so names are looked up in the module in which the class is written.
"""

from __future__ import annotations

import ast
from typing import Final

from rosward.domain.choice import join_all, lift, lift2, options
from rosward.domain.compound import BoundMethod, Descriptor, Native, Tuple
from rosward.domain.values import NONE, UNBOUND, Class, Const, Function, ModuleValue, Unknown, Value
from rosward.models.native import Machine, NativeCall, NativeFunction
from rosward.models.python.std.annotations import WRITTEN_IN, alias_of, named, parsed
from rosward.models.python.std.records import annotations_of
from rosward.models.python.std.support import class_obj

_ANY: Final = Tuple((Const("any"),))
_OTHER: Final = Tuple((Const("other"),))
_FREE: Final = frozenset(
    ("Any", "object", "List", "Set", "Dict", "Tuple", "Sequence", "Mapping", "Iterable", "Callable", "Type")
)
"""Forms that change nothing of a value."""
_DEEPEST: Final = 20
_CONTAINERS: Final = {
    **dict.fromkeys(("list", "List", "Sequence", "MutableSequence", "Iterable", "Collection"), "list"),
    **dict.fromkeys(("set", "Set", "frozenset", "FrozenSet", "AbstractSet"), "set"),
    **dict.fromkeys(("dict", "Dict", "Mapping", "MutableMapping"), "dict"),
    **dict.fromkeys(("tuple", "Tuple"), "tuple"),
}


def _of(kind: str, *parts: Value) -> Tuple:
    return Tuple((Const(kind), *parts))


def _last(tree: ast.expr) -> str:
    return ast.unparse(tree).rpartition(".")[2]


def _shape(machine: Machine, module: ModuleValue, tree: ast.expr, depth: int) -> Tuple:
    def inner(each: ast.expr) -> Tuple:
        return _shape(machine, module, each, depth + 1)

    if depth > _DEEPEST:
        return _OTHER
    if isinstance(tree, ast.Constant) and isinstance(tree.value, str):
        again = parsed(tree.value)
        return _OTHER if isinstance(again, ast.Constant) else inner(again)
    if isinstance(tree, ast.Constant):
        return _of("none") if tree.value is None else _OTHER
    if isinstance(tree, ast.BinOp) and isinstance(tree.op, ast.BitOr):
        return _of("union", inner(tree.left), inner(tree.right))
    if isinstance(tree, ast.Subscript):
        form, arguments = _last(tree.value), tree.slice.elts if isinstance(tree.slice, ast.Tuple) else [tree.slice]
        if form == "Optional":
            return _of("union", *map(inner, arguments), _of("none"))
        if form == "Union":
            return _of("union", *map(inner, arguments))
        if form in ("Final", "ClassVar", "InitVar"):
            return _of(form.lower(), *map(inner, arguments[:1]))
        if form == "Annotated" and arguments:
            extra = Tuple(tuple(_value(machine, module, each) for each in arguments[1:]))
            return _of("with", inner(arguments[0]), extra)
        if form in _CONTAINERS:
            kept = [a for a in arguments if not (isinstance(a, ast.Constant) and a.value is Ellipsis)]
            same = _CONTAINERS[form] == "tuple" and len(kept) < len(arguments)
            return _of("list of tuple" if same else _CONTAINERS[form], *map(inner, kept))
        if form == "Literal":
            return _of("literal", *(_value(machine, module, each) for each in arguments))
        return _ANY if form in _FREE else inner(tree.value)  # Generic[int]
    if isinstance(tree, (ast.Name, ast.Attribute)):
        last = _last(tree)
        if last in ("ClassVar", "InitVar", "KW_ONLY"):
            return _of(last.lower())
        if last in _FREE:
            return _ANY
        found = named(machine, module, tree)
        if len(found) == 1:
            return _class(machine, found[0])
    return _OTHER


def _class(machine: Machine, value: Value) -> Tuple:
    alias = alias_of(machine, value)
    if alias is not None:
        return _of("with", _class(machine, alias[0]), alias[1])
    return _of("class", value) if isinstance(value, (Class, Native)) else _OTHER


def _value(machine: Machine, module: ModuleValue, tree: ast.expr) -> Value:
    """What stands beside a type in `Annotated`: a literal, a name, or a call of such."""
    try:
        found = ast.literal_eval(tree)
    except (ValueError, TypeError, SyntaxError, MemoryError, RecursionError):
        pass
    else:
        return Const(found) if isinstance(found, (str, int, float, bool, bytes)) or found is None else _OTHER
    if isinstance(tree, (ast.Name, ast.Attribute)):
        return named(machine, module, tree)[0]
    if (
        isinstance(tree, ast.Call)
        and all(k.arg for k in tree.keywords)
        and isinstance(tree.func, (ast.Name, ast.Attribute))
    ):
        arguments = tuple(_value(machine, module, a) for a in tree.args)
        keywords = {str(k.arg): _value(machine, module, k.value) for k in tree.keywords}
        return machine.call(named(machine, module, tree.func)[0], arguments, keywords)
    return named(machine, module, ast.Constant(Ellipsis))[0]


def _shapes(call: NativeCall) -> Value:
    """_fields.shapes(cls): the shape of each annotation in the body of this class, by name, in order."""
    machine = call.machine

    def one(cls: Value) -> Value:
        if not isinstance(cls, Class) or cls.stub:
            return machine.new_dict({})
        module = machine.obj(class_obj(cls)).attrs.get(WRITTEN_IN)
        texts = annotations_of(machine, cls)
        if not isinstance(module, ModuleValue):
            return machine.new_dict({Const(name): _OTHER for name in texts})
        return machine.new_dict({Const(n): _shape(machine, module, parsed(t), 0) for n, t in texts.items()})

    return lift(one, call.args[0])


def _bound(call: NativeCall) -> Value:
    """_fields.bound(function, cls, instance): what a name of a class body gives on an object, or on the class where that is None."""
    function, cls, instance = call.exactly(3)

    def one(option: Value, owner: Value) -> Value:
        if isinstance(option, Descriptor):
            if option.kind == "staticmethod":
                return option.getter
            if option.kind == "classmethod":
                return BoundMethod(cls, option.getter)
            return call.machine.call(option.getter, (owner,))
        if isinstance(option, Function):
            return BoundMethod(cls if owner == NONE else owner, option)
        return option

    return lift2(one, function, instance)


def _room(call: NativeCall) -> Value:
    """_fields.room(function): how many arguments a function takes by position, without the one it is bound to; -1: any number."""

    def one(function: Value) -> Value:
        bound = 0
        while isinstance(function, (BoundMethod, Descriptor)):
            bound += isinstance(function, BoundMethod)
            function = function.function if isinstance(function, BoundMethod) else function.getter
        if not isinstance(function, Function):
            return Const(1)
        given = function.code.parameters
        return Const(-1 if given.vararg is not None else len(given.positional) - bound)

    return lift(one, call.args[0])


def _names(call: NativeCall) -> Value:
    """_fields.body(cls): what stands in the body of a class, by name, as it is kept."""
    machine = call.machine

    def one(cls: Value) -> Value:
        if not isinstance(cls, Class) or cls.stub:
            return machine.new_dict({})
        attrs = machine.obj(class_obj(cls)).attrs
        return machine.new_dict(
            {Const(n): v for n, v in attrs.items() if v is not UNBOUND and not n.startswith("_rosward")}
        )

    return lift(one, call.args[0])


def _opaque(call: NativeCall) -> Value:
    """_fields.opaque(value): whether nothing is known of a value."""
    return lift(lambda option: Const(isinstance(option, Unknown)), call.args[0])


def _known(call: NativeCall) -> Value:
    """_fields.known(value): what is known of a value that may be another one."""
    return _those(call.args[0], unknown=False)


def _unknown_of(call: NativeCall) -> Value:
    """_fields.unknown_of(value): what is not known of it."""
    return _those(call.args[0], unknown=True)


def _those(value: Value, *, unknown: bool) -> Value:
    """The alternatives of a value that are known, or those that are not; all where there are none."""
    found = [option for option in options(value) if isinstance(option, Unknown) is unknown]
    return join_all(found) if found else value


NATIVES: Final[dict[str, NativeFunction]] = {
    "_fields.shapes": _shapes,
    "_fields.bound": _bound,
    "_fields.room": _room,
    "_fields.body": _names,
    "_fields.opaque": _opaque,
    "_fields.known": _known,
    "_fields.unknown_of": _unknown_of,
}
