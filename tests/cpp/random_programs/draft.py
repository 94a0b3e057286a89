# SPDX-License-Identifier: Apache-2.0
"""How is something written in two languages at once? A draft collects what both have at the top, a block what both do in one body."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from random import Random
from typing import Final, NamedTuple, TypeVar

T = TypeVar("T")
WORDS: Final = (
    "left",
    "right",
    "arm",
    "base",
    "front",
    "rear",
    "lidar",
    "camera",
    "gripper",
    "wheel",
    "motor",
    "power",
    "dock",
    "tray",
)


class Pair(NamedTuple):
    """The same in Python and in C++."""

    py: str
    cpp: str


class NodeName(NamedTuple):
    """How a body speaks of a node: in Python, before a call in C++, as a pointer, as a reference, and in the capture of a lambda."""

    py: str
    call: str
    pointer: str
    reference: str
    capture: str

    @property
    def raw(self) -> str:
        """A plain pointer to it, be the pointer smart or not."""
        return "&*node" if self.pointer == "node" else self.pointer


OWN: Final = NodeName("self", "this->", "this", "*this", "this")
BY_REFERENCE: Final = NodeName("node", "node.", "&node", "node", "&node")
BY_POINTER: Final = NodeName("node", "node->", "node", "*node", "node")
BY_MEMBER: Final = NodeName("self.node", "node_->", "node_", "*node_", "this")


class Draft:
    """A program that is being written, by what it can be made of. With `known`, nothing that only a run knows decides about its graph."""

    def __init__(self, seed: int, ways: Mapping[str, Ways], statements: Sequence[Statement], *, known: bool) -> None:
        self.ways = ways
        self.statements = statements
        self.random = Random(seed)
        self.seed = seed
        self.known = known
        self.open = False
        self.used: set[str] = set()
        self._py: list[str] = []
        self._cpp: list[str] = []
        self._count = 0

    def define(self, py: str, cpp: str) -> None:
        """Add what stands at the top."""
        self._py.append(py.strip("\n"))
        self._cpp.append(cpp.strip("\n"))

    def use(self, what: str) -> None:
        """Note a construct."""
        self.used.add(what)

    @property
    def top(self) -> Pair:
        """All that stands at the top."""
        return Pair("\n\n\n".join(self._py), "\n\n".join(self._cpp))

    def fresh(self, prefix: str) -> str:
        """A name that nothing else has."""
        self._count += 1
        return f"{prefix}{self._count}"

    def pick(self, items: Sequence[T]) -> T:
        """One of several."""
        return self.random.choice(items)

    def chance(self, percent: int) -> bool:
        """True in so many cases of a hundred."""
        return self.random.randrange(100) < percent

    def number(self, low: int, high: int) -> int:
        """A number between two, both included."""
        return self.random.randint(low, high)

    def word(self) -> str:
        """A word of a robot."""
        return self.pick(WORDS)


Way = Callable[["Draft", "Block", int], Pair]
"""How a value can be made, so deep within others."""
Statement = Callable[["Draft", "Block", int], None]
"""What a body can do, so deep within others."""


class Ways(NamedTuple):
    """How values of one kind are made: without others, by an expression, with statements before."""

    leaves: tuple[Way, ...]
    pure: tuple[Way, ...]
    said: tuple[Way, ...] = ()


class Block:
    """The statements of one body, and what they can speak of.

    `texts`, `numbers` and `lists` are variables that keep their value; the names of those that are local are in `local`, for captures. A pure
    block has expressions only, and what constructs an object has no shared pointer to it. `methods` gets the methods that a body of the class `owner` needs, and `members` are the texts that an object holds.
    """

    def __init__(
        self,
        node: NodeName,
        keep: Pair,
        *,
        methods: list[Pair] | None = None,
        owner: str = "",
        pure: bool = False,
        constructing: bool = False,
    ) -> None:
        self.members: list[Pair] = []
        self.node = node
        self.keep = keep
        self.methods = methods
        self.owner = owner
        self.pure = pure
        self.constructing = constructing
        self.texts: list[Pair] = []
        self.numbers: list[Pair] = []
        self.lists: list[Pair] = []
        self.local: list[str] = []
        self._py: list[str] = []
        self._cpp: list[str] = []

    def say(self, py: str, cpp: str) -> None:
        """Add a statement."""
        self._py += py.splitlines()
        self._cpp += cpp.splitlines()

    def nested(self, *, captured: Sequence[str] | None = None) -> Block:
        """A block within this one, that sees what is here; with `captured`, only so many of the local variables."""
        inner = Block(self.node, self.keep, methods=self.methods, owner=self.owner, constructing=self.constructing)
        inner.members = self.members
        for here, there in ((self.texts, inner.texts), (self.numbers, inner.numbers), (self.lists, inner.lists)):
            there += [pair for pair in here if captured is None or pair.py in captured or not pair.py.isidentifier()]
        inner.local = list(self.local if captured is None else captured)
        return inner

    def py(self, depth: int = 1) -> str:
        """The body in Python."""
        return "\n".join("    " * depth + line for line in self._py or ["pass"])

    def cpp(self, depth: int = 1) -> str:
        """The body in C++."""
        return "\n".join("  " * depth + line for line in self._cpp)

    def keeps(self, py: str, cpp: str) -> None:
        """Create something and keep it."""
        self.say(f"{self.keep.py}.append({py})", f"{self.keep.cpp}.push_back({cpp});")

    def remember(self, kind: list[Pair], name: str) -> Pair:
        """A new local variable."""
        pair = Pair(name, name)
        kind.append(pair)
        self.local.append(name)
        return pair


GLOBAL_KEEP: Final = Pair("kept", "kept")
"""The list at the top that keeps what no class keeps."""
