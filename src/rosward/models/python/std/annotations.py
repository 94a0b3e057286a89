# SPDX-License-Identifier: Apache-2.0
"""What do annotations say to a program that asks for them?

typing.get_type_hints(self.on_scan)['message']      LaserScan, by the names of the module in which it is written
Outputs.__annotations__                             the same for the variables of a class; texts with `from __future__ import annotations`
inspect.signature(self.on_scan).parameters          names, kinds, defaults and annotations
"""

from __future__ import annotations

import ast
from collections.abc import Iterable, Mapping
from typing import Final, NamedTuple, TypeGuard

from rosward.domain.choice import lift
from rosward.domain.compound import BoundMethod, Descriptor, Native, Partial, Tuple
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, UNBOUND, Class, Const, Function, ModuleValue, Ref, Value
from rosward.models.interfaces import is_known_interface
from rosward.models.native import Machine, NativeCall, NativeFunction
from rosward.models.python.std.records import annotations_of
from rosward.models.python.std.support import class_obj

WRITTEN_IN: Final = "_rosward_module"
"""Where a class with annotations keeps the module in which it is written."""
_BUILTINS: Final = frozenset(
    {"int", "str", "float", "bool", "list", "dict", "set", "tuple", "bytes", "object", "complex", "frozenset", "type"}
)


_WITHOUT_BRACKETS: Final = frozenset(
    f"builtins.{name}" for name in ("int", "str", "float", "bool", "bytes", "object", "complex", "NoneType")
)
_FORMS: Final = ("Literal", "Union", "Optional")
_MOST_WRAPPED: Final = 20
"""How many decorators around a function are looked through."""


def parsed(text: str) -> ast.expr:
    """An annotation, or what stands in one that is a string; `...` where it is no expression."""
    try:
        tree = ast.parse(text, mode="eval").body
        return (
            ast.parse(tree.value, mode="eval").body
            if isinstance(tree, ast.Constant) and isinstance(tree.value, str)
            else tree
        )
    except SyntaxError:
        return ast.Constant(Ellipsis)


def named(machine: Machine, module: ModuleValue, tree: ast.expr) -> list[Value]:
    """The classes that an annotation names; those of a union apart."""
    if isinstance(tree, ast.BinOp) and isinstance(tree.op, ast.BitOr):
        return [*named(machine, module, tree.left), *named(machine, module, tree.right)]
    if isinstance(tree, ast.Subscript) and ast.unparse(tree.value).rpartition(".")[2] in ("Union", "Optional"):
        inner = tree.slice.elts if isinstance(tree.slice, ast.Tuple) else [tree.slice]
        more = [Native("builtins.NoneType")] if ast.unparse(tree.value).endswith("Optional") else []
        return [*(c for e in inner for c in named(machine, module, e)), *more]
    if isinstance(tree, ast.Constant) and tree.value is None:
        return [Native("builtins.NoneType")]
    if isinstance(tree, ast.Name):
        there = machine.obj(Ref(module.address)).attrs.get(tree.id)
        if there is None and tree.id in _BUILTINS:
            return [Native(f"builtins.{tree.id}")]
        return [_unknown(machine) if there is None else machine.load_attr(module, tree.id)]
    if isinstance(tree, ast.Attribute):
        return [machine.load_attr(v, tree.attr) for v in named(machine, module, tree.value)]
    return [_unknown(machine)]


def alias_of(machine: Machine, value: Value) -> tuple[Value, Value] | None:
    """The type, and what stands beside it, of a name that was given `Annotated[…]`."""
    obj = machine.obj(value) if isinstance(value, Ref) else None
    if obj is None or not isinstance(obj.cls, Class) or not obj.cls.stub or obj.cls.name != "_Annotated":
        return None
    return obj.attrs["__origin__"], obj.attrs["__metadata__"]


def unwrapped(machine: Machine, value: Value) -> Value:
    """The type of an alias; any other value as it is."""
    found = alias_of(machine, value)
    return value if found is None else found[0]


