# SPDX-License-Identifier: Apache-2.0
"""May Python itself raise an exception in an operation, for the operands that it has?

self.topic = 'a'          no: an object of a class of the program, without properties and slots
self.limit / count        yes, where count is not known
check(self)               what check does says so itself, operation by operation

The answer is a level (see `catcher.py`), 0 where it surely does not fail. What fails for sure, or for some alternatives, is told by the model
of the operation; a call of code that is not known tells it itself.
"""

from __future__ import annotations

import builtins
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Final

from rosward.domain.choice import is_text
from rosward.domain.compound import BoundMethod, External, Native, Partial, TooManyPartsError, Tuple
from rosward.domain.heap import KIND
from rosward.domain.values import NONE, TRUE, UNBOUND, Choice, Class, Const, Function, ModuleValue, Ref, Text, Value
from rosward.engine.python import members
from rosward.engine.running.catcher import LIBRARY, OPERATION
from rosward.engine.throwing import note
from rosward.ir import ops
from rosward.models.python.exceptions import member_of

if TYPE_CHECKING:
    from rosward.engine.machine import Engine
    from rosward.engine.running.frame import Frame

NEVER: Final = frozenset(
    {
        ops.Const,
        ops.Move,
        ops.StoreGlobal,
        ops.StoreCell,
        ops.StoreName,
        ops.MakeFunction,
        ops.MakeClass,
        ops.Build,
        ops.NewCell,
        ops.Assume,
        ops.Yield,  # notes itself
        ops.Return,
        ops.Raise,
        ops.Break,
        ops.Continue,
        ops.If,
        ops.While,
        ops.Try,
        ops.With,
        ops.Import,
    }
)
"""Operations that never fail, or tell it themselves."""
_PLAIN: Final = (Const, Text, Tuple, Ref, Class, Native, Function, BoundMethod, Partial)
_SAFE_BUILTINS: Final = frozenset([
    "print", "len", "str", "repr", "bool", "isinstance", "issubclass", "callable", "type", "id", "list",
    "tuple", "dict", "set", "frozenset", "range", "enumerate", "zip", "super", "object", "hasattr", "sorted",
    "reversed", "map", "filter", "vars", "dir", "locals", "globals", "property", "staticmethod", "classmethod",
])  # fmt: skip
_NUMBERS: Final = frozenset([
    "int", "float", "complex", "bool", "bytes", "abs", "min", "max", "sum", "round", "chr", "ord", "hex", "oct",
    "bin", "divmod", "pow", "hash",
])  # fmt: skip
_WITH_EXCEPTIONS: Final = frozenset(
    {
        "copy",
        "csv",
        "getopt",
        "io",
        "json",
        "locale",
        "pexpect",
        "pkg_resources",
        "simplejson",
        "socket",
        "tomllib",
        "yaml",
    }
)
"""Modules with exceptions of their own, of which functions are known that no stub declares."""
_DIVIDING: Final = frozenset({"/", "//", "%"})
_EVALUATED: Final = frozenset({"", "builtins", "str", "int", "float", "bytes", "list", "dict", "set", "tuple"})
_SAFE_TYPES: Final = frozenset({"str", "list", "dict", "set", "tuple", "object", "BaseException", "BaseExceptionGroup"})
_UNSAFE_METHODS: Final = frozenset({"pop", "popitem", "remove", "index", "format", "format_map", "encode", "update"})
_SAFE_INTRINSICS: Final = frozenset(
    [
        "slice",
        "append",
        "set_add",
        "dict_set",
        "annotate",
        "is_sequence",
        "is_mapping",
        "length_is",
        "length_at_least",
        "match_args",
        "exception",
        "doc",
        "isinstance",
        "hasattr",
    ]
)


def run_noting(machine: Engine, block: ops.Block, frame: Frame) -> bool:
    """Interpret a block inside a try: from each operation that may fail the state may reach the handlers."""
    table = machine.language.table
    for op in block:
        cls = op.__class__
        if cls not in NEVER:
            level = may_fail(machine, op, frame)
            if level:
                note(machine, level)
        try:
            if table[cls](machine, op, frame) is False:
                return False
        except TooManyPartsError:
            machine.give_up_value(op, frame)
    return True


def may_fail(machine: Engine, op: ops.Op, frame: Frame) -> int:
    """What Python itself may raise in an operation, before it is interpreted."""
    judge = _JUDGES.get(op.__class__)
    if judge is not None and not judge(machine, op, frame):
        return 0
    return LIBRARY if op.__class__ is ops.Call and _raises_its_own(frame.registers[op.func]) else OPERATION


def _raises_its_own(function: Value) -> bool:
    """Whether a call may raise an exception that its library defines: `json.loads`."""
    while function.__class__ in (BoundMethod, Partial):
        function = function.function
    if function.__class__ is Choice:
        return any(_raises_its_own(o) for o in function.options)
    return function.__class__ in (Native, External) and function.name.partition(".")[0] in _WITH_EXCEPTIONS


