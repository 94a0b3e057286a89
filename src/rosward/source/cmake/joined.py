# SPDX-License-Identifier: Apache-2.0
"""What do variables hold where two ways of an `if` come together?

if(UNKNOWN)
  list(APPEND sources a.cpp)      ->  sources is "main.cpp;a.cpp", with a hole: nobody knows whether that is all
endif()
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from rosward.source.cmake.variables import HOLE, split


def joined(before: Mapping[str, str], after: Sequence[dict[str, str]]) -> dict[str, str]:
    """The variables after each of the ways; where these differ, all elements that one of them has, and a hole."""
    first, *others = after
    result = dict(first)
    for name in dict.fromkeys(name for values in after for name in values):
        value = first.get(name)
        if any(values.get(name) != value for values in others):
            elements = [e for values in (before, *after) for e in split(values.get(name, "")) if _kept(name, e, after)]
            result[name] = ";".join([*dict.fromkeys(e for e in elements if e != HOLE), HOLE])
    return result


def _kept(name: str, element: str, after: Sequence[dict[str, str]]) -> bool:
    """Whether one of the ways has it: what each of them removed is gone."""
    return any(element in values.get(name, "") for values in after)
