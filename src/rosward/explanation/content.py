# SPDX-License-Identifier: Apache-2.0
"""What the content of a topic, service or action is made of, with the lines of each step.

/cmd_vel  ->  ContentTold("topic:/cmd_vel", steps=(StepTold(1, "data", "topic:/plan", "/controller", …), StepTold(2, …)))
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final, NamedTuple, final

from rosward.explanation.excerpts import Excerpt, Excerpts
from rosward.influence.declared import flows_of
from rosward.influence.graph import Vertex, graph_of, sent
from rosward.influence.search import at_least
from rosward.influence.select import Selection, meant
from rosward.influence.tree import Step, Tree
from rosward.ros.entities import Node
from rosward.ros.flows import End

__all__ = ["ConstantTold", "ContentTold", "Contents", "StepTold"]

_ALSO: Final = {"/tf": "tf", "/tf_static": "tf", "/rosout": "log"}
"""Topics on which client libraries send what is no publication of the program."""


class StepTold(NamedTuple):
    """One part: `depth` 1 of what is asked for, 2 of the step of depth 1 before it, and so on; the lines by which `node` makes it so.

    `above`: its own parts were listed before.
    """

    depth: int
    strength: str
    source: End
    node: str
    lines: tuple[Excerpt, ...]
    assumed: bool
    above: bool


class ConstantTold(NamedTuple):
    """A statement that sends the same each time."""

    node: str
    at: Excerpt


class ContentTold(NamedTuple):
    """What one kind of content is made of; `unsure`: the nodes that make it of which not all is known."""

    of: End
    steps: tuple[StepTold, ...]
    constant: tuple[ConstantTold, ...]
    unsure: tuple[str, ...]


@final
class Contents:
    """The flows of a system, to be asked for names."""

    def __init__(self, nodes: Sequence[Node]) -> None:
        self._nodes = nodes
        self._graph = graph_of(nodes)
        self._flows = [(node.display_name, flows_of(node)) for node in nodes]
        self._unsure = {name for name, flows in self._flows if not flows.complete}

    def of(self, word: str, name: str, excerpts: Excerpts) -> tuple[ContentTold, ...]:
        """What a topic, service or action of that name holds, also where it is sent under a name that may be this one."""
        selections = [Selection(f"{word}:{name}")]
        if word == "topic" and name in _ALSO:
            selections.append(Selection(_ALSO[name]))
        senders: dict[Vertex, list[tuple[str, ConstantTold | None]]] = {}
        for node, flows in self._flows:
            for sink in flows.sinks:
                vertex = sent(sink.sink, node)
                if any(selection.means(vertex) for selection in selections):
                    plain = not (sink.data or sink.control)
                    told = ConstantTold(node, excerpts.around(sink.at, 0)) if plain else None
                    senders.setdefault(vertex, []).append((node, told))
        tree = Tree(self._graph, at_least("control"))
        found = []
        for target in tree.roots({*senders, *meant(selections, self._graph.vertices)}):
            steps = list(tree.steps(target))
            sending = senders.get(target._replace(side="sent"), [])
            nodes = {node for node, _ in sending} | {step.edge.node for step in steps}
            constant = dict.fromkeys(told for _, told in sending if told is not None)
            if steps or sending:
                found.append(
                    ContentTold(
                        target.end,
                        tuple(_told(step, excerpts) for step in steps),
                        tuple(constant),
                        tuple(sorted(nodes & self._unsure)),
                    )
                )
        return tuple(found)


def _told(step: Step, excerpts: Excerpts) -> StepTold:
    edge = step.edge
    lines = tuple(excerpts.around(place, 0) for place in edge.path if place.file)
    return StepTold(step.depth, edge.strength, edge.source.end, edge.node, lines, edge.assumed, step.above)
