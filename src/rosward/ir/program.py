# SPDX-License-Identifier: Apache-2.0
"""What operations are grouped in: code bodies with what a call has to know of them, and modules."""

from __future__ import annotations

import enum
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Final, Literal, TypeVar, final

from rosward.ir.op import Block, Op, walk
from rosward.records import NamedTuple

_T = TypeVar("_T")


class CodeKind(enum.Enum):
    """What a code body belongs to."""

    MODULE = "module"
    FUNCTION = "function"
    CLASS = "class"


@final
class Parameters:
    """The parameters of a function, by name and in order. Parameter i of all of them (in the order below) arrives in register i.

    Order: positional-only and positional, then `vararg`, then keyword-only, then `kwarg`.
    """

    __slots__ = ("kwarg", "kwonly", "positional", "posonly", "vararg")

    def __init__(
        self, positional: tuple[str, ...], posonly: int, vararg: str | None, kwonly: tuple[str, ...], kwarg: str | None
    ) -> None:
        self.positional = positional  # positional-only ones included, first
        self.posonly = posonly  # how many of them are positional-only
        self.vararg = vararg
        self.kwonly = kwonly
        self.kwarg = kwarg

    @property
    def names(self) -> tuple[str, ...]:
        """All names in register order."""
        names = self.positional
        if self.vararg is not None:
            names += (self.vararg,)
        names += self.kwonly
        if self.kwarg is not None:
            names += (self.kwarg,)
        return names


MODEL_PREFIX: Final = "models:"
"""How the file name of every code body of a model begins."""
PYTHON: Final = "python"
CPP: Final = "c++"

OpKey = tuple[str, int]
"""What names an operation for good: the key of its body, and its number in it."""


Scope = tuple[str, ...]
"""Namespaces and classes, outermost first; '' for an unnamed namespace."""


class TypePattern(NamedTuple):
    """A type as it is written, for deduction and overloads: `const std::vector<T> &` is std, vector (T), reference, const.

    `names` is empty for what is no name (`auto`, a function type, `decltype`), and `builtin` then its words (`unsigned int`, `auto`).
    """

    names: tuple[str, ...] = ()
    arguments: tuple[TypePattern, ...] = ()
    builtin: str = ""
    pointers: int = 0
    reference: Literal["", "&", "&&"] = ""
    const: bool = False
    pack: bool = False
    """An argument that is a pack: `Args…`."""
    array: bool = False
    """Of a variable: an array, which counts as a pointer."""
    size: str = ""
    """The name that stands for the number of elements: `T (&items)[N]`."""


class ParameterSymbol(NamedTuple):
    """A parameter of a function: its type, whether it has a default, whether it is a pack."""

    name: str
    type: TypePattern
    default: bool = False
    pack: bool = False


class TemplateParameter(NamedTuple):
    """A parameter of a template; `default` is a thunk, whose parameters are the ones before it; so is `type`, of a parameter that is a value
    and of which the type is computed (`std::enable_if_t<…, int> = 0`)."""

    name: str
    pack: bool = False
    default: Code | None = None
    type: Code | None = None


class Signature(NamedTuple):
    """How the registers of a function are filled: `leading` ones come first (`this`, then what a lambda has captured by copy), then those
    of the template, then the parameters. A pack arrives as one value, a tuple. What got no argument is unbound: the body begins with its
    `Default`, and converts each parameter by value to its type.

    `reference`: it returns one. `using`: the namespaces of its `using namespace`. `owned`: which of its free cells a lambda has to itself, so
    that a copy of it has others. `constant`: a member function of constant objects, too. `apart`: wherever it is called, it is in one
    context for each object. `receiver`: `&` or `&&` behind its parameters, of the objects that it is for. `called`: what it calls the
    parameters of the class template that it is a member of, where it is defined outside of that.
    """

    parameters: tuple[ParameterSymbol, ...] = ()
    leading: int = 0
    template: tuple[TemplateParameter, ...] = ()
    reference: bool = False
    using: tuple[Scope, ...] = ()
    owned: tuple[int, ...] = ()
    constant: bool = False
    apart: bool = False
    receiver: str = ""
    called: Scope = ()

    def types(self, registers: Sequence[_T]) -> tuple[_T, ...]:
        """What a call has given for the parameters of the template."""
        return tuple(registers[self.leading : self.leading + len(self.template)])


