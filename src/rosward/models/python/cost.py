# SPDX-License-Identifier: Apache-2.0
"""How long does a function of Python itself take on known values, and how much does it make? Asked before it is called.

work("str.upper", ("a" * 100,))         100
work("round", (10**400, -(10**9)))      a billion: it computes 10 ** 10**9
work("str.ljust", ("a", 10**9))         a billion: it makes that many characters
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Final

MAX_WORK: Final = 1 << 20
"""Characters and digits that one call may look at or make."""
A_STEP: Final = 4_096
"""Characters that Python goes through in the time of one step of the interpreter, about."""

_NEVER: Final = 1 << 62
Operands = Sequence[object]


def work(name: str, operands: Operands) -> int:
    """Characters and digits that a call looks at or makes, at the most; `name` is that of the builtin, or `type.method`."""
    declared = _DECLARED.get(name)
    return _sizes(operands) if declared is None else _sizes(operands) + declared(operands)


def size(value: object) -> int:
    """The characters of a text, the digits of a number, the parts of a tuple."""
    if isinstance(value, (str, bytes)):
        return len(value)
    if isinstance(value, int):
        return value.bit_length() // 4 + 1
    if isinstance(value, (tuple, list, dict, set, frozenset)):
        return _sizes(tuple(value))
    return 1


def _sizes(values: Operands) -> int:
    return sum(size(v) for v in values)


def _int(operands: Operands, index: int) -> int:
    """The absolute value of an operand that says how many, 0 where there is none."""
    value = operands[index] if index < len(operands) else 0
    return min(abs(value), _NEVER) if isinstance(value, int) else 0


def _digits(operands: Operands) -> int:
    """From text to number and back: as the square."""
    return _sizes(operands) ** 2 // 64


def _power(operands: Operands) -> int:
    """pow(a, b) makes a number of bits(a) * b; pow(a, b, c) multiplies numbers like c once for each bit of b."""
    if not isinstance(operands[0], int) or len(operands) < 2:
        return 0
    if len(operands) > 2 and operands[2] is not None:
        return size(operands[1]) * (size(operands[2]) // 8 + 1) ** 2
    return 0 if operands[0] in (0, 1, -1) else min(size(operands[0]) * _int(operands, 1), _NEVER)


def _wide(operands: Operands) -> int:
    return _int(operands, 1)


def _shift(operands: Operands) -> int:
    return _int(operands, 1) // 4


def _times(operands: Operands) -> int:
    """A text repeated; a product of two numbers."""
    texts = [len(o) for o in operands if isinstance(o, (str, bytes, tuple))]
    if texts:
        return texts[0] * (_int(operands, 0) or _int(operands, 1))
    return size(operands[0]) * size(operands[1]) // 64


def _replaced(operands: Operands) -> int:
    return (size(operands[0]) + 1) * (size(operands[2]) + 1) if len(operands) > 2 else 0


def _searched(operands: Operands) -> int:
    """Some searches look at a text once for each character of what is searched."""
    return size(operands[0]) * size(operands[1]) // 16 if len(operands) > 1 else 0


def _tabs(operands: Operands) -> int:
    return size(operands[0]) * max(8, _int(operands, 1))


def _made(operands: Operands) -> int:
    """bytes(n) makes n zeros."""
    return _int(operands, 0)


_DECLARED: Final[dict[str, Callable[[Operands], int]]] = {
    "int": _digits, "float": _digits, "str": _digits, "repr": _digits, "format": _digits,
    "round": _wide, "pow": _power, "**": _power, "<<": _shift, "*": _times, "bytes": _made,
    **{f"{kind}.{name}": _wide for kind in ("str", "bytes") for name in ("zfill", "ljust", "rjust", "center")},
    **{f"{kind}.replace": _replaced for kind in ("str", "bytes")},
    **{f"{kind}.expandtabs": _tabs for kind in ("str", "bytes")},
    **{
        f"{kind}.{name}": _searched
        for kind in ("str", "bytes")
        for name in ("find", "rfind", "index", "rindex", "count", "split", "rsplit", "partition", "rpartition", "strip",
                     "lstrip", "rstrip", "startswith", "endswith")
    },
    "math.factorial": lambda o: _int(o, 0) ** 2,
    "math.comb": lambda o: min(_int(o, 0), 1 << 20) * min(_int(o, 1), 1 << 20),
    "math.perm": lambda o: min(_int(o, 0), 1 << 20) * min(_int(o, 1) or _int(o, 0), 1 << 20),
    "math.prod": lambda o: _sizes(o) ** 2 // 64,
    "math.gcd": lambda o: _sizes(o) ** 2,
    "math.lcm": lambda o: _sizes(o) ** 2,
}  # fmt: skip
