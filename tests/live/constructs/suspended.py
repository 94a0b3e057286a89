# SPDX-License-Identifier: Apache-2.0
"""How far is a generator advanced, and by whom? By next, send and throw, by loops and callbacks, by what stops asking early.

gen1 = script1("left")
next(gen1)
took1 = gen1.send("x")                 what stands between its first and its second yield has run
"""

from __future__ import annotations

from typing import Final

from ..draft import Draft, Scope, Statement, Way, block
from ..entities import create, creation
from ..values import condition, word

_SCRIPTS: Final = (
    "yield a\nyield a + '_two'\nyield 'three'\nreturn a + '_ret'",
    "for x in (a, 'b', 'c'):\n    yield x + '_i'\nreturn 'looped'",
    "got = yield a\nwhile got:\n    got = yield str(got) + '_back'\nreturn 'sent'",
    "try:\n    yield a\n    yield a + '_on'\nexcept ValueError as error:\n    yield 'thrown_' + str(error)\nfinally:\n    a = 'fin'\nyield a",
    "value = yield from inner(a)\nyield str(value) + '_v'\nreturn value",
    "yield from (x + '_c' for x in (a, 'd'))\nyield 'tail'",
    "if {t}:\n    return 'soon'\nyield a\nyield a + '_late'",
    "n = 0\nwhile True:\n    yield a + str(n)\n    n += 1",
)
_ASKED: Final = (
    "{g} = {f}({w})\n{n} = next({g}, 'end')\n{n} = {n} + next({g}, 'end')",
    "{g} = {f}({w})\nnext({g}, None)\n{n} = next({g}, 'end')",
    "{g} = {f}({w})\n{n} = 'q'\nfor {n} in {g}:\n    if {t}:\n        break\n    if len({n}) > 2:\n        break\n{n} = {n} + next({g}, 'end')",
    "{g} = {f}({w})\nnext({g}, None)\ntry:\n    {n} = {g}.send('s')\nexcept StopIteration as stop:\n    {n} = str(stop.value)",
    "{g} = {f}({w})\nnext({g}, None)\ntry:\n    {n} = {g}.throw(ValueError('v'))\nexcept (ValueError, StopIteration) as error:\n"
    "    {n} = type(error).__name__",
    "{g} = {f}({w})\n{n} = 'open'\nfor _ in range(2):\n    {n} = next({g}, 'end')\n{g}.close()\n{n} = {n} + next({g}, 'shut')",
    "{g} = {f}({w})\n{n} = 'q'\nfor x, y in zip({g}, ('p', 'q')):\n    {n} = x + y\n{n} = {n} + next({g}, 'end')",
    "{g} = {f}({w})\n{n} = str(any(len(x) > 3 for x in islice({g}, 5)))\n{n} = {n} + next({g}, 'end')",
    "{g} = {f}({w})\n{n} = str(all(x != 'b_i' for x in islice({g}, 3)))\n{n} = {n} + next({g}, 'end')",
    "{g} = {f}({w})\n{n} = '_'.join(islice({g}, 2)) + next({g}, 'end')",
    "{g} = {f}({w})\n{n} = '_'.join(takewhile(lambda x: x != 'three', islice({g}, 4))) + next({g}, 'end') + 'k'",
    "{g} = map(lambda x: x + '_m', {f}({w}))\n{n} = next({g}, 'end') + next({g}, 'end')",
    "{g} = filter(lambda x: len(x) > 2, islice({f}({w}), 4))\n{n} = next({g}, 'end')",
    "{g} = enumerate({f}({w}))\n{n} = '_'.join(str(x) for x in next({g}, ('no',)))",
    "{g} = islice({f}({w}), 4)\n{n} = str('three' in {g}) + next({g}, 'end')",
    "{g} = islice({f}({w}), 5)\n{n} = [x for x in {g}][-1:]\n{n} = ({n} or ['none'])[0] + next({g}, 'end')",
    "{g} = [{f}({w}), {f}('z')]\n{n} = '_'.join(next(x, 'end') for x in {g}) + next({g}[0], 'end')",
    "{g} = {f}({w})\n{n} = next(x for x in chain({g}, ['spare']) if len(x) > 1)",
    "{g} = {f}({w})\n{n} = 'q'\nwhile (x := next({g}, None)) is not None and len({n}) < 20:\n    {n} = {n} + x",
)
"""Ways to ask `{f}({w})` for its items; `{n}` holds a word behind."""


