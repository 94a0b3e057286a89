# SPDX-License-Identifier: Apache-2.0
"""What do annotations say to a program that asks for them?

typing.get_type_hints(self.on_scan)['message']      LaserScan, by the names of the module in which it is written
Outputs.__annotations__                             the same for the variables of a class; texts with `from __future__ import annotations`
inspect.signature(self.on_scan).parameters          names, kinds, defaults and annotations
"""

from __future__ import annotations

import ast
from collections.abc import Iterable, Mapping
from typing import Final, TypeGuard

from rosward.domain.choice import options
from rosward.domain.compound import BoundMethod, Descriptor, Native, Tuple
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, UNBOUND, Class, Const, Function, ModuleValue, Ref, Value
from rosward.models.native import Machine, NativeCall, NativeFunction
from rosward.models.python.std.records import annotations_of
from rosward.models.python.std.support import class_obj

WRITTEN_IN: Final = "_rosward_module"
"""Where a class with annotations keeps the module in which it is written."""
_BUILTINS: Final = frozenset(
    {"int", "str", "float", "bool", "list", "dict", "set", "tuple", "bytes", "object", "complex", "frozenset"}
)


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
    """A part of `Annotated[…]`: a name, or a call of one with names (`Depends(get_node)`)."""
    if isinstance(tree, ast.Call) and not tree.keywords:
        return machine.call(
            _evaluated(machine, module, tree.func), tuple(_evaluated(machine, module, part) for part in tree.args)
        )
    found = named(machine, module, tree)
    return found[0] if len(found) == 1 else _unknown(machine)


def _meant(machine: Machine, module: ModuleValue, text: str, *, hints: bool) -> Value:
    """What an annotation is when the program runs; what `get_type_hints` makes of it."""
    if not hints and _is_text(machine, module):
        return Const(text)
    if not hints and text[:1] in "'\"":  # a text is evaluated for `get_type_hints` alone
        return Const(text.strip("'\""))
    tree = parsed(text)
    if hints and _is_annotated(tree):
        tree = tree.slice.elts[0] if isinstance(tree.slice, ast.Tuple) and tree.slice.elts else tree
    if not hints and isinstance(tree, ast.Constant) and tree.value is None:
        return NONE
    if not hints and _is_annotated(tree) and isinstance(tree.slice, ast.Tuple):
        items = Tuple(tuple(_evaluated(machine, module, part) for part in tree.slice.elts))
        return machine.call(
            machine.load_attr(machine.load_attr(machine.load_module("typing"), "Annotated"), "__getitem__"), (items,)
        )
    plain = isinstance(tree, (ast.Name, ast.Attribute)) or (isinstance(tree, ast.Constant) and tree.value is None)
    found = [unwrapped(machine, f) if hints else f for f in named(machine, module, tree)] if plain else []
    return found[0] if len(found) == 1 else _unknown(machine)


def _is_text(machine: Machine, module: ModuleValue) -> bool:
    """Whether annotations of a module stay texts."""
    feature = machine.obj(Ref(module.address)).attrs.get("annotations")
    return feature is not None and feature == machine.load_attr(machine.load_module("__future__"), "annotations")


def of_function(machine: Machine, function: Function, *, hints: bool = False) -> Mapping[str, Value]:
    """The annotations of a function."""
    texts = dict(function.code.annotations)
    if function.code.returns is not None:
        texts["return"] = function.code.returns
    return {name: _meant(machine, function.module, text, hints=hints) for name, text in texts.items()}


def of_class(machine: Machine, cls: Class, *, hints: bool = False) -> Mapping[str, Value] | None:
    """The annotations in the body of a class; None where the program set others."""
    attrs = machine.obj(class_obj(cls)).attrs
    module, table = attrs.get(WRITTEN_IN), attrs.get("__annotations__")
    if table is None:
        return {}
    texts = annotations_of(machine, cls)
    if not isinstance(module, ModuleValue) or not all(texts.values()):
        return None
    return {n: _meant(machine, module, text, hints=hints) for n, text in texts.items()}


