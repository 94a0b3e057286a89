# SPDX-License-Identifier: Apache-2.0
"""Actions that change the context and start nothing.

arg robot default r1; let ns robot_$(var robot); push_ros_namespace $(var ns)    ->    robot = 'r1', ns = 'robot_r1', namespace /robot_r1
"""

from __future__ import annotations

from collections.abc import Sequence
from operator import methodcaller
from typing import TYPE_CHECKING, Final

from rosward.deployment import tree
from rosward.deployment.execution.namespaces import prefixed
from rosward.deployment.execution.parameters import evaluate
from rosward.deployment.execution.perform_names import with_origin
from rosward.deployment.execution.ros_state import GlobalFile, GlobalParameter, Remap
from rosward.deployment.execution.yaml_values import plain_text
from rosward.domain.choice import join, join_all, options
from rosward.domain.text import concat, matches, readable
from rosward.domain.unknown import Cause, Origin, Reason, causes_of
from rosward.domain.values import Const, Unknown, Value
from rosward.holes import literal
from rosward.ros.validation import validate_namespace

if TYPE_CHECKING:
    from rosward.deployment.execution.scene import Scene

SETTINGS: Final = (
    tree.Declare,
    tree.SetConfiguration,
    tree.Environ,
    tree.ScopeChange,
    tree.PushNamespace,
    tree.SetRemap,
    tree.SetParameter,
)
"""The actions that `change` executes."""

Setting = (
    tree.Declare
    | tree.SetConfiguration
    | tree.Environ
    | tree.ScopeChange
    | tree.PushNamespace
    | tree.SetRemap
    | tree.SetParameter
)


def change(action: Setting, scene: Scene) -> None:
    """Execute an action that changes the context."""
    if isinstance(action, tree.Declare):
        _declare(action, scene)
    elif isinstance(action, tree.SetConfiguration):
        value = None if action.value is None else scene.text(action.value)
        set_configuration(scene.text(action.name), value, scene)
    elif isinstance(action, tree.Environ):
        _environ(action, scene)
    elif isinstance(action, tree.ScopeChange):
        _scope(action, scene)
    elif isinstance(action, tree.PushNamespace):
        _push_namespace(action, scene)
    elif isinstance(action, tree.SetRemap):
        remap = Remap(scene.text(action.source), scene.text(action.target))
        scene.context.change_ros(lambda state: state.added(remap))
    else:
        _set_parameter(action, scene)
    if scene.context.exceeded:
        scene.context.exceeded = False
        message = "Namespaces, remap rules or parameters depend on too many conditions here. Not all combinations are analysed."
        scene.findings.tell("RW201", message, action.place)


def performed(pairs: Sequence[tuple[tree.Template, tree.Template]], scene: Scene) -> list[tuple[str, Value]]:
    """Names and values of launch configurations, each name that is known."""
    found: list[tuple[str, Value]] = []
    for name, value in pairs:
        text = scene.text(value)
        found += [(plain, text) for o in options(scene.text(name)) if (plain := plain_text(o)) is not None]
    return found


def set_configuration(name: Value, value: Value | None, scene: Scene) -> None:
    """Set a launch configuration, or remove it (None). A name that is not known may be any."""
    names = options(name)
    for option in names:
        plain = plain_text(option)
        if plain is None:
            scene.context.set_unknown_name(value)
        elif len(names) == 1:
            scene.context.set(plain, value)
        else:
            saved = scene.context.save()
            scene.context.set(plain, value)
            scene.context.join(saved)


def _declare(action: tree.Declare, scene: Scene) -> None:
    """A value that is set already counts; else the default, performed now."""
    for option in options(scene.text(action.name)):
        name = plain_text(option)
        if name is not None:
            _declare_one(name, action, scene)


def _declare_one(name: str, action: tree.Declare, scene: Scene) -> None:
    scene.asked.add(name)
    held = scene.context.held(name)
    value = held.value if held is not None else None
    if held is None or value is None or not held.sure:
        if action.default is not None:
            default = with_origin(scene.text(action.default), Origin("launch argument", name, settled=True))
        else:
            shown = f"The launch argument '{name}' has no default and was not given a value."
            reasons = (Reason(Cause.LAUNCH_ARGUMENT, name, action.place),)
            scene.findings.tell("RW312", shown, action.place, causes_of(reasons, action.place))
            default = Unknown(reasons, "str")
        value = default if value is None else join(value, default)
    scene.context.set(name, _chosen(name, value, action, scene))