def script(draft: Draft) -> str:
    """Define a generator function of one word; its name."""
    name = draft.fresh("script")
    draft.need("from itertools import chain, islice, takewhile")
    inside = Scope(names=["a"])
    body = draft.chooser.pick(_SCRIPTS).replace("{t}", condition(draft, inside, 0))
    if "inner(" in body:
        inner = script(draft) if draft.chooser.chance(50) else f"{name}_inner"
        body = body.replace("inner(", f"{inner}(")
        draft.define(f"def {name}_inner(a):\n    yield a + '_inner'\n    return a + '_r'")
    draft.define(f"def {name}(a):\n{block([*inside.lines, *body.splitlines()])}")
    return name


def advanced(draft: Draft, scope: Scope, depth: int) -> str:
    """Items of a generator, asked for one by one."""
    name, held = draft.fresh("took"), draft.fresh("gen")
    scope.add(
        draft.chooser.pick(_ASKED).format(
            g=held, n=name, f=script(draft), w=word(draft, scope, depth), t=condition(draft, scope, 0)
        )
    )
    return name


def trace(draft: Draft, scope: Scope, depth: int) -> str:
    """What a generator has written to a list by the time that its consumer stops."""
    function, name = draft.fresh("traced"), draft.fresh("trail")
    draft.define(
        f"def {function}(trail, items):\n    trail.append('begin')\n    try:\n        for x in items:\n            trail.append(x)\n"
        "            yield x\n        trail.append('end')\n    finally:\n        trail.append('fin')"
    )
    draft.need("from itertools import chain, islice, takewhile")
    items = f"({word(draft, scope, depth)}, 'b', 'c')"
    scope.add(f"{name} = ['t']\n{name}g = {function}({name}, {items})")
    scope.add(
        draft.chooser.pick(
            [
                f"next({name}g)",
                f"any(x == 'b' for x in {name}g)",
                f"list(zip([1, 2], {name}g))",
                f"list(zip({name}g, [1]))",
                f"{name}x = list(islice({name}g, 1))",
                f"'b' in {name}g",
                f"for x in {name}g:\n    {name}.append('use')\n    break",
                f"{name}x = map({name}.append, {name}g)",
                f"{name}x = (x for x in {name}g if x)",
                f"{name}x, *_ = {name}g",
                f"next({name}g)\n{name}g.close()",
            ]
        )
    )
    return draft.chooser.pick([f"'_'.join({name})", f"{name}[-1]"])


def received(draft: Draft, scope: Scope, depth: int) -> str:
    """A coroutine of old: what is sent to it makes what it answers."""
    function, name = draft.fresh("answers"), draft.fresh("answer")
    draft.define(
        f"def {function}(first):\n    seen = [first]\n    while len(seen) < 4:\n        try:\n            got = yield '_'.join(seen)\n"
        "        except KeyError as error:\n            got = 'key_' + error.args[0]\n        seen.append(got or 'none')\n    return seen[-1]"
    )
    steps = "\n".join(
        draft.chooser.pick(
            [
                f"{name} = {name}g.send({word(draft, scope, 0)})",
                f"{name} = next({name}g)",
                f"{name} = {name}g.throw(KeyError({word(draft, scope, 0)}))",
            ]
        )
        for _ in range(draft.chooser.number(1, 4))
    )
    scope.add(
        f"{name}g = {function}({word(draft, scope, depth)})\n{name} = next({name}g)\ntry:\n{block(steps.splitlines())}\n"
        f"except StopIteration as stop:\n    {name} = stop.value + '_stop'"
    )
    return name


# Entities


def _steps(draft: Draft, scope: Scope, depth: int) -> str:
    """The body of a generator that creates entities between its yields."""
    one, two = scope.inner("name"), scope.inner("name")
    create(draft, one, depth - 1)
    create(draft, two, 0)
    last = creation(draft, scope, "name + '_last'")
    lines = draft.chooser.pick(
        [
            [*one.lines, "yield 1", *two.lines, "yield 2", last],
            ["for name in (name, 'turn2', 'turn3'):", *block(one.lines).splitlines(), "    yield name", last],
            ["try:", *block([*one.lines, "yield 1", *two.lines, "yield 2"]).splitlines(), "finally:", f"    {last}"],
            ["got = yield 1", "if got:", *block(one.lines).splitlines(), "yield 2", *two.lines, "return 3"],
            [f"yield {creation(draft, scope, 'name')}", *two.lines, "yield 2", last],
        ]
    )
    return block(lines)


