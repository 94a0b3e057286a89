# SPDX-License-Identifier: Apache-2.0
"""Does the engine bear programs that confuse every type? Each modelled function, called with arguments that nobody meant.

    python -m hostile.confused --count 2000 --seed 7        (in the folder tests)

A program makes some calls: of builtins, methods of builtin types, and functions, classes and methods that the stubs describe; without
arguments, with names alone, with too many, starred ones of known and unknown length, receivers of a wrong kind, values of every kind. The
results name entities. Every fifth program is a launch file, whose actions and substitutions are confused in the same way. Nothing may
raise (the net is off), and the sound node that each program makes first must be found.

The calls are dealt: each callee in each form of arguments once, in an order that the seed shuffles, then again with other values.
"""

from __future__ import annotations

import argparse
import ast
import builtins
import tempfile
import time
import traceback
from collections.abc import Iterator, Sequence
from functools import cache
from pathlib import Path
from random import Random
from typing import Final, NamedTuple

import rosward
from hostile.fuzz import Broken, write_good
from rosward.deployment.request import Request
from rosward.engine.budget import Budget
from rosward.engine.libraries.stub_files import STUBS
from rosward.models.tables import own_models
from rosward.pipeline import Result

CALLS: Final = 8
"""Calls in one program."""
SMALL: Final = Budget(steps=12_000, entry_steps=3_000, net=False)

FORMS: Final = 9
"""Forms of arguments, see `_arguments`."""
REACHED: Final = "reached"
_LAUNCH: Final = ("launch", "launch_ros", "launch_xml", "launch_yaml", "nav2_common", "moveit_configs_utils")

_VALUES_HEAD: Final = """\
import sys, os, math, collections, functools, itertools, json, copy, enum, rclpy
from std_msgs.msg import String
unknown = sys.argv[1]
either = 'a' if unknown else ['b', 1]
text = 'x/' + unknown + '/y'
def gen():
    yield 'g'
    yield unknown
class Plain:
    at = 1
class Names(list): pass
class Topic(str): pass
class Table(dict):
    def __missing__(self, key): return key
class Odd:
    def __getattr__(self, name): return self
    def __call__(self, *args, **kwargs): return self
    def __iter__(self): return self
    def __next__(self): raise StopIteration
    def __eq__(self, other): return unknown
    def __len__(self): return unknown
    def __getitem__(self, index): return index
class Color(enum.Enum):
    RED = 'red'
    def __str__(self): return 1
grown = []
for each in unknown: grown.append(each)
"""
_HEAD: Final = """\
rclpy.init()
good = rclpy.create_node('good')
good.create_publisher(String, 'chatter', 10)
class Node(rclpy.node.Node):
    def __init__(self): super().__init__('sub')
sub = Node()
"""
_HEAD_OF_LAUNCH: Final = """\
import launch, launch_ros
from launch import LaunchDescription
from launch.actions import ExecuteProcess, GroupAction, IncludeLaunchDescription, OpaqueFunction, SetEnvironmentVariable, TimerAction
from launch.conditions import IfCondition
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterFile
good = Node(package='good', executable='good.py')
actions = [good]
"""
VALUES: Final = (
    "None", "True", "0", "-1", "10**30", "2.5", "float('nan')", "float('inf')", "1j", "''", "b''", "b'\\xff'", "'a'", "'%s{}{0[a]}'", "'\\ud800'",
    "'a' * 5000", "unknown", "either", "text", "gen()", "gen", "Plain", "Plain()", "Names", "Names(['n'])", "Topic('t')", "Table(a=1)",
    "Odd()", "Odd", "Color", "Color.RED", "good", "Node", "rclpy", "os.path", "functools.partial(len)", "functools.partial(good, 1, a=2)",
    "[].append", "good.create_publisher", "'a'.join", "(lambda *a, **k: a)", "(lambda: unknown)", "[]", "['a', 1, None]", "grown", "[grown]",
    "()", "('a',)", "('a', ('b', []))", "{}", "{'a': 1}", "{1: {}}", "{unknown: unknown}", "{'a', 1}", "frozenset()", "set()", "range(3)",
    "range(0)", "range(10**9)", "slice(None)", "iter(['a'])", "zip('ab', [1])", "map(len, [[]])", "object()", "Exception('e')", "ValueError",
    "String", "String()", "type", "super", "property(len)", "staticmethod(len)", "...", "NotImplemented", "len", "dict", "int", "json",
)  # fmt: skip
_NAMES: Final = (
    "key",
    "default",
    "reverse",
    "name",
    "start",
    "sep",
    "a",
    "x",
    "node_name",
    "callback",
    "qos_profile",
    "msg_type",
    "topic",
)


class Callee(NamedTuple):
    """What is called: an import that it needs, and the expression."""

    imports: str
    expression: str
    receiver: bool = False


