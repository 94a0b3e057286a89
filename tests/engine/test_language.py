# SPDX-License-Identifier: Apache-2.0
"""A second language runs through the same engine: its own front end, its own operation, its own rules of attributes and truth.

Toy has statements of one line. An attribute is written with dashes, and each text is true, the empty one too:

    n = Node('toy_talker')
    if '': p = n.create-publisher(String, 'always', 10)
"""

from __future__ import annotations

import re
from ast import literal_eval
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Final, final

from rosward.analysis.attempts import run
from rosward.analysis.plan import make_plan
from rosward.analysis.read import SourcesRead, silent
from rosward.analysis.source_tree import SourceTree
from rosward.analysis.standalone import of_sources
from rosward.domain.values import Const, Value
from rosward.engine.budget import Budget
from rosward.engine.languages import LANGUAGES
from rosward.engine.libraries.library import Library
from rosward.engine.machine import Engine
from rosward.engine.python.language import PYTHON
from rosward.engine.running.frame import Frame
from rosward.engine.transfer import CORE
from rosward.frontends.front_end import FrontEnd
from rosward.frontends.registry import FRONT_ENDS
from rosward.ir import ops
from rosward.ir.program import Code, CodeKind, Module, Parameters
from rosward.models.tables import own_models
from rosward.ros.distro import Distro
from rosward.ros.entities import EntityKind
from rosward.source.discover import discover
from rosward.source.workspace import SourceFile

TALKER: Final = """\
use rclpy.node Node
use std_msgs.msg String
n = Node('toy_talker')
p = n.create-publisher(String, 'chatter', 10)
if '': a = n.create-publisher(String, 'always', 10)
if 0: b = n.create-publisher(String, 'never', 10)
on tick: c = n.create-publisher(String, 'late', 10)
t = n.create-timer(1, tick)
"""
NOTHING: Final = Parameters((), 0, None, (), None)
STATEMENT: Final = re.compile(r"(?:(if|on) (\S+): )?(\w+) = (\w+)(?:\.([\w-]+))?\((.*)\)")


@final
class Use(ops.Op):
    """dst = `name` of a module: an operation that Toy alone has."""

    def __init__(self, line: int, dst: int, module: str, name: str) -> None:
        super().__init__(line, 1)
        self.dst, self.module, self.name = dst, module, name


def lower(text: str, file: str, origins: Sequence[int] = (), name: str = "") -> Module:
    """Every variable is a cell, which functions share; a call has its registers in a row."""
    del origins, name
    lines = text.splitlines()
    found_names = re.findall(r"^use \S+ (\w+)|^on (\w+)|(\w+) =", text, re.MULTILINE)
    names = tuple(dict.fromkeys("".join(each) for each in found_names))
    number = {each: at for at, each in enumerate(names)}
    body: list[ops.Op] = []
    for at, written in enumerate(lines, 1):
        if written.startswith("use "):
            _, module, wanted = written.split()
            body += [Use(at, 0, module, wanted), ops.StoreCell(at, 1, number[wanted], 0)]
            continue
        found = STATEMENT.fullmatch(written)
        assert found is not None
        kind, guard, target, function, attribute, arguments = found.groups()
        given = [each.strip() for each in arguments.split(",")]
        call: list[ops.Op] = [ops.LoadCell(at, 1, 0, number[function])]
        call += [ops.LoadAttr(at, 1, 0, 0, attribute)] if attribute else []
        for register, each in enumerate(given, 1):
            known = each in number
            call.append(
                ops.LoadCell(at, 1, register, number[each]) if known else ops.Const(at, 1, register, literal_eval(each))
            )
        passed = tuple(ops.Argument("positional", register) for register in range(1, len(given) + 1))
        call += [ops.Call(at, 1, 0, 0, passed), ops.StoreCell(at, 1, number[target], 0)]
        if kind == "if":
            call = [ops.Const(at, 1, 0, literal_eval(guard)), ops.If(at, 1, 0, call, [])]
        if kind == "on":
            inner = Code(
                CodeKind.FUNCTION, guard, guard, file, at, NOTHING, call, 9, (), (), names, index=at, language="toy"
            )
            call = [
                ops.MakeFunction(at, 1, 0, inner, (), (), tuple(range(len(names)))),
                ops.StoreCell(at, 1, number[guard], 0),
            ]
        body += call
    code = Code(CodeKind.MODULE, "toy", "toy", file, 1, NOTHING, body, 9, (), names, (), language="toy")
    modules = frozenset(each.split()[1] for each in lines if each.startswith("use "))
    return Module(file, code, modules, modules, True, len(lines))


