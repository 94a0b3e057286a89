# SPDX-License-Identifier: Apache-2.0
"""Statements that create entities on a node, as real code writes them: in loops, methods, callbacks, through aliases.

create(draft, scope, 2)    adds to the scope   for name in NAMES1: self.create_publisher(String, f"{name}/cmd", 10)
"""

from __future__ import annotations

from typing import Final

from .draft import Draft, Scope, Statement, block
from .values import condition, word


def name_of(draft: Draft, scope: Scope, depth: int) -> str:
    """An expression for the name of an entity."""
    text = word(draft, scope, depth)
    prefix = draft.chooser.pick(["", "", "/", "~/", "rel/", "/abs/"])
    return f"{prefix!r} + {text}" if prefix else text


def creation(draft: Draft, scope: Scope, name: str, node: str | None = None) -> str:
    """One call that creates something called `name`."""
    node = node or scope.node
    kind = draft.chooser.number(0, 9)
    if kind <= 3:
        return draft.chooser.pick(
            [
                f"{node}.create_publisher(String, {name}, 10)",
                f"{node}.create_publisher(msg_type=String, topic={name}, qos_profile=1)",
                f"{node}.create_publisher(String, {name}, qos_profile=QoSProfile(depth=5))",
            ]
        )
    if kind <= 5:
        return draft.chooser.pick(
            [
                f"{node}.create_subscription(String, {name}, lambda m: None, 10)",
                f"{node}.create_subscription(String, topic={name}, callback=print, qos_profile=qos_profile_sensor_data)",
            ]
        )
    if kind == 6:
        return f"{node}.create_service(Trigger, {name}, lambda q, r: r)"
    if kind == 7:
        return draft.chooser.pick(
            [f"{node}.create_client(Trigger, {name})", f"{node}.create_client(srv_name={name}, srv_type=Trigger)"]
        )
    if kind == 8:
        return f"ActionClient({node}, Fibonacci, {name})"
    return f"ActionServer({node}, Fibonacci, {name}, lambda handle: Fibonacci.Result())"


def plain(draft: Draft, scope: Scope, depth: int) -> None:
    call = creation(draft, scope, name_of(draft, scope, depth))
    if draft.chooser.chance(30):
        scope.add(f"{draft.fresh('handle')} = {call}")
    elif scope.node == "self" and draft.chooser.chance(40):
        scope.add(f"self.{draft.fresh('handle')} = {call}")
    else:
        scope.add(call)


def loop(draft: Draft, scope: Scope, depth: int) -> None:
    kind = draft.chooser.number(0, 7)
    parts = ", ".join(word(draft, scope, depth - 1) for _ in range(draft.chooser.number(1, 3)))
    heads = {
        0: (f"for x in [{parts}]:", ("x",)),
        1: (f"for x, y in {{'k': {word(draft, scope, 0)}, 'l': 'm'}}.items():", ("x", "y")),
        2: (f"for i in range({draft.chooser.number(1, 3)}):", ("'n' + str(i)", 'f"r{i}"', "'n%d' % i")),
        3: (f"for i, x in enumerate(({parts},), start=1):", ("x", 'f"{x}{i}"')),
        4: (f"for x, y in zip(({parts},), ['p', 'q', 'r']):", ("x", "y", "(x + y)")),
        5: (f"for x in sorted({{{parts}}}):", ("x",)),
        6: (f"for x in (w + '_g' for w in [{parts}]):", ("x",)),
        7: (f"for x in {{{parts}: 1}}:" if "," not in parts else f"for x in dict.fromkeys([{parts}]):", ("x",)),
    }
    head, names = heads[kind]
    inside = scope.inner(*names)
    if draft.chooser.chance(30):
        inside.add(f"if {condition(draft, inside, 0)}:\n    {draft.chooser.pick(['continue', 'pass', 'break'])}")
    create(draft, inside, depth - 1)
    scope.add(f"{head}\n{block(inside.lines)}")


def counting(draft: Draft, scope: Scope, depth: int) -> None:
    count = draft.fresh("count")
    inside = scope.inner(f"('w' + str({count}))")
    create(draft, inside, depth - 1)
    scope.add(f"{count} = {draft.chooser.number(1, 3)}\nwhile {count}:\n{block(inside.lines)}\n    {count} -= 1")


def branch(draft: Draft, scope: Scope, depth: int) -> None:
    test = condition(draft, scope, depth - 1)
    one, two = scope.inner(), scope.inner()
    create(draft, one, depth - 1)
    create(draft, two, depth - 1)
    scope.add(f"if {test}:\n{block(one.lines)}\nelse:\n{block(two.lines)}")


