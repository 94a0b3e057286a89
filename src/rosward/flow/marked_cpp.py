# SPDX-License-Identifier: Apache-2.0
"""C++: how do models in code behave, which have no declaration that could carry a mark? Those that store, those that only look, those of numbers."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from rosward.models.flow_marks import FlowMark

STORES: Final = frozenset(
    (
        *("push_back", "push", "emplace_back", "push_front", "emplace_front", "insert_or_assign", "make_shared"),
        *(
            "make_unique",
            "allocate_shared",
            "make_pair",
            "make_tuple",
            "forward_as_tuple",
            "tie",
            "bind",
            "make_optional",
        ),
    )
)
"""What they make, or write to, holds what they are given as it is."""

COUNTS: Final = frozenset(
    ("push_back", "emplace_back", "push_front", "emplace_front", "push", "pop_back", "pop_front", "pop")
)
"""There is one element more or less then, whatever it is."""

_QUIET: Final = frozenset(
    (
        *(
            "size",
            "empty",
            "length",
            "begin",
            "end",
            "cbegin",
            "cend",
            "front",
            "back",
            "get",
            "reset",
            "move",
            "forward",
        ),
        *("ref", "c_str", "data", "find", "count", "clear", "reserve", "static_pointer_cast", "dynamic_pointer_cast"),
    )
)
"""They throw nothing because of what they are given."""

READS: Final = _QUIET | frozenset(
    (
        *("rbegin", "rend", "crbegin", "crend", "at", "operator[]", "top", "lock", "release", "cref", "as_const"),
        *(
            "contains",
            "has_value",
            "value",
            "second",
            "first",
            "const_pointer_cast",
            "addressof",
            "pop_back",
            "pop_front",
        ),
        *("pop", "use_count"),
    )
)
"""What they give depends on what they are called on and on the key, not on all that it leads to."""

SORTS: Final = frozenset(
    (
        *("sort", "stable_sort", "partial_sort", "nth_element", "partition", "stable_partition", "unique"),
        *("remove_if", "remove", "make_heap", "push_heap", "pop_heap", "sort_heap"),
    )
)
"""They move the elements of a container about as these compare."""
MOVES: Final = SORTS | {"erase", "insert", "emplace", "pop_front", "shuffle", "random_shuffle"}
"""They move the elements of a container about."""

FILLS: Final = frozenset(
    (
        *("strcpy", "strncpy", "strcat", "strncat", "sprintf", "snprintf", "vsnprintf", "memcpy", "memmove", "memset"),
        *("fill", "fill_n", "iota", "generate", "generate_n", "replace", "swap", "swap_ranges"),
    )
)
"""They write to their first argument, of whatever that is a part."""
COPIES: Final = frozenset(
    (
        *("copy", "copy_n", "copy_if", "copy_backward", "move_backward", "reverse_copy", "transform", "partial_sum"),
        *("sscanf", "swap", "swap_ranges"),
    )
)
"""They write to one of those behind."""

SIZES: Final = frozenset(("size", "empty", "length", "ssize"))
"""What they give depends on how much there is."""

LOGS: Final = ("RCLCPP_", "RCUTILS_LOG_")
"""How the names of macros begin that log."""

_RANDOM: Final = FlowMark(sources=("random",))
NATIVES: Final[Mapping[str, FlowMark]] = {
    f"std.random.{number}{call}": _RANDOM for number in ("int", "float") for call in ("", ".operator()", ".min", ".max")
}
"""The marks of names that the models in code make up, and that C++ could not declare."""

STREAMS: Final[Mapping[str, str]] = {
    "std.cout": "stdout",
    "std.cerr": "stdout",
    "std.clog": "stdout",
    "std.wcout": "stdout",
}
"""Where streams of the library lead, by their names."""


_SETTERS: Final = frozenset(("fill", "swap", "resize", "conservativeResize", "normalize", "transposeInPlace"))


def is_setter(name: str) -> bool:
    """Whether a method of a library that only computes writes to its object all the same: `P.row(1).setConstant(x)`."""
    short = name.rpartition(".")[2]
    return name.startswith("Eigen.") and (short in _SETTERS or short.startswith("set"))


def is_safe(name: str) -> bool:
    """Whether a model in code surely throws nothing."""
    short = name.rpartition(".")[2]
    return name.startswith((*LOGS, "rosward.")) or short in STORES or short in _QUIET
