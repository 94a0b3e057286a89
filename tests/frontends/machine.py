# SPDX-License-Identifier: Apache-2.0
"""Runs IR with real Python objects, to compare what it means with what Python does; for the tests' own programs.

Generators run to their end at the call and give a list, coroutines run at the call: no program here needs laziness.
"""

from __future__ import annotations

import builtins
import operator
import types
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from rosward.ir import ops
from rosward.ir.ops import NO_REGISTER, Argument, Block
from rosward.ir.program import Code, Module

BINARY: dict[str, tuple[Callable[[Any, Any], Any], Callable[[Any, Any], Any]]] = {
    "+": (operator.add, operator.iadd),
    "-": (operator.sub, operator.isub),
    "*": (operator.mul, operator.imul),
    "@": (operator.matmul, operator.imatmul),
    "/": (operator.truediv, operator.itruediv),
    "%": (operator.mod, operator.imod),
    "**": (operator.pow, operator.ipow),
    "<<": (operator.lshift, operator.ilshift),
    ">>": (operator.rshift, operator.irshift),
    "|": (operator.or_, operator.ior),
    "^": (operator.xor, operator.ixor),
    "&": (operator.and_, operator.iand),
    "//": (operator.floordiv, operator.ifloordiv),
}
UNARY: dict[str, Callable[[Any], Any]] = {
    "not": operator.not_,
    "-": operator.neg,
    "+": operator.pos,
    "~": operator.invert,
}
COMPARE: dict[str, Callable[[Any, Any], Any]] = {
    "==": operator.eq,
    "!=": operator.ne,
    "<": operator.lt,
    "<=": operator.le,
    ">": operator.gt,
    ">=": operator.ge,
    "is": operator.is_,
    "is-not": operator.is_not,
    "in": lambda left, right: left in right,
    "not-in": lambda left, right: left not in right,
}
UNSET = object()
ABSENT = object()


class Cell:
    def __init__(self) -> None:
        self.value: Any = UNSET


class _Returned(Exception):  # noqa: N818
    def __init__(self, value: Any) -> None:
        super().__init__()
        self.value = value


class _Broke(Exception):  # noqa: N818
    pass


class _Continued(Exception):  # noqa: N818
    pass


CONTROL = (_Returned, _Broke, _Continued)


class Super:
    """`super()`, for which Python itself looks at the frame of the caller."""


def run(module: Module, **given: Any) -> dict[str, Any]:
    """The variables of the module after it ran."""
    variables: dict[str, Any] = {"__name__": "__main__", "__builtins__": builtins, **given}
    Frame(module.code, variables, []).execute(module.code.ops)
    return variables