def _unknown(machine: Machine) -> Value:
    return machine.unknown(Cause.OPERATION, "annotation")


def _is_annotated(tree: ast.expr) -> TypeGuard[ast.Subscript]:
    return isinstance(tree, ast.Subscript) and ast.unparse(tree.value).rpartition(".")[2] == "Annotated"


def _evaluated(machine: Machine, module: ModuleValue, tree: ast.expr) -> Value:
    """A part of `Annotated[…]`: a name, a constant, or a call with such (`Depends(get_node)`)."""
    if isinstance(tree, ast.Call) and not any(isinstance(a, ast.Starred) for a in tree.args):
        words = {word.arg: _evaluated(machine, module, word.value) for word in tree.keywords if word.arg is not None}
        if len(words) == len(tree.keywords):
            function = _evaluated(machine, module, tree.func)
            return machine.call(function, tuple(_evaluated(machine, module, part) for part in tree.args), words)
    if isinstance(tree, ast.Constant) and isinstance(tree.value, (str, int, float, bool, bytes)):
        return Const(tree.value)
    found = named(machine, module, tree)
    return found[0] if len(found) == 1 else _unknown(machine)


def _meant(
    machine: Machine, module: ModuleValue, text: str, *, hints: bool, read: bool = False, extras: bool = False
) -> Value:
    """What an annotation is when the program runs; what `get_type_hints` makes of it, with `extras`. `read` says that texts are evaluated."""
    if not hints and not read and _is_text(machine, module):
        return Const(text)
    if not hints and not read and text[:1] in "'\"":  # a text is evaluated for `get_type_hints` alone
        return Const(text.strip("'\""))
    tree = parsed(text)
    if hints and not extras and _is_annotated(tree):
        tree = tree.slice.elts[0] if isinstance(tree.slice, ast.Tuple) and tree.slice.elts else tree
    if not hints and isinstance(tree, ast.Constant) and tree.value is None:
        return NONE
    if (not hints or extras) and _is_annotated(tree) and isinstance(tree.slice, ast.Tuple):
        kind = parsed(ast.unparse(tree.slice.elts[0]))  # a text names a type that comes later
        items = Tuple(tuple(_evaluated(machine, module, part) for part in (kind, *tree.slice.elts[1:])))
        return _form(machine, "Annotated", items)
    if isinstance(tree, ast.Subscript) and (form := ast.unparse(tree.value).rpartition(".")[2]) in _FORMS:
        inner = tree.slice.elts if isinstance(tree.slice, ast.Tuple) else [tree.slice]
        parts = tuple(
            _evaluated(machine, module, part if form == "Literal" else parsed(ast.unparse(part))) for part in inner
        )
        return _form(machine, form, parts[0] if len(parts) == 1 else Tuple(parts))
    plain = isinstance(tree, (ast.Name, ast.Attribute)) or (isinstance(tree, ast.Constant) and tree.value is None)
    found = (
        [unwrapped(machine, f) if hints and not extras else f for f in named(machine, module, tree)] if plain else []
    )
    return found[0] if len(found) == 1 else _unknown(machine)


def _form(machine: Machine, name: str, item: Value) -> Value:
    """`Annotated[…]` and the like, as `typing` makes it."""
    return machine.call(
        machine.load_attr(machine.load_attr(machine.load_module("typing"), name), "__getitem__"), (item,)
    )


def _is_text(machine: Machine, module: ModuleValue) -> bool:
    """Whether annotations of a module stay texts."""
    feature = machine.obj(Ref(module.address)).attrs.get("annotations")
    return feature is not None and feature == machine.load_attr(machine.load_module("__future__"), "annotations")


def of_function(
    machine: Machine, function: Function, *, hints: bool = False, read: bool = False, extras: bool = False
) -> Mapping[str, Value]:
    """The annotations of a function."""
    texts = dict(function.code.annotations)
    if function.code.returns is not None:
        texts["return"] = function.code.returns
    return {n: _meant(machine, function.module, t, hints=hints, read=read, extras=extras) for n, t in texts.items()}


