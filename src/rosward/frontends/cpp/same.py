# SPDX-License-Identifier: Apache-2.0
"""Which declarations are the same function, or the same variable?

    struct Lamp { void on(int level = 1); void on(Mode m) const; };        void Lamp::on(int level) {…}     the first one
    extern int count;                                                      int count = 3;                   one variable

What is deleted is not there. Of a class that is defined, other declarations say nothing but the defaults of a template.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable, Iterator, Sequence
from typing import Final, TypeVar, final

from rosward.frontends.cpp.symbol import CppSymbol
from rosward.ir.symbols import SymbolKind, TypePattern

_OF_THIS: Final = frozenset({"this const", "this &", "this &&"})
_K = TypeVar("_K", bound=Hashable)


@final
class Merged:
    """The declarations that were found to be one, so that they are the same object in all programs."""

    def __init__(self) -> None:
        self._whole: dict[tuple[CppSymbol, ...], CppSymbol] = {}

    def one_each(self, declared: Sequence[CppSymbol]) -> Sequence[CppSymbol]:
        """The declarations of one name in one scope, each thing once."""
        if len(declared) == 1:
            return declared if "delete" not in declared[0].marks else ()
        found: list[CppSymbol] = []
        for kind, same in _grouped(_distinct(declared), lambda symbol: symbol.kind):
            if kind in {SymbolKind.CLASS, SymbolKind.ENUM}:
                for _, several in _grouped(same, lambda symbol: symbol.label):
                    whole = [s for s in several if s.defined]
                    found += [self.also(s, _giving_defaults(s, several)) for s in whole] or several[:1]
            elif kind is SymbolKind.FUNCTION:
                found += self._functions([s for s in same if "delete" not in s.marks])
            elif kind is SymbolKind.VARIABLE:
                for _, several in _grouped(same, lambda symbol: symbol.unit):
                    found += self._variables(several)
            else:
                found += same
        return found

    def _functions(self, declared: Sequence[CppSymbol]) -> Iterator[CppSymbol]:
        whole: list[CppSymbol] = []
        open_: list[CppSymbol] = []
        for symbol in declared:
            (whole if symbol.defined or _is_made_up(symbol) else open_).append(symbol)
        parts: dict[CppSymbol, list[CppSymbol]] = {s: [] for s in whole}
        rest: list[CppSymbol] = []
        for symbol in open_:
            same = _same_function(symbol, whole)
            if same:
                for each in same:
                    parts[each].append(symbol)
            else:
                rest.append(symbol)
        while rest:  # declared several times, defined nowhere
            first = rest.pop(0)
            same = _same_function(first, rest)
            rest = [s for s in rest if s not in same]
            parts[first] = list(same)
        for symbol in declared:
            if symbol in parts:
                yield self.also(symbol, parts[symbol])

    def _variables(self, declared: Sequence[CppSymbol]) -> Iterator[CppSymbol]:
        whole = [s for s in declared if _defines(s)]
        if not whole:
            yield self.also(declared[-1], declared[:-1])
        for symbol in whole:
            yield self.also(symbol, [s for s in declared if s not in whole])

    def also(self, symbol: CppSymbol, others: Sequence[CppSymbol]) -> CppSymbol:
        """A declaration, of which others say more."""
        if not others:
            return symbol
        key = symbol, *others
        found = self._whole.get(key)
        if found is None:
            found = self._whole[key] = symbol.with_others(tuple(others))
        return found


def _giving_defaults(symbol: CppSymbol, declared: Iterable[CppSymbol]) -> list[CppSymbol]:
    """The declarations of a template that is defined elsewhere, in which defaults of its parameters may stand."""
    if symbol.own is None:
        return []
    return [s for s in declared if not s.defined and s.own is not None and b"=" in (s.own.text or b"")]


def _grouped(symbols: Iterable[CppSymbol], key: Callable[[CppSymbol], _K]) -> list[tuple[_K, list[CppSymbol]]]:
    groups: dict[_K, list[CppSymbol]] = {}
    for symbol in symbols:
        groups.setdefault(key(symbol), []).append(symbol)
    return list(groups.items())


def _distinct(symbols: Sequence[CppSymbol]) -> Sequence[CppSymbol]:
    """Without those that say the same at the same place: of a file that is there as it is under several macros."""
    found: dict[tuple[str, int, bytes | None], CppSymbol] = {}
    for symbol in symbols:
        place = symbol.place
        found.setdefault((place.file, symbol.declared.node.start_byte, symbol.declared.node.text), symbol)
    return list(found.values())


def _defines(symbol: CppSymbol) -> bool:
    """Whether a variable is made where it is declared."""
    if symbol.owner is not None:
        return not symbol.static or not symbol.words.isdisjoint({"inline", "constexpr"})
    return "extern" not in symbol.words or symbol.declared.node.type == "init_declarator"


def _is_made_up(symbol: CppSymbol) -> bool:
    """Whether a friend is defined without a body: `friend bool operator==(const A &, const A &) = default`."""
    return symbol.declared.friend and "default" in symbol.marks


def _same_function(symbol: CppSymbol, others: Sequence[CppSymbol]) -> Sequence[CppSymbol]:
    """Those of the others that declare the same function."""
    own = symbol.parameters
    alike = [
        other
        for other in others
        if len(other.parameters) == len(own)
        and (other.template is None) == (symbol.template is None)
        and other.words & _OF_THIS == symbol.words & _OF_THIS
        and (other.declared.arguments is None) == (symbol.declared.arguments is None)
        and (not symbol.unit or not other.unit or symbol.unit == other.unit)
    ]
    exact = [
        other for other in alike if all(_same_type(a.type, b.type) for a, b in zip(own, other.parameters, strict=True))
    ]
    if exact or len(alike) != 1:
        return exact
    return alike  # one that writes its types in another way


def _same_type(one: TypePattern, other: TypePattern) -> bool:
    """Whether two types are the same, however much of their scope is written."""
    by_value = not one.pointers and not one.reference
    return (
        one.names[-1:] == other.names[-1:]
        and one.builtin == other.builtin
        and one.pointers == other.pointers
        and one.reference == other.reference
        and (by_value or one.const == other.const)
        and len(one.arguments) == len(other.arguments)
        and all(_same_type(a, b) for a, b in zip(one.arguments, other.arguments, strict=True))
    )
