# SPDX-License-Identifier: Apache-2.0
"""Where does a name live: in a register, in a cell, in a class body or in the module?

    def outer():          x is captured by `inner`: a cell of `outer`, a free cell of `inner`
        x = y = 1         y is a register of `outer`
        def inner():
            return x + z  z is a global

A `Scope` is what Python calls a block. Comprehensions and the scopes of type parameters are INLINE: they have variables
of their own but no code of their own; their variables are registers or cells of the code around them, their `owner`.
"""

from __future__ import annotations

import ast
import enum
from typing import Final, final

from rosward.ir.ops import NO_REGISTER
from rosward.records import NamedTuple

CLASS_CELL: Final = "__class__"


class ScopeKind(enum.Enum):
    """What opens a scope."""

    MODULE = "module"
    FUNCTION = "function"
    CLASS = "class"
    INLINE = "inline"


class PlaceKind(enum.Enum):
    """Where a variable is kept."""

    REGISTER = "register"
    CELL = "cell"
    GLOBAL = "global"
    NAME = "name"


class VariablePlace(NamedTuple):
    """A variable's place; `number` is the register, or the cell (for NAME the one to look in next, or NO_REGISTER)."""

    kind: PlaceKind
    number: int


@final
class Scope:
    """The names of one block, filled by `symbols`; complete after `link`."""

    __slots__ = (
        "at_once",
        "bound",
        "captured",
        "cells",
        "free",
        "given",
        "global_names",
        "in_function",
        "is_generator",
        "kind",
        "nonlocal_names",
        "owner",
        "parent",
        "places",
        "private",
        "registers",
        "sees_class",
        "used",
        "walrus",
    )

    def __init__(self, kind: ScopeKind, parent: Scope | None, private: str, *, sees_class: bool = False) -> None:
        self.kind = kind
        self.parent = parent
        self.owner: Scope = parent.owner if kind is ScopeKind.INLINE and parent is not None else self
        self.private = private  # the class name that `__x` is mangled with, or ''
        self.in_function: bool = kind is ScopeKind.FUNCTION or (parent is not None and parent.in_function)
        self.sees_class = sees_class  # an INLINE scope right in a class body that sees the names of the class
        self.bound: dict[str, None] = {}
        self.used: dict[str, None] = {}
        self.global_names: set[str] = set()
        self.nonlocal_names: dict[str, ast.Nonlocal] = {}
        self.walrus: dict[str, int] = {}  # of an owner: names assigned by `:=`, how often
        self.is_generator = False
        self.at_once = False  # of a generator expression that is used up, or dropped, by the call that it stands in
        self.given: list[str] = []  # of such a one: the variables around it whose values it is given
        self.captured: dict[str, int] = {}  # variables of this scope that inner code captures: cell number in the owner
        self.cells: list[str] = []  # of an owner: its cells
        self.free: dict[str, int] = {}  # of an owner: what it captures, numbered from 0
        self.registers: dict[str, int] = {}
        self.places: dict[str, VariablePlace] = {}

    def mangle(self, name: str) -> str:
        """`__x` in class `C` is `_C__x`."""
        if not self.private or not name.startswith("__") or name.endswith("__") or "." in name:
            return name
        return f"_{self.private}{name}"

    def place(self, name: str) -> VariablePlace:
        """Where `name` (mangled) lives, seen from this scope."""
        found = self.places.get(name)
        if found is None:
            found = self.places[name] = self._resolve(name)
        return found

    def capture(self, name: str) -> int:
        """The cell that code right inside this scope captures `name` from."""
        definer, _ = find(self, name, inside=True)
        return NO_REGISTER if definer is None else self._cell(definer, name)

    def _cell(self, definer: Scope, name: str) -> int:
        owner = self.owner
        return definer.captured[name] if definer.owner is owner else len(owner.cells) + owner.free[name]

    def _resolve(self, name: str) -> VariablePlace:
        definer, _ = find(self, name)
        place = VariablePlace(PlaceKind.GLOBAL, NO_REGISTER)
        if definer is not None and name in definer.captured:
            place = VariablePlace(PlaceKind.CELL, self._cell(definer, name))
        elif definer is not None:
            place = VariablePlace(PlaceKind.REGISTER, definer.registers[name])
        if self.kind is ScopeKind.INLINE and self.sees_class and self.parent is not None and definer is not self:
            return self.parent.place(name)
        if self.kind is ScopeKind.CLASS and name not in self.global_names and name not in self.nonlocal_names:
            return VariablePlace(PlaceKind.NAME, place.number if place.kind is PlaceKind.CELL else NO_REGISTER)
        return place


