# SPDX-License-Identifier: Apache-2.0
"""Abstract values: immutable, normalised, compared by content.

Law: every class is final; what is mutable in the program lives on the heap and is here a `Ref` (or `Class`, `ModuleValue`) with an address.
Values that the program computed from a default (of a parameter, an argument, the environment) carry their `origins`.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final, final

from rosward.domain.unknown import NO_ORIGINS, Origins, Reason
from rosward.records import NamedTuple

if TYPE_CHECKING:
    from rosward.ir.program import Code
    from rosward.location import Place

Plain = None | bool | int | float | complex | str | bytes


class Value:
    """What a register, an attribute or an element can hold.

    Those that keep their hash are copied to another process by what they are made of: there a text has another hash.
    """

    __slots__ = ()


Reduced = tuple[type, tuple[object, ...]]


_PLAIN_HASH: Final = 1 << 60


def is_nan(value: Plain) -> bool:
    """Whether it is the one constant that Python says is not equal to itself."""
    return value != value  # noqa: PLR0124


def _hash_of(value: Plain) -> int:
    """The hash of a constant. Python's own has one value for endlessly many numbers, so that a dict of such numbers would take for ever."""
    if is_nan(value):
        return hash((value.__class__, "nan"))
    if value.__class__ is int and not -_PLAIN_HASH < value < _PLAIN_HASH:
        return hash((int, hex(value)))
    if value.__class__ is float and not -_PLAIN_HASH < value < _PLAIN_HASH:
        return hash((float, repr(value)))
    if value.__class__ is complex:
        return hash((complex, repr(value)))
    return hash((value.__class__, value))


@final
class Const(Value):
    """A constant of Python: None, bool, int, float, complex, str, bytes. As a value NaN is one, although Python says that none equals another."""

    __slots__ = ("_hash", "origins", "value")

    def __init__(self, value: Plain, origins: Origins = NO_ORIGINS) -> None:
        self.value = value
        self.origins = origins
        self._hash = hash(value) if value.__class__ is str else _hash_of(value)

    def __eq__(self, other: object) -> bool:
        return self is other or (
            other.__class__ is Const
            and self._hash == other._hash
            and self.value.__class__ is other.value.__class__
            and (self.value == other.value or (is_nan(self.value) and is_nan(other.value)))
            and self.origins == other.origins
        )

    def __hash__(self) -> int:
        return self._hash

    def __reduce__(self) -> Reduced:
        return Const, (self.value, self.origins)

    @property
    def is_settled(self) -> bool:
        """Whether it is no mere default, in the place of which another value of its type may stand."""
        return not self.origins or all(origin.settled for origin in self.origins)

    def __repr__(self) -> str:
        return f"Const({self.value!r})" if not self.origins else f"Const({self.value!r}, {set(self.origins)})"


class Hole(NamedTuple):
    """The unknown part of a text. `shape` is '' (anything), 'word' (no `/`, not empty) or 'digits'."""

    reasons: tuple[Reason, ...]
    shape: str = ""


@final
class Text(Value):
    """A str of which a part is known: `parts` alternate text and holes; at least one hole and one non-empty text. See `text.make`."""

    __slots__ = ("_hash", "origins", "parts")

    def __init__(self, parts: tuple[str | Hole, ...], origins: Origins = NO_ORIGINS) -> None:
        self.parts = parts
        self.origins = origins
        self._hash = hash(tuple([p if p.__class__ is str else None for p in parts]))

    def __eq__(self, other: object) -> bool:
        return self is other or (
            other.__class__ is Text and self.parts == other.parts and self.origins == other.origins
        )

    def __hash__(self) -> int:
        return self._hash

    def __reduce__(self) -> Reduced:
        return Text, (self.parts, self.origins)

    def __repr__(self) -> str:
        return f"Text({''.join(p if isinstance(p, str) else '*' for p in self.parts)!r})"


@final
class Unknown(Value):
    """Any value, and why. `hint` is the Python type where that is known ('str', 'int', 'float', 'bool', 'list', 'dict', …), else ''.

    `variable` is the environment variable that it is the whole value of, as its reader found it; nothing that is computed from it has that.
    """

    __slots__ = ("_hash", "hint", "reasons", "variable")

    def __init__(self, reasons: tuple[Reason, ...], hint: str = "", variable: str = "") -> None:
        self.variable = variable
        self.reasons = reasons
        self.hint = hint
        self._hash = 0  # made when it is asked for: most are compared by their reasons only

    def __eq__(self, other: object) -> bool:
        return self is other or (
            other.__class__ is Unknown
            and self.hint == other.hint
            and self.reasons == other.reasons
            and self.variable == other.variable
        )

    def __hash__(self) -> int:
        found = self._hash
        if not found:
            found = self._hash = hash((self.reasons, self.hint)) or 1
        return found

    def __reduce__(self) -> Reduced:
        return Unknown, (self.reasons, self.hint, self.variable)

    def __repr__(self) -> str:
        return f"Unknown({self.hint}: {'; '.join(map(str, self.reasons))})"


