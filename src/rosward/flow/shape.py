# SPDX-License-Identifier: Apache-2.0
"""How do the objects of a process lie in one another? What the interpretation found of that, for who looks at flow alone."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Final, final

from rosward.domain.certain import text_of
from rosward.domain.compound import External
from rosward.domain.values import NONE, Class
from rosward.engine.seen import refs_of
from rosward.flow.marks import Root, Source
from rosward.flow.remembered import Tracker

if TYPE_CHECKING:
    from rosward.domain.heap import Obj
    from rosward.engine.interpreter import Interpreter

_CONTAINERS: Final = ("list", "set", "dict")
_NAMES: Final = {
    "topic": ("topic", "topic_name"),
    "service": ("srv_name",),
    "response": ("srv_name",),
    "goal": ("_action_name",),
    "feedback": ("_action_name",),
    "result": ("_action_name",),
}
"""The attributes in which the models of the client library keep the name of an entity."""


@final
class Shape:
    """Which objects there are several of, which are nodes, and what each holds at the end.

    `inner`: the objects that belong to an attribute of another one (the header of a message), with that one and the name.
    """

    def __init__(self, machine: Interpreter) -> None:
        self._machine = machine
        self.inner: dict[int, tuple[int, str]] = machine.inner_objects()
        self.many = {address for address, obj in machine.state.heap.items() if obj.many}
        self.placed: set[int] = set()  # what was made since the callback that runs began
        self.aliases: dict[object, frozenset[Root]] = {}  # what results of calls may be views of, where that is much
        self.tracker: Tracker | None = None  # of the body that is being walked through
        self.several: set[int] = set()  # what was made again while the one before was still held
        self.parameters = {n for effect in machine.log.parameters if (n := text_of(effect.name))}
        self.nodes = {effect.address for effect in machine.log.nodes}
        self._parts: dict[int, list[int]] = {}
        for address, (owner, _) in self.inner.items():
            self._parts.setdefault(owner, []).append(address)
        self._held: dict[int, list[int]] = {}
        self._classes: dict[int, tuple[int, ...]] = {}

    def record(self, address: int) -> Obj | None:
        """What stands at an address at the end."""
        return self._machine.state.heap.stands(address)

    def parts(self, address: int) -> Iterator[int]:
        """The objects that belong to an object, and to these."""
        for inner in self._parts.get(address, ()):
            yield inner
            yield from self.parts(inner)

    def held(self, root: object) -> list[int]:
        """What an object holds: elements, and the fields of messages; of other objects only what was seen to be written counts."""
        if not isinstance(root, int):
            return []
        found = self._held.get(root)
        if found is None:
            found = self._held[root] = list(dict.fromkeys(self._of(root)))
        return found

    def _of(self, address: int) -> Iterator[int]:
        obj = self.record(address)
        if obj is None:
            return
        if obj.kind == "instance" and isinstance(obj.cls, External):
            for value in obj.attrs.values():
                yield from refs_of(value)
        if obj.kind in _CONTAINERS:
            rest = () if obj.rest is None else (obj.rest,)
            for value in (*(obj.items or ()), *obj.entries.values(), *obj.entries, *rest):
                yield from refs_of(value)

    def classes(self, root: object) -> tuple[int, ...]:
        """Where the class of an object and its bases keep their attributes."""
        if not isinstance(root, int):
            return ()
        found = self._classes.get(root)
        if found is None:
            obj = self.record(root)
            cls = None if obj is None else obj.cls
            mro = cls.mro if isinstance(cls, Class) else ()
            found = self._classes[root] = tuple(c.address for c in mro if isinstance(c, Class) and not c.stub)
        return found

    def is_native(self, name: str) -> bool:
        """Whether a function of a library has a model in code."""
        return self._machine.library.native(name) is not None

    def entity(self, root: object, kind: str) -> Source | None:
        """What arrives at an object of the client library, by the name that it keeps; None where it is none of that kind."""
        obj = self.record(root) if isinstance(root, int) else None
        if obj is None or not isinstance(obj.cls, Class) or not obj.cls.stub:
            return None
        for attribute in ("_action_client", "_action_server"):
            for address in refs_of(obj.attrs.get(attribute, NONE)):
                return self.entity(address, kind)
        for attribute in _NAMES.get(kind, ()):
            name = obj.attrs.get(attribute)
            if name is not None:
                node = next(iter(refs_of(obj.attrs.get("_node", NONE))), None)
                return Source(kind, node=node, given=name)
        return None