def of_class(machine: Machine, cls: Class, *, hints: bool = False, extras: bool = False) -> Mapping[str, Value] | None:
    """The annotations in the body of a class; None where the program set others."""
    attrs = machine.obj(class_obj(cls)).attrs
    module, table = attrs.get(WRITTEN_IN), attrs.get("__annotations__")
    if table is None:
        return {}
    texts = annotations_of(machine, cls)
    if not isinstance(module, ModuleValue) or not all(texts.values()):
        return None
    return {n: _meant(machine, module, text, hints=hints, extras=extras) for n, text in texts.items()}


def _hints(call: NativeCall) -> Value:
    """typing._hints(function or class, extras): its annotations, those of base classes among them."""
    machine, value, extras = call.machine, _function(call.args[0]), call.machine.truth(call.args[1])
    if extras is None:
        return machine.unknown(Cause.CALL, "typing.get_type_hints", "dict")
    found: dict[str, Value] = {}
    if isinstance(value, Function):
        found.update(of_function(machine, value, hints=True, extras=extras))
    elif isinstance(value, Class):
        for base in reversed(value.mro):
            own = (
                of_class(machine, base, hints=True, extras=extras) if isinstance(base, Class) and not base.stub else {}
            )
            if own is None or not isinstance(base, (Class, Native)):
                return machine.unknown(Cause.CALL, "typing.get_type_hints", "dict")
            found.update(own)
    else:
        return machine.unknown(Cause.CALL, "typing.get_type_hints", "dict")
    return machine.new_dict({Const(name): meant for name, meant in found.items()})


def _form_of(call: NativeCall) -> Value:
    """typing._form_of(type): the class of this model that keeps its brackets, 'bare' where it surely has none, else ''."""

    def one(value: Value) -> Value:
        cls = call.machine.obj(value).cls if isinstance(value, Ref) else None
        if isinstance(cls, Class) and cls.stub and cls.module == "typing":
            return Const(cls.name)
        bare = (isinstance(value, Native) and value.name in _WITHOUT_BRACKETS) or isinstance(value, Const)
        return Const("bare" if bare or is_known_interface(call.machine, value) else "")

    return lift(one, call.args[0])


def _function(value: Value) -> Value:
    """The function behind a method."""
    while isinstance(value, (BoundMethod, Descriptor)):
        value = value.function if isinstance(value, BoundMethod) else value.getter
    return value


def _parameters(call: NativeCall) -> Value:
    """inspect._parameters(callable, empty, follow, evaluate): name, kind, default and annotation of each parameter, and that of the result."""
    machine, (value, empty, follow, evaluate) = call.machine, call.exactly(4)
    followed = machine.truth(follow)
    found = None if followed is None else _signature(machine, value, empty, followed, machine.truth(evaluate) is True)
    if found is None:
        return machine.unknown(Cause.CALL, "inspect.signature")
    return Tuple((_tuple(Tuple((Const(r.name), Const(r.kind), *r[2:])) for r in found[0]), found[1]))


class _Row(NamedTuple):
    """A parameter, as `inspect` tells of it."""

    name: str
    kind: int
    default: Value
    annotation: Value


