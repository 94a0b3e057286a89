# SPDX-License-Identifier: Apache-2.0
"""What a node, a container and its components are started with.

<node pkg="demo" exec="talker" name="t" args="-v"><remap from="chatter" to="c"/></node>, below the namespace /left
->  Started(NODE, name='t', namespace='/left', words: -v --ros-args -r __node:=t -r __ns:=/left -r chatter:=c)

The order of the words is that of launch_ros: arguments, ros_arguments, name, namespace, parameters (SetParameter's first), remap rules
(SetRemap's first). A component gets the words that its container makes of the request to load it.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Final

from rosward.deployment.execution.component_parameters import ComponentParameters
from rosward.deployment.execution.namespaces import full_name, prefixed, scopes
from rosward.deployment.execution.parameters import LaunchedParameters
from rosward.deployment.execution.word_files import word_files
from rosward.deployment.execution.yaml_values import plain_text
from rosward.deployment.started import Started, StartKind
from rosward.deployment.tree import Component, NodeKind, StartNode, Template
from rosward.domain.choice import join, lift2, options
from rosward.domain.text import concat, parts_of
from rosward.domain.unknown import Cause
from rosward.domain.values import Const, Hole, Value
from rosward.effects.configuration import Configuration
from rosward.holes import literal
from rosward.records import NamedTuple
from rosward.ros.validation import validate_namespace, validate_node_name

if TYPE_CHECKING:
    from rosward.deployment.execution.ros_state import RosState
    from rosward.deployment.execution.scene import Scene
    from rosward.location import Place
    from rosward.network.launch_tree import Inclusion

_ROS_ARGS: Final = Const("--ros-args")
_RULE: Final = Const("-r")
_BY_PUSH: Final = "what was pushed or set earlier for all nodes"
_KINDS: Final = {
    NodeKind.NODE: StartKind.NODE,
    NodeKind.LIFECYCLE: StartKind.LIFECYCLE,
    NodeKind.CONTAINER: StartKind.CONTAINER,
}


class At(NamedTuple):
    """The circumstances under which an action is executed, as `Started` has them; `depth` counts the includes and groups around.

    `load` says which time of loading a launch file gave the action: the same object of another load is another action.
    """

    conditional: bool = False
    why: tuple[str, ...] = ()
    event: str = ""
    trail: tuple[Inclusion, ...] = ()
    depth: int = 0
    load: int = 0

    def inside(self, file: str) -> At:
        """In the file that the last include names."""
        return self._replace(trail=(*self.trail[:-1], self.trail[-1]._replace(file=file)))

    def maybe(self, why: str) -> At:
        """Only under a condition that is not known."""
        return self._replace(conditional=True, why=self.why if why in self.why else (*self.why, why))


def start_node(action: StartNode, scene: Scene, at: At) -> list[Started]:
    """The node, once for each alternative of what is pushed and set for all nodes."""
    states = scene.context.alternatives
    at = at.maybe(_BY_PUSH) if len(states) > 1 else at
    return [_with_doubts(partial(_node, action, state, scene, at), scene) for state in states]


def _with_doubts(start: Callable[[], Started], scene: Scene) -> Started:
    """What is started, with what is told of it alone, not of all that its line starts."""
    with scene.findings.heard() as told:
        started = start()
    return replace(started, told=tuple(told))


def _optional(template: Template | None, scene: Scene) -> Value | None:
    return None if template is None else scene.text(template)


def _node(action: StartNode, state: RosState, scene: Scene, at: At) -> Started:
    place = action.place
    name = _optional(action.name, scene)
    namespace = prefixed(state.namespace, _optional(action.namespace, scene))
    _check(name, namespace, scene, place)
    package, executable = _program(action, scene)
    words = [scene.text(word) for word in action.arguments]
    if action.ros_arguments:
        words += [_ROS_ARGS, *(scene.text(word) for word in action.ros_arguments)]
    own = word_files(words, scene, place)
    words.append(_ROS_ARGS)
    words += _identity(name, namespace)
    parameters = LaunchedParameters(scene, scopes(namespace, name), name)
    parameters.add_global(state.parameters)
    parameters.add(action.parameters)
    remaps = _remaps(action.remappings, state, scene)
    words += [*parameters.words, *_rules(remaps)]
    return Started(
        kind=_KINDS[action.kind],
        place=place,
        configuration=Configuration(
            words=tuple(words),
            files={**own.files, **parameters.files},
            missing={**own.missing, **parameters.missing},
            environment=environment(action.environment, action.replaces_environment, scene, place),
        ),
        package=package,
        executable=executable,
        name=name,
        namespace=namespace,
        remaps=remaps,
        settings=tuple(parameters.settings),
        conditional=at.conditional,
        why=at.why,
        event=at.event,
        trail=at.trail,
    )


def installed_program(path: Value) -> tuple[Value, Value] | None:
    """The package and the name of an executable whose path leads below the prefix of its package, as `ros2 run` finds it."""
    first, *rest = parts_of(path)
    if not isinstance(first, Hole) or len(rest) != 1 or not isinstance(rest[0], str) or len(first.reasons) != 1:
        return None
    reason = first.reasons[0]
    folder, _, name = rest[0].rpartition("/")
    if reason.cause is not Cause.PREFIX or folder != f"/lib/{reason.subject}" or not name:
        return None
    return Const(reason.subject), Const(name)


def _program(action: StartNode, scene: Scene) -> tuple[Value | None, Value]:
    """The package and the executable; a path may lead to that of a package, whatever package is named beside it."""
    executable = scene.text(action.executable)
    installed = installed_program(executable)
    if installed is not None:
        return installed
    is_path = (plain_text(executable) or "").startswith("/")
    return None if is_path else _optional(action.package, scene), executable


def _check(name: Value | None, namespace: Value | None, scene: Scene, place: Place) -> None:
    """launch_ros validates both before it starts the node."""
    for value, validate, what in ((name, validate_node_name, "name"), (namespace, validate_namespace, "namespace")):
        for option in options(value) if value is not None else ():
            plain = plain_text(option)
            error = validate(literal(plain)) if plain is not None else None
            if error is not None:
                scene.fails(f"{plain!r} is not a valid {what} of a node ({error})", place)


def _identity(name: Value | None, namespace: Value | None) -> list[Value]:
    words: list[Value] = []
    for rule, value in (("__node:=", name), ("__ns:=", namespace)):
        if value is not None:
            words += [_RULE, _joined(Const(rule), value)]
    return words


def _joined(left: Value, right: Value) -> Value:
    return lift2(lambda a, b: concat((a, b)), left, right)


def _remaps(own: Sequence[tuple[Template, Template]], state: RosState, scene: Scene) -> tuple[tuple[Value, Value], ...]:
    return (*state.remaps, *((scene.text(source), scene.text(target)) for source, target in own))


def _rules(remaps: Sequence[tuple[Value, Value]]) -> list[Value]:
    return [word for source, target in remaps for word in (_RULE, _joined(_joined(source, Const(":=")), target))]


def environment(
    own: Sequence[tuple[Template, Template]], replaces: bool, scene: Scene, place: Place
) -> dict[str, Value | None]:
    """The variables that a process is given: those that launch has set, and its own."""
    found = scene.context.replaced_environment(place) if replaces else scene.context.environment(place)
    for name, value in own:
        performed = scene.text(value)
        for option in options(scene.text(name)):
            plain = plain_text(option)
            if plain is not None:
                found[plain] = performed
    return found


# Components


def container_name(action: StartNode, scene: Scene) -> Value:
    """The full name of a container that is executed now, as the request to load a component names it."""
    name = _optional(action.name, scene) or Const("")
    own = _optional(action.namespace, scene)
    result: Value | None = None
    for state in scene.context.alternatives:
        namespace = prefixed(state.namespace, own)
        found = full_name(namespace, name) or name
        result = found if result is None else join(result, found)
    return result or name


def load_component(component: Component, container: Value, scene: Scene, at: At) -> list[Started]:
    """A component, once for each alternative of what is pushed and set for all nodes."""
    states = scene.context.alternatives
    at = at.maybe(_BY_PUSH) if len(states) > 1 else at
    return [_with_doubts(partial(_component, component, container, state, scene, at), scene) for state in states]


def _component(component: Component, container: Value, state: RosState, scene: Scene, at: At) -> Started:
    place = component.place
    name = _optional(component.name, scene)
    namespace = prefixed(state.namespace, _optional(component.namespace, scene))
    _check(None if name is not None and plain_text(name) == "" else name, namespace, scene, place)
    remaps = _remaps(component.remappings, state, scene)
    parameters = ComponentParameters(scene, namespace, name)
    parameters.add_global(state.parameters)
    parameters.add(component.parameters)
    words: list[Value] = [_ROS_ARGS, *_rules(remaps)]
    words += _identity(None if name is not None and plain_text(name) == "" else name, namespace)
    files = parameters.write(words)
    return Started(
        kind=StartKind.COMPONENT,
        place=place,
        configuration=Configuration(words=tuple(words), files=files, environment=scene.context.environment(place)),
        package=scene.text(component.package),
        plugin=scene.text(component.plugin),
        container=container,
        name=name,
        namespace=namespace,
        remaps=remaps,
        settings=tuple(parameters.settings),
        conditional=at.conditional,
        why=at.why,
        event=at.event,
        trail=at.trail,
    )
