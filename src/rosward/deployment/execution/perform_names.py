# SPDX-License-Identifier: Apache-2.0
"""Substitutions that look something up, or compute a text: var, env, param, anon, eval, command, for-var, index, string-join, python.

$(var id)            the launch configuration; one that is not set fails
$(env HOME)          unknown, unless it is given or launch set it; a default is one value of many: conditions on it take both ways
$(anon talker)       Text('talker_', hole), the same each time
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.deployment.execution.ros_state import GlobalParameter
from rosward.deployment.execution.yaml_values import plain_text, printed
from rosward.domain.choice import join, join_all, lift, lift2, options, reasons_of
from rosward.domain.text import concat, make, readable
from rosward.domain.unknown import Cause, Origin, Reason
from rosward.domain.values import EMPTY, Const, Hole, Text, Unknown, Value
from rosward.effects.shell import ORIGIN

if TYPE_CHECKING:
    from rosward.deployment.execution.scene import Performing, Scene
    from rosward.deployment.tree import Substitution
    from rosward.location import Place


def with_origin(value: Value, origin: Origin) -> Value:
    """The value, known to come from `origin` too."""

    def one(option: Value) -> Value:
        if isinstance(option, Const):
            return Const(option.value, option.origins | {origin})
        return Text(option.parts, option.origins | {origin}) if isinstance(option, Text) else option

    return lift(one, value)


def _default(scene: Scene, substitution: Substitution) -> Value | None:
    return scene.text(substitution.arguments[1]) if len(substitution.arguments) > 1 else None


def _var(scene: Scene, substitution: Substitution) -> Value:
    found: list[Value] = []
    for option in options(scene.text(substitution.arguments[0])):
        name = plain_text(option)
        found.append(
            _configuration(scene, name, substitution)
            if name is not None
            else Unknown(reasons_of(option) or (Reason(Cause.OPERATION, "", substitution.place),), "str")
        )
    return join_all(found)


def _configuration(scene: Scene, name: str, substitution: Substitution) -> Value:
    scene.asked.add(name)
    held = scene.context.held(name)
    if held is not None and held.value is not None and held.sure:
        return held.value
    default = _default(scene, substitution)
    if held is not None and held.value is not None:
        return held.value if default is None else join(held.value, default)
    if default is not None:
        return default
    reasons = (Reason(Cause.LAUNCH_ARGUMENT, name, substitution.place),)
    if not scene.context.unread:  # else what could not be read, which was told, may have set it
        scene.fails(f"the launch configuration '{name}' is not set", substitution.place, reasons)
    return Unknown(reasons, "str")


def _env(scene: Scene, substitution: Substitution) -> Value:
    return join_all(_variable(scene, o, substitution) for o in options(scene.text(substitution.arguments[0])))


def _variable(scene: Scene, name: Value, substitution: Substitution) -> Value:
    default = _default(scene, substitution)
    plain = plain_text(name)
    shown = readable(name)
    held = scene.context.variable(shown) if plain is not None else None
    if held is not None and held.sure and held.value is not None:
        return held.value
    if held is not None and held.sure:  # launch removed it
        if default is None:
            scene.fails(f"the environment variable '{shown}' is not set", substitution.place)
        return default or Unknown((Reason(Cause.ENVIRONMENT, shown, substitution.place),), "str")
    if default is None:
        reasons = (Reason(Cause.ENVIRONMENT, shown, substitution.place),)
        shell: Value = Unknown(reasons, "str", shown if plain is not None else "")
    else:
        shell = with_origin(default, Origin(ORIGIN, shown))
    return shell if held is None or held.value is None else join(held.value, shell)


def _param(scene: Scene, substitution: Substitution) -> Value:
    """The value of a SetParameter; the first of that name counts."""
    name = scene.text(substitution.arguments[0])
    found: list[Value] = []
    for state in scene.context.alternatives:
        first = next((e for e in state.parameters if isinstance(e, GlobalParameter) and e.name == name), None)
        if first is not None:
            found.append(printed(first.value))
            continue
        default = _default(scene, substitution)
        if default is None:
            scene.fails(f"no SetParameter has set '{readable(name)}'", substitution.place)
            default = Unknown((Reason(Cause.PARAMETER, readable(name), substitution.place),), "str")
        found.append(default)
    return join_all(found)


def _anon(scene: Scene, substitution: Substitution) -> Value:
    name = scene.text(substitution.arguments[0])
    key = f"anon{readable(name)}"
    held = scene.context.held(key)
    if held is not None and held.value is not None:
        return held.value
    hole = Hole((Reason(Cause.RANDOM, "anonymous name", substitution.place),), "word")
    value = lift(lambda n: concat((n, make(("_", hole)))), name)
    scene.context.set(key, value)
    return value


def _eval(scene: Scene, substitution: Substitution) -> Value:
    expression, *modules = [scene.text(t) for t in substitution.arguments]
    names = [name for name in map(plain_text, modules) if name is not None] or ["math"]

    def one(option: Value) -> Value:
        found = _text(scene.python.evaluate(option, names, scene), substitution.place)
        error = next((r for r in reasons_of(found) if r.cause is Cause.ERROR), None)
        if error is not None and plain_text(option) is not None:
            scene.fails(f"an expression that raises an exception: {error.subject}", substitution.place)
        return found

    return lift(one, expression)


def _text(value: Value, place: Place) -> Value:
    """A text of what Python gave: something else is none."""

    def one(option: Value) -> Value:
        if isinstance(option, Text) or plain_text(option) is not None:
            return option
        if isinstance(option, Const):
            return Const(str(option.value), option.origins)
        return Unknown(reasons_of(option) or (Reason(Cause.OPERATION, "", place),), "str")

    return lift(one, value)


def _command(scene: Scene, substitution: Substitution) -> Value:
    shown = readable(scene.text(substitution.arguments[0])) if substitution.arguments else ""
    return Unknown((Reason(Cause.CALL, shown, substitution.place),), "str")


def _local(scene: Scene, substitution: Substitution) -> Value:
    shown = readable(scene.text(substitution.arguments[0])) if substitution.arguments else ""
    return Unknown((Reason(Cause.OPERATION, shown, substitution.place),), "str")


def _turn(scene: Scene, substitution: Substitution) -> Value:
    """$(for-var NAME) and $(index NAME), inside of a <for_each> or a <for>."""
    name = readable(scene.text(substitution.arguments[0]))
    value = scene.turn.get(name)
    if value is not None:
        return _text(value, substitution.place)
    default = _default(scene, substitution)
    if default is None:
        scene.fails(f"no enclosing loop has a variable '{name}'", substitution.place)
    return default or Unknown((Reason(Cause.LOOP, name, substitution.place),), "str")


def _string_join(scene: Scene, substitution: Substitution) -> Value:
    delimiter, *parts = [scene.text(t) for t in substitution.arguments]
    result: Value = parts[0] if parts else EMPTY
    for part in parts[1:]:
        result = lift2(lambda a, b: concat((a, b)), lift2(lambda a, b: concat((a, b)), result, delimiter), part)
    return result


def _python(scene: Scene, substitution: Substitution) -> Value:
    if substitution.value is None:
        return Unknown((Reason(Cause.OPERATION, "", substitution.place),), "str")
    return _text(scene.python.perform(substitution.value, scene), substitution.place)


NAMES: Final[dict[str, Performing]] = {
    "var": _var,
    "env": _env,
    "param": _param,
    "anon": _anon,
    "eval": _eval,
    "command": _command,
    "local": _local,
    "for-var": _turn,
    "index": _turn,
    "string-join": _string_join,
    "python": _python,
}
