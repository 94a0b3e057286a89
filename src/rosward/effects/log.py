# SPDX-License-Identifier: Apache-2.0
"""What a process does to ROS, as the interpretation records it: nodes, entities, parameters, each with its place and values.

An effect keeps abstract values; `naming.collect` turns them into names.
"""

from __future__ import annotations

from collections.abc import Collection, Container, Iterable
from typing import TYPE_CHECKING, Final, Protocol, final

from rosward.domain.compound import External
from rosward.domain.series import Series
from rosward.domain.unknown import Cause
from rosward.domain.values import UNBOUND, Choice, Class, Ref, Text, Unknown, Value
from rosward.effects.sent import SentEffect
from rosward.effects.variables import Variables
from rosward.findings import Finding, Findings
from rosward.location import Place
from rosward.records import NamedTuple
from rosward.ros.entities import Qos

if TYPE_CHECKING:
    from rosward.domain.heap import Obj
    from rosward.domain.state import State
    from rosward.effects.configuration import Configuration
    from rosward.effects.flows import ProcessFlows
    from rosward.effects.launch_context import LaunchContext
    from rosward.ir.program import Code


_NAMED: Final = 3
"""How many classes are told that may be nodes."""


class Execution(Protocol):
    """Where the interpretation stands, as the log asks it."""

    @property
    def state(self) -> State:
        """The current state."""

    @property
    def place(self) -> Place:
        """Where in the user's sources the innermost user call stands (calls inside library models are looked through)."""

    @property
    def path(self) -> tuple[Place, ...]:
        """The calls in the user's code that lead here, outermost first; of a longer chain the innermost."""

    @property
    def in_callback(self) -> bool:
        """Whether something that was scheduled is running, not the main body."""

    def fresh_version(self, compared: int = 0) -> int:
        """A version number never used before, for a state that took as many comparisons of objects to make."""

    def keep_end(self) -> None:
        """Here a path of the main body ends: its state counts for what runs afterwards."""

    def note_effect(self, effect: EntityEffect | SentEffect) -> None:
        """An entity is created, or a message sent, here."""

    def note_creation(self, *, new: bool, exact: bool, key: object = None) -> None:
        """Here something is created: what runs now is worth to be followed call by call. `exact`: its name and type are known."""

    def obj(self, ref: Ref) -> Obj:
        """The heap record behind a reference."""

    def part(self, ref: Ref, name: str) -> Obj:
        """The same record, of which nothing is read but one attribute, and what tells how it is read (`KIND`: nothing else)."""

    def is_node(self, address: int) -> bool:
        """Whether the object at an address is a node."""

    def unknown(self, cause: Cause, subject: str, hint: str = "") -> Unknown:
        """An unknown that arises here."""

    def report(self, code: str, message: str, causes: tuple[str, ...] = ()) -> None:
        """A finding at the current place."""


class NodeEffect(NamedTuple):
    """A node is created: the object at `address` becomes a node of that name."""

    address: int
    name: Value
    namespace: Value
    options: tuple[tuple[str, Value], ...]
    words: Series  # its cli_args
    global_words: Series  # those of its context, where it uses them
    cls: Value
    place: Place
    late: bool  # created in a callback, or by one of several command lines
    assumed: bool = False


class EntityEffect(NamedTuple):
    """An entity is created on the node at `address` (None: on an unknown node)."""

    kind: str
    address: int | None
    name: Value
    type: Value
    callback: str | None
    qos: Qos | None
    ros_prefix: bool
    introspection: bool
    place: Place
    via: str | None


class ParameterEffect(NamedTuple):
    """A parameter is declared."""

    address: int | None
    name: Value
    default: Value
    value: Value
    type: Value
    place: Place


def _known(*values: Value) -> bool:
    """Whether each of these is one value, wholly known."""
    return not any(isinstance(value, (Choice, Text, Unknown)) for value in values)