def _load_global(machine: Engine, op: ops.LoadGlobal, frame: Frame) -> bool:
    record = machine.at(frame.module.address)
    found = record.attrs.get(op.name, UNBOUND)
    return (found is UNBOUND or op.name in record.partial) and not hasattr(builtins, op.name)


def _load_cell(machine: Engine, op: ops.LoadCell, frame: Frame) -> bool:
    return not machine.at(frame.cells[op.cell]).surely_has("value")


def _load_attr(machine: Engine, op: ops.LoadAttr, frame: Frame) -> bool:
    return not _has(machine, frame.registers[op.obj], op.name)


def _has(machine: Engine, value: Value, name: str) -> bool:
    """Whether a value surely has an attribute."""
    if value.__class__ is Ref:
        obj = machine.part(value, name)
        if obj.kind != "instance":
            return True
        if not obj.many and obj.surely_has(name):
            return True
        return members.surely_has(machine, obj.cls, name) or member_of(machine, obj, name) is not None
    if value.__class__ is ModuleValue:
        return machine.at(value.address).surely_has(name)
    if value.__class__ is Class:
        return members.surely_has(machine, value, name) or name.startswith("__")
    if value.__class__ is Choice:
        return all(_has(machine, o, name) for o in value.options)
    if value.__class__ is Const:
        return hasattr(value.value, name)
    if value.__class__ is Function:
        kept = machine.function_record(value)
        return (kept is not None and kept.surely_has(name)) or hasattr(_has, name)
    return value.__class__ in (Text, Tuple, Native, BoundMethod) or value.__class__.__name__ == "Super"


def _store_attr(machine: Engine, op: ops.StoreAttr, frame: Frame) -> bool:
    target = frame.registers[op.obj]
    if op.narrowing or target.__class__ in (Class, ModuleValue, Function):
        return False
    if target.__class__ is not Ref:
        return True
    cls = machine.part(target, KIND).cls
    if cls.__class__ is not Class:
        return not members.is_builtin_exception(cls)
    return members.lookup(machine, cls, "__slots__") is not None or members.lookup(machine, cls, op.name) is not None


def _load_item(machine: Engine, op: ops.LoadItem, frame: Frame) -> bool:
    value, index = frame.registers[op.obj], frame.registers[op.index]
    if index.__class__ is not Const or not index.is_settled:
        return True
    if value.__class__ in (Tuple, Class) or (value.__class__ is Const and value.is_settled and is_text(value)):
        return False  # where it fails, the operation says so
    if value.__class__ is not Ref:
        return True
    obj = machine.obj(value)
    if obj.many:
        return True
    if obj.kind == "dict":
        return obj.rest is not None or index in obj.maybe
    return obj.kind != "list" or obj.items is None


def _store_item(machine: Engine, op: ops.StoreItem, frame: Frame) -> bool:
    value, index = frame.registers[op.obj], frame.registers[op.index]
    return not (value.__class__ is Ref and machine.obj(value).kind == "dict" and index.__class__ in (Const, Text))


def _delete(machine: Engine, op: ops.Delete, frame: Frame) -> bool:
    del machine
    return op.kind != "local" or frame.registers[op.obj] is UNBOUND


def _plain(*values: Value) -> bool:
    """Whether values are known ones, without alternatives."""
    return all(v.__class__ in (Const, Text, Tuple) for v in values)


def _binary(_machine: Engine, op: ops.Binary, frame: Frame) -> bool:
    left, right = frame.registers[op.left], frame.registers[op.right]
    if op.operator in _DIVIDING and right.__class__ is Const and not right.is_settled and not is_text(left):
        return True  # it may be zero
    return not _plain(left, right)


def _unary(_machine: Engine, op: ops.Unary, frame: Frame) -> bool:
    return op.operator != "not" and not _plain(frame.registers[op.src])


def _compare(_machine: Engine, op: ops.Compare, frame: Frame) -> bool:
    if op.operator in ("is", "is-not", "==", "!="):
        return False
    right = frame.registers[op.right]
    if op.operator in ("in", "not-in"):
        return right.__class__ not in (Tuple, Ref, Text) and not (right.__class__ is Const and right != NONE)
    return not _plain(frame.registers[op.left], right)


def _format(_machine: Engine, op: ops.Format, frame: Frame) -> bool:
    return any(
        not isinstance(part, str) and part[2] != ops.NO_REGISTER and not _plain(frame.registers[part[0]])
        for part in op.parts
    )


def _unpack(machine: Engine, op: ops.Unpack, frame: Frame) -> bool:
    value = frame.registers[op.src]
    if value.__class__ is Ref and machine.obj(value).kind == "list":
        items = machine.obj(value).items
        if items is None or len(items) != len(op.dsts) or op.star != ops.NO_REGISTER:
            return True
        # A text that is split and is another one may have other parts.
        return not all(i.is_settled for i in items if i.__class__ is Const)
    return not (value.__class__ is Tuple and len(value.items) == len(op.dsts) and op.star == ops.NO_REGISTER)


