# SPDX-License-Identifier: Apache-2.0
"""What does one declaration of C++ say, and what do the other declarations of the same function or variable add?

What costs something is computed when it is asked for: most declarations of most headers never are.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property, partial
from typing import TYPE_CHECKING, Final, Protocol, final

from rosward.frontends.cpp import patterns
from rosward.frontends.cpp.declarators import dense, inner, spelled, template_parameter_name
from rosward.frontends.cpp.lower import entry as lower
from rosward.frontends.cpp.marks import function_of, marks_of, receiver_in, words_of
from rosward.frontends.cpp.outline import CLASSES, Declared, enumeration_name, has_variables, is_scoped, local, members
from rosward.frontends.cpp.parse import Parsed
from rosward.frontends.cpp.patterns import arguments, has_const, parameter_nodes, parameters
from rosward.frontends.cpp.written import DefaultArgument, Written
from rosward.ir.symbols import (
    BaseSymbol,
    ParameterSymbol,
    Scope,
    Signature,
    Symbol,
    SymbolKind,
    TemplateParameter,
    TypePattern,
)
from rosward.location import Place

if TYPE_CHECKING:
    from tree_sitter import Node

    from rosward.ir.program import Code

_REFERENCES: Final = frozenset({"reference_declarator", "abstract_reference_declarator"})
_TYPED: Final = frozenset({SymbolKind.VARIABLE, SymbolKind.FUNCTION})
_SPACES: Final = frozenset({SymbolKind.USING_NAMESPACE, SymbolKind.NAMESPACE_ALIAS})
_NO_BASES: Final = frozenset({"access_specifier", "attribute_declaration", "virtual"})


class Home(Protocol):
    """The file of a symbol."""

    @property
    def parsed(self) -> Parsed:
        """Its text and tree."""

    @property
    def text(self) -> str:
        """What names its text for good."""

    def linkage(self, symbol: CppSymbol) -> str:
        """The file that alone may see a symbol, or ''."""

    def member(self, declared: Declared, of: CppSymbol | None) -> CppSymbol:
        """The symbol of what a class declares."""

    def local(self, declared: Declared) -> CppSymbol:
        """The symbol of a class or enum that a function body declares, which is found from now on."""

    def in_class(self, symbol: CppSymbol) -> bool:
        """Whether what is written with a scope before its name is a member of a class, not of a namespace."""


_APART: Final = "apart"
"""The mark of a method whose calls share a context."""


@final
class CppSymbol:
    """See `ir.symbols.Symbol`. `owner` is the class that it is declared in, `own` the list of parameters of the template that it is itself,
    `others` are the other declarations of the same.
    """

    def __init__(
        self,
        home: Home,
        declared: Declared,
        scope: Scope,
        own: Node | None,
        owner: CppSymbol | None = None,
        others: tuple[CppSymbol, ...] = (),
    ) -> None:
        self.declared = declared
        self.kind = declared.kind
        self.scope = scope
        self.name = declared.name
        self.defined = declared.defined
        self.sure = not declared.choices
        self.owner = owner
        self.own = own
        self.others = others
        self._home = home

    def __repr__(self) -> str:
        return f"<{self.kind.value} {'::'.join(self.inner)} at {self.place.file}:{self.place.line}>"

    def with_others(self, others: tuple[CppSymbol, ...]) -> CppSymbol:
        """The same, which these declare as well."""
        return CppSymbol(self._home, self.declared, self.scope, self.own, self.owner, others)

    @cached_property
    def key(self) -> str:
        """What names it for good."""
        return f"{self._home.text}:{self.declared.node.start_byte}:{self.kind.name}"

    @cached_property
    def place(self) -> Place:
        """Where it stands."""
        return self._home.parsed.place(self.declared.node)

    @cached_property
    def unit(self) -> str:
        """The file that may see it where it is of internal linkage, else ''."""
        return self._home.linkage(self)

    @property
    def label(self) -> str:
        """Its name, with what it specialises."""
        return self.declared.label

    @property
    def inner(self) -> Scope:
        """The scope of what is in it."""
        return (*self.scope, self.declared.label)

    @cached_property
    def target(self) -> Scope:
        """What a `using` or alias of a namespace names."""
        node: Node | None = None
        if self.kind is SymbolKind.USING:
            node = self.declared.node
        elif self.kind in _SPACES and self.declared.node.named_children:
            node = self.declared.node.named_children[-1]
        if node is None:
            return ()
        if node.type == "nested_namespace_specifier":
            names = tuple(dense(node).split("::"))
        else:
            parts = spelled(node)
            names = (*("",) * parts.absolute, *(part.name for part in parts.scope), parts.last.name)
        return names

    # Words

    @cached_property
    def words(self) -> frozenset[str]:
        """The specifiers of this declaration and the others."""
        own = words_of(self.declared.whole, self.function if self.kind is SymbolKind.FUNCTION else None)
        return own.union(*(other.words for other in self.others))

    @property
    def static(self) -> bool:
        """A static member."""
        return "static" in self.words

    @property
    def virtual(self) -> bool:
        """`virtual`, `override` or `final`."""
        return not self.words.isdisjoint({"virtual", "override", "final"})

    @cached_property
    def constant(self) -> bool:
        """`const` or `constexpr`: the variable, not what it points to; a member function with `const` behind its parameters."""
        if self.kind is SymbolKind.FUNCTION:
            return "this const" in self.words
        if self.kind is SymbolKind.ENUMERATOR or not self.words.isdisjoint({"constexpr", "constinit"}):
            return True
        node: Node | None = self.declared.node
        while node is not None and node.type == "init_declarator":
            node = inner(node)
        if node is not None and node.type == "pointer_declarator":
            return any(child.type == "type_qualifier" and child.text == b"const" for child in node.children)
        return self.kind is SymbolKind.VARIABLE and has_const(self.declared.whole)

    @property
    def explicit(self) -> bool:
        """A constructor that converts nothing by itself."""
        return "explicit" in self.words

    @property
    def enumeration(self) -> str:
        """Of an enumerator, the dotted name of its enumeration; '' where that has none."""
        listed = self.declared.node.parent if self.kind is SymbolKind.ENUMERATOR else None
        node = listed.parent if listed is not None else None
        name = enumeration_name(node) if node is not None else ""
        if node is None or not name:
            return ""
        scope = self.scope if is_scoped(node) else (*self.scope, name)
        return ".".join(scope)

    @cached_property
    def marks(self) -> Mapping[str, tuple[str, ...]]:
        """The attributes of a model, and `default`, `delete`, `abstract` for `= default`, `= delete`, `= 0`."""
        found: dict[str, tuple[str, ...]] = {}
        for other in self.others:
            found.update(other.marks)
        found.update(marks_of(self.declared.node, self.declared.whole))
        return found

    @cached_property
    def reference(self) -> bool:
        """A variable that is a reference; a function that returns one; an alias of one."""
        for child in self.function.children if self.function is not None else ():
            if child.type == "trailing_return_type" and child.named_children:
                trailing = child.named_children[0].child_by_field_name("declarator")
                return trailing is not None and trailing.type in _REFERENCES
        if self.kind is SymbolKind.ALIAS:
            return bool(self.pattern.reference)
        node = self._declarator
        while node is not None and node != self.function:
            if node.type in _REFERENCES:
                return True
            node = inner(node)
        return False

    @cached_property
    def pattern(self) -> TypePattern:
        """The type of a variable or alias as it is written."""
        return patterns.declared(self.declared.whole, self.declared.node)

    @cached_property
    def overlaps(self) -> bool:
        """A field that shares its storage with others, of a union. A class without a name is a part of what is around it."""
        node = self.declared.node.parent
        while node is not None and node.type != "union_specifier":
            if node.type in CLASSES and (node.child_by_field_name("name") is not None or has_variables(node)):
                return False
            node = node.parent
        return node is not None

    # Templates

    @cached_property
    def template(self) -> tuple[TemplateParameter, ...] | None:
        """The parameters of the template that it is; None where it is none. An empty tuple: `template <>`. Defaults stand in any declaration."""
        own = self._own_template
        if own is None or not self.others:
            return own
        others = [t for other in self.others if (t := other.template) is not None and len(t) == len(own)]
        given = [[p.default for p in same if p.default is not None] for same in zip(own, *others, strict=True)]
        return tuple([p._replace(default=found[0]) if found else p for p, found in zip(own, given, strict=True)])

    @property
    def _own_template(self) -> tuple[TemplateParameter, ...] | None:
        if self.own is None:
            return None
        found: list[TemplateParameter] = []
        for node in self.own.named_children:
            default = node.child_by_field_name("default_type") or node.child_by_field_name("default_value")
            before = tuple(found)
            code = None if default is None else lower.lower_default(self.written, default, before)
            computed = _computed_type(node)
            type_ = None if computed is None else lower.lower_default(self.written, computed, before)
            name, pack = template_parameter_name(node), node.type.startswith("variadic")
            found.append(TemplateParameter(name, pack, code, type_))
        return tuple(found)

    @cached_property
    def specialises(self) -> tuple[TypePattern, ...] | None:
        """What a specialisation is for."""
        node = self.declared.arguments
        return None if node is None else arguments(node)

    @cached_property
    def tested(self) -> tuple[Code | None, ...]:
        """For each of these a thunk, where it may say more than its pattern: `std::enable_if_t<…>`, `decltype(…)`."""
        nodes = patterns.tested(self.declared.arguments)
        return tuple([None if n is None else lower.lower_default(self.written, n, self.template or ()) for n in nodes])

    @property
    def instance(self) -> tuple[TypePattern, ...]:
        """Of a member of a single instance of a template, what that is made of."""
        before = self.declared.before
        return arguments(before[-1].arguments) if before else ()

    # Code

    @cached_property
    def code(self) -> Code | None:
        """The body of a function, a thunk of a first value, of the type of an alias, of the class of a `using`."""
        if self.kind is SymbolKind.FUNCTION:
            return lower.lower_body(self.written, self.signature) if self.defined else None
        if self.kind in {SymbolKind.VARIABLE, SymbolKind.ENUMERATOR}:
            own = lower.lower_initial(self.written, self.template or ())
            return own or next((code for other in self.others if (code := other.code) is not None), None)
        if self.kind is SymbolKind.ALIAS or (self.kind is SymbolKind.USING and self.owner is not None):
            return lower.lower_target(self.written, self.template or ())
        return None

    @cached_property
    def type(self) -> Code | None:
        """A thunk of the type of a variable, or of what a function returns."""
        return lower.lower_type(self.written, self.template or ()) if self.kind in _TYPED else None

    @cached_property
    def parameters(self) -> tuple[ParameterSymbol, ...]:
        """Those of a function, `this` left out."""
        own = parameters(self.function)
        if not self.others:
            return own
        return tuple(
            p if d is None or p.default else p._replace(default=True) for p, d in zip(own, self.defaults, strict=True)
        )

    @cached_property
    def defaults(self) -> tuple[DefaultArgument | None, ...]:
        """The default of each parameter, in whichever declaration it stands."""
        found: list[DefaultArgument | None] = [None] * len(parameters(self.function))
        for each in (self, *self.others):
            for index, node in enumerate(parameter_nodes(each.function)[: len(found)]):
                value = None if node is None else node.child_by_field_name("default_value")
                if value is not None and found[index] is None:
                    found[index] = DefaultArgument(each._home.parsed, value)
        return tuple(found)

    @cached_property
    def signature(self) -> Signature:
        """How the registers of a function are filled."""
        given = self.parameters, self.leading, self.template or (), self.reference, (), (), self.constant
        return Signature(*given, apart=bool(self.leading) and _APART in self.marks, receiver=receiver_in(self.words))

    @cached_property
    def leading(self) -> int:
        """1 for what has `this`: a member function, the first value of a field."""
        if self.declared.friend or self.kind not in _TYPED or self.static:
            return 0
        is_member = self.owner is not None or any(other.owner is not None for other in self.others)
        return int(is_member or (bool(self.declared.before) and self._home.in_class(self)))

    # Classes

    @cached_property
    def bases(self) -> tuple[BaseSymbol, ...]:
        """Those of a class, in their order."""
        clause = next((c for c in self.declared.node.children if c.type == "base_class_clause"), None)
        return () if clause is None else tuple(self._bases(clause))

    def _bases(self, clause: Node) -> Iterator[BaseSymbol]:
        virtual = False
        for child, following in zip(clause.children, [*clause.children[1:], None], strict=True):
            if child.type in {"virtual", ","}:
                virtual = child.type == "virtual"
            elif child.is_named and child.type not in _NO_BASES:
                pack = following is not None and following.type == "..."
                yield BaseSymbol(lower.lower_base(self.written, child, self.template or ()), pack, virtual)

    @cached_property
    def members(self) -> Sequence[CppSymbol]:
        """What a class or enum declares, in its order."""
        return [self._home.member(each, self) for each in members(self._home.parsed, self.declared)]

    @cached_property
    def named_members(self) -> Mapping[str, Sequence[CppSymbol]]:
        """The same by name."""
        found: dict[str, list[CppSymbol]] = {}
        for member in self.members:
            found.setdefault(member.name, []).append(member)
        return found

    # What they are made of

    @cached_property
    def written(self) -> Written:
        """What lowering gets."""
        scope = (*self.scope, f"{self.name}()")
        return Written(
            self._home.parsed,
            self.declared,
            self._home.text,
            self.own,
            self.leading,
            self.defaults if self.kind is SymbolKind.FUNCTION else (),
            partial(self._local, scope),
        )

    def _local(self, scope: Scope, node: Node) -> Symbol | None:
        found = local(self._home.parsed, node, scope)
        return None if found is None else self._home.local(found)

    @property
    def _declarator(self) -> Node | None:
        """The declarator: of a function the one with which its return type goes."""
        is_function = self.kind is SymbolKind.FUNCTION
        return self.declared.whole.child_by_field_name("declarator") if is_function else self.declared.node

    @cached_property
    def function(self) -> Node | None:
        """The declarator with the parameters of a function."""
        return function_of(self._declarator) if self.kind is SymbolKind.FUNCTION else None


def _computed_type(node: Node) -> Node | None:
    """The type of a parameter of a template that is a value, where that has arguments."""
    is_value = node.type in {"parameter_declaration", "optional_parameter_declaration"}
    type_ = node.child_by_field_name("type") if is_value else None
    return type_ if type_ is not None and b"<" in (type_.text or b"") else None
