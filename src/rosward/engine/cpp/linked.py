# SPDX-License-Identifier: Apache-2.0
"""What is known of one C++ program while it runs: its symbols, and what was made of them so far.

A scope at run time is a `ModuleValue`: its record holds the variables of a namespace, or the static members of a class. So a function
sees the names of the very instance of a template that it belongs to.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, Final, final

from rosward.domain.heap import KIND, Obj
from rosward.domain.values import NONE, Class, Function, ModuleValue, Ref, Value
from rosward.ir.symbols import Scope, Symbol, Symbols

if TYPE_CHECKING:
    from rosward.engine.cpp.guess import Guess
    from rosward.engine.machine import Engine
    from rosward.location import Place

__all__ = ["INSTANCES", "Info", "Linked", "linked"]

ValueOf = Callable[["Engine", Any, tuple[Value, ...] | None], Value]
"""What a declaration that was found is, with these template arguments: a class, a value, functions."""

INSTANCES: Final = 400
"""How many instances of one class template are told apart."""


@final
class Info:
    """A class at run time: its symbol, the scope of its members, what its template parameters stand for, its bases and fields.

    `keys` says under which name each field stands in an object: two fields of one name in a class and its base are two. `clashing` are those that
    several of its bases have under one name, `doubled` those of a base that is there several times, and `hidden` those of which one is seen or
    another, as the object is declared. `references`: the fields that are references. `around`: names of the function that declares the class.
    `special`: members of this instance of a template alone. `shares`: it is, or has in it, a union. `open`: a template of which the arguments are
    not known yet (they follow from a constructor). `virtual`: its virtual bases, those of its bases, too.
    `elsewhere`: its arguments by the names that definitions of members elsewhere give them.
    """

    __slots__ = (
        "around",
        "bindings",
        "clashing",
        "cls",
        "doubled",
        "elsewhere",
        "env",
        "fields",
        "hidden",
        "keys",
        "open",
        "outer",
        "references",
        "scope",
        "shares",
        "special",
        "symbol",
        "types",
        "virtual",
    )

    def __init__(
        self,
        symbol: Symbol,
        outer: ModuleValue,
        env: ModuleValue,
        scope: Scope,
        types: tuple[Value, ...],
        bindings: dict[str, Value],
    ) -> None:
        self.symbol = symbol
        self.outer = outer
        self.env = env
        self.scope = scope
        self.types = types
        self.bindings = bindings
        self.around: dict[str, Value] = {}
        self.elsewhere: dict[str, Value] = {}
        self.shares = False
        self.clashing = frozenset[str]()
        self.doubled = frozenset[str]()
        self.hidden = frozenset[str]()
        self.special: dict[str, list[Symbol]] = {}
        self.open = False
        self.fields: tuple[Symbol, ...] = ()
        self.keys: dict[str, str] = {}
        self.references = frozenset[str]()
        self.cls: Class | None = None
        self.virtual: tuple[Value, ...] = ()

    def argument(self, number: int) -> Value | None:
        """What the parameter of the template at this place stands for."""
        own = self.symbol.template or ()
        if number >= len(own):
            return None
        return self.bindings.get(own[number].name) if own[number].name else next(iter(self.types[number:]), None)


class Unaware:
    """What was spent in functions that know nothing of ROS (`unaware.py`): `before` by calls that are over, `since` one that is running began.

    `large`: the code of those of which a call took many steps. `left`: what was handed to calls that were not followed, and came of them; where.
    """

    __slots__ = ("before", "large", "left", "since")

    def __init__(self) -> None:
        self.before = 0
        self.since: int | None = None
        self.large: set[str] = set()
        self.left: dict[Ref, Place] = {}

    def spent(self, steps: int) -> int:
        """How much that is, where the process has taken so many steps."""
        return self.before + (0 if self.since is None else steps - self.since)


@final
class Linked:
    """A program and its classes, functions and scopes; none of it depends on what the program does."""

    __slots__ = (
        "buffers",
        "clashes",
        "constants",
        "constructing",
        "declared",
        "effort",
        "enumerations",
        "evaluating",
        "fields",
        "firsts",
        "fixed",
        "found",
        "functions",
        "guess",
        "hiding",
        "infos",
        "instances",
        "scopes",
        "special",
        "symbols",
        "templates",
        "unsure",
        "used",
        "value_of",
    )

    def __init__(self, symbols: Symbols, value_of: ValueOf) -> None:
        self.symbols = symbols
        self.value_of = value_of
        self.scopes: dict[int, Scope] = {}
        self.clashes = False  # whether any class has fields of one name from several bases
        self.hiding: dict[tuple[int, str], bool] = {}  # which classes hide functions of their bases
        self.infos: dict[int, Info] = {}  # by the address of the class, which is that of its scope
        self.instances: dict[str, int] = {}  # how many of each template there are
        self.functions: dict[tuple[str, int], Function] = {}
        self.declared: dict[str, Symbol] = {}  # functions, by the key of their code, or of what stands for that
        self.effort = Unaware()
        self.special: dict[
            tuple[str, int], tuple[Symbol, ...]
        ] = {}  # specialisations of a function, by its code and scope
        self.templates: dict[str, Symbol] = {}  # templates of functions, by their code
        self.unsure: set[str] = set()  # the code of functions that the preprocessor may leave out
        self.constants: dict[tuple[str, int], Value] = {}
        self.buffers: set[tuple[int, str]] = set()  # arrays of characters, by class or scope and name
        self.fixed: set[tuple[int, str]] = set()  # variables that are constants, by scope and name
        self.firsts: dict[
            tuple[str, int], tuple[Value, tuple[tuple[int, Obj], ...]]
        ] = {}  # the values of constants, with the objects that were made for them
        self.fields: dict[tuple[int, str], Value] = {}  # the types of fields, by class and the name in its objects
        self.enumerations: dict[str, bool] = {}  # which types are enumerations
        self.evaluating: set[tuple[str, int]] = set()
        self.guess: Guess | None = None  # that which is being followed
        self.constructing: list[
            tuple[int, Class]
        ] = []  # objects whose constructors run, with the class that they are as yet
        self.used: dict[str, Scope | None] = {}  # what each `using namespace` names
        self.found: dict[tuple[int, str, str | int], object] = {}  # what names stand for: of a scope, of an operation

    def namespace(self, machine: Engine, scope: Scope, file: str = "") -> ModuleValue:
        """The scope of a namespace."""
        address = machine.place_key(("namespace", scope))
        self.scopes[address] = scope
        return ModuleValue(address, ".".join(n for n in scope if n), file)

    def scope_of(self, env: ModuleValue) -> Scope:
        """The names around what stands in a scope."""
        return self.scopes.get(env.address, ())

    def info(self, value: Value) -> Info | None:
        """The class of a class value or scope; None for a namespace, or a class of another language."""
        return self.infos.get(value.address) if isinstance(value, (Class, ModuleValue)) else None

    def members(self, info: Info, name: str) -> Sequence[Symbol]:
        """What a class declares under a name: in an unnamed namespace of a source, not what one of its name in another source does."""
        found, unit = self.symbols.at(info.scope, name), info.symbol.unit
        return [s for s in found if s.unit in ("", unit)] if unit else found

    def class_of(self, machine: Engine, ref: Ref) -> Value:
        """The class of an object: of one whose constructor runs, that of the constructor."""
        for address, cls in reversed(self.constructing):
            if address == ref.address:
                return cls
        return machine.part(ref, KIND).cls

    def key_in(self, machine: Engine, ref: Ref, seen: Info, name: str) -> str | None:
        """Under which name an object has a field, as a class of it sees it; None where it has no such field."""
        key = seen.keys.get(name)
        whole = self.info(machine.part(ref, KIND).cls) if key is not None else None
        if key is None or whole is None or key not in whole.clashing:
            return key
        for cls in seen.cls.mro if seen.cls is not None else ():
            own = self.info(cls)
            if own is not None and any(f.name == name for f in own.fields):
                return f"{key} of {own.env.name}"
        return key

    def bases_to_make(self, ref: Ref, info: Info) -> tuple[Value, ...]:
        """The bases that a constructor makes of an object: virtual ones first, but only where the object is of no further class."""
        assert info.cls is not None
        if not info.virtual:
            return info.cls.bases
        whole = next((cls for address, cls in self.constructing if address == ref.address), info.cls)
        others = tuple(base for base in info.cls.bases if base not in info.virtual)
        return (*info.virtual, *others) if whole == info.cls else others


def linked(machine: Engine) -> Linked:
    """The program that runs."""
    return machine.linked  # type: ignore[return-value]  # of which only C++ makes use


def record(machine: Engine, address: int) -> Obj:
    """What a scope holds."""
    found = machine.own(address)
    return found if found is not None else Obj("module", NONE)