def attempt(draft: Draft, scope: Scope, depth: int) -> None:
    inside = scope.inner()
    create(draft, inside, depth - 1)
    tail = scope.inner()
    if draft.chooser.chance(50):
        create(draft, tail, depth - 1)
    ends = draft.chooser.pick(["", "raise RuntimeError('no')", "int('x')"])
    word_of = draft.chooser.pick(["except Exception as error:", "except (RuntimeError, ValueError):", "finally:"])
    if word_of == "finally:" and ends:
        ends = ""
    scope.add(f"try:\n{block([*inside.lines, *([ends] if ends else [])])}\n{word_of}\n{block(tail.lines)}")


def method(draft: Draft, scope: Scope, depth: int) -> None:
    if scope.methods is None:
        function(draft, scope, depth)
        return
    name = draft.fresh("setup")
    inside = Scope([], "self", ["name", "suffix"], scope.methods)
    create(draft, inside, depth - 1)
    scope.methods.append(f"def {name}(self, name, suffix='sfx'):\n{block(inside.lines)}")
    argument = word(draft, scope, depth - 1)
    draft_call = draft.chooser.pick(
        [
            f"self.{name}({argument})",
            f"self.{name}(name={argument}, suffix='s2')",
            f"getattr(self, {name!r})({argument})",
            f"type(self).{name}(self, {argument})",
            f"[self.{name}(x) for x in ({argument}, 'twice')]",
            f"self.{name}(*[{argument}], **{{'suffix': 'kw'}})",
        ]
    )
    scope.add(draft_call if scope.node == "self" else f"self.{name}({argument})")


def function(draft: Draft, scope: Scope, depth: int) -> None:
    name = draft.fresh("add")
    inside = Scope([], "node", ["name"])
    create(draft, inside, depth - 1)
    draft.define(f"def {name}(node, name='dflt'):\n{block(inside.lines)}")
    argument = word(draft, scope, depth - 1)
    scope.add(
        draft.chooser.pick(
            [
                f"{name}({scope.node}, {argument})",
                f"{name}(name={argument}, node={scope.node})",
                f"list(map(lambda a: {name}({scope.node}, a), [{argument}, 'mapped']))",
                f"{name}({scope.node})",
            ]
        )
    )


def composition(draft: Draft, scope: Scope, depth: int) -> None:
    cls = draft.fresh("Part")
    inside = Scope([], draft.chooser.pick(["self.node", "node", "self._parent.node"]), ["prefix", "self.prefix"], None)
    create(draft, inside, depth - 1)
    later = Scope([], "self.node", ["self.prefix"], None)
    create(draft, later, depth - 1)
    start = ["self.node = node", "self.prefix = prefix", "self._parent = self"]
    draft.define(
        f"class {cls}:\n    def __init__(self, node, prefix):\n"
        f"{block([*start, *inside.lines], 2)}\n    def start(self):\n{block(later.lines, 2)}\n"
        "        return self"
    )
    keep = "self.part = " if scope.node == "self" and draft.chooser.chance(50) else ""
    scope.add(f"{keep}{cls}({scope.node}, {word(draft, scope, depth - 1)}){draft.chooser.pick(['', '.start()'])}")


def alias(draft: Draft, scope: Scope, depth: int) -> None:
    maker, name = draft.fresh("make"), name_of(draft, scope, depth - 1)
    draft.need("from functools import partial")
    scope.add(
        draft.chooser.pick(
            [
                f"{maker} = {scope.node}.create_publisher\n{maker}(String, {name}, 10)",
                f"{maker} = partial({scope.node}.create_publisher, String, qos_profile=10)\n{maker}(topic={name})",
                f"getattr({scope.node}, 'create_' + 'publisher')(String, {name}, 10)",
                f"{maker} = [{scope.node}.create_publisher(String, x + '_l', 10) for x in ({name}, 'l2')]",
                f"{maker} = {{x: {scope.node}.create_client(Trigger, x + '_d') for x in [{name}]}}",
                f"{maker} = lambda n: {scope.node}.create_subscription(String, n, print, 10)\n{maker}({name})",
                f"{scope.node}.destroy_publisher({scope.node}.create_publisher(String, {name}, 10))",
                f"{maker} = {{'pub': {scope.node}.create_publisher}}\n{maker}['pub'](String, {name}, 10)",
                f"Node.create_publisher({scope.node}, String, {name}, 10)",
                f"{maker} = (String, {name}, 10)\n{scope.node}.create_publisher(*{maker})",
                f"{maker} = dict(topic={name}, qos_profile=10)\n{scope.node}.create_publisher(String, **{maker})",
                f"list(map(lambda n: {scope.node}.create_publisher(String, n, 10), [{name}]))",
                (
                    f"{maker} = {scope.node}.create_publisher(String, {name}, 10)\n"
                    f"{scope.node}.create_publisher(String, {maker}.topic_name + '_of', 10)"
                ),
            ]
        )
    )


