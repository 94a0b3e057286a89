# SPDX-License-Identifier: Apache-2.0
"""Statements in which an analysis easily loses a way: what one branch sets, what a handler sees, what a callback left behind.

    if len(sys.argv) > 3: self.topic2 = "b"
    self.create_publisher(String, getattr(self, "topic2", "a"), 10)    both names are possible

Each gives a variable that holds a word; which one may depend on what only a run knows.
"""

from __future__ import annotations

from typing import Final

from .draft import Draft, Scope, Way
from .values import condition, word


def maybe_attribute(draft: Draft, scope: Scope, depth: int) -> str:
    """An attribute that only one way sets, over one of the class or a default."""
    cls, thing = draft.fresh("Maybe"), draft.fresh("maybe")
    draft.define(f"class {cls}:\n    topic = {_plain(draft)}")
    scope.add(
        f"{thing} = {cls}()\nif {condition(draft, scope, 0)}:\n"
        f"    {thing}.topic = {word(draft, scope, depth)}\n    {thing}.extra = 'ex'"
    )
    if draft.chooser.chance(30):
        scope.add(f"{thing}.topic = 'del_me'\ndel {thing}.topic")
    return draft.chooser.pick(
        [
            f"{thing}.topic",
            f"getattr({thing}, 'extra', 'none')",
            f"('has' if 'extra' in vars({thing}) else 'not')",
            f"vars({thing}).get('topic', 'unset')",
        ]
    )


def maybe_keyword(draft: Draft, scope: Scope, depth: int) -> str:
    """Keyword arguments of which one may be missing."""
    function, options = draft.fresh("keyworded"), draft.fresh("options")
    draft.define(f"def {function}(a='da', b='db', **rest):\n    return a + b + ''.join(sorted(rest))")
    scope.add(
        f"{options} = {{}}\nif {condition(draft, scope, 0)}:\n"
        f"    {options}['a'] = {word(draft, scope, depth)}\nelse:\n    {options}['c'] = 'x'"
    )
    return draft.chooser.pick(
        [
            f"{function}(**{options})",
            f"{options}.get('a', 'no_a')",
            f"'_'.join(['k', *{options}])",
            f"{function}(**{{'b': 'q', **{options}}})",
            f"{options}.pop('a', 'popped')",
            f"{options}.setdefault('a', 'sd')",
        ]
    )


def handler(draft: Draft, scope: Scope, _depth: int) -> str:
    """What a handler sees of what was done before the failure."""
    name, risky = draft.fresh("h"), draft.fresh("risky")
    draft.define(
        f"def {risky}(flag):\n    if flag:\n"
        f"        raise {draft.chooser.pick(['ValueError', 'KeyError', 'RuntimeError'])}('x')\n"
        "    return 'fine'"
    )
    inner = draft.chooser.pick(
        [
            "except KeyError:\n        {n} = 'inner'",
            "finally:\n        {n}f = 'fin'",
            "except (OSError, RuntimeError):\n        pass\n    else:\n        {n} = {n} + '_else'",
        ]
    ).format(n=name)
    scope.add(
        f"{name} = 'start'\ntry:\n    {name} = {_plain(draft)}\n    try:\n"
        f"        if {condition(draft, scope, 0)}:\n            {name} = 'mid'\n"
        f"        {risky}({condition(draft, scope, 0)})\n"
        f"        {name} = {word(draft, scope, 0)} + '_after'\n    {inner}\nexcept Exception:\n"
        f"    {name} = {name} + '_caught'"
    )
    return name


def suppressed(draft: Draft, scope: Scope, depth: int) -> str:
    """A block that may end early."""
    draft.need("import contextlib")
    name = draft.fresh("sup")
    scope.add(
        f"{name} = {word(draft, scope, depth)}\nwith contextlib.suppress(Exception):\n"
        f"    {name} = {name} + '_one'\n    if {condition(draft, scope, 0)}:\n"
        f"        raise ValueError\n    {name} = {name} + '_two'"
    )
    return name