@final
class EffectLog:
    """All effects of one process, each once, in the order in which they were first seen; and what else is worth telling."""

    def __init__(self, configuration: Configuration | None = None) -> None:
        self.configuration = configuration
        self.launch: LaunchContext | None = None  # the launch whose Python code this is
        self.variables = Variables()
        self.nodes: dict[NodeEffect, None] = {}
        self.entities: dict[EntityEffect, None] = {}
        self.paths: dict[EntityEffect, tuple[Place, ...]] = {}  # the calls that first led to each
        self.sent: dict[SentEffect, tuple[Place, ...]] = {}  # with the calls that first led to each
        self.parameters: dict[ParameterEffect, None] = {}
        self.findings = Findings()
        self.open: dict[int, Findings] = {}  # why the interface of the node at an address is not wholly known
        self.failures: dict[int, Findings] = {}  # what to tell of an exception of a library that nothing catches
        self.doubtful: list[tuple[int, Finding]] = []  # the same, of what fails for one of several alternatives
        self.uncaught: set[int] = set()  # exceptions that nothing caught
        self.classes: dict[Class, None] = {}
        self.functions: dict[str, Code] = {}
        self.spun: dict[Place, str] = {}  # where something unknown is spun as a node, and why it is unknown
        self.begun: dict[Place, None] = {}  # where the client library is started
        self.outside: dict[str, None] = {}  # classes of libraries that are not known, of which objects were made
        self.ends: list[frozenset[tuple[object, ...]]] = []
        self.flows: ProcessFlows | None = None  # where that was asked for
        self.remembered: dict[object, object] = {}  # what was computed of its configuration, for who asks again
        self._at: dict[int, dict[NodeEffect, None]] = {}

    def add_node(self, machine: Execution, effect: NodeEffect) -> None:
        """Record a node."""
        machine.note_creation(
            new=effect not in self.nodes, exact=_known(effect.name, effect.namespace), key=("node", effect.address)
        )
        self.nodes[effect] = None
        self._at.setdefault(effect.address, {})[effect] = None
        self._done(machine, ("node", effect.address))

    def add_entity(self, machine: Execution, effect: EntityEffect) -> None:
        """Record an entity."""
        machine.note_creation(
            new=effect not in self.entities, exact=_known(effect.name, effect.type), key=self.key(effect)
        )
        if effect not in self.entities:
            self.entities[effect] = None
            self.paths[effect] = machine.path
        machine.note_effect(effect)
        self._done(machine, self.key(effect))

    def add_sent(self, machine: Execution, effect: SentEffect) -> None:
        """Record that something is sent."""
        self.sent.setdefault(effect, machine.path)
        machine.note_effect(effect)

    def add_parameter(self, machine: Execution, effect: ParameterEffect) -> None:
        """Record a parameter."""
        machine.note_creation(new=effect not in self.parameters, exact=_known(effect.name))
        self.parameters[effect] = None

    @staticmethod
    def key(effect: EntityEffect) -> tuple[object, ...]:
        """What tells an entity from others of its node."""
        return ("entity", effect.kind, effect.address, effect.name, effect.type)

    @staticmethod
    def _done(machine: Execution, key: tuple[object, ...]) -> None:
        state = machine.state
        if key not in state.done:
            state.done |= {key}
            state.version = machine.fresh_version()

    @property
    def open_doubts(self) -> int:
        """So many failures of single alternatives are not settled."""
        return len(self.doubtful)

    def settle_doubts(self, first: int, *, sure: bool) -> None:
        """The doubts from the `first` on: each alternative has failed, so they are `sure`; else another goes on, and they are dropped."""
        for address, finding in self.doubtful[first:] if sure else ():
            self.failures.setdefault(address, Findings()).add(finding)
            if address in self.uncaught:
                self.findings.add(finding)
        del self.doubtful[first:]

    def tell_spun(self) -> None:
        """The program spins a node that is not known, and makes none: whose node it is nobody can tell."""
        if not self.nodes:
            for place, why in self.spun.items():
                self.findings.add(
                    Finding(
                        "RW208", f"the node that is spun here is unknown, and this program creates none{why}", place
                    )
                )

    def tell_outside(self, names: list[str]) -> None:
        """The program starts the client library and makes no node: objects of these classes, of which nothing is known, may be nodes."""
        if not names or self.nodes or self.spun or any(effect.address is None for effect in self.entities):
            return
        told = ", ".join(names[:_NAMED]) + (f" and {len(names) - _NAMED} more" if len(names) > _NAMED else "")
        for place in self.begun:
            self.findings.add(
                Finding(
                    "RW208", f"this program starts rclpy and creates no node: what {told} may create is unknown", place
                )
            )

    @property
    def tells_once(self) -> bool:
        """Whether it is all the same how often something is recorded: what a launch file does has an order, and stands in another log."""
        return self.launch is None

    @property
    def made(self) -> int:
        """How much was recorded that is created."""
        return len(self.nodes) + len(self.entities) + len(self.parameters)

    def count_at(self, address: int) -> int:
        """How many nodes were recorded for the object at an address; 0: it is none."""
        return len(self._at.get(address, ()))

    def nodes_at(self, addresses: Collection[int]) -> list[NodeEffect]:
        """The nodes at some addresses, in the order in which they were recorded."""
        if len(addresses) == 1:
            return [effect for address in addresses for effect in self._at.get(address, ()) if effect in self.nodes]
        return [effect for effect in self.nodes if effect.address in addresses]

    def leave_out(self, nodes: Iterable[NodeEffect], entities: Container[EntityEffect]) -> None:
        """Forget nodes that have nothing but these entities: they are told elsewhere."""
        own = {e.address for e in self.entities if e not in entities}
        for node in nodes:
            if node.address not in own:
                self.nodes.pop(node, None)

    def assumed_node(self, machine: Execution, ref: Ref, base: Value) -> None:
        """An object whose class is not completely known is used as a node."""
        if machine.is_node(ref.address):
            return
        name = base.name if isinstance(base, External) else "an unknown base class"
        machine.report(
            "RW204",
            f"{name} is assumed to be a node because entities are created on it; its own entities and its name are unknown",
        )
        unknown = machine.unknown(Cause.MODULE, name, "str")
        cls = machine.obj(ref).cls
        self.add_node(
            machine, NodeEffect(ref.address, unknown, UNBOUND, (), Series(), Series(), cls, machine.place, False, True)
        )

    def defined(self, cls: Class) -> None:
        """A class was made."""
        if not cls.stub:
            self.classes[cls] = None

    def add_function(self, code: Code, *, stub: bool) -> None:
        """A function was made."""
        if not stub:
            self.functions[code.key] = code

    def may_end(self, machine: Execution) -> None:
        """The program can stay here for ever, or an exception that nothing catches ends it: an execution is sure of what surely happened so far.

        A callback does not end the main body. What was scheduled may still run from this state.
        """
        if not machine.in_callback:
            self.ends.append(machine.state.done)
            machine.keep_end()

    def final(self, state: State) -> frozenset[tuple[object, ...]]:
        """What every execution does, given the state behind the main body."""
        done = state.done
        for end in self.ends:
            done &= end
        return done
