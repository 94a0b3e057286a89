# SPDX-License-Identifier: Apache-2.0
"""The order of values: join, widening, and how an operation distributes over alternatives.

join(Const('a'), Const('b'))            Choice(Const('a'), Const('b'))
widen(Choice(0, 1), Choice(0, 1, 2))    Unknown('int')
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import reduce
from typing import Final

from rosward.domain.compound import BoundMethod, External, Native, Partial, Range, Slice, Tuple
from rosward.domain.enumerated import Enumerated, Whole
from rosward.domain.slots import Pointer, Slot
from rosward.domain.text import common
from rosward.domain.unknown import COMPARED, TAKEN_FOR_NOTHING, Cause, Origins, Reason, of_library
from rosward.domain.values import UNBOUND, Choice, Class, Const, Function, Ref, Text, Unknown, Value, is_nan
from rosward.location import Place

MAX_OPTIONS: Final = 64
MAX_NUMBERS: Final = 12
MAX_CALLABLES: Final = 256
"""Alternatives that can be called are given up later than others: with them goes what they would do."""
MAX_REASONS: Final = 4
_NUMBERS: Final = (int, float)
_NOWHERE: Final = Place("", 0)
_BEHAVIOUR: Final = "functions"
_APART: Final = frozenset((Ref, Pointer, Slot, Function, Class, BoundMethod, Partial, External))
"""Values that joins leave as they are: they are the same as another, or stand beside it."""
_PLAIN: Final = frozenset((Const, Text, Tuple))
"""Of too many alternatives these are given up first."""
_FINITE: Final = frozenset((Ref, Function, Class))
"""Of these a program has finitely many: widenings leave them as they are."""


def options(value: Value) -> tuple[Value, ...]:
    """The alternatives of a value: itself alone unless it is a `Choice`."""
    return value.options if value.__class__ is Choice else (value,)


def _members(value: Value) -> frozenset[Value]:
    return value.members if value.__class__ is Choice else frozenset((value,))


def join(left: Value, right: Value) -> Value:
    """The least value that covers both."""
    if left is right or right is UNBOUND:
        return left
    if left is UNBOUND:
        return right
    if left.__class__ is Unknown and right.__class__ is Unknown:
        return _join_unknown(left, right)
    if left == right:
        return left
    if left.__class__ is Choice:  # most joins are of what is known already
        if right.__class__ is Unknown and len(left.options) <= MAX_NUMBERS and left.options[-1].__class__ is Unknown:
            before = left.options[-1]
            both = _join_unknown(before, right)
            return left if both is before else Choice((*left.options[:-1], both))
        new = [o for o in options(right) if o not in left.members]
        if not new:
            return left
        if all(o.__class__ in _APART for o in new):
            last = left.options[-1]
            found = (*left.options[:-1], *new, last) if last.__class__ is Unknown else (*left.options, *new)
            return _bounded(found) if len(found) > MAX_NUMBERS else Choice(found)
    elif right.__class__ is not Choice:
        if left.__class__ is Const and right.__class__ is Const and _are_alike(left, right):
            return Const(left.value, _both(left.origins, right.origins))
        return Choice((right, left) if left.__class__ is Unknown else (left, right))
    else:
        found_first = _joined_first(left, right)
        if found_first is not None:
            return found_first
    return join_all((*options(left), *options(right)))


def _joined_first(value: Value, several: Choice) -> Value | None:
    """The join of one value and some that are known already; None where that takes longer to tell."""
    known = several.options
    last = known[-1]
    if value.__class__ is Unknown:
        if last.__class__ is not Unknown:
            found = (*known, value)
        else:
            both = _join_unknown(value, last)
            if both == last:
                return several
            found = (*known[:-1], both)
    elif value == known[0]:
        return several
    elif value.__class__ in _APART and value not in several.members:
        found = (value, *known)
    else:
        return None
    return _bounded(found) if len(found) > MAX_NUMBERS else Choice(found)


def _are_alike(left: Const, right: Const) -> bool:
    """Whether two constants are one value, of whatever origins."""
    one, other = left.value, right.value
    return one.__class__ is other.__class__ and (one == other or (is_nan(one) and is_nan(other)))


def _both(one: Origins, other: Origins) -> Origins:
    """Where a constant stems from that comes from two places. What a test has told of it holds where it was told in both."""
    every = one | other
    if one == other or not any(o.kind == COMPARED for o in every):
        return every
    return frozenset(o for o in every if o.kind != COMPARED or (o in one and o in other))


def join_all(values: Iterable[Value]) -> Value:
    """The least value that covers all; UNBOUND where there are none."""
    several = values if values.__class__ is tuple or values.__class__ is list else tuple(values)
    if len(several) == 1:
        only = several[0]
        if only.__class__ is not Choice or len(only.options) <= MAX_NUMBERS:
            return only
    elif len(several) == 2:
        one, other = several
        if one.__class__ is not Choice and other.__class__ is not Choice:
            return join(one, other)
    found: dict[Value, None] = {}
    for value in several:
        if value.__class__ is Choice:
            found.update(dict.fromkeys(value.options))
        else:
            found[value] = None
    found.pop(UNBOUND, None)
    if len(found) > 1:
        unknowns: list[Unknown] = []
        merges = False
        for option in found:
            if option.__class__ is Unknown:
                unknowns.append(option)
            elif option.__class__ is Const and option.origins:
                merges = True
        if merges:
            found = _merged(found)
        if unknowns:
            for unknown in unknowns:
                del found[unknown]
            found[reduce(_join_unknown, unknowns)] = None
    if not found:
        return UNBOUND
    if len(found) == 1:
        return next(iter(found))
    if len(found) > MAX_NUMBERS:
        return _bounded(tuple(found))
    return Choice(tuple(found), frozenset(found))


def _merged(values: Iterable[Value]) -> dict[Value, None]:
    """Values of which constants may differ in their origins alone: such are one, of all their origins."""
    found: dict[Value, None] = {}
    consts: dict[object, Const] = {}  # by the value alone
    for value in values:
        option = value
        if option.__class__ is Const:
            key = option.value if option.value.__class__ is str else Const(option.value)
            before = consts.get(key)
            if before is not None:
                del found[before]
                option = Const(before.value, _both(before.origins, option.origins))
            consts[key] = option
        found[option] = None
    return found


def _bounded(values: tuple[Value, ...]) -> Value:
    """Many alternatives: numbers, of which names are seldom made, are given up sooner than texts, and these sooner than objects."""
    rest: list[Value] = []
    kinds: list[type] = []  # of numbers
    for value in values:
        if value.__class__ is Const and value.value.__class__ in _NUMBERS:
            kinds.append(value.value.__class__)
        else:
            rest.append(value)
    if len(kinds) > MAX_NUMBERS:
        hint = kinds[0].__name__ if kinds.count(kinds[0]) == len(kinds) else ""
        return join_all([*rest, Unknown((Reason(Cause.MANY, "", _NOWHERE),), hint)])
    if len(values) <= MAX_OPTIONS:
        return Choice(values)
    plain = tuple([v for v in values if v.__class__ in _PLAIN])
    if plain and len(values) - len(plain) < MAX_OPTIONS and any(v.__class__ is Ref for v in values):
        return join_all([*(v for v in values if v.__class__ not in _PLAIN), generalise(plain)])
    callables = [v for v in values if _acts(v)]
    others = tuple([v for v in values if not _acts(v)])
    if not callables or len(callables) > MAX_CALLABLES:
        return generalise(values)
    return join_all([*callables, generalise(others)]) if len(others) > MAX_OPTIONS else Choice(values)


def _acts(value: Value) -> bool:
    """Whether a value is a function, method or class of the program: with it goes what a call of it would do."""
    if value.__class__ is BoundMethod or value.__class__ is Partial:
        return value.function.__class__ is not Native
    return value.__class__ is Function or value.__class__ is Class


def lost_behaviour(value: Value) -> bool:
    """Whether an unknown stands for functions of the program that were too many to keep apart."""
    return value.__class__ is Unknown and any(r.cause is Cause.MANY and r.subject == _BEHAVIOUR for r in value.reasons)


def _join_unknown(left: Unknown, right: Unknown) -> Unknown:
    if left == right:
        return left
    reasons = tuple(dict.fromkeys(left.reasons + right.reasons))[:MAX_REASONS]
    same = left.hint == right.hint and left.variable == right.variable
    hint, variable = left.hint if left.hint == right.hint else "", left.variable if same else ""
    if reasons == left.reasons and hint == left.hint and variable == left.variable:
        return left
    return Unknown(reasons, hint, variable)


def reasons_of(value: Value) -> tuple[Reason, ...]:
    """Why a value (or a part of it) is not known; empty where it is."""
    if value.__class__ is Unknown:
        return value.reasons
    if value.__class__ is Text:
        return tuple(dict.fromkeys(r for p in value.parts if not isinstance(p, str) for r in p.reasons))
    if value.__class__ is Choice:
        return tuple(dict.fromkeys(r for o in value.options for r in reasons_of(o)))
    if value.__class__ is Tuple:
        return tuple(dict.fromkeys(r for o in value.items for r in reasons_of(o)))
    if value.__class__ is External:
        return (of_library(value.name),)
    return ()


def generalise(values: tuple[Value, ...]) -> Value:
    """One value for too many: a text of what strings have in common, else Unknown; never more than the type is kept."""
    reasons = tuple(dict.fromkeys(r for v in values for r in reasons_of(v)))[:MAX_REASONS]
    if any(map(_acts, values)):
        reasons = tuple(dict.fromkeys((Reason(Cause.MANY, _BEHAVIOUR, _NOWHERE), *reasons)))[:MAX_REASONS]
    elif any(not reasons_of(v) for v in values):
        reasons = _telling(reasons, Reason(Cause.MANY, "", _NOWHERE))
    if all(is_text(v) for v in values):
        return common(values, reasons)
    kinds = {_kind(v) for v in values}
    return Unknown(reasons, kinds.pop() if len(kinds) == 1 else "")


def _telling(reasons: tuple[Reason, ...], why: Reason) -> tuple[Reason, ...]:
    """The reasons of an unknown that something known has become a part of: not only such as may be taken for nothing."""
    return reasons if any(r.cause not in TAKEN_FOR_NOTHING for r in reasons) else (why, *reasons)[:MAX_REASONS]


def is_text(value: Value) -> bool:
    """Whether a value is a text, of which a part may not be known."""
    return value.__class__ is Text or (value.__class__ is Const and value.value.__class__ is str)


def _kind(value: Value) -> str:
    if value.__class__ is Const:
        return "int" if isinstance(value.value, (Enumerated, Whole)) else value.value.__class__.__name__
    if value.__class__ is Text:
        return "str"
    if value.__class__ is Unknown:
        return value.hint
    return "tuple" if value.__class__ is Tuple else ""


def widen(old: Value, new: Value, reason: Reason) -> Value:
    """A value that covers both and that cannot grow for ever: numbers and texts that still change lose what changes.

    Law: widen(old, new) covers join(old, new); every chain of widenings is finite. Options that are objects, classes or functions stay
    apart, since there are finitely many of them.
    """
    joined = join(old, new)
    known = _members(old)
    if joined == old or all(o.__class__ in _FINITE for o in options(joined) if o not in known):
        return old if joined == old else joined
    joined = _anywhere(known, joined, reason)
    joined = _kept_small(known, joined, reason)
    if joined == old:
        return old
    absorbed = {_kind(o) for o in options(old) if o.__class__ is Unknown}
    new_ones = [o for o in options(joined) if o not in known and o.__class__ in (Const, Text, Tuple)]
    plain = [o for o in new_ones if _kind(o) not in ("NoneType", "bool")]  # of those there are finitely many
    if not absorbed & {"", "str"} and not _grow(old, joined):
        plain = [o for o in plain if _kind(o) != "str"]
    moving = {_kind(o) for o in plain}
    if moving and (absorbed & moving or "" in absorbed):  # an unknown of that type is there already: it covers them
        gone = {o for o in plain if "" in absorbed or _kind(o) in absorbed}
        rest = [o for o in options(joined) if o not in gone]
        joined = join_all(Unknown(_telling(o.reasons, reason), o.hint) if o.__class__ is Unknown else o for o in rest)
        moving = {_kind(o) for o in plain if o not in gone}
    if not moving or joined == old:
        return joined
    keep: list[Value] = []
    strings: list[Value] = []
    for option in options(joined):
        kind = _kind(option)
        if kind == "str" and "str" in moving and is_text(option):
            strings.append(option)
        elif kind in moving and option.__class__ in (Const, Tuple):
            keep.append(Unknown((reason,), kind))
        else:
            keep.append(option)
    if strings:
        keep.append(common(tuple(strings), (reason,)))
        if any(o.__class__ is Text for o in options(old)):  # the second time nothing but the type is kept
            keep[-1] = Unknown((reason,), "str")
    return join_all(keep)


_FEW: Final = 3
_SOME: Final = 16


def _grow(old: Value, joined: Value) -> bool:
    """Whether the texts of a loop may be new in each turn. Some that come at once, none of them made of one before, are those of a list that it
    goes through: they are kept apart a few times."""
    before = [o for o in options(old) if is_text(o)]
    after = [o for o in options(joined) if is_text(o)]
    if len(before) > _FEW or len(after) > _SOME or any(o.__class__ is not Const for o in after):
        return True
    known = [str(o.value) for o in before if o.__class__ is Const and o.value]
    return any(k in str(o.value) for o in after if o not in before and o.__class__ is Const for k in known)


def _anywhere(known: frozenset[Value], joined: Value, reason: Reason) -> Value:
    """Iterators that move on from turn to turn: of several into one container the position is not known."""
    places: dict[tuple[Value, str], list[Value]] = {}
    for option in options(joined):
        slot = option.target if option.__class__ is Pointer else option
        if slot.__class__ is Slot and slot.key.__class__ is Const and slot.key.value.__class__ is int:
            places.setdefault((slot.base, slot.kind), []).append(option)
    moving = {
        o for several in places.values() if len(several) > 1 and any(o not in known for o in several) for o in several
    }
    if not moving:
        return joined
    return join_all(_without_position(o, reason) if o in moving else o for o in options(joined))


def _without_position(value: Value, reason: Reason) -> Value:
    if value.__class__ is Pointer:
        return Pointer(_without_position(value.target, reason), value.owner)
    return Slot(value.base, value.kind, Unknown((reason,), "int")) if value.__class__ is Slot else value


_GROWING: Final = (External, Partial, Range, Slice)
_MOST: Final = 8
"""Values that are made of values (or of names) and can grow for ever: so many of them are kept apart by a widening."""


def _kept_small(known: frozenset[Value], joined: Value, reason: Reason) -> Value:
    """Without the growing options that are new, where there are enough of them: one Unknown stands for them."""
    grown = {o for o in options(joined) if o.__class__ in _GROWING}
    fresh = grown - known
    if not fresh or len(grown) <= _MOST:
        return joined
    return join_all([*(o for o in options(joined) if o not in fresh), Unknown((reason,))])


def lift(function: Callable[[Value], Value], value: Value) -> Value:
    """Apply to each alternative and join."""
    if value.__class__ is Choice:
        return join_all(function(o) for o in value.options)
    return function(value)


def lift2(function: Callable[[Value, Value], Value], left: Value, right: Value) -> Value:
    """Apply to each pair of alternatives and join; where there are too many pairs, to generalised operands."""
    if left.__class__ is not Choice and right.__class__ is not Choice:
        return function(left, right)
    lefts, rights = options(left), options(right)
    if len(lefts) * len(rights) > MAX_OPTIONS:
        if len(lefts) > len(rights):
            return lift2(function, generalise(lefts), right)
        return lift2(function, left, generalise(rights))
    return join_all(function(a, b) for a in lefts for b in rights)