def callback(draft: Draft, scope: Scope, depth: int) -> None:
    if scope.methods is None or scope.node != "self":
        plain(draft, scope, depth)
        return
    name = draft.fresh("on")
    inside = Scope([], "self", [], scope.methods)
    create(draft, inside, depth - 1)
    source = name_of(draft, scope, depth - 1)
    kind = draft.chooser.number(0, 5)
    if kind == 0:
        scope.add(f"self.create_timer(1.0, self.{name})")
        arguments, result = "self", ""
    elif kind == 1:
        scope.add(f"self.create_subscription(String, {source}, self.{name}, 10)")
        arguments, result = "self, message", ""
    elif kind == 2:
        scope.add(f"self.create_service(Trigger, {source}, self.{name})")
        arguments, result = "self, request, response", "return response"
    elif kind == 3:
        draft.need("from functools import partial")
        scope.add(f"self.create_subscription(String, {source}, partial(self.{name}, {word(draft, scope, 0)}), 10)")
        arguments, result = "self, given, message", ""
        inside.lines += [creation(draft, inside, "given + '_g'")]
    elif kind == 4:
        scope.add(f"self.create_timer(1.0, lambda: self.{name}({word(draft, scope, 0)}))")
        arguments, result = "self, given", ""
        inside.lines += [creation(draft, inside, "given + '_h'")]
    else:
        flag = draft.fresh("flag")
        scope.add(
            f"self.{flag} = None\nself.create_timer(1.0, self.{name})\n"
            f"self.create_subscription(String, {source}, lambda m: setattr(self, {flag!r}, 'got'), 10)"
        )
        arguments, result = (
            "self",
            f"if self.{flag} is not None:\n    self.create_publisher(String, self.{flag} + '_late', 10)",
        )
    scope.methods.append(f"def {name}({arguments}):\n{block([*inside.lines, *result.splitlines()])}")


def thread(draft: Draft, scope: Scope, depth: int) -> None:
    draft.need("import threading")
    name, worker = name_of(draft, scope, depth - 1), draft.fresh("worker")
    scope.add(
        f"{worker} = threading.Thread(target={scope.node}.create_publisher, args=(String, {name}, 10))\n"
        f"{worker}.start()\n{worker}.join()"
    )


def nothing(_draft: Draft, _scope: Scope, _depth: int) -> None:
    """A block without an entity."""


def dispatch(draft: Draft, scope: Scope, depth: int) -> None:
    table, node = draft.fresh("table"), scope.node
    name, key = name_of(draft, scope, depth - 1), draft.chooser.pick(["pub", "sub", "none"])
    draft.define(
        f"def {table}_pub(node, name):\n"
        "    return node.create_publisher(String, name, 10)\n\n\n"
        f"def {table}_sub(node, name):\n"
        "    return node.create_subscription(String, name, print, 10)\n\n\n"
        f"{table} = {{'pub': {table}_pub, 'sub': {table}_sub}}"
    )
    scope.add(
        draft.chooser.pick(
            [
                f"{table}.get({key!r}, {table}_pub)({node}, {name})",
                f"for action in {table}.values():\n    action({node}, {name})",
                f"[a({node}, k + 'x') for k, a in {table}.items()]",
            ]
        )
    )


STATEMENTS: Final[tuple[Statement, ...]] = (
    *(plain, plain, plain, loop, loop, counting, branch, branch, attempt, method, method, function, function),
    *(composition, composition, alias, alias, callback, callback, thread, dispatch, nothing),
)


def create(draft: Draft, scope: Scope, depth: int) -> None:
    """Add statements that create entities."""
    for _ in range(draft.chooser.number(1, 2)):
        statement = plain if depth <= 0 else draft.chooser.pick(draft.statements)
        draft.used.add(f"create {statement.__name__}")
        statement(draft, scope, max(depth, 1))
