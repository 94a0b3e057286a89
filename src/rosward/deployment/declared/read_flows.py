# SPDX-License-Identifier: Apache-2.0
"""What does a declaration say about what an output is made of?

{to: cmd_vel, data: [joy, 'parameter:scale'], control: ['service:~/enable']}
->  FlowTemplate(EndTemplate('topic', 'cmd_vel'), (('data', EndTemplate('topic', 'joy')), …))
"""

from __future__ import annotations

from typing import Final

from rosward.deployment.declared.shapes import EndTemplate, FlowTemplate
from rosward.ros.flows import STRENGTHS
from rosward.source.yaml_nodes import Item, Malformed

FLOW: Final = frozenset(("to", *STRENGTHS, "when", "since", "until", "description"))
"""The keys of one entry."""
_SINKS: Final = ("topic", "request", "response", "goal", "feedback", "result")
_SOURCES: Final = ("topic", "service", "response", "goal", "feedback", "result", "parameter")
_OUTSIDE_SINKS: Final = ("log", "network", "file", "process", "device", "stdout")
_OUTSIDE_SOURCES: Final = ("clock", "random", "argv", "env", "file", "network", "process", "device", "stdin")
_EVENTS: Final = ("timer", "thread", "main", "parameters")
"""What only triggers."""


def read_flow(item: Item) -> FlowTemplate:
    """One entry, without its conditions. Raises Malformed."""
    shape = item.mapping(FLOW)
    if "to" not in shape:
        raise Malformed("'to' is missing: the output that is made of something", item.place)
    to = _end(shape["to"], _SINKS, _OUTSIDE_SINKS, "output")
    sources: list[tuple[str, EndTemplate]] = []
    for strength in STRENGTHS:
        more = _EVENTS if strength == "trigger" else ()
        for each in shape[strength].items() if strength in shape else ():
            source = _end(each, _SOURCES, (*_OUTSIDE_SOURCES, *more), "input")
            if any(source.kind == known.kind and source.name == known.name for _, known in sources):
                raise Malformed(f"{each.text()} stands here twice: name it where it is strongest", each.place)
            sources.append((strength, source))
    return FlowTemplate(to, tuple(sources), (), place=item.place)


def _end(item: Item, named: tuple[str, ...], outside: tuple[str, ...], what: str) -> EndTemplate:
    """`KIND:NAME`, a word that stands for itself, or the name of a topic."""
    text = item.text()
    if not text or any(c.isspace() for c in text):
        raise Malformed(f"expected an {what}: a name without spaces, or KIND:NAME", item.place)
    kind, colon, name = text.partition(":")
    if not colon or "$" in kind:
        kind, name = (text, "") if text in outside else ("topic", text)
    if kind not in (*named, *outside) or (kind in named and not name):
        kinds = ", ".join((*named, *outside))
        raise Malformed(f"{text} is no {what}: expected a topic, or KIND:NAME with KIND one of {kinds}", item.place)
    return EndTemplate(kind, name, item.place)
