# SPDX-License-Identifier: Apache-2.0
"""Builtin functions of single values; those of iterables, of attributes and the types stand in modules of their own.

abs(-1), round(x, 2), isinstance(x, str), input(), eval('[1, 2]'); open() is in `std/files.py`
"""

from __future__ import annotations

import ast
from collections.abc import Callable
from typing import Final

from rosward.domain.choice import options
from rosward.domain.compound import Native, Tuple
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, UNBOUND, Class, Const, ModuleValue, Ref, Unknown, Value
from rosward.models.native import Machine, NativeCall, NativeFunction
from rosward.models.python.asked import does_something
from rosward.models.python.builtins.attributes import attribute_names, has_attribute
from rosward.models.python.builtins.constructors import is_callable
from rosward.models.python.plain import evaluate, from_python, native, origins, spread, text_of, unknown_from
from rosward.models.python.strings.formatting import format_value, represent, to_str

MAX_SOURCE: Final = 4_096
_PURE: Final[dict[str, tuple[Callable[..., object], str]]] = {
    "abs": (abs, ""), "round": (round, ""), "chr": (chr, "str"), "ord": (ord, "int"),
    "bin": (bin, "str"), "hex": (hex, "str"), "oct": (oct, "str"), "pow": (pow, ""), "divmod": (divmod, ""),
}  # fmt: skip
_NEEDS: Final[dict[str, tuple[int, str]]] = {
    "round": (1, "number ndigits"),
    "pow": (2, "base exp mod"),
    "divmod": (2, ""),
}
_ASKED: Final = {"abs": "__abs__", "round": "__round__", "divmod": "__divmod__", "pow": "__pow__"}
"""What Python calls in the place of a function, on an object that has it."""
_AS_INDEX: Final = frozenset({"bin", "hex", "oct", "chr"})
_ABSOLUTE: Final = {"int": "int", "bool": "int", "float": "float"}
_OPAQUE: Final = {"memoryview": "", "help": ""}


def _pure(call: NativeCall) -> Value:
    """A function of constants."""
    name = call.name.rpartition(".")[2]
    function, hint = _PURE[name]

    def one(*values: Value) -> Value:
        if name == "pow" and len(values) == 2 and any(_has_power(call.machine, v) for v in values):
            return call.machine.binary("**", *values)
        special = "__index__" if name in _AS_INDEX else _ASKED.get(name, "")
        if _is_object(call.machine, values[0], special):
            answer = call.machine.call(call.machine.load_attr(values[0], special), values[1:])
            return one(answer) if name in _AS_INDEX and isinstance(answer, Const) else answer
        known = evaluate(call.machine, name, function, values, hint)
        if known is not None:
            return known
        kept = _ABSOLUTE.get(values[0].hint, "") if isinstance(values[0], Unknown) and name == "abs" else hint
        result = unknown_from(call.machine, name, "int" if name == "round" and len(values) == 1 else kept, *values)
        return Tuple((Unknown(result.reasons), Unknown(result.reasons))) if name == "divmod" else result

    if call.keywords:
        return unknown_from(call.machine, name, hint, *call.args, *call.keywords.values())
    return spread(one, *call.args)


def _is_object(machine: Machine, value: Value, special: str) -> bool:
    """Whether a value is an object whose class has a special method."""
    if not special or not isinstance(value, Ref) or machine.obj(value).kind != "instance":
        return False
    return has_attribute(machine, value, special) is True


def _has_power(machine: Machine, value: Value) -> bool:
    return _is_object(machine, value, "__pow__") or _is_object(machine, value, "__rpow__")


def _is_instance(call: NativeCall) -> Value:
    decided = call.machine.is_instance(call.args[0], call.args[1])
    return unknown_from(call.machine, "isinstance", "bool", call.args[0]) if decided is None else Const(decided)


def _is_subclass(call: NativeCall) -> Value:
    decided = call.machine.is_subclass(call.args[0], call.args[1])
    return unknown_from(call.machine, "issubclass", "bool", *call.args[:2]) if decided is None else Const(decided)


def _callable(call: NativeCall) -> Value:
    def one(value: Value) -> Value:
        decided = is_callable(call.machine, value)
        return unknown_from(call.machine, "callable", "bool", value) if decided is None else Const(decided)

    return spread(one, call.args[0])


_MOST_PRINTED: Final = 50


def _pieces(call: NativeCall) -> list[Value]:
    """What `print` writes, one piece after another."""
    if call.loose is not None or len(call.args) > _MOST_PRINTED or {"sep", "end"} & call.unsure:
        return [call.machine.unknown(Cause.CALL, "print", "str")]
    between, end = (
        Const(usual) if given is None or given == NONE else given
        for given, usual in ((call.keywords.get("sep"), " "), (call.keywords.get("end"), "\n"))
    )
    pieces: list[Value] = []
    for number, value in enumerate(call.args):
        pieces += [between] * (number > 0) + [to_str(call.machine, format_value(call.machine, value, "s"))]
    return [*pieces, end]