def _signature(
    machine: Machine, value: Value, empty: Value, follow: bool, read: bool
) -> tuple[list[_Row], Value] | None:
    """The parameters of something that is called, and the annotation of the result; None where they are not known."""
    bound, given_words = 0, dict[str, Value]()
    for _ in range(_MOST_WRAPPED):
        kept = machine.function_record(value) if isinstance(value, Function) else None
        if isinstance(value, Ref):
            kept = machine.obj(value)
        if isinstance(value, (BoundMethod, Class)):
            bound += 1
            value = value.function if isinstance(value, BoundMethod) else _maker(machine, value)
            if value == Native("builtins.object"):
                return [], empty
        elif isinstance(value, Partial):
            bound += len(value.arguments)
            given_words = dict(value.keywords) | given_words
            value = value.function
        elif follow and kept is not None and "__wrapped__" in kept.attrs:
            value = kept.attrs["__wrapped__"]
        elif isinstance(value, Ref) and isinstance(machine.obj(value).cls, Class):
            value = machine.load_attr(value, "__call__")
        else:
            break
    if not isinstance(value, Function):
        return None
    given, notes = value.code.parameters, of_function(machine, value, read=read)
    first = len(given.positional) - len(value.defaults)
    defaults = dict(zip(given.positional[first:], value.defaults, strict=False)) | dict(value.kwdefaults) | given_words
    kinds = [(n, 0 if number < given.posonly else 1) for number, n in enumerate(given.positional)][bound:]
    words = next((number for number, (n, _) in enumerate(kinds) if n in given_words), len(kinds))
    kinds[words:] = [(n, 3) for n, _ in kinds[words:]]  # behind what a partial gives by name, all are given so
    kinds += [(given.vararg, 2)] if given.vararg is not None else []
    kinds += [(n, 3) for n in given.kwonly]
    kinds += [(given.kwarg, 4)] if given.kwarg is not None else []
    return [_Row(n, k, defaults.get(n, empty), notes.get(n, empty)) for n, k in kinds], notes.get("return", empty)


def _maker(machine: Machine, cls: Class) -> Value:
    """What takes the arguments of a call of a class: `__call__` of its metaclass, else the first `__new__` or `__init__`; `object` if none does.

    A model that takes any number of them does not say what the library takes: `NamedTuple`.
    """
    metaclass = machine.call_native("builtins.type", (cls,))
    for of, names in ((metaclass, ("__call__",)), (cls, ("__new__", "__init__"))):
        for base in of.mro if isinstance(of, Class) else ():
            attrs = machine.obj(class_obj(base)).attrs if isinstance(base, Class) else {}
            if not isinstance(base, Class) and base != Native("builtins.object") and of is cls:
                return base
            found = next((attrs[name] for name in names if name in attrs), None)
            made = found.getter if isinstance(found, Descriptor) else found
            if isinstance(base, Class) and base.stub and isinstance(made, Function) and made.code.parameters.vararg:
                return machine.unknown(Cause.CALL, "inspect.signature")
            if made is not None:
                return made
    return Native("builtins.object")


def _filled(call: NativeCall) -> Value:
    """inspect._filled(function, fill): called with what `fill(function, default, annotation)` gives for each parameter."""
    machine, (function, fill) = call.machine, call.exactly(2)

    def filled(one: Value) -> Value:
        found = _signature(machine, one, NONE, follow=True, read=True)
        if found is None:
            machine.escape((one,), call.name)
            return machine.unknown(Cause.CALL, call.name)
        rows = [row for row in found[0] if row.kind not in (2, 4)]
        values = [machine.call(fill, (one, row.default, row.annotation)) for row in rows]
        if UNBOUND in values:
            return UNBOUND
        given = [value for row, value in zip(rows, values, strict=True) if row.kind < 2]
        return machine.call(one, given, {r.name: v for r, v in zip(rows, values, strict=True) if r.kind == 3})

    return lift(filled, function)


def _instance(call: NativeCall) -> Value:
    """inspect._instance(class, value, beside): the value, or what stands beside it, that surely is of the class; None where nothing is."""
    machine, (cls, value, beside) = call.machine, call.exactly(3)
    parts = (value, *(beside.items if isinstance(beside, Tuple) else ()))
    return next((part for part in parts if machine.is_instance(part, cls)), NONE)


def _tuple(items: Iterable[Value]) -> Tuple:
    return Tuple(tuple(i for i in items if i is not UNBOUND))


NATIVES: Final[dict[str, NativeFunction]] = {
    "inspect._parameters": _parameters,
    "inspect._filled": _filled,
    "inspect._instance": _instance,
    "typing._hints": _hints,
    "typing._form_of": _form_of,
}