@final
class Code:
    """One body: of a module, a function (lambda, coroutine, generator) or a class.

    `cells` are the names of the variables that inner functions capture; where one is a parameter, the body begins by
    storing the register into the cell.
    `free` are the names captured from outside, in the order of `captures` of the operation that makes the function or class.
    Cell numbers count `cells` first, then `free`. `__class__` is a free cell of each method in which `super()` without
    arguments or `__class__` occurs, and a cell of the class body around it, set when the class is made.
    `key` names the body for good: its file (`unit` where it is of no whole file) and which one of that it is (`index`); with the number
    of an operation it names that (`OpKey`). `entry` is where it begins, before its first operation.
    `language` is the name of the language that it is written in, which says what its operations mean (`engine/machine.py`).
    `signature` says of a language with overloads what a call has to know of a function.
    `annotations` and `returns` keep annotations as source text, `doc` the docstring. `is_stub`: the body is `...` alone.
    """

    __slots__ = (
        "annotations",
        "cells",
        "doc",
        "entry",
        "file",
        "free",
        "is_coroutine",
        "is_generator",
        "is_model",
        "is_stub",
        "key",
        "kind",
        "language",
        "line",
        "name",
        "ops",
        "parameters",
        "qualname",
        "registers",
        "returns",
        "signature",
        "variables",
        "waits",
    )

    def __init__(
        self,
        kind: CodeKind,
        name: str,
        qualname: str,
        file: str,
        line: int,
        parameters: Parameters,
        ops: Block,
        registers: int,
        variables: tuple[str, ...],
        cells: tuple[str, ...],
        free: tuple[str, ...],
        *,
        is_generator: bool = False,
        is_coroutine: bool = False,
        is_stub: bool = False,
        annotations: dict[str, str] | None = None,
        returns: str | None = None,
        doc: str | None = None,
        index: int = 0,
        language: str = PYTHON,
        unit: str = "",
        signature: Signature | None = None,
    ) -> None:
        self.signature = signature
        self.key = f"{unit or file}#{index}"
        self.language = language
        self.entry = Op(line, 1)
        self.kind = kind
        self.name = name
        self.qualname = qualname
        self.file = file
        self.is_model = file.startswith(MODEL_PREFIX)
        self.line = line
        self.parameters = parameters
        self.ops = ops
        self.registers = registers  # how many registers; parameters first, then locals, then temporaries
        self.variables = variables  # names of the registers that are parameters or local variables
        self.cells = cells
        self.free = free
        self.is_generator = is_generator
        self.is_coroutine = is_coroutine
        self.is_stub = is_stub
        self.annotations = annotations or {}
        self.returns = returns
        self.doc = doc
        for number, op in enumerate(walk(ops), 1):
            op.number = number

    @staticmethod
    def waiting(key: str, waits: Callable[[], Code]) -> Code:
        """A body of which the key is known; what else it has, `waits` gives where somebody asks for it."""
        code = Code.__new__(Code)
        code.key = key
        code.waits = waits  # type: ignore[attr-defined]  # what is complete has no such thing
        return code

    if not TYPE_CHECKING:  # for a type checker it has what it has, and nothing else

        def __getattr__(self, name: str) -> object:
            """What is asked for is not there yet: from now on all is."""
            if name == "waits" or name not in Code.__slots__:
                raise AttributeError(name)
            made = self.waits()
            for each in Code.__slots__:
                if each != "waits":
                    setattr(self, each, getattr(made, each))
            del self.waits
            return getattr(self, name)


@final
class Module:
    """A lowered source file.

    `imports` are the dotted names of all modules that any of its code imports (relative ones with their dots), `first` those of them that
    it imports before any of its functions is called.
    """

    __slots__ = ("code", "file", "first", "has_main", "imports", "lines")

    def __init__(
        self, file: str, code: Code, imports: frozenset[str], first: frozenset[str], has_main: bool, lines: int
    ) -> None:
        self.file = file
        self.code = code
        self.imports = imports
        self.first = first
        self.has_main = has_main  # it has an `if __name__ == '__main__'` block
        self.lines = lines