def _print(call: NativeCall) -> Value:
    """What is printed goes to `file`, or to what the program put in the place of sys.stdout: its `write` runs."""
    file = call.keywords.get("file")
    if file is None or file == NONE:
        machine = call.machine
        file = machine.load_attr(machine.load_module("sys"), "stdout")
    for option in options(file):
        cls = call.machine.obj(option).cls if isinstance(option, Ref) else None
        if not isinstance(cls, Class):
            continue
        write = call.machine.load_attr(option, "write")
        if not cls.stub or does_something(write):
            for piece in _pieces(call):
                call.machine.call(write, (piece,))
            if call.keywords.get("flush") is not None:
                call.machine.call(call.machine.load_attr(option, "flush"), ())
    return NONE


def _input(call: NativeCall) -> Value:
    call.machine.waits()
    return call.machine.unknown(Cause.INPUT, "input", "str")


def _identity(call: NativeCall) -> Value:
    """id and hash."""
    return call.machine.unknown(Cause.RANDOM, call.name.rpartition(".")[2], "int")


def _repr(call: NativeCall) -> Value:
    return spread(
        lambda v: v if text_of(v) is not None else unknown_from(call.machine, "repr", "str", v),
        represent(call.machine, call.args[0]),
    )


def _ascii(call: NativeCall) -> Value:
    return format_value(call.machine, call.args[0], "a")


def _format(call: NativeCall) -> Value:
    return to_str(
        call.machine, format_value(call.machine, call.args[0], "", call.args[1] if len(call.args) > 1 else None)
    )


def _opaque(call: NativeCall) -> Value:
    name = call.name.rpartition(".")[2]
    return call.machine.unknown(Cause.LIVE, name, _OPAQUE[name])


def _variables(call: NativeCall) -> Value:
    """vars, globals and locals."""
    if call.name.endswith("vars") and call.args:
        return spread(lambda value: call.machine.load_attr(value, "__dict__"), call.args[0])
    return call.machine.variables(local=not call.name.endswith("globals"))


def _of_module(call: NativeCall, module: ModuleValue) -> set[str] | None:
    """The names in a module of the program; None where a star import hides some."""
    attrs = call.machine.obj(Ref(module.address)).attrs
    if not module.file or "__dir__" in attrs or "*" in attrs:
        return None
    return {name for name, value in attrs.items() if value is not UNBOUND}


def _dir(call: NativeCall) -> Value:
    """The names of the attributes of an object, where all of its classes are known; those of a module."""
    machine = call.machine
    names: set[str] = set()
    for option in options(call.args[0]) if call.args else (NONE,):
        if isinstance(option, ModuleValue):
            hook = machine.obj(Ref(option.address)).attrs.get("__dir__", UNBOUND)
            if hook is not UNBOUND:
                return machine.call_native("builtins.list", (machine.call(hook, ()),))
            inside = _of_module(call, option)
            if inside is None:
                return machine.unknown(Cause.LIVE, "dir", "list")
            names.update(inside)
            continue
        names.update(dir(object))
        cls = machine.obj(option).cls if isinstance(option, Ref) else option
        if isinstance(cls, Class) and any(
            isinstance(b, Class) and "__dir__" in machine.obj(Ref(b.address)).attrs for b in cls.mro
        ):
            return machine.call_native("builtins.list", (machine.call(machine.load_attr(option, "__dir__"), ()),))
        known = attribute_names(machine, option)
        if not known or not isinstance(cls, Class) or not all(isinstance(b, (Class, Native)) for b in cls.mro):
            return machine.unknown(Cause.LIVE, "dir", "list")
        names.update(known)
    return machine.new_list([Const(name) for name in sorted(names)])


def _run_code(call: NativeCall) -> Value:
    """exec and compile."""
    name = call.name.rpartition(".")[2]
    call.machine.report("RW203", f"{name}() is not analysed")
    return NONE if name == "exec" else unknown_from(call.machine, name, "", *call.args)


def _eval(call: NativeCall) -> Value:
    """eval of a literal is that literal; anything else is not followed."""
    source = text_of(call.args[0])
    if source is not None and len(source) <= MAX_SOURCE:
        try:
            return from_python(call.machine, ast.literal_eval(source.strip()), origins(call.args[0]), "eval")
        except (ValueError, SyntaxError, TypeError, RecursionError, MemoryError):
            pass
    return _run_code(call)


NATIVES: Final[dict[str, NativeFunction]] = {
    **{f"builtins.{name}": native(_pure, *_NEEDS.get(name, (1, ""))) for name in _PURE},
    **{f"builtins.{name}": native(_opaque) for name in _OPAQUE},
    **{f"builtins.{name}": native(_variables) for name in ("vars", "globals", "locals")},
    "builtins.dir": native(_dir),
    **{f"builtins.{name}": native(_run_code) for name in ("exec", "compile")},
    "builtins.isinstance": native(_is_instance, 2),
    "builtins.issubclass": native(_is_subclass, 2),
    "builtins.callable": native(_callable, 1),
    "builtins.print": native(_print),
    "builtins.input": native(_input),
    "builtins.id": native(_identity),
    "builtins.hash": native(_identity),
    "builtins.repr": native(_repr, 1),
    "builtins.ascii": native(_ascii, 1),
    "builtins.format": native(_format, 1),
    "builtins.eval": native(_eval, 1),
}