@cache
def callees() -> tuple[Callee, ...]:
    """All natives that a program can name, and all functions, classes and methods of the stubs."""
    found: list[Callee] = []
    for name in sorted(own_models().natives):
        head, _, last = name.rpartition(".")
        if head == "builtins":
            found.append(Callee("", last))
        elif hasattr(builtins, head):
            found += [Callee("", f"{head}.{last}", receiver=True), Callee("", f"@.{last}")]
        else:
            found.append(Callee(f"import {head}", name))
    for path in sorted(STUBS.rglob("*.pyi")):
        module = ".".join(path.relative_to(STUBS).with_suffix("").parts).removesuffix(".__init__")
        for each in ast.parse(path.read_text(encoding="utf-8")).body:
            if isinstance(each, ast.FunctionDef | ast.ClassDef):
                found.append(Callee(f"import {module}", f"{module}.{each.name}"))
            if isinstance(each, ast.ClassDef):
                for inner in each.body:
                    if isinstance(inner, ast.FunctionDef):
                        found.append(Callee(f"import {module}", f"{module}.{each.name}.{inner.name}", receiver=True))
                        found.append(Callee(f"import {module}", f"{module}.{each.name}().{inner.name}"))
                        found.append(Callee("", f"@.{inner.name}"))
    return tuple(dict.fromkeys(found))


def _arguments(random: Random, form: int, *, receiver: bool) -> str:
    def value() -> str:
        return random.choice(VALUES)

    own = [value()] if receiver and random.random() < 0.8 else []
    match form:
        case 0:
            words: list[str] = []
        case 1:
            words = [f"{n}={value()}" for n in random.sample(_NAMES, random.randrange(1, 4))]
        case 2:
            words = [f"*{value()}", *([value()] if random.random() < 0.3 else [])]
        case 3:
            words = [value(), f"**{value()}"]
        case 4:
            words = [value() for _ in range(random.randrange(4, 9))]
        case 5:
            words = [value(), f"{random.choice(_NAMES)}={value()}"]
        case _:
            words = [value() for _ in range(form - 5)]
    return ", ".join([*own, *words])


class Call(NamedTuple):
    """One call, as a program writes it."""

    imports: str
    text: str


def calls(random: Random, known: Sequence[Callee]) -> Iterator[Call]:
    """Calls without end: each callee in each form of arguments, then all of them again, with other values."""
    deck = [(callee, form) for callee in known for form in range(FORMS)]
    while True:
        random.shuffle(deck)
        for callee, form in deck:
            imports = f"try: {callee.imports}\nexcept ImportError: pass" if callee.imports else ""
            expression = callee.expression.replace("@", f"({random.choice(VALUES)})")
            yield Call(imports, f"{expression}({_arguments(random, form, receiver=callee.receiver)})")


_USES: Final = (
    "    good.create_publisher(String, r, 10)",
    "    good.create_publisher(String, f'{r}/x', 10)",
    "    for each in r: good.create_publisher(String, each, 10)",
    "    good.create_subscription(r, 'y', r, r)",
    "    good.create_publisher(String, 'a' + r, 10) if r == 'a' or 'a' in r else r[0]",
    "    a, *b = r; good.declare_parameter(a, b); rclpy.create_node(r)",
    "    r.x = r; r['x'] = r; r += r; del r[0]; good.create_timer(r, r); -r; r < @",
    "    with r as s: good.create_client(String, s)\n    match r:\n        case [x, *y] | {'a': x, **y}: print(x, y)",
)
_LAUNCHED: Final = (
    "actions.append(r)",
    "actions.append(GroupAction(r))",
    "actions.append(GroupAction([r, Node(package='good', executable='good.py', name=r, namespace=[r, '/', r])]))",
    "actions.append(Node(package=r, executable=r, parameters=[r, {'a': r, r: 1}], remappings=r))",
    "actions.append(Node(package='good', executable='good.py', parameters=r, remappings=[(r, r)], arguments=[r], ros_arguments=r))",
    "actions.append(ExecuteProcess(cmd=[r, 'a', r], additional_env=r, condition=IfCondition(r)))",
    "actions.append(IncludeLaunchDescription(r, launch_arguments=r, condition=r))",
    "actions += [SetEnvironmentVariable(r, r), TimerAction(period=r, actions=[r])]",
    "actions.append(OpaqueFunction(function=r, args=[r])); actions.append(OpaqueFunction(function=lambda context: f@(context)))",
    "actions.append(Node(package='good', executable='good.py', parameters=[ParameterFile(r)], condition=r, env=r, name=[r, r]))",
)


def _node_program(random: Random, dealt: Iterator[Call]) -> str:
    """One program that makes nodes."""
    imports: dict[str, None] = {}
    lines: list[str] = []
    for number in range(CALLS):
        call = next(dealt)
        imports[call.imports] = None
        use = random.choice(_USES).replace("@", random.choice(VALUES))
        lines.append(f"def f{number}():\n    r = {call.text}\n{use}\n    return r")
        lines.append(f"good.create_publisher(String, '{REACHED}{number}', 10)")
        lines.append(f"try: good.create_publisher(String, f{number}(), 10)\nexcept Exception as error: print(error)")
    return "\n".join([*imports, _VALUES_HEAD + _HEAD, *lines, "rclpy.spin(good)\n"])


