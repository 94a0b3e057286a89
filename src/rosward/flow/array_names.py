# SPDX-License-Identifier: Apache-2.0
"""The functions on arrays, of numpy and OpenCV, that give a view of what they get, or write into it: by their names."""

from __future__ import annotations

from typing import Final

VIEWS: Final = frozenset(
    (
        *("reshape", "ravel", "view", "transpose", "squeeze", "swapaxes", "asarray", "asanyarray", "ascontiguousarray"),
        *("frombuffer", "atleast_1d", "atleast_2d", "atleast_3d", "broadcast_to", "broadcast_arrays", "expand_dims"),
        *("split", "array_split", "hsplit", "vsplit", "dsplit", "diagonal", "flip", "fliplr", "flipud", "rot90"),
        *("moveaxis", "rollaxis", "real", "imag", "array", "matrix", "asmatrix", "require", "sliding_window_view"),
        *("ndarray", "astype", "newbyteorder", "getfield", "nditer", "ndenumerate", "vectorize", "apply_along_axis"),
    )
)
CHANGE: Final = frozenset(("fill", "sort", "put", "partition", "resize", "itemset", "setfield", "byteswap", "seed"))
"""Methods that write to their object."""
INTO: Final[dict[str, int]] = {
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
PICTURES: Final[dict[str, tuple[int, ...]]] = {
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
RESULTS: Final = frozenset(
    ("out", "dst", "edges", "image", "labels", "stats", "centroids", "mv", "lines", "circles", "hull")
)
"""The names of the parameters into which they write."""


def tells(name: str) -> bool:
    """Whether more is known of a function by its dotted name than that it may do anything."""
    method = name.rpartition(".")[2]
    return name in PICTURES or method in CHANGE or (name.startswith("numpy.") and (method in VIEWS or method in INTO))