class Frame:
    def __init__(self, code: Code, variables: dict[str, Any], free: Sequence[Cell]) -> None:
        self.code = code
        self.globals = variables
        self.registers: list[Any] = [UNSET] * code.registers
        self.cells = [*(Cell() for _ in code.cells), *free]
        self.names: dict[str, Any] = {}
        self.yielded: list[Any] = []
        self.handled: list[BaseException] = []

    def get(self, register: int) -> Any:
        value = self.registers[register]
        if value is UNSET:
            assert register < len(self.code.variables), "a temporary that was never written"
            raise UnboundLocalError(self.code.variables[register])
        return value

    def load_global(self, name: str) -> Any:
        if name in self.globals:
            return self.globals[name]
        if name == "super":
            return Super
        if not hasattr(builtins, name):
            raise NameError(name)
        return getattr(builtins, name)

    def load_cell(self, cell: int) -> Any:
        value = self.cells[cell].value
        if value is UNSET:
            raise NameError((*self.code.cells, *self.code.free)[cell])
        return value

    def execute(self, block: Block) -> None:
        for op in block:
            getattr(self, type(op).__name__)(op)

    # Values

    def Const(self, op: ops.Const) -> None:  # noqa: N802
        self.registers[op.dst] = op.value

    def Move(self, op: ops.Move) -> None:  # noqa: N802
        self.registers[op.dst] = self.get(op.src)

    def LoadGlobal(self, op: ops.LoadGlobal) -> None:  # noqa: N802
        self.registers[op.dst] = self.load_global(op.name)

    def StoreGlobal(self, op: ops.StoreGlobal) -> None:  # noqa: N802
        if not op.narrowing:
            self.globals[op.name] = self.get(op.src)

    def LoadName(self, op: ops.LoadName) -> None:  # noqa: N802
        if op.name in self.names:
            value = self.names[op.name]
        else:
            value = self.load_global(op.name) if op.cell == NO_REGISTER else self.load_cell(op.cell)
        self.registers[op.dst] = value

    def StoreName(self, op: ops.StoreName) -> None:  # noqa: N802
        self.names[op.name] = self.get(op.src)

    def LoadCell(self, op: ops.LoadCell) -> None:  # noqa: N802
        self.registers[op.dst] = self.load_cell(op.cell)

    def StoreCell(self, op: ops.StoreCell) -> None:  # noqa: N802
        if op.narrowing:
            assert self.cells[op.cell].value is self.get(op.src)
        self.cells[op.cell].value = self.get(op.src)

    def NewCell(self, op: ops.NewCell) -> None:  # noqa: N802
        self.cells[op.cell] = Cell()

    def LoadAttr(self, op: ops.LoadAttr) -> None:  # noqa: N802
        self.registers[op.dst] = getattr(self.get(op.obj), op.name)

    def StoreAttr(self, op: ops.StoreAttr) -> None:  # noqa: N802
        obj, value = self.get(op.obj), self.get(op.src)
        if not op.narrowing:
            setattr(obj, op.name, value)
        elif op.name in getattr(obj, "__dict__", {}):
            assert obj.__dict__[op.name] is value, "a stale narrowing"

    def LoadItem(self, op: ops.LoadItem) -> None:  # noqa: N802
        self.registers[op.dst] = self.get(op.obj)[self.get(op.index)]

    def StoreItem(self, op: ops.StoreItem) -> None:  # noqa: N802
        obj, index, value = self.get(op.obj), self.get(op.index), self.get(op.src)
        if not op.narrowing:
            obj[index] = value
        elif isinstance(obj, (list, dict)):
            assert obj[index] is value, "a stale narrowing"

    def Delete(self, op: ops.Delete) -> None:  # noqa: N802
        if op.kind == "local":
            self.get(op.obj)
            self.registers[op.obj] = UNSET
        elif op.kind == "cell":
            self.load_cell(op.obj)
            self.cells[op.obj].value = UNSET
        elif op.kind in ("global", "name"):
            del (self.globals if op.kind == "global" else self.names)[op.name]
        elif op.kind == "attr":
            delattr(self.get(op.obj), op.name)
        else:
            del self.get(op.obj)[self.get(op.index)]

    def Unary(self, op: ops.Unary) -> None:  # noqa: N802
        self.registers[op.dst] = UNARY[op.operator](self.get(op.src))

    def Binary(self, op: ops.Binary) -> None:  # noqa: N802
        self.registers[op.dst] = BINARY[op.operator][op.inplace](self.get(op.left), self.get(op.right))

    def Compare(self, op: ops.Compare) -> None:  # noqa: N802
        self.registers[op.dst] = COMPARE[op.operator](self.get(op.left), self.get(op.right))

    def _arguments(self, arguments: Sequence[Argument]) -> tuple[list[Any], dict[str, Any]]:
        positional: list[Any] = []
        keywords: dict[str, Any] = {}
        for argument in arguments:
            value = self.get(argument.register)
            if argument.kind == "positional":
                positional.append(value)
            elif argument.kind == "star":
                positional.extend(value)
            elif argument.kind == "keyword":
                keywords[argument.name] = value
            else:
                keywords.update(value)
        return positional, keywords

    def Call(self, op: ops.Call) -> None:  # noqa: N802
        positional, keywords = self._arguments(op.arguments)
        function = self.get(op.func)
        if function is Super and not positional:
            cell = (*self.code.cells, *self.code.free).index("__class__")
            first = self.registers[0]
            if "self" in self.code.cells:
                first = self.load_cell(self.code.cells.index("self"))
            self.registers[op.dst] = super(self.load_cell(cell), first)
        else:
            self.registers[op.dst] = (super if function is Super else function)(*positional, **keywords)

    def Build(self, op: ops.Build) -> None:  # noqa: N802
        if op.kind == "dict":
            made: dict[Any, Any] = {}
            items = iter(op.items)
            for starred, register in items:
                if starred:
                    made.update(self.get(register))
                else:
                    made[self.get(register)] = self.get(next(items)[1])
            self.registers[op.dst] = made
            return
        values: list[Any] = []
        for starred, register in op.items:
            values.extend(self.get(register) if starred else [self.get(register)])
        kinds: dict[str, Callable[[list[Any]], Any]] = {"list": list, "tuple": tuple, "set": set}
        self.registers[op.dst] = kinds[op.kind](values)

    def Format(self, op: ops.Format) -> None:  # noqa: N802
        text = ""
        convert: dict[str, Callable[[Any], Any]] = {"": lambda v: v, "s": str, "r": repr, "a": ascii}
        for part in op.parts:
            if isinstance(part, str):
                text += part
            else:
                spec = "" if part[2] == NO_REGISTER else self.get(part[2])
                text += format(convert[part[1]](self.get(part[0])), spec)
        self.registers[op.dst] = text

    # Functions and classes

    def MakeFunction(self, op: ops.MakeFunction) -> None:  # noqa: N802
        free = [self.cells[number] for number in op.captures]
        defaults = [self.get(register) for register in op.defaults]
        kwdefaults = {name: self.get(register) for name, register in op.kwdefaults}
        code, variables = op.code, self.globals

        def function(*args: Any, **kwargs: Any) -> Any:
            frame = Frame(code, variables, free)
            frame.registers[: len(code.parameters.names)] = bind(code, defaults, kwdefaults, args, kwargs)
            result = None
            try:
                frame.execute(code.ops)
            except _Returned as returned:
                result = returned.value
            return frame.yielded if code.is_generator else result

        function.__name__, function.__qualname__ = code.name, code.qualname
        self.registers[op.dst] = function

    def MakeClass(self, op: ops.MakeClass) -> None:  # noqa: N802
        bases, keywords = self._arguments(op.arguments)
        frame = Frame(op.code, self.globals, [self.cells[number] for number in op.captures])

        def fill(namespace: dict[str, Any]) -> None:
            namespace["__module__"], namespace["__qualname__"] = "m", op.code.qualname
            frame.names = namespace
            frame.execute(op.code.ops)

        made = types.new_class(op.code.name, tuple(bases), keywords, fill)
        if "__class__" in op.code.cells:
            frame.cells[op.code.cells.index("__class__")].value = made
        self.registers[op.dst] = made

    # Imports

    def Import(self, op: ops.Import) -> None:  # noqa: N802
        top = __import__(op.module)
        for name in op.module.split(".")[1:] if op.leaf else ():
            top = getattr(top, name)
        self.registers[op.dst] = top

    def ImportFrom(self, op: ops.ImportFrom) -> None:  # noqa: N802
        self.registers[op.dst] = getattr(__import__(op.module, fromlist=[op.name]), op.name)

    def ImportStar(self, op: ops.ImportStar) -> None:  # noqa: N802
        module = __import__(op.module, fromlist=["*"])
        names = getattr(module, "__all__", None) or [name for name in dir(module) if not name.startswith("_")]
        self.globals.update({name: getattr(module, name) for name in names})

    # The rest

    def Unpack(self, op: ops.Unpack) -> None:  # noqa: N802
        values = list(self.get(op.src))
        if op.star == NO_REGISTER:
            if len(values) != len(op.dsts):
                raise ValueError("wrong number of values to unpack")
        else:
            after = len(op.dsts) - op.star - 1
            if len(values) < op.star + after:
                raise ValueError("not enough values to unpack")
            end = len(values) - after
            values = [*values[: op.star], values[op.star : end], *values[end:]]
        for register, value in zip(op.dsts, values, strict=True):
            self.registers[register] = value

    def Intrinsic(self, op: ops.Intrinsic) -> None:  # noqa: N802
        values = [self.get(register) for register in op.arguments]
        self.registers[op.dst] = getattr(self, f"intrinsic_{op.name}", self._other)(op.name, values)

    def intrinsic_bound(self, _name: str, v: list[Any]) -> None:
        if not v[0]:
            raise UnboundLocalError

    def _other(self, name: str, v: list[Any]) -> Any:
        table: dict[str, Callable[[], Any]] = {
            "slice": lambda: slice(*v),
            "append": lambda: v[0].append(v[1]),
            "set_add": lambda: v[0].add(v[1]),
            "dict_set": lambda: operator.setitem(v[0], v[1], v[2]),
            "annotate": lambda: self.names.setdefault("__annotations__", {}).__setitem__(v[0], v[1]),
            "is_sequence": lambda: isinstance(v[0], Sequence) and not isinstance(v[0], (str, bytes, bytearray)),
            "is_mapping": lambda: isinstance(v[0], Mapping),
            "length_is": lambda: len(v[0]) == v[1],
            "length_at_least": lambda: len(v[0]) >= v[1],
            "mapping_rest": lambda: {key: value for key, value in v[0].items() if key not in v[1:]},
            "match_args": lambda: v[0].__match_args__[: v[1]],
            "isinstance": lambda: isinstance(v[0], v[1]),
            "attribute": lambda: getattr(v[0], v[1], ABSENT),
            "is_there": lambda: v[0] is not ABSENT,
            "there": lambda: v[0],
        }
        return table[name]()

    def Assume(self, op: ops.Assume) -> None:  # noqa: N802
        value = self.get(op.src)
        tests: dict[str, Callable[[Any, Any], Any]] = {
            "is": operator.is_,
            "==": operator.eq,
            "in": lambda item, container: item in container,
            "isinstance": isinstance,
            "<": operator.lt,
            ">": operator.gt,
        }
        holds = bool(value) if op.test == "true" else bool(tests[op.test](value, self.get(op.other)))
        assert holds is op.sense, f"line {op.line}: {value!r} {op.test} is not {op.sense}"
        self.registers[op.dst] = value

    def Yield(self, op: ops.Yield) -> None:  # noqa: N802
        if op.many:
            self.yielded.extend(self.get(op.src))
        else:
            self.yielded.append(self.get(op.src))
        self.registers[op.dst] = None

    def Await(self, op: ops.Await) -> None:  # noqa: N802
        self.registers[op.dst] = self.get(op.src)

    # Control

    def If(self, op: ops.If) -> None:  # noqa: N802
        self.execute(op.then if self.get(op.test) else op.orelse)

    def _turn(self, body: Block) -> bool:
        try:
            self.execute(body)
        except _Broke:
            return False
        except _Continued:
            pass
        return True

    def While(self, op: ops.While) -> None:  # noqa: N802
        while True:
            self.execute(op.condition)
            if not self.get(op.test):
                break
            if not self._turn(op.body):
                return
        self.execute(op.orelse)

    def ForEach(self, op: ops.ForEach) -> None:  # noqa: N802
        for item in self.get(op.iterable):
            self.registers[op.item] = item
            if not self._turn(op.body):
                return
        self.execute(op.orelse)

    def With(self, op: ops.With) -> None:  # noqa: N802
        context = self.get(op.context)
        if op.is_async:
            entered = context.__aenter__()
            if op.bind != NO_REGISTER:
                self.registers[op.bind] = entered
            self.execute(op.body)
            context.__aexit__(None, None, None)
            return
        control: list[BaseException] = []
        with context as entered:
            if op.bind != NO_REGISTER:
                self.registers[op.bind] = entered
            try:
                self.execute(op.body)
            except CONTROL as left:
                control.append(left)
        if control:
            raise control[0]

    def Try(self, op: ops.Try) -> None:  # noqa: N802
        try:
            try:
                self.execute(op.body)
            except CONTROL:
                raise
            except BaseException as error:
                self._handle(op, error)
            else:
                self.execute(op.orelse)
        finally:
            self.execute(op.final)

    def _handle(self, op: ops.Try, error: BaseException) -> None:
        if isinstance(error, AssertionError) and "stale" in str(error):
            raise error
        for handler in op.handlers:
            self.execute(handler.match)
            if handler.type == NO_REGISTER or isinstance(error, self.get(handler.type)):
                if handler.bind != NO_REGISTER:
                    self.registers[handler.bind] = error
                self.handled.append(error)
                self.execute(handler.body)
                self.handled.pop()
                return
        raise error

    def Return(self, op: ops.Return) -> None:  # noqa: N802
        raise _Returned(self.get(op.src))

    def Raise(self, op: ops.Raise) -> None:  # noqa: N802
        raise self.handled[-1] if op.src == NO_REGISTER else self.get(op.src)

    def Break(self, _op: ops.Break) -> None:  # noqa: N802
        raise _Broke

    def Continue(self, _op: ops.Continue) -> None:  # noqa: N802
        raise _Continued


def bind(
    code: Code, defaults: list[Any], kwdefaults: dict[str, Any], args: tuple[Any, ...], kwargs: dict[str, Any]
) -> list[Any]:
    parameters = code.parameters
    names = parameters.positional
    found: dict[str, Any] = dict(zip(names[len(names) - len(defaults) :], defaults, strict=True))
    found.update(kwdefaults)
    found.update(zip(names, args, strict=False))
    if len(args) > len(names) and parameters.vararg is None:
        raise TypeError("too many arguments")
    if parameters.vararg is not None:
        found[parameters.vararg] = args[len(names) :]
    rest: dict[str, Any] = {}
    for name, value in kwargs.items():
        known = name in names[parameters.posonly :] or name in parameters.kwonly
        (found if known else rest)[name] = value
    if parameters.kwarg is not None:
        found[parameters.kwarg] = rest
    elif rest:
        raise TypeError(f"unexpected arguments {sorted(rest)}")
    try:
        return [found[name] for name in parameters.names]
    except KeyError as missing:
        raise TypeError(f"missing argument {missing}") from None