def iterator(draft: Draft, scope: Scope, depth: int) -> str:
    """A class that is iterated step by step."""
    cls, name = draft.fresh("Steps"), draft.fresh("step")
    draft.define(
        f"class {cls}:\n    def __init__(self, items):\n"
        "        self.items, self.at = items, 0\n    def __iter__(self):\n"
        "        return self\n    def __next__(self):\n"
        "        if self.at >= len(self.items):\n            raise StopIteration\n"
        "        self.at += 1\n        return self.items[self.at - 1]"
    )
    scope.add(
        f"{name} = 's'\nfor x in {cls}([{word(draft, scope, depth)}, 'second']):\n"
        f"    if {condition(draft, scope, 0)}:\n        {name} = x"
    )
    return draft.chooser.pick(
        [
            name,
            f"next({cls}([{name}]))",
            f"'_'.join({cls}(['a', {name}]))",
            f"list({cls}(['a', {name}]))[1]",
            f"[*{cls}([{name}, 'q'])][0]",
        ]
    )


def stopping(draft: Draft, scope: Scope, _depth: int) -> str:
    """A generator that may yield nothing, and what it leaves behind."""
    function, name = draft.fresh("some"), draft.fresh("last")
    draft.need("import sys, os, time, random")
    draft.define(
        f"def {function}(state):\n    state['x'] = 'before'\n"
        f"    if {condition(draft, Scope(), 0)}:\n        return\n    yield {_plain(draft)}\n"
        "    state['x'] = 'between'\n    yield 'two'\n    state['x'] = 'behind'"
    )
    scope.add(
        f"{name}, {name}s = 'empty', {{'x': 'none'}}\nfor {name} in {function}({name}s):\n"
        f"    {name}t = {name}s['x']\n    if {condition(draft, scope, 0)}:\n        break"
    )
    return draft.chooser.pick([name, f"{name}s['x']", f"next({function}({{}}), 'exhausted')"])


def growing(draft: Draft, scope: Scope, depth: int) -> str:
    """A list that grows while it is worked off."""
    name = draft.fresh("queue")
    scope.add(
        f"{name} = [{word(draft, scope, depth)}]\n{name}d = []\nwhile {name}:\n"
        f"    x = {name}.pop(0)\n    {name}d.append(x)\n    if len({name}d) < 3:\n"
        f"        {name}.append(x + '_n')"
    )
    return draft.chooser.pick([f"{name}d[-1]", f"{name}d[1]", f"'_'.join({name}d)[:40]", f"{name}d[len({name}d) // 2]"])


def shared(draft: Draft, scope: Scope, depth: int) -> str:
    """Objects that have two names, default arguments that are shared, classes that count."""
    name, function = draft.fresh("shared"), draft.fresh("keep")
    kind = draft.chooser.number(0, 3)
    if kind == 0:
        draft.define(f"def {function}(x, kept=[]):\n    kept.append(x)\n    return '_'.join(kept)")
        scope.add(f"{name} = {function}({word(draft, scope, depth)})")
        return draft.chooser.pick([name, f"{function}('again')"])
    if kind == 1:
        scope.add(
            f"{name} = {{'t': 'one'}}\n"
            f"{name}b = {name} if {condition(draft, scope, 0)} else {{'t': 'other'}}\n"
            f"{name}b['t'] = {word(draft, scope, depth)}"
        )
        return draft.chooser.pick([f"{name}['t']", f"{name}b['t']"])
    if kind == 2:
        scope.add(
            f"{name} = [[]] * 2\n{name}[0].append({word(draft, scope, depth)})\n"
            f"{name}c = [list(x) for x in {name}]\n{name}[1].append('late')"
        )
        return draft.chooser.pick([f"{name}[1][0]", f"{name}c[0][-1]", f"{name}[0][-1]"])
    scope.add(f"{name} = []\nfor i in range(3):\n    {name}.append(lambda: 'v' + str(i))")
    return draft.chooser.pick([f"{name}[0]()", f"{name}[2]()"])


