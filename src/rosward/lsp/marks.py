# SPDX-License-Identifier: Apache-2.0
"""What of a view stands in which file, and what bears which name?

marks = Marks(view)
marks.at["demo/talker.py"]      [Mark(place, node, End("publisher", "/chatter", …)), …]
marks.named["/chatter"]         the endpoints of that name
"""

from __future__ import annotations

from fnmatch import fnmatchcase
from typing import Final, NamedTuple, final

from rosward.location import Place
from rosward.lsp.records import End, Seen, Setting, Started, View
from rosward.ros.entities import EntityKind

__all__ = ["OPPOSITE", "Mark", "Marks", "meeting", "plural"]

OPPOSITE: Final = {
    EntityKind.PUBLISHER.value: EntityKind.SUBSCRIPTION.value,
    EntityKind.SUBSCRIPTION.value: EntityKind.PUBLISHER.value,
    EntityKind.SERVICE_SERVER.value: EntityKind.SERVICE_CLIENT.value,
    EntityKind.SERVICE_CLIENT.value: EntityKind.SERVICE_SERVER.value,
    EntityKind.ACTION_SERVER.value: EntityKind.ACTION_CLIENT.value,
    EntityKind.ACTION_CLIENT.value: EntityKind.ACTION_SERVER.value,
}
_MEETING: Final = {kind.value: kind.meeting for kind in EntityKind}


class Mark(NamedTuple):
    """Something at a place: an endpoint or a parameter of a node, a node itself, or what a launch file starts (`node` is None)."""

    place: Place
    node: Seen | None
    what: End | Setting | Seen | Started


@final
class Marks:
    """The marks of a view; nothing of it changes."""

    def __init__(self, view: View) -> None:
        self.view = view
        self.at: dict[str, list[Mark]] = {}
        self.named: dict[str, list[Mark]] = {}
        self.open: list[Mark] = []
        """The endpoints of which the name is known in part."""
        for node in view.nodes:
            self._put(Mark(node.place, node, node))
            for end in node.ends:
                places = end.places or (node.place,)
                for place in places:
                    self._put(Mark(place, node, end))
                mark = Mark(places[0], node, end)
                self.named.setdefault(end.name, []).append(mark)
                if not end.whole:
                    self.open.append(mark)
            for setting in node.settings:
                if setting.place is not None:
                    self._put(Mark(setting.place, node, setting))
        for started in view.started:
            self._put(Mark(started.place, None, started))
        for marks in self.at.values():
            marks.sort(key=lambda mark: mark.place)

    def _put(self, mark: Mark) -> None:
        self.at.setdefault(mark.place.file, []).append(mark)

    def others(self, end: End) -> list[Mark]:
        """The endpoints that it may talk to."""
        return [m for m in self.meeting(end.name, meeting(end)) if _end(m).kind == OPPOSITE[end.kind]]

    def meeting(self, name: str, kind: str = "") -> list[Mark]:
        """The endpoints at a name; `kind`: only those of topics, services or actions."""
        found = list(self.named.get(name, ()))
        found += [m for m in self.open if _end(m).name != name and fnmatchcase(name, _end(m).name)]
        if "*" in name:
            found += [
                m for other, marks in self.named.items() if other != name and fnmatchcase(other, name) for m in marks
            ]
        return [m for m in found if not kind or meeting(_end(m)) == kind]

    def nodes_at(self, place: Place) -> list[Seen]:
        """The nodes that a place of a launch file starts."""
        return [node for node in self.view.nodes if node.launched_by is not None and _same(node.launched_by, place)]

    def started(self, node: Seen) -> Started | None:
        """What a launch file says of a node."""
        if node.launched_by is None:
            return None
        return next((each for each in self.view.started if _same(each.place, node.launched_by)), None)


def _same(left: Place, right: Place) -> bool:
    return (left.file, left.line) == (right.file, right.line)


def _end(mark: Mark) -> End:
    assert isinstance(mark.what, End)
    return mark.what


def meeting(end: End) -> str:
    """Where an endpoint meets others: topic, service or action."""
    return _MEETING[end.kind]


def plural(number: int, word: str) -> str:
    """`2 publishers`."""
    return f"{number} {word}" if number == 1 else f"{number} {word}s"
