# SPDX-License-Identifier: Apache-2.0
"""How do the objects of a process lie in one another? What the interpretation found of that, for who looks at flow alone."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping
from typing import TYPE_CHECKING, Final, final

from rosward.domain.certain import text_of
from rosward.domain.compound import External, Tuple
from rosward.domain.values import NONE, Class, Function, Ref, Value
from rosward.effects.flows import Source
from rosward.engine.python.implicit import FOLLOWED
from rosward.engine.running.seen import Activation, refs_of
from rosward.flow.marks import Root, unrolled
from rosward.flow.said import marks_of, told_by
from rosward.flow.stored.store import MELTED, Numbers
from rosward.flow.stored.tracker import Tracker
from rosward.flow.stored.trail import Trail
from rosward.models.python.containers.lists import ITERATOR

if TYPE_CHECKING:
    from rosward.domain.heap import Obj
    from rosward.engine.interpreter import Interpreter
    from rosward.models.flow_marks import FlowMark

_CONTAINERS: Final = ("list", "set", "dict")
_NAMES: Final = {
    "topic": ("topic", "topic_name", "_topic"),
    "service": ("srv_name", "_service"),
    "response": ("srv_name", "_service"),
    "goal": ("_action_name", "_action"),
    "cancel": ("_action_name", "_action"),
    "feedback": ("_action_name", "_action"),
    "result": ("_action_name", "_action"),
}
"""The attributes in which the models of the client library keep the name of an entity."""


_FIELDS: Final = ("__match_args__", "_fields")
"""The attributes in which a class keeps the names of its fields."""


GIVING_NOTHING: Final = frozenset(
    (
        *(
            "__del__",
            "__init__",
            "__init_subclass__",
            "__set_name__",
            "__setattr__",
            "__delattr__",
            "__set__",
            "__delete__",
        ),
        *("__setitem__", "__delitem__", "__setstate__", "__release_buffer__"),
    )
)
"""Methods of which nobody takes what they return."""
_LAYOUTS: Final = {
    f"ctypes.{order}{kind.capitalize()}": kind
    for order in ("", "BigEndian", "LittleEndian")
    for kind in ("structure", "union")
}
"""Classes of `ctypes` whose attributes have their places in memory."""
_FEW: Final = ((60_000, 48), (100_000, 12), (float("inf"), 4))
"""While less was spent than that, so many objects are told apart."""
_ALL: Final = 1_000_000
_MOST_PARTS: Final = 6
"""What a library makes has no name from so many dots on: it may be made of itself, in each turn of a loop."""


class Many:
    """What objects are that are one: where their classes keep their attributes, which bases nobody knows, whether there are iterators and sets.

    `count`: so many of them were looked at; there may be more later.
    """

    __slots__ = ("bases", "classes", "count", "iterators", "sets")

    def __init__(self) -> None:
        self.classes: dict[int, None] = {}
        self.bases: dict[str, None] = {}
        self.count, self.iterators, self.sets = 0, False, False


@final
class Shape:
    """Which objects there are several of, which are nodes, and what each holds at the end.

    `inner`: the objects that belong to an attribute of another one (the header of a message), with that one and the name.
    """

    def __init__(self, machine: Interpreter) -> None:
        self._machine = machine
        self._told = told_by(machine)
        self.numbers = Numbers(self._told)
        self._few = _FEW[0][1]
        self._until: float = _FEW[0][0]
        self.spent = 0  # operations and objects that were looked at
        self.inner: dict[int, tuple[int, str]] = machine.inner_objects()
        self.many = {address for address, obj in machine.state.heap.items() if obj.many}
        self.placed: set[int] = set()  # what was made since the callback that runs began
        self.trail: Trail | None = None  # by which lines sources come along
        self.tracker: Tracker | None = None  # of the body that is being walked through
        # The variables of functions that do not run, in languages where these end with them.
        self.ended: set[Root] = set()
        self.several: set[int] = set()  # what was made again while the one before was still held
        self.parameters = {n for effect in machine.log.parameters if (n := text_of(effect.name))}
        self.entities = tuple(machine.log.entities)
        self.nodes = {effect.address for effect in machine.log.nodes}
        self._parts: dict[int, list[int]] = {}
        for address, (owner, _) in self.inner.items():
            self._parts.setdefault(owner, []).append(address)
        self._inside = {owner: address for address, owner in self.inner.items()}
        self._named: dict[str, list[tuple[int, str]]] | None = None
        # In C++ parts have their place in a whole: only what libraries made is merged.
        self.merges_objects = machine.linked is None
        self._said = marks_of(machine)
        self._laid_out: dict[Root, bool] | None = None
        self._held: dict[int, list[int]] = {}
        self._classes: dict[int, tuple[int, ...]] = {}
        self._many: dict[int, Many] = {}
        self._several_names: dict[tuple[Activation, int], str] = {}

    def made(self, activation: Activation, number: int, name: str = "", kind: str = "made") -> Root:
        """The object that an operation makes and that has no address; `name`: of what in a library it is the result."""
        return (kind, activation, number, unrolled(name) if name.count(".") < _MOST_PARTS else "")

    def result(self, activation: Activation, number: int, names: Collection[str]) -> Root:
        """What a call of a library gives, by the name of what is called; where that may be several, by one that was met at first.

        More are met while the walk goes on, and with another name it would be another object.
        """
        name = min(names, default="")
        if len(names) > 1:
            name = self._several_names.setdefault((activation, number), name)
        return self.made(activation, number, name)

    @property
    def few(self) -> int:
        """So many objects that one value may be are told apart; the more was walked through, the fewer; where they are not merged, all."""
        if not self.merges_objects:
            return _ALL
        if self.spent >= self._until:
            self._until, self._few = next(step for step in _FEW if self.spent < step[0])
        return self._few

    def record(self, address: int) -> Obj | None:
        """What stands at an address at the end."""
        return self._machine.state.heap.stands(address)

    def is_iterator(self, root: Root) -> bool:
        """Whether elements are used up where somebody goes through it."""
        if root.__class__ is tuple:
            return root[0] == MELTED and self.many_as_one(root).iterators
        record = self.record(root)  # type: ignore[arg-type]  # an address
        return record is not None and record.kind == "list" and record.payload == ITERATOR

    def is_set(self, root: Root) -> bool:
        """Whether it is a set, or one with some."""
        if self.numbers.of.get(root) in self.numbers.merged:
            return self.many_as_one(root).sets
        return isinstance(root, int) and self.kind(root) == "set"

    def many_as_one(self, root: Root) -> Many:
        """What those are with which an object is one."""
        number = self.numbers.number(root)
        found = self._many.setdefault(number, Many())
        several = self.numbers.alike(root)
        for each in several[found.count :]:
            if isinstance(each, int):
                found.classes.update(dict.fromkeys(self.classes(each)))
                found.bases.update(dict.fromkeys(self._unknown_bases(each)))
                found.iterators |= self.is_iterator(each)
                found.sets |= self.kind(each) == "set"
        found.count = len(several)
        return found

    def kind(self, address: int) -> str:
        """What stands at an address: an object of a class ('instance'), a 'set', a 'dict' and so on; '' where nobody knows."""
        record = self.record(address)
        return "" if record is None else record.kind

    def owner(self, root: Root) -> Root:
        """The object whose attributes a dict is (`vars(self)`, `globals()`); of all else, the object itself."""
        record = self.record(root) if isinstance(root, int) else None
        if record is None or record.kind != "dict" or not isinstance(record.payload, Ref):
            return root
        return record.payload.address

    def parts(self, address: int) -> Iterator[int]:
        """The objects that belong to an object, and to these."""
        for inner in self._parts.get(address, ()):
            yield inner
            yield from self.parts(inner)

    def part(self, owner: object, name: object) -> int | None:
        """The object that belongs to an attribute of another one."""
        return self._inside.get((owner, name))  # type: ignore[arg-type]  # of others there is none

    def named(self, name: str) -> list[tuple[int, str]]:
        """The scopes that have a variable of a name, and what it is called there."""
        if self._named is None:
            self._named = {}
            for address, obj in self._machine.state.heap.items():
                if obj.kind in ("module", "class"):
                    for key in obj.attrs:
                        self._named.setdefault(key.partition("@")[0], []).append((address, key))
        return self._named.get(name, [])

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
        by_value = self._machine.linked is not None and address not in self.nodes
        if by_value and obj.kind == "instance":
            for value in obj.attrs.values():
                if not isinstance(obj.cls, Class) or isinstance(value, Ref):
                    yield from refs_of(value)
        elif obj.kind == "instance" and isinstance(obj.cls, External):
            for value in obj.attrs.values():
                yield from refs_of(value)
        if obj.kind in _CONTAINERS:
            rest = () if obj.rest is None else (obj.rest,)
            for value in (*(obj.items or ()), *obj.entries.values(), *obj.entries, *rest):
                yield from refs_of(value)

    def classes(self, root: object) -> Collection[int]:
        """Where the class of an object and its bases keep their attributes; of what stands for many, those of all."""
        if not isinstance(root, int):
            return self.many_as_one(root).classes if root[0] == MELTED else ()  # type: ignore[index, arg-type]  # a root
        found = self._classes.get(root)
        if found is None:
            obj = self.record(root)
            cls = None if obj is None else obj.cls
            mro = cls.mro if isinstance(cls, Class) else ()
            found = self._classes[root] = tuple(c.address for c in mro if isinstance(c, Class) and not c.stub)
        return found

    def classes_of(self, roots: Collection[object]) -> Collection[int]:
        """The same for several objects."""
        if len(roots) == 1:
            return self.classes(*roots)
        return dict.fromkeys(cls for root in roots for cls in self.classes(root))

    def fields(self, roots: Iterable[Root]) -> tuple[str, ...]:
        """The names of what objects are made of, in order, where their classes say so and agree."""
        found: set[tuple[str, ...]] = set()
        for root in (each for one in roots for each in self.numbers.alike(one)):
            known: tuple[str, ...] = ()
            for cls in self.classes(root):
                record = self.record(cls)
                values = [] if record is None or known else [record.attrs.get(name) for name in _FIELDS]
                for value in values:
                    if isinstance(value, Tuple):
                        known = tuple(text_of(item) or "" for item in value.items)
            found.add(known)
        return found.pop() if len(found) == 1 else ()

    def is_native(self, name: str) -> bool:
        """Whether a function of a library has a model in code."""
        return self._machine.library.native(name) is not None

    def class_name(self, address: int) -> str:
        """The dotted name of the class of an object, where that is one of a model; else ''."""
        obj = self.record(address)
        cls = None if obj is None else obj.cls
        return f"{cls.module}.{cls.qualname}" if isinstance(cls, Class) and cls.stub else ""

    def unknown_bases(self, root: Root) -> Collection[str]:
        """The dotted names of the base classes of an object, or of those that are one with it, that nobody knows."""
        if self.numbers.of.get(root) in self.numbers.merged:
            return self.many_as_one(root).bases
        return self._unknown_bases(root) if isinstance(root, int) else ()

    def _unknown_bases(self, address: int) -> list[str]:
        obj = self.record(address)
        cls = None if obj is None else obj.cls
        return [c.name for c in cls.mro if isinstance(c, External)] if isinstance(cls, Class) else []

    def libraries(self, address: int) -> set[str]:
        """The modules of libraries in which an object has base classes."""
        obj = self.record(address)
        cls = None if obj is None else obj.cls
        mro = cls.mro if isinstance(cls, Class) else ()
        names = [c.module for c in mro if isinstance(c, Class) and c.stub]
        names += [c.name for c in mro if isinstance(c, External)]
        return {name.partition(".")[0] for name in names}

    def overlaps(self, root: Root) -> bool:
        """Whether what is written to one attribute of an object may stand in others, too: in a union of `ctypes`, and in a part of one."""
        if self._laid_out is None:
            self._laid_out = dict(self._layouts())
        if not self._laid_out:
            return False
        part, inside = root, False
        while not isinstance(part, int) and part[0] == "of":
            part, inside = part[1], True  # type: ignore[assignment]  # a root
        return self._laid_out.get(part, False) or (inside and part in self._laid_out)

    def _layouts(self) -> Iterator[tuple[Root, bool]]:
        """The objects whose attributes have places in memory; whether these are the same for several."""
        for address, obj in self._machine.state.heap.items():
            mro = obj.cls.mro if obj.kind == "instance" and isinstance(obj.cls, Class) else ()
            kinds = {kind for c in mro if isinstance(c, External) and (kind := _LAYOUTS.get(c.name))}
            if kinds:
                yield (
                    address,
                    "union" in kinds or any("_anonymous_" in self._attributes(c) for c in self.classes(address)),
                )

    def _attributes(self, cls: int) -> Mapping[str, Value]:
        record = self.record(cls)
        return {} if record is None else record.attrs

    def followed(self) -> dict[str, set[int]]:
        """The methods that the interpretation follows where Python calls them, by their code; with the classes that have them."""
        found: dict[str, set[int]] = {}
        for address, obj in self._machine.state.heap.items():
            for name, value in obj.attrs.items() if obj.kind == "class" else ():
                if (
                    name in FOLLOWED
                    and name not in GIVING_NOTHING
                    and isinstance(value, Function)
                    and not value.code.file.startswith("models:")
                ):
                    found.setdefault(value.code.key, set()).add(address)
        return found

    def module_name(self, root: Root) -> str:
        """The name of what is a module, up to the first dot; '' where it is none, or none with a model."""
        if not isinstance(root, int):
            return str(root[1]).partition(".")[0] if root[0] == "external" else ""
        obj = self.record(root)
        name = None if obj is None or obj.kind != "module" else obj.attrs.get("__name__")
        return (text_of(name) or "").partition(".")[0] if name is not None else ""

    def tells(self, name: str) -> bool:
        """Whether more is known of something of a library by its dotted name than by that of what it is a part of; in C++ nobody asks."""
        return not self.merges_objects or self._told(name)

    def said(self, name: str) -> FlowMark:
        """What marks say of a function of a library, by its dotted name."""
        return self._said(name)

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
                node = next((r for a in ("_node", "node") for r in refs_of(obj.attrs.get(a, NONE))), None)
                return Source(kind, node=node, given=name)
        return None