def _chosen(name: str, value: Value, action: tree.Declare, scene: Scene) -> Value:
    """The alternatives that are among the choices: launch fails with any other."""
    if not action.choices:
        return value
    choices = [scene.text(choice) for choice in action.choices]
    plain = [c for c in map(plain_text, choices) if c is not None]
    if len(plain) < len(choices):
        return value
    origin = Origin("launch argument", name, settled=True)
    fitting: list[Value] = []
    for option in options(value):
        if isinstance(option, Const):
            fitting += [option] if option.value in plain else []
        else:
            fitting += [with_origin(Const(c), origin) for c in plain if matches(option, c)]
    if fitting:
        return join_all(fitting)
    choice = ", ".join(plain)
    scene.fails(f"the launch argument '{name}' is '{readable(value)}', but must be one of {choice}", action.place)
    return value


def _environ(action: tree.Environ, scene: Scene) -> None:
    value = scene.text(action.value)
    separator = scene.text(action.separator) if action.separator else Const(":")
    names = options(scene.text(action.name))
    for option in names:
        name = plain_text(option)
        if name is None:
            continue
        saved = scene.context.save() if len(names) > 1 else None
        if action.how in ("append", "prepend"):
            scene.context.set_variable(name, _extended(name, value, separator, action, scene))
        else:
            scene.context.set_variable(name, None if action.how == "unset" else value)
        if saved is not None:
            scene.context.join(saved)


def _extended(name: str, value: Value, separator: Value, action: tree.Environ, scene: Scene) -> Value:
    """The variable with more at its end or beginning; that of the shell may be set or not."""
    held = scene.context.variable(name)
    shell = Unknown((Reason(Cause.ENVIRONMENT, name, action.place),), "str")
    before: list[Value | None] = [None, shell] if held is None else [held.value]
    if held is not None and not held.sure:
        before += [None, shell]
    found: list[Value] = []
    for old in before:
        for option in options(value):
            for previous in options(old) if old is not None else (None,):
                if previous is None:
                    found.append(option)
                else:
                    parts = (previous, separator, option)
                    found.append(concat(parts if action.how == "append" else parts[::-1]))
    return join_all(found)


def _scope(action: tree.ScopeChange, scene: Scene) -> None:
    context = scene.context
    done = True
    if action.what == "configurations":
        if action.how == "push":
            context.push_configurations()
        elif action.how == "pop":
            done = context.pop_configurations()
        else:
            context.reset_configurations(performed(action.configurations, scene))
    elif action.how == "push":
        context.push_environment()
    elif action.how == "pop":
        done = context.pop_environment()
    else:
        context.reset_environment()
    if not done:
        scene.fails(f"there are no {action.what} to restore", action.place)


def _push_namespace(action: tree.PushNamespace, scene: Scene) -> None:
    namespace = scene.text(action.namespace)
    scene.context.change_ros(lambda state: state.with_namespace(prefixed(state.namespace, namespace)))
    for state in scene.context.alternatives:
        for option in options(state.namespace) if state.namespace is not None else ():
            plain = plain_text(option)
            error = validate_namespace(literal(plain)) if plain is not None else None
            if error is not None:
                scene.fails(f"{plain!r} is not a valid namespace ({error})", action.place)


def _set_parameter(action: tree.SetParameter, scene: Scene) -> None:
    source, place = action.parameter, action.place
    added: list[GlobalParameter | GlobalFile] = []
    if isinstance(source, tree.ParameterFile):
        node = None if action.node is None else scene.text(action.node)
        path = scene.text(source.path)
        if source.substitutions:
            path = scene.generated.performed(scene, path, place)
        added.append(GlobalFile(path, place, node))
    elif isinstance(source, tree.ParameterArgument):
        name = scene.text(source.name)
        added.append(GlobalParameter(name, evaluate(source.data, name, scene, place), place))
    else:
        for key, data in source.entries:
            name = scene.text(key)
            added.append(GlobalParameter(name, evaluate(data, name, scene, place), place))
    for entry in added:
        scene.context.change_ros(methodcaller("added", entry))
