# SPDX-License-Identifier: Apache-2.0
"""Which of several functions that take the same types is meant: that for lvalues, for constants, or for what may be moved from?

void set(const std::string & s);  void set(std::string && s);      set(name): the first; set("x"), set(std::move(name)): the second
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Final, Literal, TypeVar

from rosward.domain.compound import Tuple
from rosward.domain.slots import Overloads, Slot
from rosward.domain.values import Choice, Function, Ref, Value
from rosward.engine.cpp.linked import Info, linked
from rosward.engine.running.frame import Frame
from rosward.ir.core import Binary, Compare
from rosward.ir.cpp import Argued, Assign, InvokeMember
from rosward.ir.program import TypePattern
from rosward.ir.symbols import Signature
from rosward.models.cpp.values.slots import read

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

__all__ = [
    "Category",
    "by_category",
    "cast_to",
    "class_cast_to",
    "for_object",
    "forwards",
    "numbers_written",
    "of_constness",
    "same_parameters",
    "undominated",
    "ways",
]

_T = TypeVar("_T")
Category = Literal["lvalue", "constant", "rvalue"]
_NEVER: Final = 0
_AS_CONSTANT: Final = 1
_EXACT: Final = 2


def by_category(
    machine: Engine, functions: list[Function], args: tuple[Value, ...], known: tuple[Category, ...]
) -> list[Function]:
    """Those of several functions that fit best what the arguments are, if that is not known yet; all where it cannot be known."""
    categories = known or _categories(machine, args)
    if categories is None:
        return functions
    scores = [(f, tuple(_fits(f, n, category) for n, category in enumerate(categories))) for f in functions]
    possible = [(f, score) for f, score in scores if _NEVER not in score] or scores
    left = undominated({score for _, score in possible}, _better)
    best = [f for f, score in possible if score in left]
    return best or [f for f, _ in possible]


def undominated(scores: set[_T], better: Callable[[_T, _T], bool]) -> set[_T]:
    """Those than which none is better: of forty functions nearly all fit equally well, so that there are few."""
    return {score for score in scores if not any(better(other, score) for other in scores)}


def _better(one: tuple[int | None, ...], other: tuple[int | None, ...]) -> bool:
    both = [(a, b) for a, b in zip(one, other, strict=True) if a is not None and b is not None]
    return any(a > b for a, b in both) and all(a >= b for a, b in both)


def numbers_written(machine: Engine, args: tuple[Value, ...]) -> tuple[str, ...]:
    """The types of numbers that the arguments of the call that runs have as they are written; none where there are none."""
    frame = machine.frames[-1] if machine.frames else None
    written = _written(frame, args) if frame is not None else None
    return tuple(argued.number for argued in written) if written and any(argued.number for argued in written) else ()


def cast_to(machine: Engine, args: tuple[Value, ...]) -> tuple[Value | None, ...]:
    """The types that casts say the arguments, or operands, have of the call that runs; none where there are none.

    `show(static_cast<const Base &>(lamp))` means the `show` of a Base, whatever the lamp is.
    """
    frame = machine.frames[-1] if machine.frames else None
    if frame is None or not frame.cast:
        return ()
    registers: tuple[int, ...]
    if isinstance(frame.op, (Binary, Compare)):
        registers = (frame.op.left, frame.op.right)
    elif isinstance(frame.op, Assign):
        registers = (frame.op.slot, frame.op.src)
    else:
        written = _written(frame, args)
        registers = () if written is None else tuple(argued.register for argued in written)
    if len(registers) != len(args) or any(
        read(machine, frame.registers[r]) is not read(machine, a) for r, a in zip(registers, args, strict=True)
    ):
        return ()
    found = tuple(frame.cast.get(register) for register in registers)
    return found if any(each is not None for each in found) else ()


def class_cast_to(machine: Engine, value: Value) -> Info | None:
    """The class that a cast says an object has of which the operation that runs takes an element, or that it calls or converts."""
    frame = machine.frames[-1] if machine.frames else None
    if frame is None or not frame.cast:
        return None
    op = frame.op
    own: list[int] = [getattr(op, name) for name in ("obj", "func", "src") if hasattr(op, name)]
    given = [each.register for each in getattr(op, "arguments", None) or () if isinstance(each, Argued)]
    for register in (*own, *given):
        cast = frame.cast.get(register)
        if cast is not None and read(machine, frame.registers[register]) is value:
            return linked(machine).info(cast)
    return None


def _categories(machine: Engine, args: tuple[Value, ...]) -> list[Category] | None:
    """What the arguments of the call are that runs; None where these are not the arguments."""
    if not machine.frames:
        return None
    frame = machine.frames[-1]
    written = _written(frame, args)
    if written is None:
        return None
    return [_category(machine, frame, argued, value) for argued, value in zip(written, args, strict=True)]


def _written(frame: Frame, args: tuple[Value, ...]) -> tuple[Argued, ...] | None:
    """The arguments as the operation has them that runs; None where these are not the arguments."""
    op = frame.op
    if isinstance(op, Assign):
        written: Sequence[object] = (Argued(op.slot, "slot"), Argued(op.src, op.kind))[-len(args) :]
    else:
        written = frame.initialising or getattr(op, "arguments", None) or ()
    spread = _each(frame, written)
    if not spread or len(spread) != len(args):
        return None
    if any(a.kind == "pack" or found is not value for (a, found), value in zip(spread, args, strict=True)):
        return None
    return tuple(argued for argued, _ in spread)


def _each(frame: Frame, written: Sequence[object]) -> list[tuple[Argued, Value]]:
    """Arguments and their values, with the items of packs; nothing where one is no argument."""
    found: list[tuple[Argued, Value]] = []
    for argued in written:
        if not isinstance(argued, Argued):
            return []
        value = frame.registers[argued.register]
        if argued.kind == "pack" and isinstance(value, Tuple):
            found += [(argued._replace(kind=argued.items), item) for item in value.items]
        else:
            found.append((argued, value))
    return found


def ways(machine: Engine, functions: Sequence[Function], args: tuple[Value, ...]) -> list[tuple[Category, ...]]:
    """What the arguments may be, where one of the functions takes whatever is given as what it is (`T &&`): a variable that may be constant,
    or not, is either; so is what a library makes an object of (`names.push_back(name)`). What is handed on may be anything where several calls
    are followed as one. Nothing where that does not count, or is not known.
    """
    if not machine.frames:
        return []
    frame = machine.frames[-1]
    written = _written(frame, args)
    if written is None:
        return []
    several = [_is_of_several(machine, argued, value) for argued, value in zip(written, args, strict=True)]
    if any(several):
        given = [_category(machine, frame, argued, value) for argued, value in zip(written, args, strict=True)]
        kinds: tuple[Category, ...] = ("lvalue", "constant", "rvalue")
        return [tuple(kind if s else each for each, s in zip(given, several, strict=True)) for kind in kinds]
    if not any(forwards(f, n) for f in functions for n in range(len(args))):
        return []
    found = tuple(_category(machine, frame, argued, value) for argued, value in zip(written, args, strict=True))
    making = linked(machine).constructing[-1:]
    is_inside = isinstance(frame.op, InvokeMember) and any(
        f.code.name == cls.name for _, cls in making for f in functions
    )
    unsure = [c == "lvalue" and (is_inside or not a.alterable) for a, c in zip(written, found, strict=True)]
    if not any(unsure):
        return [found]
    return [found, tuple("constant" if open_ else each for each, open_ in zip(found, unsure, strict=True))]


def forwards(function: Function, number: int) -> bool:
    """Whether a function takes an argument as what it is, whatever that is: by `T &&`, where no condition is set."""
    signature = function.code.signature
    if signature is None or not signature.template or number >= len(signature.parameters):
        return False
    free = frozenset(p.name for p in signature.template)
    if not _is_free(signature.parameters[number].type, free):
        return False
    return not any(p.type is not None or (p.default is not None and not p.name) for p in signature.template)


def _category(machine: Engine, frame: Frame, argued: Argued, value: Value) -> Category:
    if argued.kind == "slot":
        return "lvalue"
    if argued.kind == "constant":
        return "constant"
    if argued.kind == "forwarded":
        return _as_given(machine, value)
    if argued.kind == "result" and (isinstance(value, Slot) or (isinstance(value, Ref) and value != frame.handed)):
        return "lvalue"  # of a function that returns a reference
    return "rvalue"


def _is_of_several(machine: Engine, argued: Argued, value: Value) -> bool:
    """Whether `std::forward<T>(x)` gives what several calls were given, each of which may be of another category."""
    return argued.kind == "forwarded" and (machine.precision.coarse or isinstance(value, Choice))


def _as_given(machine: Engine, value: Value) -> Category:
    """What `std::forward<T>(x)` gives: what the argument was to the first of the calls that hand it on."""
    frames = machine.frames
    for inner, frame in zip(reversed(frames), reversed(frames[:-1]), strict=False):
        is_new = value in inner.found or not isinstance(value, (Slot, Ref))
        looked_for = read(machine, value) if is_new else value
        given = _each(frame, getattr(frame.op, "arguments", None) or ())
        argued = next((each for each, found in given if found == looked_for), None)
        if argued is None or argued.kind == "pack":
            return "rvalue" if is_new else "lvalue"
        if argued.kind == "constant":
            return "constant"
        if is_new:
            return "rvalue"
        if argued.kind != "forwarded":
            is_lent = argued.kind == "slot" or (argued.kind == "result" and value != frame.handed)
            return "lvalue" if is_lent else "rvalue"
    return "lvalue" if isinstance(value, (Slot, Ref)) else "rvalue"


def _fits(function: Function, number: int, category: Category) -> int | None:
    """How well a reference takes an argument; None of what is no reference, which takes each as well."""
    signature = function.code.signature
    if signature is None or number >= len(signature.parameters):
        return None
    type_ = signature.parameters[number].type
    if not type_.reference:
        return None
    if _is_free(type_, frozenset(p.name for p in signature.template)):
        return _AS_CONSTANT
    if type_.reference == "&&":
        return _EXACT if category == "rvalue" else _NEVER
    if type_.const and not type_.pointers:
        return _EXACT if category == "constant" else _AS_CONSTANT
    return _EXACT if category == "lvalue" else _NEVER if not type_.pointers else _AS_CONSTANT


def _is_free(type_: TypePattern, names: frozenset[str]) -> bool:
    """Whether `T &&` takes whatever is given."""
    return type_.reference == "&&" and len(type_.names) == 1 and type_.names[0] in names


def of_constness(several: Overloads, *, constant: bool) -> Overloads:
    """The functions that are for a constant object, or of two that differ in nothing else, the one for any other."""
    own = [f.code.signature for f in several.functions]
    if len(own) < 2 or not any(s is not None and s.constant for s in own) or all(s is None or s.constant for s in own):
        return several
    if constant:
        kept = [f for f, s in zip(several.functions, own, strict=True) if s is None or s.constant or not s.leading]
    else:
        others = [s for s in own if s is not None and not s.constant]
        kept = [
            f
            for f, s in zip(several.functions, own, strict=True)
            if s is None or not s.constant or not any(same_parameters(s, other) for other in others)
        ]
    return several.only(tuple(kept)) if kept else several


def for_object(several: Overloads, *, constant: bool, is_new: bool) -> Overloads:
    """The functions that are for such an object: what cannot be called for it is left out before one is preferred to another."""
    if constant:
        return _of_receiver(of_constness(several, constant=True), is_new=is_new)
    return of_constness(_of_receiver(several, is_new=is_new), constant=False)


def _of_receiver(several: Overloads, *, is_new: bool) -> Overloads:
    """Of functions with `&` and `&&` behind their parameters, those for an object that is new or moved, or for any other."""
    own = [f.code.signature for f in several.functions]
    if len(own) < 2 or not any(s is not None and s.receiver for s in own):
        return several
    moving = [s for s in own if s is not None and s.receiver == "&&"]
    kept = [f for f, s in zip(several.functions, own, strict=True) if s is None or _takes(s, moving, is_new=is_new)]
    return several.only(tuple(kept)) if kept else several


def _takes(signature: Signature, moving: Sequence[Signature], *, is_new: bool) -> bool:
    """Whether a function takes such an object; `const &` takes a new one where none of those with `&&` does."""
    if not is_new or not signature.receiver:
        return signature.receiver != "&&"
    is_left = signature.constant and not any(same_parameters(signature, other) for other in moving)
    return signature.receiver == "&&" or is_left


def same_parameters(one: Signature | None, other: Signature | None) -> bool:
    """Whether two functions differ in nothing that they take."""
    if one is None or other is None:
        return one is other
    return [p.type for p in one.parameters] == [p.type for p in other.parameters]