def find(scope: Scope, name: str, *, inside: bool = False) -> tuple[Scope | None, list[Scope]]:
    """The scope whose variable `name` is (None: the module's, or a class body's own), and who has to capture it.

    These are the owners between the two. With `inside`, as code right inside `scope` sees it: past the names of a
    class body.
    """
    crossed: list[Scope] = []
    at: Scope | None = scope
    while at is not None and at.kind is not ScopeKind.MODULE:
        if at.kind is ScopeKind.CLASS:
            if at is scope and not inside:
                if name in at.global_names or (name in at.bound and name not in at.nonlocal_names):
                    return None, crossed
            elif name == CLASS_CELL:
                return at, crossed
            crossed.append(at)
        else:
            if name in at.global_names:
                return None, crossed
            if name in at.bound and name not in at.nonlocal_names:
                return at, crossed
            if at.kind is ScopeKind.FUNCTION:
                crossed.append(at)
        at = at.parent
    return None, crossed


def defines(scope: Scope, name: str) -> bool:
    """Whether a name that `scope` reads is one that the file binds, in a scope around."""
    at: Scope | None = scope
    while at is not None:
        if name in at.bound and (at is scope or at.kind is not ScopeKind.CLASS):
            return True
        at = at.parent
    return False


def _give(scopes: list[Scope]) -> None:
    """Give generator expressions that are used up at once the values of the variables around them: nothing can change these meanwhile."""
    for scope in reversed(scopes):
        if scope.parent is not None and scope.parent.at_once:
            scope.parent.used.update((name, None) for name in scope.used if name not in scope.bound)
    for scope in scopes:
        for name in scope.used:
            definer, _ = find(scope, name)
            if definer is None or scope.parent is None or definer is scope or name == CLASS_CELL:
                continue
            if definer.kind is not ScopeKind.CLASS and definer.owner is scope.parent.owner:
                scope.given.append(name)
        scope.bound.update((name, None) for name in scope.given)


def link(scopes: list[Scope]) -> None:
    """Find out what is captured by whom, and number the cells. `scopes`: all of a file, outer ones first."""
    _give([scope for scope in scopes if scope.at_once])
    for scope in scopes:
        if scope.kind is ScopeKind.MODULE:
            continue
        own = scope.bound if scope.kind is not ScopeKind.CLASS else {}
        for name in scope.used:
            if name in own and name not in scope.nonlocal_names and name not in scope.global_names:
                continue
            definer, crossed = find(scope, name)
            if definer is not None and crossed:
                definer.captured[name] = NO_REGISTER
                for owner in crossed:
                    owner.free.setdefault(name, len(owner.free))
    for scope in scopes:
        cells = scope.owner.cells
        for name in scope.captured:
            scope.captured[name] = len(cells)
            cells.append(name if name not in cells else f"{name}.{len(cells)}")


def unresolved_nonlocal(scopes: list[Scope]) -> tuple[str, ast.Nonlocal] | None:
    """A `nonlocal` declaration without a variable to refer to, if there is one: such a file doesn't compile."""
    for scope in scopes:
        for name, node in scope.nonlocal_names.items():
            if scope.kind is ScopeKind.MODULE or find(scope, name)[0] is None:
                return name, node
    return None
