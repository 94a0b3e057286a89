# SPDX-License-Identifier: Apache-2.0
"""Functions on arrays that compute only, but for two things: some give a view of what they get, and some write their result into it.

a.reshape(2, 2)[0, 0] = v        what is written to the view, stands in `a`
numpy.add(b, c, out=a)           `a` holds `b` and `c`
a.fill(v)                        `a` holds `v`
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Final

from rosward.flow.marks import Mark, Root

if TYPE_CHECKING:
    from rosward.flow.stored.memory import Memory
    from rosward.ir import ops

_VIEWS: Final = frozenset(
    (
        *("reshape", "ravel", "view", "transpose", "squeeze", "swapaxes", "asarray", "asanyarray", "ascontiguousarray"),
        *("frombuffer", "atleast_1d", "atleast_2d", "atleast_3d", "broadcast_to", "broadcast_arrays", "expand_dims"),
        *("split", "array_split", "hsplit", "vsplit", "dsplit", "diagonal", "flip", "fliplr", "flipud", "rot90"),
        *("moveaxis", "rollaxis", "real", "imag", "array", "matrix", "asmatrix", "require", "sliding_window_view"),
        *("ndarray", "astype", "newbyteorder", "getfield", "nditer", "ndenumerate", "vectorize", "apply_along_axis"),
    )
)
_CHANGE: Final = frozenset(("fill", "sort", "put", "partition", "resize", "itemset", "setfield", "byteswap", "seed"))
"""Methods that write to their object."""
_INTO: Final[dict[str, int]] = {
    **dict.fromkeys(
        (
            *(
                "abs",
                "absolute",
                "arccos",
                "arcsin",
                "arctan",
                "ceil",
                "cos",
                "deg2rad",
                "degrees",
                "exp",
                "fabs",
                "floor",
            ),
            *("isfinite", "isinf", "isnan", "log", "log10", "log2", "logical_not", "negative", "positive", "rad2deg"),
            *("radians", "reciprocal", "rint", "sign", "sin", "sqrt", "square", "tan", "tanh", "trunc", "invert"),
        ),
        1,
    ),
    **dict.fromkeys(
        (
            *(
                "add",
                "subtract",
                "multiply",
                "divide",
                "true_divide",
                "floor_divide",
                "power",
                "mod",
                "remainder",
                "dot",
            ),
            *("maximum", "minimum", "fmax", "fmin", "hypot", "arctan2", "logical_and", "logical_or", "logical_xor"),
            *("bitwise_and", "bitwise_or", "bitwise_xor", "greater", "less", "equal", "matmul", "fmod", "copysign"),
            *("not_equal", "greater_equal", "less_equal", "left_shift", "right_shift", "outer", "all", "any", "amax"),
            *("amin", "max", "min", "argmax", "argmin", "round", "around", "choose", "concatenate", "stack"),
        ),
        2,
    ),
    **dict.fromkeys(("clip", "cumsum", "cumprod", "sum", "prod", "mean", "std", "var", "take", "compress"), 3),
}
"""Functions that write into what they are given in this place, counted from 0."""
_PICTURES: Final[dict[str, tuple[int, ...]]] = {
    f"cv2.{name}": places
    for places, names in {
        (0,): ("VideoCapture.read", "VideoCapture.retrieve"),
        (1,): ("bitwise_not", "split", "merge", "Rodrigues", "convexHull", "boxPoints"),
        (): ("connectedComponents", "connectedComponentsWithStats"),  # by place, they are told how to connect
        (2,): (
            *("cvtColor", "resize", "blur", "medianBlur", "bitwise_and", "bitwise_or", "bitwise_xor"),
            *("erode", "dilate", "flip", "rotate"),
        ),
        (3,): ("inRange", "GaussianBlur", "Canny", "warpPerspective", "approxPolyDP"),
        (3, 4): ("findContours",),
        (4,): ("threshold", "HoughLines", "HoughLinesP", "HoughCircles"),
        (5,): ("addWeighted",),
    }.items()
    for name in names
}
"""The same of functions on pictures, and cameras."""
_RESULTS: Final = frozenset(
    ("out", "dst", "edges", "image", "labels", "stats", "centroids", "mv", "lines", "circles", "hull")
)
"""The names of the parameters into which they write."""


def viewed(names: Iterable[str], given: Iterable[Mark]) -> frozenset[Root]:
    """The objects that the result of functions of these names may be a view of."""
    if not any(name.startswith("numpy.") and name.rpartition(".")[2] in _VIEWS for name in names):
        return frozenset()
    return frozenset[Root]().union(*(mark.roots for mark in given))


def change(
    memory: Memory,
    arguments: Iterable[ops.Argument],
    names: Iterable[str],
    marks: list[Mark],
    owner: Mark,
    mask: int,
) -> None:
    """Functions of these names write what they get to what they get."""
    named = {a.name: m for a, m in zip(arguments, marks, strict=False) if a.kind == "keyword"}
    changed = [named[n] for n in ("out", "dst", "output") if n in named]
    for name in names:
        if name in _PICTURES:
            changed += [marks[place] for place in _PICTURES[name] if place < len(marks)]
            changed += [m for n, m in named.items() if n in _RESULTS]
        method = name.rpartition(".")[2]
        if method in _CHANGE and not name.startswith(_MODULES):
            changed.append(owner)
        elif name.startswith("numpy.") and len(marks) > (place := _INTO.get(method, len(marks))):
            changed.append(marks[place])
    for each in changed:
        memory.write_any(each.roots, Mark(mask), mask)


_MODULES: Final = ("numpy.random.", "numpy.sort", "numpy.put", "numpy.partition", "numpy.resize")
"""Functions of the same names that are no methods."""
