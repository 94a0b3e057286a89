# SPDX-License-Identifier: Apache-2.0
"""Promise: a process that is started with a command line has the nodes, names and parameters that the real rclpy (kilted) gives it.

One program with two nodes, whose topics depend on parameters, is started with each row of a table of command lines: for real, and by the
analysis. The graphs have to be equal.
"""

from __future__ import annotations

import itertools
import os
from pathlib import Path
from typing import Any

import pytest

os.environ.setdefault("ROS_AUTOMATIC_DISCOVERY_RANGE", "LOCALHOST")
rclpy = pytest.importorskip("rclpy")

from rosward.analysis.attempts import run  # noqa: E402
from rosward.analysis.deep_stack import with_deep_stack  # noqa: E402
from rosward.analysis.plan import make_plan  # noqa: E402
from rosward.analysis.source_tree import SourceTree  # noqa: E402
from rosward.domain.series import Series  # noqa: E402
from rosward.domain.values import Const  # noqa: E402
from rosward.effects.configuration import Configuration  # noqa: E402
from rosward.engine.budget import Budget  # noqa: E402
from rosward.engine.libraries.library import Library  # noqa: E402
from rosward.models.tables import own_models  # noqa: E402
from rosward.naming.collect import Process, collect  # noqa: E402
from rosward.naming.command_line import read_words  # noqa: E402
from rosward.ros.distro import Distro  # noqa: E402
from rosward.ros.entities import EntityKind  # noqa: E402
from rosward.source.discover import discover  # noqa: E402

PROGRAM = """
import rclpy
from rclpy.action import ActionClient
from rclpy.node import Node
from std_msgs.msg import String
from std_srvs.srv import SetBool
from test_msgs.action import Fibonacci


class First(Node):
    def __init__(self, context=None):
        super().__init__('first', context=context)
        label = self.declare_parameter('label', 'plain').value
        self.create_publisher(String, f'label_{label}', 1)
        self.create_publisher(String, 'chatter', 1)
        self.create_publisher(String, '~/private', 1)
        self.create_subscription(String, '/absolute', print, 1)
        self.create_service(SetBool, 'serve', print)
        self.create_client(SetBool, '/remote/call')
        self.goals = ActionClient(self, Fibonacci, 'goal')
        if self.declare_parameter('extra', False).value:
            self.create_publisher(String, 'extra', 1)
        for word in self.declare_parameter('words', ['one']).value:
            self.create_publisher(String, f'word/{word}', 1)


class Second(Node):
    def __init__(self, context=None):
        super().__init__('second', context=context, namespace='/own')
        self.declare_parameter('label', 'other')
        self.create_publisher(String, 'label_' + self.get_parameter('label').value, 1)
        self.create_publisher(String, 'chatter', 1)
        self.create_subscription(String, '~/private', print, 1)


def main():
    rclpy.init()
    nodes = [First(), Second()]
    rclpy.spin(nodes[0])


if __name__ == '__main__':
    main()
"""

RULES = """
__node:=renamed | first:__node:=renamed | second:__node:=other | __name:=renamed | __ns:=/space | second:__ns:=/space | first:__ns:=/a/b
first:__node:=second | chatter:=/up/talk | chatter:=talk | first:chatter:=talk | second:chatter:=~/talk | /chatter:=/talk | /own/chatter:=/talk
~/private:=public | ~/private:=~/hidden | first:~/private:=/public | /first/private:=there | /absolute:=relative | /absolute:=~/x
serve:=/other/serve | rosservice://serve:=/s | rostopic://serve:=/t | rostopic://chatter:=/t | rosservice://chatter:=/s
/remote/call:=call | goal:=/robot/goal | rostopic://goal:=aim | label_plain:=named | label_other:=named | word/one:=/w | extra:=more
/rosout:=/log | /parameter_events:=/events | ~/get_parameters:=~/gp | first:/rosout:=/first_log | chatter:={node}/c | {node}/x:=y
""".replace("\n", "|")
PARAMETERS = """
label:=set | first:label:=mine | second:label:=yours | /**:label:=any | label:=007 | label:='7' | extra:=true | extra:=True | extra:=yes
first:extra:=on | second:extra:=true | words:=[a,b] | words:=['1','2'] | use_sim_time:=true | second:use_sim_time:=true | label:=/abs
label:=~/tilde | other:=1 | first:words:=[x,y,z]
""".replace("\n", "|")
REMAPS = [r.strip() for r in RULES.split("|") if r.strip()]
VALUES = [p.strip() for p in PARAMETERS.split("|") if p.strip()]


