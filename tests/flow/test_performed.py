# SPDX-License-Identifier: Apache-2.0
"""Promise: what a builtin is given is not lost where something else calls it: a partial function, `map`, a timer, a subscription, or `*`.

The rows are read as in `test_flows.py`.
"""

from __future__ import annotations

from pathlib import Path
from typing import Final

import pytest

from .robots import Case, said_strongly

CASES: Final = {
    "what a partial function gives to a method of a list": Case(
        "self.items = [0.0]", "partial(self.items.append, msg.data)()", "self.items[-1]"
    ),
    "a message of a partial function": Case(
        "self.kept = Float64()", "self.kept = partial(Float64, data=msg.data)()", "self.kept.data"
    ),
    "a dict of a partial function": Case(
        "self.state = {'a': 0.0}", "self.state = partial(dict, a=msg.data)()", "self.state['a']"
    ),
    "an update in a partial function": Case(
        "self.state = {'a': 0.0}", "partial(self.state.update, a=msg.data)()", "self.state['a']"
    ),
    "an attribute that a partial function sets": Case(
        "self.value = 0.0", "partial(setattr, self, 'value', msg.data)()", "self.value"
    ),
    "an attribute that a partial function sets, its name given": Case(
        "self.value = 0.0", "partial(setattr, self, 'value')(msg.data)", "self.value"
    ),
    "an attribute that a partial function reads": Case(
        "self.value = 0.0\nself.kept = 0.0",
        "self.value = msg.data\nself.kept = partial(getattr, self)('value')",
        "self.kept",
    ),
    "the larger one, by a partial function": Case(
        "self.value = 0.0", "self.value = partial(max, msg.data)(0.0)", "self.value"
    ),
    "what nested partial functions give to a method of a list": Case(
        "self.items = [0.0]", "partial(partial(self.items.insert, 0), msg.data)()", "self.items[0]"
    ),
    "one of two partial functions": Case(
        "self.items = [0.0]",
        "some = [partial(self.items.append, msg.data), partial(self.items.append, 1.0)]\nsome[int(time.time()) % 2]()",
        "self.items[-1]",
    ),
    "partial functions of different length": Case(
        "self.items = [0.0]",
        "some = [partial(self.items.insert, 0), partial(self.items.insert, 0, msg.data)]\nif msg.data > 9.0:\n    some[0](0.0)\nelse:\n    some[1]()",
        "self.items[0]",
    ),
    "a method of a class in a partial function": Case(
        "self.items = [0.0]", "partial(list.append, self.items)(msg.data)", "self.items[-1]"
    ),
    "a data class of a partial function": Case(
        "self.size = Size(0.0)", "self.size = partial(Size, msg.data)(1.0)", "self.size.width"
    ),
    "a data class of a partial function, by name": Case(
        "self.size = Size(0.0)", "self.size = partial(Size, height=msg.data)(1.0)", "self.size.height"
    ),
    "a partial function with star": Case(
        "self.items = [0.0]", "given = [0, msg.data]\npartial(self.items.insert, *given)()", "self.items[0]"
    ),
    "a partial function with two stars": Case(
        "self.state = {'a': 0.0}", "given = {'a': msg.data}\npartial(self.state.update, **given)()", "self.state['a']"
    ),
    "a publication in a partial function": Case("", "partial(self.out.publish, Float64(data=msg.data))()", "0.0"),
    "a map of a partial function": Case(
        "self.items = [0.0]", "list(map(partial(self.items.insert, 0), [msg.data]))", "self.items[0]"
    ),
    "a partial function that the timer calls": Case(
        "self.items = [0.0]\nself.act = partial(int)",
        "self.act = partial(self.items.append, msg.data)",
        "(self.act(), self.items[-1])[1]",
    ),
    "a partial function of arrays that is told where to write": Case(
        "self.grid = np.zeros(4) * 2.0", "partial(np.add, out=self.grid)(self.grid, msg.data)", "self.grid[0]"
    ),
    "a thread with a partial function": Case(
        "self.items = [0.0]", "threading.Thread(target=partial(self.items.append, msg.data)).start()", "self.items[-1]"
    ),
    "a timer with a method of a list": Case(
        "self.items = [0.0]", "threading.Timer(0.01, self.items.append, [msg.data]).start()", "self.items[-1]"
    ),
    "a method of a list with star": Case("self.items = [0.0]", "self.items.append(*[msg.data])", "self.items[-1]"),
    "all arguments by star": Case("self.items = [0.0]", "self.items.insert(*[0, msg.data])", "self.items[0]"),
    "an attribute that is set by star": Case("self.value = 0.0", "setattr(self, *['value', msg.data])", "self.value"),
    "an attribute that is set by star, with its object": Case(
        "self.value = 0.0", "setattr(*(self, 'value', msg.data))", "self.value"
    ),
    "a dict by star": Case("self.state = {'a': 0.0}", "self.state = dict(*[[('a', msg.data)]])", "self.state['a']"),
    "a default by star": Case("self.state = {}", "self.state.setdefault(*('a', msg.data))", "self.state.get('a', 0.0)"),
    "a default of what is not there, by star": Case(
        "self.state = {}\nself.value = 0.0", "self.value = self.state.get(*('a', msg.data))", "self.value"
    ),
    "a list that is extended by star": Case("self.items = [0.0]", "self.items.extend(*[[msg.data]])", "self.items[-1]"),
    "columns of rows": Case(
        "self.value = 0.0", "self.value = list(zip(*[[msg.data, 1.0], [0.0, 0.0]]))[0][0]", "self.value"
    ),
    "a list by star": Case("self.value = 0.0", "self.value = list(*[[msg.data]])[0]", "self.value"),
    "the next element, by star": Case("self.value = 0.0", "self.value = next(*[iter([msg.data])])", "self.value"),
    "a method of a list in a map": Case(
        "self.items = [0.0]", "list(map(self.items.append, [msg.data]))", "self.items[-1]"
    ),
    "a key that a map writes": Case(
        "self.state = {'a': 0.0}", "list(map(self.state.__setitem__, ['a'], [msg.data]))", "self.state['a']"
    ),
    "an attribute that a map sets": Case(
        "self.value = 0.0", "any(map(setattr, [self], ['value'], [msg.data]))", "self.value"
    ),
    "a method of a dict that filters": Case(
        "self.state = {'a': 0.0}\nself.found = []",
        "self.state['a'] = msg.data\nself.found = list(filter(self.state.get, ['a']))",
        "float(len(self.found))",
        "control",
    ),
    "the key with the largest value": Case(
        "self.state = {'a': 0.0, 'b': 1.0}",
        "self.state['a'] = msg.data",
        "1.0 if max(['a', 'b'], key=self.state.get) == 'a' else 0.0",
        "control",
    ),
    "keys in the order of their values": Case(
        "self.state = {'a': 0.0, 'b': 1.0}",
        "self.state['a'] = msg.data",
        "1.0 if sorted(['a', 'b'], key=self.state.get)[0] == 'a' else 0.0",
        "control",
    ),
    "a timer that appends": Case(
        "self.items = [0.0]", "self.create_timer(0.1, partial(self.items.append, msg.data))", "self.items[-1]"
    ),
    "a method of a list that a loop of events calls": Case(
        "self.items = [0.0]",
        "loop = asyncio.new_event_loop()\nloop.call_soon(self.items.append, msg.data)",
        "self.items[-1]",
    ),
    "a subscription that appends": Case(
        "self.items = [Float64()]\nself.create_subscription(Float64, '/in', self.items.append, 10)",
        "pass",
        "self.items[-1].data",
    ),
    "a subscription that appends, in a partial function": Case(
        "self.items = [Float64()]\nself.create_subscription(Float64, '/in', partial(self.items.append), 10)",
        "pass",
        "self.items[-1].data",
    ),
    "a subscription that sets an attribute": Case(
        "self.got = Float64()\nself.create_subscription(Float64, '/in', partial(setattr, self, 'got'), 10)",
        "pass",
        "self.got.data",
    ),
    "a subscription that writes under a key": Case(
        "self.state = {'a': Float64()}\nself.create_subscription(Float64, '/in', partial(self.state.__setitem__, 'a'), 10)",
        "pass",
        "self.state['a'].data",
    ),
    "an object or a number, by star": Case(
        "self.value = 0.0",
        "def f(x): self.value = x\nf(*[[self, msg.data][int(time.time()) % 2]])",
        "float(self.value)",
    ),
    "a method of an array in a map": Case(
        "self.grid = np.zeros(2)", "list(map(self.grid.fill, [msg.data]))", "self.grid[0]"
    ),
}


@pytest.mark.parametrize("case", CASES.values(), ids=list(CASES))
def test_what_a_builtin_is_given_is_not_lost(case: Case, tmp_path: Path) -> None:
    sources, said = said_strongly(case, tmp_path)
    assert "topic:/in" in sources, said
