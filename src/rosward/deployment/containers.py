# SPDX-License-Identifier: Apache-2.0
"""Into which process is a component loaded?

Node(package='rclcpp_components', executable='component_container_mt', name='cont'); LoadComposableNodes(target_container='/cont', …)
->  the process of the node /cont, whose command line, environment and enclave the component shares

launch calls the service /cont/_container/load_node: whoever has that name loads it, however it was started. What is known not to have this
service (a program in Python, a declared one without it) is no container.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from typing import TYPE_CHECKING, Final, final

from rosward.deployment.started import StartKind
from rosward.domain.choice import options
from rosward.domain.series import Series
from rosward.domain.text import concat, matches, readable
from rosward.domain.values import NONE, Const, Unknown, Value
from rosward.effects.configuration import Configuration
from rosward.effects.log import EffectLog, NodeEffect
from rosward.naming.final_name import final_name
from rosward.network.launch_tree import CONTAINER
from rosward.records import NamedTuple

if TYPE_CHECKING:
    from rosward.deployment.declared.shapes import EndpointGroup, Program
    from rosward.deployment.launched import Launched
    from rosward.deployment.started import Started

_LOADS: Final = "composition_interfaces/srv/LoadNode"


class _Container(NamedTuple):
    """A process that may load components, and each name that it may have."""

    start: Launched
    names: tuple[Value, ...]


@final
class Containers:
    """The processes of a system that may load components."""

    def __init__(self, started: Iterable[Launched]) -> None:
        self._found = [_Container(p, tuple(_names(p))) for p in started if _may_load(p)]

    def of(self, component: Started) -> list[tuple[Launched, bool]]:
        """The processes that load a component, and whether each may do it only; none where nothing has the name of its target.

        One process of which the executable is not known is one, and not as many as there are executables that it may run.
        """
        wanted = [_absolute(o) for o in options(component.container)] if component.container is not None else []
        found: dict[int, tuple[Launched, bool]] = {}
        for target in wanted:
            exact = [c for c in self._found if any(readable(n) == readable(target) for n in c.names)]
            chosen = exact or [c for c in self._found if any(_may_be(n, target) for n in c.names)]
            for each in chosen:
                open_ = not exact or len(wanted) > 1 or len(each.names) > 1 or each.start.started.conditional
                found.setdefault(id(each.start.started), (each.start, open_))
        return list(found.values())


def loaded(component: Launched, container: Launched, *, conditional: bool) -> Launched:
    """The component in the process of a container."""
    return component._replace(
        process=container.process,
        conditional=component.conditional or conditional,
        configuration=inside(component.configuration, container.configuration),
    )


def inside(component: Configuration, process: Configuration) -> Configuration:
    """The start of a process as one of its components has it: what launch gives the component goes to its own node alone."""
    return replace(
        process,
        component=component.words,
        files={**process.files, **component.files},
        missing={**process.missing, **component.missing},
    )


def target_of(component: Started) -> str:
    """The full name of the container that a component asks for, as a person reads it."""
    return readable(_absolute(component.container)) if component.container is not None else "a container"


def label_of(target: str) -> str:
    """The label of a process that nothing here starts."""
    return f"{CONTAINER}{target}"


def is_container(program: Program) -> bool:
    """Whether a declared program has the service that loads components."""
    return any(_has_service(shape.group) for shape in program.nodes)


def _may_load(launched: Launched) -> bool:
    kind = launched.started.kind
    if kind in (StartKind.COMPONENT, StartKind.CONTAINER):
        return kind is StartKind.CONTAINER
    if launched.program is not None:
        return is_container(launched.program)
    return launched.entry is None or bool(launched.entry.program)


def _has_service(group: EndpointGroup) -> bool:
    inner = (*group.groups, *(g for _, g in group.cases))
    return any(e.type == _LOADS for e in group.endpoints) or any(map(_has_service, inner))


def _names(launched: Launched) -> Iterator[Value]:
    """The full names that the node of a process may have: what its command line says, else what its program does."""
    words = launched.configuration.words
    own = _own_name(launched.program)
    effect = NodeEffect(
        1, own, NONE, (), Series(), Series(words), Unknown(()), launched.started.place, late=False, assumed=True
    )
    name, namespace = final_name(EffectLog(launched.configuration), effect)
    for space in options(namespace):
        for each in options(name):
            if each != _NO_NAME:
                root = isinstance(space, Const) and space.value == "/"
                yield concat((Const("/"), each)) if root else concat((space, Const("/"), each))


_NO_NAME: Final = Unknown((), "str")


def _own_name(program: Program | None) -> Value:
    said = program.nodes[0].name if program is not None and program.nodes else None
    return Const(said) if said is not None and "$" not in said else _NO_NAME


def _absolute(target: Value) -> Value:
    """launch asks from the root: a relative name is one below it."""
    return target if readable(target).startswith("/") else concat((Const("/"), target))


def _may_be(name: Value, target: Value) -> bool:
    """Whether two names, of which parts are not known, may be the same."""
    known = [v for v in (name, target) if isinstance(v, Const)]
    if len(known) == 2:
        return False
    if len(known) == 1:
        other = target if known[0] is name else name
        return matches(other, str(known[0].value))
    return True