def _launch_program(random: Random, dealt: Iterator[Call]) -> str:
    """One launch file."""
    imports: dict[str, None] = {}
    lines: list[str] = []
    for number in range(CALLS):
        call = next(dealt)
        imports[call.imports] = None
        lines.append(f"def f{number}(*context):\n    return {call.text}")
        lines.append(f"try: r = f{number}()\nexcept Exception as error: r = error")
        use = random.choice(_LAUNCHED).replace("@", f"{number}").replace("; ", "\n    ")
        lines.append(f"try:\n    {use}\nexcept Exception as error: print(error)")
    end = "def generate_launch_description():\n    return LaunchDescription(actions)\n"
    return "\n".join([*imports, _VALUES_HEAD + _HEAD_OF_LAUNCH, *lines, end])


class Program(NamedTuple):
    """One program, and where it stands in the workspace of its batch."""

    path: str
    text: str


def programs(seed: int) -> Iterator[Program]:
    """Programs without end, the same ones for each seed."""
    random = Random(seed)
    every = calls(random, callees())
    of_launch = calls(random, [c for c in callees() if c.expression.partition(".")[0] in _LAUNCH])
    number = 0
    while True:
        if number % 5 == 4:
            yield Program(f"p{number}/p{number}.launch.py", _launch_program(random, of_launch))
        else:
            yield Program(f"p{number}/p{number}.py", _node_program(random, every))
        number += 1


class Failure(NamedTuple):
    """What one program did."""

    program: Program
    error: str


class Tried(NamedTuple):
    """What a run of programs showed, and how many of their calls surely were reached."""

    failures: list[Failure]
    reached: int


def confuse(source: Iterator[Program], count: int, slow: float = 8.0, size: int = 50) -> Tried:
    """Analyse `count` programs. Those fail that make rosward fail, or take more than `slow` seconds of CPU time."""
    failures: list[Failure] = []
    reached = 0
    for first in range(0, count, size):
        batch = [next(source) for _ in range(min(size, count - first))]
        tried = _attempt(batch, SMALL)
        while tried.error and batch:  # which one it was is known with the net on
            fell = _attempt(batch, SMALL._replace(net=True)).fell or {p.path for p in batch}
            for each in [p for p in batch if p.path in fell]:
                alone = _attempt([each], SMALL)
                failures += [Failure(each, alone.error)] if alone.error else []
            batch = [p for p in batch if p.path not in fell]
            tried = _attempt(batch, SMALL)
        if tried.seconds > slow + size / 4:
            for each in batch:
                spent = _attempt([each], SMALL).seconds
                failures += [Failure(each, f"{spent:.1f} seconds")] if spent > slow else []
        reached += tried.reached
    return Tried(failures, reached)


class _Attempt(NamedTuple):
    """What went wrong, the seconds of CPU time, how many calls were reached, and which files fell into the net."""

    error: str
    seconds: float
    reached: int
    fell: set[str]


def _attempt(batch: list[Program], budget: Budget) -> _Attempt:
    with tempfile.TemporaryDirectory(prefix="rosward-confused-") as folder:
        write_good(Path(folder))
        for each in batch:
            path = Path(folder) / each.path
            path.parent.mkdir()
            path.write_text(each.text, encoding="utf-8")
        start = time.process_time()
        reached = 0
        error = ""
        fell: set[str] = set()
        try:
            alone = rosward.extract(folder, budget=budget)
            launched = rosward.extract(folder, budget=budget, request=Request(all_launch=True))
            fell = {f.place.file for r in (alone, launched) for f in r.findings if f.code == "RW299"}
            reached = sum(REACHED in e.name for n in alone.network.nodes if n.fqn == "/good" for e in n.entities)
            _expect(alone, 1 + sum(not p.path.endswith(".launch.py") for p in batch))
            _expect(launched, 1)
        except Exception:
            error = traceback.format_exc(limit=-6)
        return _Attempt(error, time.process_time() - start, reached, fell)


def _expect(result: Result, sound: int) -> None:
    wrong = [f for f in result.findings if f.code == "RW001"]
    if wrong:
        raise Broken(f"not a program: {wrong[0].place} {wrong[0].message}")
    found = sum(n.fqn == "/good" for n in result.network.nodes)
    if found < sound:
        raise Broken(f"the sound node is lost: {found} of {sound}")


def _main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=1_000)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--keep", type=Path, default=Path("confused-failures"), help="where failing programs go")
    options = parser.parse_args()
    failed = reached = 0
    source = programs(options.seed)
    for first in range(0, options.count, 100):
        failures, more = confuse(source, min(100, options.count - first))
        reached += more
        for failure in failures:
            failed += 1
            options.keep.mkdir(parents=True, exist_ok=True)
            kept = options.keep / f"{options.seed}-{Path(failure.program.path).name}"
            kept.write_text(failure.program.text, encoding="utf-8")
            print(kept, *failure.error.strip().splitlines()[-5:], sep="\n", flush=True)
        done, spent = min(first + 100, options.count), time.process_time()
        print(f"{done} programs, {reached} calls reached, {failed} failures, {spent:.0f} s", flush=True)


if __name__ == "__main__":
    _main()