def use(machine: Engine, op: Use, frame: Frame) -> None:
    frame.op, frame.sequence = op, 0
    module = PYTHON.load_module(machine, op.module, frame, 0)
    frame.registers[op.dst] = PYTHON.load_attr(machine, module, op.name)


def truth(machine: Engine, value: Value) -> bool | None:
    return True if value.__class__ is Const and isinstance(value.value, str) else PYTHON.truth(machine, value)


def load_attr(machine: Engine, value: Value, name: str) -> Value:
    return PYTHON.load_attr(machine, value, name.replace("-", "_"))


TOY: Final = replace(PYTHON, name="toy", table={**CORE, Use: use}, truth=truth, load_attr=load_attr)
FRONT_END: Final = FrontEnd("toy", (".toy",), lower)


def read(folder: Path, text: str, **others: str) -> SourcesRead:
    (folder / "talker.toy").write_text(text, encoding="utf-8")
    for name, other in others.items():
        (folder / f"{name}.py").write_text(other, encoding="utf-8")
    found = discover([folder])
    workspace = replace(found, files=(*found.files, SourceFile(folder / "talker.toy", "talker.toy")))
    sources = SourceTree(workspace, front_ends=(FRONT_END, *FRONT_ENDS))
    library = Library(sources, own_models(), languages={**LANGUAGES, "toy": lambda: TOY})
    plan = make_plan(workspace, sources, library)
    return SourcesRead(workspace, sources, plan, library, (), Distro.JAZZY, Budget())


def published(read_: SourcesRead) -> dict[str, list[str]]:
    """The topics that each node publishes, without those that the client library adds."""
    nodes = of_sources(read_, (), silent).nodes
    return {n.fqn: sorted(e.name for e in n.entities if e.kind is EntityKind.PUBLISHER and not e.system) for n in nodes}


def test_another_language_creates_through_the_same_models(tmp_path: Path) -> None:
    """Its truth decides its branches, its attributes find the methods, and a model calls its function back."""
    assert published(read(tmp_path, TALKER)) == {"/toy_talker": ["/always", "/chatter", "/late"]}


def test_each_language_has_its_own_rules_in_one_run(tmp_path: Path) -> None:
    """A text is true in Toy and not in Python, whichever of them runs first."""
    python = (
        "import rclpy\nfrom rclpy.node import Node\nfrom std_msgs.msg import String\n"
        "n = Node('talker')\nn.create_publisher(String, 'first', 10)\n"
        "if '': n.create_publisher(String, 'empty', 10)\nrclpy.spin(n)\n"
    )
    found = published(read(tmp_path, TALKER, talker=python))
    assert found == {"/toy_talker": ["/always", "/chatter", "/late"], "/talker": ["/first"]}


def test_what_it_does_is_told_at_its_own_lines(tmp_path: Path) -> None:
    sources = read(tmp_path, TALKER)
    (entry,) = sources.plan.entries
    found = run(sources.library, entry, sources.budget)
    places = {(e.place.file, e.place.line) for e in found.log.entities}
    assert {("talker.toy", line) for line in (4, 5, 7)} <= places
    assert ("talker.toy", 6) not in places