def classes(draft: Draft, scope: Scope, depth: int) -> str:
    """Classes that are chosen, derived twice, made in functions, with hooks."""
    cls, text = draft.fresh("Kind"), word(draft, scope, depth)
    kind = draft.chooser.number(0, 4)
    if kind == 0:
        draft.need("import sys, os, time, random")
        draft.define(
            f"class {cls}A:\n    topic = 'ka'\n\n\nclass {cls}B:\n    topic = 'kb'\n\n\n"
            f"{cls} = {cls}A if {condition(draft, Scope(), 0)} else {cls}B\n\n\n"
            f"class {cls}C({cls}):\n    def get(self):\n        return self.topic + '_c'"
        )
        return f"{cls}C().get()"
    if kind == 1:
        draft.define(
            f"class {cls}Root:\n    def get(self):\n        return 'root'\n\n\n"
            f"class {cls}L({cls}Root):\n    def get(self):\n"
            f"        return 'l_' + super().get()\n\n\nclass {cls}R({cls}Root):\n"
            "    def get(self):\n        return 'r_' + super().get()\n\n\n"
            f"class {cls}({cls}L, {cls}R):\n    pass"
        )
        return draft.chooser.pick(
            [
                f"{cls}().get()",
                f"{cls}L().get()",
                f"'_'.join(c.__name__ for c in {cls}.__mro__[:2])",
                f"{cls}.__bases__[1]().get()",
            ]
        )
    if kind == 2:
        draft.define(f"def {cls}_make(topic):\n    class Made:\n        name = topic + '_made'\n    return Made")
        return f"{cls}_make({text}).name"
    if kind == 3:
        draft.define(
            f"class {cls}:\n    known = []\n    def __init_subclass__(cls, label='lab', **kw):\n"
            "        super().__init_subclass__(**kw)\n"
            f"        {cls}.known.append(cls.__name__ + label)\n\n\nclass {cls}One({cls}):\n"
            f"    pass\n\n\nclass {cls}Two({cls}, label='two'):\n    pass"
        )
        return draft.chooser.pick([f"{cls}.known[1]", f"{cls}.known[0]", f"'_'.join({cls}.known)"])
    draft.need("import abc")
    draft.define(
        f"class {cls}(abc.ABC):\n    @abc.abstractmethod\n    def name(self): ...\n"
        "    def topic(self):\n        return self.name() + '_abc'\n\n\n"
        f"class {cls}Real({cls}):\n    def __init__(self, n):\n        self.n = n\n"
        "    def name(self):\n        return self.n"
    )
    return f"{cls}Real({text}).topic()"


def mutual(draft: Draft, scope: Scope, depth: int) -> str:
    """Functions that call each other, and results that come back through them."""
    one = draft.fresh("mutual")
    draft.need("import sys, os, time, random")
    draft.define(
        f"def {one}(n, acc):\n    if n <= 0:\n        return acc\n"
        f"    if {condition(draft, Scope(), 0)} and n == 1:\n        return acc + '_early'\n"
        f"    return {one}_b(n, acc + 'x')\n\n\ndef {one}_b(n, acc):\n"
        f"    return {one}(n - 1, acc + 'y')"
    )
    return f"{one}({draft.chooser.number(0, 4)}, {word(draft, scope, depth)})"


def unknown_loop(draft: Draft, scope: Scope, depth: int) -> str:
    """A loop whose number of turns only a run knows."""
    name = draft.fresh("turn")
    draft.need("import sys, os, time, random")
    count = "random.randint(0, 2)" if not draft.known else str(draft.chooser.number(0, 2))
    body = draft.chooser.pick(
        [
            "{n} = 'in_loop'",
            "{n} = {n} + 'z'",
            "{n}, {n}p = {n}p, {n}",
            "{n}l.append({n})\n    {n} = {n}l[0] + 'w'",
            "if {n} == 'init':\n        {n} = 'first'\n    elif {n} == 'first':\n        {n} = 'then'",
        ]
    ).format(n=name)
    scope.add(
        f"{name}, {name}p, {name}l = 'init', {word(draft, scope, depth)}, []\nfor i in range({count}):\n    {body}"
    )
    return name


def _plain(draft: Draft) -> str:
    return word(draft, Scope(), 0)


HAZARDS: Final[tuple[Way, ...]] = (
    *(maybe_attribute, maybe_keyword, handler, handler, suppressed, iterator, stopping),
    *(growing, shared, shared, classes, classes, mutual, unknown_loop),
)
