# SPDX-License-Identifier: Apache-2.0
"""Where does the content of a message decide what is executed: a command line, code, a pickle, the name of a method?"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Final

from rosward.findings import Finding
from rosward.ros.entities import Node

_MESSAGES: Final = ("topic", "service", "goal", "feedback", "result", "response", "network")
_HOW: Final = {
    "process": "is part of a command line",
    "code": "is executed as code",
    "pickle": "is unpickled, which can execute anything",
    "method": "chooses the method that is called",
}


def executed(nodes: Iterable[Node]) -> Iterator[Finding]:
    """One finding for each source and place."""
    for node in nodes:
        if node.flows is not None:
            for sink in (*node.flows.sinks, *node.flows.executed):
                how = _HOW.get(sink.sink.kind)
                paths = dict(sink.paths)
                for source in sink.data if how is not None else ():
                    if source.kind in _MESSAGES and source not in sink.assumed:
                        message = f"the content of {source} {how}"
                        yield Finding("RW605", message, sink.at, nodes=(node.fqn,), path=paths.get(source, ()))