def stepwise(draft: Draft, scope: Scope, depth: int) -> None:
    """A generator of entities that is asked for some of its steps."""
    name, held = draft.fresh("steps"), draft.fresh("run")
    inside = Scope([], "node", ["name"])
    draft.define(f"def {name}(node, name):\n{_steps(draft, inside, depth)}")
    draft.need("from itertools import chain, islice, takewhile")
    made = f"{name}({scope.node}, {word(draft, scope, 0)})"
    scope.add(
        draft.chooser.pick(
            [
                f"{held} = {made}\nnext({held})",
                f"{held} = {made}\nfor _ in range({draft.chooser.number(1, 4)}):\n    next({held}, None)",
                f"for _ in {made}:\n    {draft.chooser.pick(['pass', 'break'])}",
                f"any({made})",
                f"list(zip({made}, range({draft.chooser.number(0, 2)})))",
                f"list(zip(range({draft.chooser.number(0, 2)}), {made}))",
                f"{held} = {made}",
                f"{held} = {made}\nnext({held})\n{held}.close()",
                f"list(islice({made}, {draft.chooser.number(0, 3)}))",
                f"{held} = {made}\nnext({held})\ntry:\n    {held}.send('go')\nexcept StopIteration:\n    pass",
                f"{held} = {made}\nnext({held})\ntry:\n    {held}.throw(ValueError)\nexcept (ValueError, StopIteration):\n    pass",
                f"all(x == 1 for x in {made})",
                f"{held} = map(str, {made})",
                f"list(map(str, {made}))",
            ]
        )
    )


def by_callback(draft: Draft, scope: Scope, depth: int) -> None:
    """A generator of entities that timers and messages advance, any number of times."""
    if scope.methods is None or scope.node != "self":
        stepwise(draft, scope, depth)
        return
    name, held = draft.fresh("plan"), draft.fresh("running")
    inside = Scope([], "self", ["name"], scope.methods)
    scope.methods.append(f"def {name}(self, name):\n{_steps(draft, inside, depth)}")
    scope.add(f"self.{held} = self.{name}({word(draft, scope, 0)})")
    if draft.chooser.chance(40):
        scope.add(f"next(self.{held})")
    tick = draft.chooser.pick(
        [
            f"next(self.{held}, None)",
            f"try:\n    next(self.{held})\nexcept StopIteration:\n    self.create_publisher(String, {held + '_done'!r}, 10)",
            f"for _ in self.{held}:\n    break",
            f"next(self.{held}, None)\nnext(self.{held}, None)",
        ]
    )
    scope.methods.append(f"def on_{held}(self, *message):\n{block(tick.splitlines())}")
    scope.add(
        draft.chooser.pick(
            [
                f"self.create_timer(0.1, self.on_{held})",
                f"self.create_subscription(String, {held + '_in'!r}, self.on_{held}, 10)",
                f"self.create_timer(0.1, lambda: next(self.{held}, None))",
                f"self.create_timer(0.1, self.{held}.__next__)",
            ]
        )
    )


def lazily(draft: Draft, scope: Scope, _depth: int) -> None:
    """Expressions that make entities only as far as somebody asks."""
    name, parts = draft.fresh("lazy"), f"({word(draft, scope, 0)}, 'second', 'third')"
    made = creation(draft, scope, "x")
    draft.need("from itertools import chain, islice, takewhile")
    scope.add(
        draft.chooser.pick(
            [
                f"{name} = ({made} for x in {parts})",
                f"{name} = ({made} for x in {parts})\nnext({name})",
                f"any({made} for x in {parts})",
                f"all(({made}) is None for x in {parts})",
                f"{name} = map(lambda x: {made}, {parts})",
                f"next(map(lambda x: {made}, {parts}))",
                f"list(zip(map(lambda x: {made}, {parts}), [1, 2]))",
                f"list(islice(({made} for x in {parts}), 2))",
                f"for {name} in filter(lambda x: {made}, {parts}):\n    break",
                f"next(x for x in {parts} if ({made}) and x.startswith('s'))",
                f"list(takewhile(lambda x: ({made}) and x != 'second', {parts}))",
            ]
        )
    )


WAYS: Final[tuple[Way, ...]] = (advanced, advanced, advanced, trace, received)
STATEMENTS: Final[tuple[Statement, ...]] = (stepwise, by_callback, by_callback, lazily)