def _hints(call: NativeCall) -> Value:
    """typing._hints(function or class): its annotations, those of base classes among them."""
    machine, value = call.machine, _function(call.args[0])
    found: dict[str, Value] = {}
    if isinstance(value, Function):
        found.update(of_function(machine, value, hints=True))
    elif isinstance(value, Class):
        for base in reversed(value.mro):
            own = of_class(machine, base, hints=True) if isinstance(base, Class) and not base.stub else {}
            if own is None or not isinstance(base, (Class, Native)):
                return machine.unknown(Cause.CALL, "typing.get_type_hints", "dict")
            found.update(own)
    else:
        return machine.unknown(Cause.CALL, "typing.get_type_hints", "dict")
    return machine.new_dict({Const(name): meant for name, meant in found.items()})


def _function(value: Value) -> Value:
    """The function behind a method."""
    while isinstance(value, (BoundMethod, Descriptor)):
        value = value.function if isinstance(value, BoundMethod) else value.getter
    return value


def _parameters(call: NativeCall) -> Value:
    """inspect._parameters(callable, empty, follow): name, kind, default and annotation of each parameter, and the annotation of the result."""
    machine, (value, empty, follow) = call.machine, call.exactly(3)
    bound, followed = 0, machine.truth(follow)
    for _ in range(_MOST_WRAPPED):
        kept = machine.function_record(value) if isinstance(value, Function) and followed else None
        if isinstance(value, (BoundMethod, Class)):
            bound += 1
            value = value.function if isinstance(value, BoundMethod) else machine.load_attr(value, "__init__")
        elif kept is not None and "__wrapped__" in kept.attrs:
            value = kept.attrs["__wrapped__"]
        else:
            break
    if not isinstance(value, Function) or followed is None:
        return machine.unknown(Cause.CALL, "inspect.signature")
    given, notes = value.code.parameters, of_function(machine, value)
    first = len(given.positional) - len(value.defaults)
    defaults = dict(zip(given.positional[first:], value.defaults, strict=False)) | dict(value.kwdefaults)
    kinds = [(n, 0 if number < given.posonly else 1) for number, n in enumerate(given.positional)][bound:]
    kinds += [(given.vararg, 2)] if given.vararg is not None else []
    kinds += [(n, 3) for n in given.kwonly]
    kinds += [(given.kwarg, 4)] if given.kwarg is not None else []
    rows = [Tuple((Const(n), Const(kind), defaults.get(n, empty), notes.get(n, empty))) for n, kind in kinds]
    return Tuple((_tuple(rows), notes.get("return", empty)))


def _call_with(call: NativeCall) -> Value:
    """inspect._call_with(function, args, names, values): function(*args, **dict(zip(names, values))), without a dict that others may share."""
    machine, (function, *given) = call.machine, call.exactly(4)
    args, names, values = (part.items if isinstance(part, Tuple) else None for part in given)
    if args is None or names is None or values is None or len(options(function)) > 1:  # several functions, say
        machine.escape((function,), call.name)
        return machine.unknown(Cause.CALL, call.name)
    words = (str(name.value) for name in names if isinstance(name, Const))
    return machine.call(function, args, dict(zip(words, values, strict=False)))


def _instances(call: NativeCall) -> Value:
    """inspect._instances(class, value, beside): the value, and what stands beside it, where it surely is of the class."""
    machine, (cls, value, beside) = call.machine, call.exactly(3)
    parts = (value, *(beside.items if isinstance(beside, Tuple) else ()))
    return Tuple(tuple(part for part in parts if machine.is_instance(part, cls)))


def _tuple(items: Iterable[Value]) -> Tuple:
    return Tuple(tuple(i for i in items if i is not UNBOUND))


NATIVES: Final[dict[str, NativeFunction]] = {
    "inspect._parameters": _parameters,
    "inspect._call_with": _call_with,
    "inspect._instances": _instances,
    "typing._hints": _hints,
}
