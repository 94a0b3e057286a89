# SPDX-License-Identifier: Apache-2.0
"""What a language with declarations declares: the names of a program by scope, each with code that says what it is, lowered when asked for.

    namespace lamp { template <class T> struct Topic { static constexpr auto name = "a"; };  void on(const std::string & t = "x"); }
    lamp            Topic: class, template (T)        on: function, one parameter by const reference with a default
    lamp::Topic     name: variable, static

A *thunk* is the code of a function without parameters that returns what is asked for (an initial value, a type); of a template, its parameters
are those of the template.
"""

from __future__ import annotations

import enum
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Protocol

from rosward.ir.program import Code, ParameterSymbol, Scope, Signature, TemplateParameter, TypePattern
from rosward.records import NamedTuple

__all__ = [
    "BaseSymbol",
    "Marked",
    "ParameterSymbol",
    "Scope",
    "Signature",
    "Symbol",
    "SymbolKind",
    "Symbols",
    "TemplateParameter",
    "TypePattern",
]

if TYPE_CHECKING:
    from rosward.location import Place


class SymbolKind(enum.Enum):
    """What is declared."""

    CLASS = "class"
    ENUM = "enum"
    ENUMERATOR = "enumerator"
    FUNCTION = "function"
    VARIABLE = "variable"
    ALIAS = "alias"
    USING = "using"
    USING_NAMESPACE = "using namespace"
    NAMESPACE_ALIAS = "namespace alias"


class BaseSymbol(NamedTuple):
    """A base of a class: a thunk of its type. `pack`: it returns several."""

    type: Code
    pack: bool = False
    virtual: bool = False


class Marked(NamedTuple):
    """What the attributes of a declaration say, by their names; `is_scope`: a class or namespace, of all that is in it."""

    words: Mapping[str, tuple[str, ...]]
    place: Place
    is_scope: bool = False
    parameters: tuple[str, ...] = ()


class Symbol(Protocol):
    """One declaration; of a function, all declarations and the definition together: defaults and marks of the one, the body of the other.
    One that is deleted is not there. What is expensive to know is computed when it is asked for; the same object for the same text of a file."""

    @property
    def kind(self) -> SymbolKind:
        """What it is."""

    @property
    def scope(self) -> Scope:
        """Where it is declared."""

    @property
    def name(self) -> str:
        """As it is written; a destructor with its `~`, an operator as `operator==`, a conversion as `operator bool`."""

    @property
    def key(self) -> str:
        """What names it for good."""

    @property
    def unit(self) -> str:
        """The file that may see it where it is of internal linkage, else ''."""

    @property
    def place(self) -> Place:
        """Where it stands."""

    @property
    def sure(self) -> bool:
        """Whether it is surely there, whatever the preprocessor decides."""

    @property
    def defined(self) -> bool:
        """A class or function with its body."""

    @property
    def static(self) -> bool:
        """A static member; for a class or enum that does not matter."""

    @property
    def constant(self) -> bool:
        """A variable that is `const` or `constexpr`, a member function of constant objects."""

    @property
    def virtual(self) -> bool:
        """`virtual`, `override` or `final`."""

    @property
    def explicit(self) -> bool:
        """A constructor that converts nothing by itself."""

    @property
    def enumeration(self) -> str:
        """Of an enumerator, the dotted name of its enumeration; '' where that has none."""

    @property
    def template(self) -> tuple[TemplateParameter, ...] | None:
        """The parameters of the innermost template that it is; None where it is none. An empty tuple: `template <>`."""

    @property
    def specialises(self) -> tuple[TypePattern, ...] | None:
        """What a specialisation is for: `template <> struct Topic<Imu>`."""

    @property
    def tested(self) -> tuple[Code | None, ...]:
        """For each of these a thunk, whose parameters are those of the template, where it may say more than its pattern; else None."""

    @property
    def instance(self) -> tuple[TypePattern, ...]:
        """Of a member of a single instance of a template, what that is made of: `template <> int Box<Imu>::size()`."""

    @property
    def inner(self) -> Scope:
        """Of a class or enum: the scope of its members; that of a specialisation is its own."""

    @property
    def target(self) -> Scope:
        """Of a `using`, `using namespace` or alias of a namespace: the names as they are written, '' first where they begin with `::`."""

    @property
    def code(self) -> Code | None:
        """A function: its body, None where it has none. A variable: a thunk of its first value, None without; of a field that is not static,
        with `this`. An enumerator: a thunk of its value (of the one before plus one). An alias: a thunk of its type. A `using` in a class:
        a thunk of the class that it names a member of."""

    @property
    def type(self) -> Code | None:
        """A variable: a thunk of its type; a function: of its return type. None for `auto` and constructors."""

    @property
    def reference(self) -> bool:
        """A variable that is a reference; a function that returns one; an alias of one."""

    @property
    def pattern(self) -> TypePattern:
        """Of a variable or alias, the type as it is written."""

    @property
    def overlaps(self) -> bool:
        """A field that shares its storage with others, of a union."""

    @property
    def parameters(self) -> tuple[ParameterSymbol, ...]:
        """Those of a function, `this` left out."""

    @property
    def bases(self) -> tuple[BaseSymbol, ...]:
        """Those of a class, in their order."""

    @property
    def members(self) -> Sequence[Symbol]:
        """What a class declares, in its order: fields, functions, classes, aliases."""

    @property
    def marks(self) -> Mapping[str, tuple[str, ...]]:
        """The attributes `[[rosward::mark("word")]]` of a model: each with its words."""


class Symbols(Protocol):
    """The names of a program."""

    def at(self, scope: Scope, name: str) -> Sequence[Symbol]:
        """What a scope declares under a name, over all files of the program, in their order; declarations before definitions elsewhere."""

    def of_instances(self, scope: Scope) -> Mapping[str, Sequence[Symbol]]:
        """The members that single instances of a class template have instead of those of all: `template <> int Box<Imu>::size()`."""

    def called(self, scope: Scope) -> Sequence[Sequence[str]]:
        """What members of a class template that are defined elsewhere call its parameters: `template<class U> void Box<U>::fill()`."""

    def used(self, scope: Scope) -> Sequence[Symbol]:
        """The `using namespace` of a scope."""

    def is_namespace(self, scope: Scope) -> bool:
        """Whether anything is declared in a namespace of that name."""

    def is_elsewhere(self, scope: Scope, name: str) -> bool:
        """Whether another namespace than this has functions of that name."""

    @property
    def unaware(self) -> Mapping[str, frozenset[Scope]]:
        """The files that know nothing of ROS, and keep nothing between two calls, unless they are handed something of these namespaces."""

    @property
    def digest(self) -> str:
        """What tells the program from one of other files, or of files that became something else."""

    @property
    def variables(self) -> Sequence[Symbol]:
        """The variables of namespaces, and static members, in the order in which a program gives them their first values."""

    @property
    def statics_used(self) -> Mapping[Scope, Sequence[str]]:
        """By the scope of a class template, the static members that whoever makes an object of it needs."""

    @property
    def derived(self) -> Sequence[Symbol]:
        """The classes that have a base and are no templates."""

    @property
    def registered(self) -> Mapping[str, tuple[Scope, str]]:
        """Where a macro registers a class for others to make by name, by what it says: the namespace and the file."""

    @property
    def main(self) -> Symbol | None:
        """The function `main`."""

    @property
    def marked(self) -> Mapping[str, Marked]:
        """The declarations with attributes that say how information flows, by dotted names; those of libraries as well that have no model."""
