# SPDX-License-Identifier: Apache-2.0
"""Any tree of actions is executed to an end, without an exception and to the same result each time."""

from __future__ import annotations

import random
from typing import Any

import pytest
from sampling import sample

from deployment.execution import HERE, UNKNOWN, Run, share, text
from rosward.deployment import tree
from rosward.domain.choice import join
from rosward.domain.compound import Tuple
from rosward.domain.values import Const, Value

TEXTS = (
    "",
    "a",
    "/a",
    "a/",
    "true",
    "false",
    "1",
    "-1",
    "[1, 2]",
    "{a: 1}",
    "a b",
    "'",
    "$(x",
    "\0",
    "ros_namespace",
    "é",
    "x:=y",
    "../..",
)
KINDS = [
    "var",
    "env",
    "find-pkg-share",
    "find-pkg-prefix",
    "exec-in-pkg",
    "find-exec",
    "dirname",
    "filename",
    "launch-log-dir",
    "anon",
    "eval",
    "command",
    "param",
    "not",
    "and",
    "or",
    "any",
    "all",
    "equals",
    "not-equals",
    "if",
    "file-content",
    "path-join",
    "string-join",
    "local",
    "for-var",
    "index",
    "parameter-file",
    "replace-string",
    "rewritten-yaml",
    "python",
    "nonsense",
]
SCOPES = [(what, how) for what in ("configurations", "environment") for how in ("push", "pop", "reset")]
EVENTS = (
    "process-start",
    "process-exit",
    "process-io",
    "execution-complete",
    "shutdown",
    "lifecycle",
    "include-complete",
    "other",
)