def _intrinsic(_machine: Engine, op: ops.Intrinsic, frame: Frame) -> bool:
    if op.name == "bound":
        return frame.registers[op.arguments[0]] != TRUE
    return op.name not in _SAFE_INTRINSICS


def _for_each(machine: Engine, op: ops.ForEach, frame: Frame) -> bool:
    value = frame.registers[op.iterable]
    if value.__class__ is Ref:
        return machine.obj(value).kind not in ("list", "set", "dict", "generator")
    return value.__class__ is not Tuple and not _plain(value) and value.__class__.__name__ != "Range"


def _call(machine: Engine, op: ops.Call, frame: Frame) -> bool:
    given: list[Value] = []
    for argument in op.arguments:
        value = frame.registers[argument.register]
        if argument.is_spread:
            if not _is_exact(machine, value):
                return True
            given.extend(value.items if value.__class__ is Tuple else _elements(machine, value))
        else:
            given.append(value)
    return _callee(machine, frame.registers[op.func], given)


def _elements(machine: Engine, value: Value) -> list[Value]:
    if not isinstance(value, Ref):
        return []
    obj = machine.obj(value)
    return [*(obj.items or ()), *obj.entries.values()]


def _callee(machine: Engine, function: Value, arguments: list[Value]) -> bool:
    """Whether a call may fail by itself. A function of the program says so where it is interpreted."""
    if function.__class__ is BoundMethod:
        return _callee(machine, function.function, [function.receiver, *arguments])
    if function.__class__ is Partial:
        return _callee(machine, function.function, [*function.arguments, *arguments])
    if function.__class__ is Function:
        return False
    if function.__class__ is Class:
        return any(b.__class__ not in (Class, Native) for b in function.mro)
    if function.__class__ is Choice:
        return any(_callee(machine, o, arguments) for o in function.options)
    if function.__class__ is Native:
        return _native(machine, function.name, arguments)
    if function.__class__ is External:
        return not function.name.startswith("_rosward.")
    return function.__class__ is not Ref or members.lookup(machine, machine.obj(function).cls, "__call__") is None


def _is_known(machine: Engine, value: Value) -> bool:
    """Whether all that a builtin asks of a value is known: of a number that it is one, of text each letter."""
    if value.__class__ is Tuple:
        return all(_is_known(machine, v) for v in value.items)
    if value.__class__ is Const:
        return not isinstance(value.value, str) or value.is_settled
    return value.__class__ is Ref and _is_exact(machine, value)


def _is_exact(machine: Engine, value: Value) -> bool:
    """Whether a value is a tuple, or a list, set or dict of which all elements are known."""
    if value.__class__ is not Ref:
        return value.__class__ is Tuple
    obj = machine.obj(value)
    if obj.kind not in ("list", "dict", "set") or obj.many:
        return False
    return obj.items is not None and obj.rest is None and not obj.maybe


def _is_generator(machine: Engine, arguments: list[Value]) -> bool:
    first = arguments[0] if arguments else NONE
    return first.__class__ is Ref and machine.obj(first).kind == "generator"


def _native(machine: Engine, name: str, arguments: list[Value]) -> bool:
    head, _, method = name.rpartition(".")
    if head == "generator" or (method == "next" and _is_generator(machine, arguments)):
        return False  # what it raises is followed
    if (
        head in _EVALUATED
        and (method in _NUMBERS or head not in ("", "builtins"))
        and all(_is_known(machine, a) for a in arguments)
    ):
        return False  # where it fails, it says so
    if head in ("", "builtins") and members.is_builtin_exception(Native(f"builtins.{method}")):
        return False
    if head in ("", "builtins"):
        safe = method in _SAFE_BUILTINS
    else:
        safe = head in _SAFE_TYPES and method not in _UNSAFE_METHODS
    return not safe or any(
        a.__class__ not in _PLAIN and method not in ("print", "str", "repr", "isinstance") for a in arguments
    )


_JUDGES: Final[dict[type[ops.Op], Callable[[Any, Any, Any], bool]]] = {
    ops.LoadGlobal: _load_global,
    ops.LoadCell: _load_cell,
    ops.LoadAttr: _load_attr,
    ops.StoreAttr: _store_attr,
    ops.LoadItem: _load_item,
    ops.StoreItem: _store_item,
    ops.Delete: _delete,
    ops.Binary: _binary,
    ops.Unary: _unary,
    ops.Compare: _compare,
    ops.Format: _format,
    ops.Unpack: _unpack,
    ops.Intrinsic: _intrinsic,
    ops.ForEach: _for_each,
    ops.Call: _call,
}
