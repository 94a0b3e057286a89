# SPDX-License-Identifier: Apache-2.0
"""The functions on arrays, of numpy, that give a view of what they get, or write into it: by their names."""

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
CHANGE: Final = frozenset(
    ("fill", "sort", "put", "partition", "resize", "itemset", "setfield", "byteswap", "seed", "setflags")
)
"""Methods that write to their object."""
INTO: Final[dict[str, int]] = {
    name: place
    for place, names in {
        1: (
            "at abs absolute acos acosh arccos arccosh arcsin arcsinh arctan arctanh asin asinh atan atanh bitwise_count "
            "bitwise_invert bitwise_not cbrt ceil conj conjugate cos cosh deg2rad degrees exp exp2 expm1 fabs fix "
            "floor frexp invert isfinite isinf isnan isnat isneginf isposinf log log10 log1p log2 logical_not modf "
            "negative positive rad2deg radians reciprocal rint sign signbit sin sinh spacing sqrt square tan tanh "
            "trunc"
        ),
        2: (
            "add all amax amin any arctan2 argmax argmin around atan2 bitwise_and bitwise_left_shift bitwise_or "
            "bitwise_right_shift bitwise_xor choose concat concatenate copysign divide divmod dot equal float_power "
            "floor_divide fmax fmin fmod gcd greater greater_equal heaviside hypot lcm ldexp left_shift less "
            "less_equal logaddexp logaddexp2 logical_and logical_or logical_xor matmul matvec max maximum median min "
            "minimum mod multiply nanargmax nanargmin nanmax nanmedian nanmin nextafter not_equal outer pow power ptp "
            "remainder right_shift round round_ stack subtract true_divide vecdot vecmat"
        ),
        3: (
            "clip compress cumprod cumsum mean nancumprod nancumsum nanmean nanpercentile nanprod nanquantile nanstd "
            "nansum nanvar percentile prod quantile std sum take var"
        ),
        4: "reduce accumulate",
        5: "reduceat trace",
    }.items()
    for name in names.split()
}
"""Functions that write into what they are given from this place on, counted from 0; as methods, from the one before."""


def tells(name: str) -> bool:
    """Whether more is known of a function by its dotted name than that it may do anything."""
    method = name.rpartition(".")[2]
    return method in CHANGE or (name.startswith("numpy.") and (method in VIEWS or method in INTO))