def command_lines() -> list[tuple[str, ...]]:
    """Every rule alone, pairs that meet, old-style rules, and both kinds together."""
    ros = "--ros-args"
    rows: list[tuple[str, ...]] = [
        (),
        (ros,),
        (ros, "--disable-rosout-logs"),
        ("user", ros, "-r", "chatter:=x", "--", "tail"),
    ]
    rows += [(ros, "-r", rule) for rule in REMAPS]
    rows += [(ros, "-p", value) for value in VALUES]
    rows += [(rule,) for rule in REMAPS[:12]]
    rows += [(ros, "-r", one, "-r", two) for one, two in itertools.pairwise(REMAPS)]
    rows += [(ros, "-p", one, "-p", two) for one, two in itertools.pairwise(VALUES)]
    rows += [(ros, "-r", one, "-p", two) for one, two in zip(itertools.cycle(REMAPS[:7]), VALUES, strict=False)]
    rows += [
        (ros, "-p", two, "-r", one, "-r", three)
        for one, two, three in zip(REMAPS[7:], itertools.cycle(VALUES), REMAPS, strict=False)
    ]
    return rows


LINES = command_lines()
DOMAINS = 231
"""So many domains there are beside that of everybody (the ports of further ones are beyond the last)."""
Graph = set[tuple[str, str, str]]


def live(words: tuple[str, ...], namespace: dict[str, Any], domain: int) -> Graph | str:
    """The graph of the real nodes: (node, kind, name); the word of the error where they cannot be made.

    Each in a domain of its own: what is left of nodes of the same name would be mixed in.
    """
    context = rclpy.Context()
    nodes = []
    try:
        rclpy.init(args=["program", *words], context=context, domain_id=domain)
        nodes = [namespace["First"](context), namespace["Second"](context)]
        eye = nodes[0]
        found: Graph = set()
        for node in nodes:
            name, space = node.get_name(), node.get_namespace()
            fqn = node.get_fully_qualified_name()
            for kind, ask in (
                ("publisher", eye.get_publisher_names_and_types_by_node),
                ("subscription", eye.get_subscriber_names_and_types_by_node),
                ("service server", eye.get_service_names_and_types_by_node),
                ("service client", eye.get_client_names_and_types_by_node),
            ):
                found |= {(fqn, kind, n) for n, _ in ask(name, space)}
        return found
    except Exception as error:
        return type(error).__name__
    finally:
        for node in nodes:
            node.destroy_node()
        context.try_shutdown()


def static(words: tuple[str, ...], library: Library, entry: Any) -> tuple[Graph, list[str]]:
    """The graph of the analysis, actions as the topics and services that they are made of; and what it says that fails."""
    values = tuple(Const(w) for w in words)
    found = run(library, entry, Budget(), Configuration(values))
    nodes, doubts = collect(found.log, Process(None, None, "program", found.done), Distro.KILTED)
    graph: Graph = set()
    for node in nodes:
        for entity in node.entities:
            if entity.kind is EntityKind.ACTION_CLIENT:
                name = entity.name
                graph |= {
                    (node.fqn, "service client", f"{name}/_action/{s}")
                    for s in ("send_goal", "get_result", "cancel_goal")
                }
                graph |= {(node.fqn, "subscription", f"{name}/_action/{t}") for t in ("feedback", "status")}
            else:
                graph.add((node.fqn, entity.kind.value, entity.name))
    return graph, [*read_words(Series(values)).errors, *(f.message for f in (*found.log.findings, *doubts))]


def test_the_table_has_at_least_150_rows() -> None:
    assert len(set(LINES)) >= 150


def test_every_command_line_gives_the_real_graph(tmp_path: Path) -> None:
    file = tmp_path / "program.py"
    file.write_text(PROGRAM, encoding="utf-8")
    namespace: dict[str, Any] = {"__name__": "program"}
    exec(compile(PROGRAM, str(file), "exec"), namespace)  # our own program, above

    def analyse() -> list[tuple[Graph, list[str]]]:
        workspace = discover([file])
        sources = SourceTree(workspace)
        library = Library(sources, own_models())
        (entry,) = make_plan(workspace, sources, library).entries
        return [static(words, library, entry) for words in LINES]

    differing: list[str] = []
    assert len(LINES) <= DOMAINS
    for number, (words, (ours, doubts)) in enumerate(zip(LINES, with_deep_stack(analyse), strict=True)):
        real = live(words, namespace, 1 + number)
        if isinstance(real, str):
            if not doubts:
                differing.append(f"{' '.join(words)}: {real} comes as a surprise")
        elif real != ours:
            differing.append(
                f"{' '.join(words)}\n  only real: {sorted(real - ours)}\n  only ours: {sorted(ours - real)}"
            )
    assert not differing, f"{len(differing)} of {len(LINES)}\n" + "\n".join(differing[:20])
