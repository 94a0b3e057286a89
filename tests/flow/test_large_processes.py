# SPDX-License-Identifier: Apache-2.0
"""In a large process, functions of libraries that only compute are taken as a whole; what becomes of what they get is the same."""

from __future__ import annotations

from pathlib import Path

import pytest
from sampling import sample

from rosward.models.stub_marks import StubMarks

from .robots import Case, said_strongly
from .test_flows import CASES as OF_ALL

CASES = {
    "a view of an array": Case(
        "self.grid = np.zeros(4)", "self.grid.reshape(2, 2)[0, 0] = msg.data", "self.grid.sum()"
    ),
    "an array that is given back": Case(
        "self.grid = np.array([0.0, 0.0])", "np.asarray(self.grid)[0] = msg.data", "self.grid.sum()"
    ),
    "a view of a view": Case("self.grid = np.zeros(4)", "self.grid.T.reshape(4)[0] = msg.data", "self.grid.sum()"),
    "an operator that writes": Case("self.items = [0.0]", "operator.iadd(self.items, [msg.data])", "self.items[-1]"),
    "a function that writes an item": Case(
        "self.items = {}", "operator.setitem(self.items, 'a', msg.data)", "self.items.get('a', 0.0)"
    ),
    "a function that writes to what it gets": Case(
        "import io\nself.file = io.StringIO()",
        "import json\njson.dump(msg.data, self.file)",
        "float(len(self.file.getvalue()))",
    ),
    "elements that are sorted": Case(
        "self.items = [[0.0], [1.0]]", "sorted(self.items)[0].append(msg.data)", "self.items[0][-1]"
    ),
    "a method that a function calls": Case(
        "self.value = 0.0",
        "class A:\n    def __array__(s, *a):\n        return [msg.data]\nself.value = np.array(A())[0]",
        "self.value",
    ),
    "a function of the program that is handed on": Case(
        "self.value = 0.0", "self.value = functools.reduce(lambda a, b: a + msg.data, [1.0, 2.0])", "self.value"
    ),
    "a class that a class of a library calls": Case(
        "self.value = ''",
        "import json\nclass E(json.JSONEncoder):\n    def default(s, o):\n        return msg.data\n"
        "self.value = E().encode(object())",
        "float(len(self.value))",
    ),
    "a generator": Case("self.value = 0.0", "self.value = math.fsum(msg.data for _ in range(3))", "self.value"),
    "a copy": Case("self.items = []", "import copy\nself.items = copy.copy([[msg.data]])", "self.items[0][0]"),
}


@pytest.mark.parametrize("case", [*CASES.values(), *sample(OF_ALL.values(), 8)], ids=[*CASES, *OF_ALL])
def test_nothing_is_lost(case: Case, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("rosward.flow.walker.CALM", 0)
    sources, said = said_strongly(case, tmp_path)
    assert "topic:/in" in sources, said


@pytest.mark.parametrize(
    ("name", "tells"),
    [
        ("serial.Serial.read", True),  # a stub describes it
        ("google.cloud", True),  # a package of stubs
        ("numpy.arange", True),  # a mark is about all of `numpy`
        ("numpy.arange.shape", False),  # and says no more of what one gives
        ("geometry_msgs.msg.Twist.linear", False),  # no stub
        ("nobody.knows.this", False),
    ],
)
def test_names_that_tell_more_than_what_they_are_a_part_of(name: str, tells: bool) -> None:
    assert StubMarks().tells(name) == tells