class Trees:
    """Random trees."""

    def __init__(self, seed: int) -> None:
        self.random = random.Random(seed)

    def value(self) -> Value:
        plain = Const(self.random.choice(TEXTS))
        if self.random.random() < 0.6:
            return plain
        odd = (Const(None), Const(5), Const(b"x"), Tuple((Const(1),)), Tuple(()))
        return self.random.choice(
            (join(plain, Const("b")), UNKNOWN, share("demo", "/a.yaml"), share("acme", "/b"), *odd)
        )

    def template(self, depth: int = 0) -> tree.Template:
        pieces: list[Value | tree.Substitution] = []
        for _ in range(self.random.choice((0, 1, 1, 2))):
            deeper = depth < 3 and self.random.random() < 0.4
            pieces.append(self.substitution(depth + 1) if deeper else self.value())
        return tuple(pieces)

    def substitution(self, depth: int) -> tree.Substitution:
        arguments = tuple(self.template(depth) for _ in range(self.random.randrange(4)))
        tables = tuple(((self.template(3), self.template(3)),) for _ in range(self.random.randrange(3)))
        return tree.Substitution(
            self.random.choice(KINDS), arguments, HERE, self.random.choice((None, self.value())), tables
        )

    def pairs(self) -> tuple[tuple[tree.Template, tree.Template], ...]:
        return tuple((self.template(2), self.template(2)) for _ in range(self.random.randrange(3)))

    def data(self, depth: int = 0) -> tree.ParameterData:
        kind = self.random.choice((None, "str", "int", "float", "bool", "yaml", "List[int]", "List[str]", "odd"))
        choices: list[tree.ParameterData] = [tree.Literal(self.value()), tree.Typed(self.template(2), kind)]
        if depth < 2:
            choices.append(tree.Several(tuple(self.data(depth + 1) for _ in range(self.random.randrange(3)))))
        return self.random.choice(choices)

    def source(self) -> tree.ParameterSource:
        return self.random.choice(
            (
                tree.ParameterTable(tuple((self.template(2), self.data()) for _ in range(2)), HERE),
                tree.ParameterFile(self.template(), HERE, self.random.random() < 0.5),
                tree.ParameterArgument(self.template(2), self.data(), HERE),
            )
        )

    def condition(self) -> tree.Condition | None:
        kind = self.random.choice(("if", "unless", "equals", "not-equals", "python", "odd"))
        found = tree.Condition(
            kind, tuple(self.template(2) for _ in range(self.random.randrange(3))), HERE, self.value()
        )
        return found if self.random.random() < 0.3 else None

    def component(self) -> tree.Component:
        return tree.Component(
            package=self.template(2),
            plugin=self.template(2),
            name=self.random.choice((None, self.template(2))),
            namespace=self.random.choice((None, self.template(2))),
            remappings=self.pairs(),
            parameters=(self.source(),),
            place=HERE,
            condition=self.condition(),
        )

    def node(self) -> tree.StartNode:
        return tree.StartNode(
            place=HERE,
            condition=self.condition(),
            identity=self.random.choice((None, Const("one"))),
            kind=self.random.choice(list(tree.NodeKind)),
            package=self.random.choice((None, self.template())),
            executable=self.template(),
            name=self.random.choice((None, self.template())),
            namespace=self.random.choice((None, self.template())),
            remappings=self.pairs(),
            parameters=tuple(self.source() for _ in range(2)),
            arguments=(self.template(),),
            environment=self.pairs(),
            components=(self.component(),) if self.random.random() < 0.3 else (),
        )

    def action(self, depth: int = 0) -> tree.LaunchAction:
        given: dict[str, Any] = {"place": HERE, "condition": self.condition()}
        template = self.template
        what, how = self.random.choice(SCOPES)
        return self.random.choice(
            (
                self.node,
                lambda: tree.StartProcess(
                    command=tuple(template() for _ in range(3)), shell=self.random.random() < 0.5, **given
                ),
                lambda: tree.LoadComponents(
                    target=self.random.choice((template(), self.node())), components=(self.component(),), **given
                ),
                lambda: tree.Include(path=template(), arguments=self.pairs(), **given),
                lambda: tree.Include(path=None, arguments=self.pairs(), body=self.inner(depth), **given),
                lambda: tree.Include(path=(share("demo", "/launch/main.launch.py"),), arguments=self.pairs(), **given),
                lambda: tree.Group(
                    actions=self.inner(depth),
                    scoped=self.random.random() < 0.7,
                    forwarding=self.random.random() < 0.7,
                    configurations=self.pairs(),
                    **given,
                ),
                lambda: tree.Maybe(actions=self.inner(depth), why="something", **given),
                lambda: tree.Declare(
                    name=template(), default=self.random.choice((None, template())), choices=(template(),), **given
                ),
                lambda: tree.SetConfiguration(name=template(), value=self.random.choice((None, template())), **given),
                lambda: tree.Environ(
                    how=self.random.choice(("set", "unset", "append", "prepend")),
                    name=template(),
                    value=template(),
                    **given,
                ),
                lambda: tree.ScopeChange(what=what, how=how, configurations=self.pairs(), **given),
                lambda: tree.PushNamespace(namespace=template(), **given),
                lambda: tree.SetRemap(source=template(), target=template(), **given),
                lambda: tree.SetParameter(
                    parameter=self.source(), node=self.random.choice((None, template())), **given
                ),
                lambda: tree.Timer(period=template(), actions=self.inner(depth), **given),
                lambda: tree.OnEvent(
                    event=self.random.choice(EVENTS),
                    actions=self.inner(depth),
                    target=self.random.choice((None, Const("one"))),
                    **given,
                ),
                lambda: tree.ForEach(
                    values=template(), count=self.random.random() < 0.5, body=self.inner(depth), **given
                ),
                lambda: tree.Inert(kind="LogInfo", **given),
                lambda: tree.Unread(why="odd", **given),
            )
        )()

    def inner(self, depth: int) -> tuple[tree.LaunchAction, ...]:
        return self.actions(depth + 1) if depth < 3 else ()

    def actions(self, depth: int = 0) -> tuple[tree.LaunchAction, ...]:
        return tuple(self.action(depth) for _ in range(self.random.randrange(1, 4 if depth else 12)))


def test_each_action_of_the_tree_has_an_execution() -> None:
    """`test_any_tree` executes random trees, and what has no execution is an exception: so each action is in one of them."""
    executed: set[str] = set()
    for seed in range(40):
        executed |= {type(action).__name__ for action in Trees(seed).actions()}
    declared = {cls.__name__ for cls in tree.LaunchAction.__subclasses__()}
    assert declared - executed == {
        "Opaque",
        "Added",
    }  # functions of Python: test_python_code.py, systems/added_entities.md


@pytest.mark.parametrize("seed", sample(range(40), 2))
def test_any_tree(seed: int) -> None:
    def run() -> Run:
        files = {"demo/a.yaml": "/**: {ros__parameters: {a: $(var x), b: [1, 2]}}"}
        return Run(Trees(seed).actions(), files, limit=300, x="*")

    one, two = run(), run()
    assert (one.lines, one.codes) == (two.lines, two.codes)


def test_texts_of_any_length() -> None:
    long = text("x" * 200_000)
    run = Run(
        [
            tree.StartNode(
                place=HERE,
                executable=long,
                name=long,
                parameters=(tree.ParameterTable(((long, tree.Typed(long)),), HERE),),
            )
        ]
    )
    assert len(run.lines) == 1