@final
class Choice(Value):
    """One of several values: at least two options, none of them a Choice, at most one Unknown. Made by `choice.join` only."""

    __slots__ = ("_hash", "members", "options")

    def __init__(self, options: tuple[Value, ...], members: frozenset[Value] | None = None) -> None:
        self.options = options
        # The same, to ask whether one is among them.
        self.members: frozenset[Value] = frozenset(options) if members is None else members
        self._hash = hash(self.members)

    def __eq__(self, other: object) -> bool:
        return self is other or (
            other.__class__ is Choice and self._hash == other._hash and self.members == other.members
        )

    def __hash__(self) -> int:
        return self._hash

    def __reduce__(self) -> Reduced:
        return Choice, (self.options,)

    def __repr__(self) -> str:
        return f"Choice{self.options!r}"


@final
class Ref(Value):
    """An object on the heap: instance, list, dict, set, generator, …; what it is stands there."""

    __slots__ = ("address",)

    def __init__(self, address: int) -> None:
        self.address = address

    def __eq__(self, other: object) -> bool:
        return other.__class__ is Ref and self.address == other.address

    def __hash__(self) -> int:
        return self.address

    def __reduce__(self) -> Reduced:
        return Ref, (self.address,)

    def __repr__(self) -> str:
        return f"Ref({self.address})"


@final
class Class(Value):
    """A class made by a class statement; its attributes live on the heap at `address`.

    `mro` is its method resolution order (itself first), the external and builtin bases in it as `External` and `Native`.
    """

    __slots__ = ("address", "bases", "enumeration", "module", "mro", "name", "place", "qualname", "stub")

    def __init__(
        self,
        address: int,
        name: str,
        qualname: str,
        module: str,
        bases: tuple[Value, ...],
        mro: tuple[Value, ...],
        place: Place,
        stub: bool,
    ) -> None:
        self.address = address
        self.name = name
        self.qualname = qualname
        self.module = module
        self.bases = bases
        self.mro = (self, *mro)
        self.place = place
        self.stub = stub  # declared by a library model, not by the analysed sources
        self.enumeration: bool = (stub and module == "enum") or any(
            isinstance(b, Class) and b.enumeration for b in bases
        )

    @property
    def dotted(self) -> str:
        """`module.qualname`, as `External` names things."""
        return f"{self.module}.{self.qualname}"

    def __eq__(self, other: object) -> bool:
        return other.__class__ is Class and self.address == other.address

    def __hash__(self) -> int:
        return self.address

    def __reduce__(self) -> Reduced:
        told = (self.address, self.name, self.qualname, self.module, self.bases, self.mro[1:], self.place, self.stub)
        return Class, told

    def __repr__(self) -> str:
        return f"Class({self.module}.{self.qualname})"


@final
class ModuleValue(Value):
    """A module that was (or is being) run; its variables live on the heap at `address`."""

    __slots__ = ("address", "file", "name")

    def __init__(self, address: int, name: str, file: str) -> None:
        self.address = address
        self.name = name
        self.file = file

    def __eq__(self, other: object) -> bool:
        return other.__class__ is ModuleValue and self.address == other.address

    def __hash__(self) -> int:
        return self.address

    def __reduce__(self) -> Reduced:
        return ModuleValue, (self.address, self.name, self.file)

    def __repr__(self) -> str:
        return f"ModuleValue({self.name})"


@final
class Function(Value):
    """A function: its code, the module whose variables it sees, the addresses of its captured cells, its default values."""

    __slots__ = ("_hash", "cells", "code", "defaults", "effects", "kwdefaults", "module")

    def __init__(
        self,
        code: Code,
        module: ModuleValue,
        cells: tuple[int, ...],
        defaults: tuple[Value, ...],
        kwdefaults: tuple[tuple[str, Value], ...],
        effects: tuple[Value, ...] = (),
    ) -> None:
        self.code = code
        self.module = module
        self.cells = cells
        self.defaults = defaults
        self.kwdefaults = kwdefaults
        self.effects = effects  # what a model's decorators declare of it, innermost first
        self._hash = hash((code.key, cells))

    def __eq__(self, other: object) -> bool:
        return self is other or (
            other.__class__ is Function
            and self.code.key == other.code.key
            and self.module == other.module
            and self.cells == other.cells
            and self.defaults == other.defaults
            and self.kwdefaults == other.kwdefaults
        )

    def __hash__(self) -> int:
        return self._hash

    def __reduce__(self) -> Reduced:
        return Function, (self.code, self.module, self.cells, self.defaults, self.kwdefaults, self.effects)

    def __repr__(self) -> str:
        return f"Function({self.code.qualname})"


@final
class Unbound(Value):
    """What a variable holds before its first assignment."""

    __slots__ = ()

    def __reduce__(self) -> str:
        return "UNBOUND"

    def __repr__(self) -> str:
        return "UNBOUND"


UNBOUND: Final = Unbound()
NONE: Final = Const(None)
TRUE: Final = Const(True)
FALSE: Final = Const(False)
EMPTY: Final = Const("")
