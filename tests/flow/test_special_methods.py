# SPDX-License-Identifier: Apache-2.0
"""Promise: what a special method gives is in what Python makes of the object, whether a line of the program calls it or not.

Each row: the method with its parameters, what it returns, and what is made of an object `A()` of its class.
"""

from __future__ import annotations

from pathlib import Path
from typing import Final

import pytest
from sampling import sample

from .robots import Case, said_strongly

_NUMBER: Final = "int(msg.data)"
_TEXT: Final = "str(msg.data)"
_TRUTH: Final = "msg.data > 0"
_ITERATOR: Final = "iter([msg.data])"
ROWS: Final = (
    ("__float__(s)", "msg.data", "float(A())"),
    ("__int__(s)", _NUMBER, "int(A())"),
    ("__index__(s)", _NUMBER, "[1.0, 2.0][A()]"),
    ("__index__(s)", _NUMBER, "len(list(range(A())))"),
    ("__index__(s)", _NUMBER, "operator.index(A())"),
    ("__index__(s)", _NUMBER, "len([1,2,3][A():])"),
    ("__index__(s)", _NUMBER, "len('a' * A())"),
    ("__index__(s)", _NUMBER, "float(bin(A()))"),
    ("__complex__(s)", "complex(msg.data)", "complex(A()).real"),
    ("__round__(s, n=None)", "msg.data", "round(A())"),
    ("__abs__(s)", "msg.data", "abs(A())"),
    ("__floor__(s)", _NUMBER, "math.floor(A())"),
    ("__ceil__(s)", _NUMBER, "math.ceil(A())"),
    ("__trunc__(s)", _NUMBER, "math.trunc(A())"),
    ("__float__(s)", "msg.data", "math.sin(A())"),
    ("__bytes__(s)", "bytes([int(msg.data)])", "float(bytes(A()))"),
    ("__hash__(s)", _NUMBER, "hash(A())"),
    ("__eq__(s, o)", _TRUTH, "float(A() == 1)"),
    ("__eq__(s, o)", _TRUTH, "float(A() in [1])"),
    ("__eq__(s, o)", _TRUTH, "float([A()].index(2))"),
    ("__eq__(s, o)", _TRUTH, "float([A()].count(1))"),
    ("__eq__(s, o)", _TRUTH, "float([A()] == [1])"),
    ("__eq__(s, o)", _TRUTH, "float((A(),) == (1,))"),
    ("__lt__(s, o)", _TRUTH, "float(A() < A())"),
    ("__divmod__(s, o)", "(1, msg.data)", "divmod(A(), 1)[1]"),
    ("__pow__(s, o, m=None)", "msg.data", "pow(A(), 2)"),
    ("__pow__(s, o, m=None)", "msg.data", "pow(A(), 2, 3)"),
    ("__rpow__(s, o)", "msg.data", "2 ** A()"),
    ("__reversed__(s)", _ITERATOR, "next(reversed(A()))"),
    ("__len__(s)", _NUMBER, "float(len(A()))"),
    ("__bool__(s)", _TRUTH, "float(bool(A()))"),
    ("__bool__(s)", _TRUTH, "float(any([A()]))"),
    ("__bool__(s)", _TRUTH, "float(len(list(filter(None, [A()]))))"),
    ("__dir__(s)", "[str(msg.data)]", "float(dir(A())[0])"),
    ("__repr__(s)", _TEXT, "float(repr(A()))"),
    ("__repr__(s)", _TEXT, "float(str(A()))"),
    ("__repr__(s)", _TEXT, "float(str([A()])[1:-1])"),
    ("__repr__(s)", _TEXT, "float('%r' % A())"),
    ("__repr__(s)", _TEXT, "float('%s' % (A(),))"),
    ("__repr__(s)", _TEXT, "float('{}'.format(A()))"),
    ("__str__(s)", _TEXT, "float(' '.join(map(str, [A()])))"),
    ("__format__(s, f)", _TEXT, "float(f'{A():x}')"),
    ("__format__(s, f)", _TEXT, "float(format(A(), 'x'))"),
    ("__format__(s, f)", _TEXT, "float('{:x}'.format(A()))"),
    ("__fspath__(s)", _TEXT, "float(os.fspath(A()))"),
    ("__fspath__(s)", _TEXT, "float(os.path.join(A(), 'x'))"),
    ("__copy__(s)", "msg.data", "copy.copy(A())"),
    ("__deepcopy__(s, m)", "msg.data", "copy.deepcopy(A())"),
    ("__deepcopy__(s, m)", "msg.data", "copy.deepcopy([A()])[0]"),
    ("__contains__(s, x)", _TRUTH, "float(1 in A())"),
    ("__iter__(s)", _ITERATOR, "list(A())[0]"),
    ("__iter__(s)", _ITERATOR, "sum(A())"),
    ("__iter__(s)", "iter([str(msg.data)])", "float(','.join(A()))"),
    ("__iter__(s)", _ITERATOR, "float(1 in A())"),
    ("__iter__(s)", _ITERATOR, "list(itertools.chain(A()))[0]"),
    ("__iter__(s)", _ITERATOR, "max(A())"),
    ("__iter__(s)", _ITERATOR, "list(enumerate(A()))[0][1]"),
    ("__iter__(s)", _ITERATOR, "list(zip(A(), [1]))[0][0]"),
    ("__iter__(s)", _ITERATOR, "sorted(A())[0]"),
    ("__getitem__(s, i)", "[msg.data][i]", "list(A())[0]"),
    ("__getitem__(s, i)", "msg.data", "A()[1:2]"),
    ("__call__(s, *a)", "msg.data", "list(map(A(), [1]))[0]"),
    ("__call__(s, *a)", "msg.data * a[0]", "sorted([1.0, 2.0], key=A())[0]"),
    ("__call__(s, *a)", "msg.data", "functools.reduce(A(), [1, 2])"),
    ("__getattr__(s, k)", "msg.data", "getattr(A(), 'x')"),
    ("__and__(s, o)", "msg.data", "A() & 1"),
    ("__rand__(s, o)", "msg.data", "1 & A()"),
    ("__invert__(s)", "msg.data", "~A()"),
    ("__matmul__(s, o)", "msg.data", "A() @ 1"),
    ("__array__(s, *a)", "[msg.data]", "np.array(A())[0]"),
    ("__next__(s)", "msg.data", "next(A())"),
    ("__radd__(s, o)", "msg.data", "sum([A()])"),
    ("__class_getitem__(c, k)", "msg.data", "A[int]"),
)


@pytest.mark.parametrize(
    ("method", "returned", "made"), sample(ROWS, 3), ids=[f"{row[0].partition('(')[0]}: {row[2]}" for row in ROWS]
)
def test_what_a_special_method_gives_is_not_lost(method: str, returned: str, made: str, tmp_path: Path) -> None:
    does = f"import copy, math, os\nclass A:\n    def {method}:\n        return {returned}\nself.value = {made}"
    sources, said = said_strongly(Case("self.value = 0.0", does, "self.value"), tmp_path)
    assert "topic:/in" in sources, said
