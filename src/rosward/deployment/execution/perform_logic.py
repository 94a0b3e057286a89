# SPDX-License-Identifier: Apache-2.0
"""Substitutions that compute 'true' or 'false', or choose by it.

$(not false) -> 'true'      $(and $(var a) true)      $(equals 1.0 1) -> 'true', as floats      $(if $(var sim) gazebo real)
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Final

from rosward.deployment.execution.yaml_values import is_same_path, truth
from rosward.domain.choice import join, join_all, lift, lift2, options, reasons_of
from rosward.domain.text import is_path, matches, origins_of
from rosward.domain.unknown import NO_ORIGINS, Cause, Origins, Reason
from rosward.domain.values import Const, Text, Unknown, Value
from rosward.effects.variables import Variables

if TYPE_CHECKING:
    from rosward.deployment.execution.scene import Performing, Scene
    from rosward.deployment.tree import Substitution, Template
    from rosward.location import Place

_WORDS: Final = ("true", "false", "1", "0")
_YES: Final = ("true", "1", "yes", "on")
_MOST: Final = 256
"""So many combinations of alternatives are computed one by one; more are unknown."""


def _truth(scene: Scene, template: Template, place: Place) -> Value:
    return truth(scene.text(template), lambda why: scene.fails(f"a bool is needed here, but {why}", place))


def _combined(values: Sequence[Value], decide: bool, place: Place) -> Value:
    """`any` (decide=True) or `all` (decide=False): one argument of that value settles it, whatever the others are."""
    ways: list[tuple[bool | None, Origins]] = [(not decide, NO_ORIGINS)]
    for value in values:
        ways = list(dict.fromkeys(_next(way, option, decide) for way in ways for option in options(value)))
        if len(ways) > _MOST:
            return Unknown(reasons_of(value) or (Reason(Cause.MANY, "", place),), "str")
    reasons = tuple(dict.fromkeys(r for v in values for r in reasons_of(v)))
    return join_all(_word(found, origins, reasons) for found, origins in ways)


def _next(way: tuple[bool | None, Origins], option: Value, decide: bool) -> tuple[bool | None, Origins]:
    found, origins = way
    if found is decide:
        return way
    if not isinstance(option, Const):
        return None, origins
    if bool(option.value) is decide:
        return decide, option.origins
    return found, origins | option.origins


def _word(found: bool | None, origins: Origins, reasons: tuple[Reason, ...]) -> Value:
    return Unknown(reasons, "str") if found is None else Const("true" if found else "false", origins)


def _any(scene: Scene, substitution: Substitution) -> Value:
    values = [_truth(scene, t, substitution.place) for t in substitution.arguments]
    return _combined(values, True, substitution.place)


def _all(scene: Scene, substitution: Substitution) -> Value:
    values = [_truth(scene, t, substitution.place) for t in substitution.arguments]
    return _combined(values, False, substitution.place)


def _not(scene: Scene, substitution: Substitution) -> Value:
    value = _truth(scene, substitution.arguments[0], substitution.place)
    return join_all(_negated(option) for option in options(value))


def _negated(option: Value) -> Value:
    if isinstance(option, Const):
        return Const("false" if option.value in (True, "true") else "true", option.origins)
    return Unknown(reasons_of(option), "str")


def _equals(scene: Scene, substitution: Substitution) -> Value:
    left, right = (scene.text(t) for t in substitution.arguments[:2])
    return equal(left, right, scene.variables, substitution.place)


def _not_equals(scene: Scene, substitution: Substitution) -> Value:
    return join_all(_negated(option) for option in options(_equals(scene, substitution)))


def equal(left: Value, right: Value, variables: Variables, place: Place) -> Value:
    """'true' or 'false' as EqualsSubstitution has it: bools and floats are compared as such."""

    def pair(a: Value, b: Value) -> Value:
        if isinstance(a, Const) and isinstance(b, Const):
            variables.of_default(a.origins, b, place)
            variables.of_default(b.origins, a, place)
            same = _same(str(a.value), str(b.value))
            return Const("true" if same else "false", a.origins | b.origins)
        same_path = is_same_path(a, b)
        if same_path is not None:
            return Const("true" if same_path else "false", origins_of(a) | origins_of(b))
        other = variables.equal(a, b) is False and not (_is_number_or_bool(a) or _is_number_or_bool(b))
        if other or _differ(a, b) or _differ(b, a):
            return Const("false", origins_of(a) | origins_of(b))
        return Unknown(reasons_of(a) + reasons_of(b), "str")

    return lift2(pair, left, right)


def _differ(text: Value, const: Value) -> bool:
    """Whether a text with holes is surely not equal to a constant that is neither a bool nor a number."""
    if not isinstance(text, Text) or not isinstance(const, Const) or not isinstance(const.value, str):
        return False
    if is_path(text) and not const.value.startswith("/"):
        return True
    return not _is_number_or_bool(const) and not matches(text, const.value)


def _is_number_or_bool(value: Value) -> bool:
    """Whether a text is compared as what it stands for: others that look different may be equal."""
    text = value.value if isinstance(value, Const) else None
    return isinstance(text, str) and (text.lower() in _WORDS or _float(text) is not None)


def _same(left: str, right: str) -> bool:
    if left.lower() in _WORDS and right.lower() in _WORDS:
        return (left.lower() in ("true", "1")) == (right.lower() in ("true", "1"))
    one, other = _float(left), _float(right)
    return math.isclose(one, other) if one is not None and other is not None else left == right


def _float(text: str) -> float | None:
    try:
        return float(text)
    except ValueError:
        return None


def _if(scene: Scene, substitution: Substitution) -> Value:
    """Both ways where the condition is not known or may be another one (a default of the environment)."""
    condition = _truth(scene, substitution.arguments[0], substitution.place)
    found: list[Value] = []
    for option in options(condition):
        known = isinstance(option, Const) and option.is_settled
        for index in (1, 2):
            if not known or (isinstance(option, Const) and bool(option.value) is (index == 1)):
                branch = substitution.arguments[index] if index < len(substitution.arguments) else ()
                found.append(scene.text(branch))
    result = found[0]
    for other in found[1:]:
        result = join(result, other)
    return result


def _holds(scene: Scene, substitution: Substitution) -> Value:
    """A condition of launch, or of a class of the sources, as text."""
    assert substitution.value is not None
    found = scene.python.test(substitution.value, scene)
    return join_all(
        Const("true" if o.value else "false", o.origins) if isinstance(o, Const) else Unknown(reasons_of(o), "str")
        for o in options(found)
    )


def _as_bool(scene: Scene, substitution: Substitution) -> Value:
    """LaunchConfigAsBool of nav2_common: more words than a condition of launch knows, and a name that Python expressions know."""

    def one(option: Value) -> Value:
        if not isinstance(option, Const):
            return Unknown(reasons_of(option), "str")
        return Const("True" if str(option.value).strip().lower() in _YES else "False", option.origins)

    return lift(one, scene.text(substitution.arguments[0]))


LOGIC: Final[dict[str, Performing]] = {
    "not": _not,
    "and": _all,
    "all": _all,
    "or": _any,
    "any": _any,
    "equals": _equals,
    "not-equals": _not_equals,
    "if": _if,
    "holds": _holds,
    "as-bool": _as_bool,
}
