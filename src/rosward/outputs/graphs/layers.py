# SPDX-License-Identifier: Apache-2.0
"""How much is there to draw, before it is drawn? The layers that each edge crosses, as Graphviz counts them.

a -> b -> c, a -> c      three layers; a -> c crosses one that it does not end in: 4 steps in all

Graphviz gives each edge a place in every layer between its ends, and then needs time with the square of their number. So this, and not a
clock, decides how a graph is drawn: the same sources give the same picture on every machine.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence

__all__ = ["steps_between_layers"]


def steps_between_layers(edges: Collection[tuple[str, str]]) -> int:
    """The number of layers that all edges cross, each as long as it has to be once those that close a circle are turned round."""
    forward = _without_circles(edges)
    layer = _layers(forward)
    return sum(layer[head] - layer[tail] for tail, head in forward)


def _without_circles(edges: Collection[tuple[str, str]]) -> list[tuple[str, str]]:
    """The edges, turned round where a walk in depth comes back to where it is."""
    following: dict[str, list[str]] = {}
    for tail, head in sorted(edges):
        if tail != head:
            following.setdefault(tail, []).append(head)
            following.setdefault(head, [])
    found: list[tuple[str, str]] = []
    done: set[str] = set()
    for start, heads in following.items():
        if start in done:
            continue
        path, on_path = [(start, iter(heads))], {start}
        while path:
            here, left = path[-1]
            for head in left:
                found.append((head, here) if head in on_path else (here, head))
                if head not in on_path and head not in done:
                    path.append((head, iter(following[head])))
                    on_path.add(head)
                    break
            else:
                path.pop()
                on_path.discard(here)
                done.add(here)
    return found


def _layers(edges: Sequence[tuple[str, str]]) -> dict[str, int]:
    """The layer of each vertex: one behind the last of those that lead to it."""
    following: dict[str, list[str]] = {}
    before: dict[str, int] = {}
    for tail, head in edges:
        following.setdefault(tail, []).append(head)
        before[head] = before.get(head, 0) + 1
        before.setdefault(tail, 0)
    layer = dict.fromkeys(before, 0)
    ready = [vertex for vertex, count in before.items() if not count]
    while ready:
        here = ready.pop()
        for head in following.get(here, ()):
            layer[head] = max(layer[head], layer[here] + 1)
            before[head] -= 1
            if not before[head]:
                ready.append(head)
    return layer
