# SPDX-License-Identifier: Apache-2.0
"""What string operations do to texts with holes. Each result covers whatever the holes stand for.

upper(('/a', hole))                      ('/A', hole)
strip_left(('/', hole, '/x'), '/')       [(hole, '/x'), ('x',)]        the hole may be nothing but slashes
remove_front((hole, '/x'), '/')          [(hole, '/x'), ('x',)]        what may stand behind the prefix
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from rosward.domain.unknown import Reason, derived
from rosward.domain.values import Hole

Part = str | Hole
Parts = tuple[Part, ...]
MAX_RESULTS: Final = 16
_DIGITS: Final = frozenset("-0123456789")
_PER_CHARACTER: Final = ("lower", "upper", "casefold", "swapcase")
_SIGMA: Final = "\N{GREEK CAPITAL LETTER SIGMA}"


def reasons_in(parts: Parts) -> tuple[Reason, ...]:
    """Why parts are not known."""
    return derived(tuple(dict.fromkeys(r for p in parts if isinstance(p, Hole) for r in p.reasons)))[:4]


def anything(parts: Parts) -> Hole:
    """One hole for all parts."""
    return Hole(reasons_in(parts))


def loose(part: Part) -> Part:
    """A hole of which a piece may be missing; text as it is."""
    return Hole(derived(part.reasons)) if isinstance(part, Hole) else part


def mirror(parts: Parts) -> Parts:
    """The text written backwards."""
    return tuple(p[::-1] if isinstance(p, str) else p for p in reversed(parts))


def may_be(hole: Hole, text: str) -> bool:
    """Whether a hole can stand for a text."""
    if not hole.shape:
        return True
    return bool(text) and ("/" not in text if hole.shape == "word" else _DIGITS.issuperset(text))


def may_hold(hole: Hole, text: str) -> bool:
    """Whether a text can occur inside of what a hole stands for."""
    return not text or may_be(hole, text)


def may_end_in(hole: Hole, chars: str | None) -> bool:
    """Whether what a hole stands for can begin or end with one of some characters (None: white space)."""
    if not hole.shape:
        return True
    if hole.shape == "digits":
        return chars is not None and not _DIGITS.isdisjoint(chars)
    return chars is None or any(c != "/" for c in chars)


# Case


def change_case(parts: Parts, method: str) -> Parts:
    """lower, upper, casefold, swapcase, capitalize or title, part by part."""
    result: list[Part] = []
    for number, part in enumerate(parts):
        if isinstance(part, Hole):
            result.append(Hole(derived(part.reasons), part.shape) if method in _PER_CHARACTER else loose(part))
        elif _SIGMA in part:  # its small form depends on what stands around it
            result.append(anything(parts))
        elif number == 0 or method in _PER_CHARACTER:
            result.append(getattr(part, method)())
        elif method == "title":
            result.extend(_behind_hole(part, str.title))
        elif number == 1:
            result.extend(_behind_hole(part, str.lower))
        else:
            result.append(part.lower())
    return tuple(result)


def _behind_hole(part: str, change: Callable[[str], str]) -> Parts:
    """A part behind a hole: the case of its first letter depends on what the hole ends with."""
    first = part[0]
    if first.lower() == first.upper() == first.title():
        return (change(part),)
    return (Hole(()), change("a" + part[1:])[1:])


# Taking away at the ends


def strip_left(parts: Parts, chars: str | None) -> list[Parts]:
    """What lstrip may leave: one alternative for each hole that may be stripped away whole."""
    results: list[Parts] = []
    for number, part in enumerate(parts):
        behind = parts[number + 1 :]
        if isinstance(part, str):
            kept = part.lstrip(chars)
            if kept:
                return [*results, (kept, *behind)]
        elif not may_end_in(part, chars):
            return [*results, (part, *behind)]
        else:
            results.append((loose(part), *behind))
    return [*results, ()]


def strip_right(parts: Parts, chars: str | None) -> list[Parts]:
    """What rstrip may leave."""
    return [mirror(p) for p in strip_left(mirror(parts), chars)]


def remove_front(parts: Parts, prefix: str) -> list[Parts]:
    """What may stand behind `prefix` where the text begins with it; empty where it surely does not."""
    results: dict[Parts, None] = {}
    found: Parts
    offsets = {0}
    for number, part in enumerate(parts):
        behind = parts[number + 1 :]
        following: set[int] = set()
        for offset in sorted(offsets):
            left = prefix[offset:]
            if isinstance(part, str):
                if part.startswith(left):
                    found = (part[len(left) :], *behind)
                    results[found] = None
                elif left.startswith(part):
                    following.add(offset + len(part))
                continue
            if may_hold(part, left):
                found = (loose(part), *behind)
                results[found] = None
            following.update(offset + n for n in range(len(left)) if may_be(part, left[:n]))
        offsets = following
    if prefix == "" and not parts:
        return [()]
    return list(results) if len(results) <= MAX_RESULTS else [(anything(parts),)]


def starts_with(parts: Parts, prefix: str) -> bool | None:
    """Whether the text begins with `prefix`."""
    if not prefix or (parts and isinstance(parts[0], str) and parts[0].startswith(prefix)):
        return True
    return None if remove_front(parts, prefix) else False


def drop_front(parts: Parts, count: int) -> list[Parts]:
    """What may be left without the first `count` characters."""
    results: dict[Parts, None] = {}
    found: Parts
    missing = {count}
    for number, part in enumerate(parts):
        behind = parts[number + 1 :]
        following: set[int] = set()
        for left in sorted(missing):
            if left == 0:
                results[parts[number:]] = None
            elif isinstance(part, Hole):
                if left > MAX_RESULTS:  # as far as nobody counts: `std::string::npos`
                    return [(anything(parts),)]
                found = (loose(part), *behind)
                results[found] = None
                following.update(range(1, left if part.shape else left + 1))
            elif len(part) >= left:
                found = (part[left:], *behind)
                results[found] = None
            else:
                following.add(left - len(part))
        missing = following
        if len(results) > MAX_RESULTS or len(missing) > MAX_RESULTS:
            return [(anything(parts),)]
    if missing:
        results[()] = None
    return list(results)


def take_front(parts: Parts, count: int) -> Parts:
    """A text that covers the first `count` characters."""
    taken: list[Part] = []
    for part in parts:
        if isinstance(part, Hole):
            return (*taken, anything(parts))
        if len(part) >= count:
            return (*taken, part[:count])
        taken.append(part)
        count -= len(part)
    return tuple(taken)


# Inside


def may_straddle(parts: Parts, old: str) -> bool:
    """Whether an occurrence of `old` can lie partly in a hole and partly in known text."""
    for number, part in enumerate(parts):
        if isinstance(part, Hole):
            continue
        before, after = number > 0, number + 1 < len(parts)
        widths = range(1, min(len(part), len(old) - 1) + 1)
        if before and any(old.endswith(part[:n]) for n in widths):
            return True
        if after and any(old.startswith(part[-n:]) for n in widths):
            return True
        if before and after and part in old[1:-1]:
            return True
    return False


def replace(parts: Parts, old: str, new: Parts, count: int) -> Parts:
    """The text with `new` for `old` (at most `count` times where that is not negative); `old` is not empty."""
    if may_straddle(parts, old):
        return before_place(parts, old)
    result: list[Part] = []
    exact = True
    for part in parts:
        if isinstance(part, Hole):
            touched = may_hold(part, old) and count != 0
            result.append(Hole((*derived(part.reasons), *reasons_in(new))) if touched else part)
            exact = exact and (not touched or count < 0)
        elif old not in part or count == 0:
            result.append(part)
        elif not exact:
            result.append(anything((*parts, *new)))
        else:
            pieces = part.split(old, count)
            count = count if count < 0 else count - (len(pieces) - 1)
            result.append(pieces[0])
            for piece in pieces[1:]:
                result.extend((*new, piece))
    return tuple(result)


def before_place(parts: Parts, old: str) -> Parts:
    """What stays where the places of `old` are not known: the known beginning up to the first possible one."""
    first = parts[0]
    if isinstance(first, Hole):
        return (anything(parts),)
    stop = first.find(old)
    for start in range(max(0, len(first) - len(old) + 1), len(first)):
        if (stop < 0 or start < stop) and old.startswith(first[start:]):
            stop = start
    return (first if stop < 0 else first[:stop], anything(parts))


def split_all(parts: Parts, separator: str) -> list[Parts] | None:
    """All pieces between separators; None where the holes may hold separators."""
    if may_straddle(parts, separator) or any(isinstance(p, Hole) and may_hold(p, separator) for p in parts):
        return None
    pieces: list[list[Part]] = [[]]
    for part in parts:
        if isinstance(part, Hole):
            pieces[-1].append(part)
            continue
        first, *others = part.split(separator)
        pieces[-1].append(first)
        pieces.extend([other] for other in others)
    return [tuple(p) for p in pieces]


def cut_front(parts: Parts, separator: str) -> tuple[Parts, Parts] | None:
    """The text before and behind the first separator, where it is known to stand in the known beginning."""
    if parts and isinstance(parts[0], str):
        before, found, after = parts[0].partition(separator)
        if found:
            return (before,), (after, *parts[1:])
    return None


def cut_back(parts: Parts, separator: str) -> tuple[Parts, Parts] | None:
    """The text before and behind the last separator, where it is known to stand in the known end."""
    found = cut_front(mirror(parts), separator[::-1])
    return None if found is None else (mirror(found[1]), mirror(found[0]))
