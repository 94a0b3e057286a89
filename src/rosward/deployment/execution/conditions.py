# SPDX-License-Identifier: Apache-2.0
"""Is an action executed?

if="$(var sim)" with sim:=true          surely
if="$(env SIM false)"                   either way: the default is one value of many
if="$(var sim)" with sim unknown        either way, told as RW316
if="yes"                                launch raises an exception (RW320); both ways are taken
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from rosward.deployment.execution.yaml_values import is_same_path, plain_text
from rosward.deployment.tree import Condition, Substitution, Template
from rosward.domain.choice import options, reasons_of
from rosward.domain.text import is_path, matches, origins_of
from rosward.domain.unknown import Cause, Origins
from rosward.domain.values import Const, Text, Unknown, Value
from rosward.effects.shell import ORIGIN
from rosward.location import Place
from rosward.records import NamedTuple

if TYPE_CHECKING:
    from rosward.deployment.execution.scene import Scene

_TRUE, _FALSE = ("true", "1"), ("false", "0")


class Truth(NamedTuple):
    """Whether a condition can be true and can be false; `why` says what it depends on where both are possible."""

    true: bool = True
    false: bool = True
    why: str = ""
    variables: tuple[str, ...] = ()
    """The environment variables that it depends on, where it depends on nothing else."""

    @property
    def open(self) -> bool:
        """Whether both are possible."""
        return self.true and self.false

    def negated(self) -> Truth:
        """The verdict on `not`."""
        return Truth(self.false, self.true, self.why, self.variables)


YES = Truth(false=False)
NO = Truth(true=False)


def decide(condition: Condition | None, scene: Scene) -> Truth:
    """Whether an action with this condition is executed. What is not known is told (RW316)."""
    if condition is None:
        return YES
    verdict = _verdict(condition, scene)
    if verdict.open and verdict.variables:
        for name in verdict.variables:
            scene.variables.compared(name, (), condition.place)
    elif verdict.open:
        message = f"The condition is unknown: it depends on {verdict.why}. Both branches are analysed."
        scene.findings.tell("RW316", message, condition.place, (verdict.why,) if verdict.why else ())
    return verdict


def _verdict(condition: Condition, scene: Scene) -> Truth:
    if condition.kind in ("if", "unless"):
        text = condition.arguments[0] if condition.arguments else ()
        verdict = _of_text(scene.text(text), text, condition, scene)
        return verdict.negated() if condition.kind == "unless" else verdict
    if condition.kind in ("equals", "not-equals"):
        verdict = _comparison(condition, scene)
        return verdict.negated() if condition.kind == "not-equals" else verdict
    if condition.value is None:
        return Truth(why="an unreadable condition")
    return _of_bool(scene.python.test(condition.value, scene))


def _of_text(text: Value, template: Template, condition: Condition, scene: Scene) -> Truth:
    """`true`, `1`, `false`, `0` in any case, without the blanks around; anything else raises an exception."""
    verdicts: list[Truth] = []
    for option in options(text):
        plain = str(option.value).strip().lower() if isinstance(option, Const) else None
        if plain in _TRUE or plain in _FALSE:
            verdicts.append(_settled(plain in _TRUE, origins_of(option)))
        elif plain is not None:
            scene.fails(f"the condition is {plain!r}, which is neither true nor false", condition.place)
            verdicts.append(Truth(why=f"the text {plain!r}"))
        else:
            if isinstance(option, Unknown) and option.variable:
                scene.variables.is_condition(option.variable)
            verdicts.append(_not_known(option))
    return _joined(verdicts, template)


def _settled(truth: bool, origins: Origins) -> Truth:
    """A known truth counts unless it comes from a default that somebody may change."""
    open_ones = sorted(o for o in origins if not o.settled)
    if not open_ones:
        return Truth(truth, not truth)
    names = tuple(o.name for o in open_ones) if all(o.kind == ORIGIN for o in open_ones) else ()
    return Truth(why=", ".join(f"the {o.kind} '{o.name}'" for o in open_ones), variables=names)


def _not_known(value: Value) -> Truth:
    """Both, because of what keeps a value from being known."""
    reasons = reasons_of(value)
    names = [r.subject for r in reasons if r.cause is Cause.ENVIRONMENT]
    return Truth(why=_reasons(value), variables=tuple(names) if len(names) == len(reasons) else ())


def _of_bool(value: Value) -> Truth:
    verdicts: list[Truth] = []
    for option in options(value):
        if isinstance(option, Const):
            verdicts.append(_settled(bool(option.value), option.origins))
        else:
            verdicts.append(_not_known(option))
    return _joined(verdicts, ())


def _joined(verdicts: list[Truth], template: Template) -> Truth:
    true, false = any(v.true for v in verdicts), any(v.false for v in verdicts)
    if not (true and false):
        return Truth(true, false)
    why = dict.fromkeys(v.why for v in verdicts if v.why)
    every = [v for v in verdicts if v.open]
    names = dict.fromkeys(n for v in every for n in v.variables) if all(v.variables for v in every) else {}
    return Truth(why="; ".join(why) or _names(template), variables=tuple(names))


def _reasons(value: Value) -> str:
    return "; ".join(str(r) for r in reasons_of(value)[:3]) or "an unknown value"


def _names(template: Template) -> str:
    """What a text with several alternatives is made of."""
    names = [
        s.arguments[0][0]
        for s in template
        if isinstance(s, Substitution) and s.kind == "var" and s.arguments and s.arguments[0]
    ]
    plain = [text for n in names if not isinstance(n, Substitution) and (text := plain_text(n)) is not None]
    found = [f"the launch configuration '{name}'" for name in plain]
    return ", ".join(found) or "a value with several alternatives"


def _comparison(condition: Condition, scene: Scene) -> Truth:
    """LaunchConfigurationEquals: false where the configuration is not set; None as the expected text is true then."""
    name = scene.text(condition.arguments[0]) if condition.arguments else Unknown(())
    expected = scene.text(condition.arguments[1]) if len(condition.arguments) > 1 else None
    plain = plain_text(name)
    if plain is None:
        return Truth(why=_reasons(name))
    scene.asked.add(plain)
    held = scene.context.held(plain)
    verdicts: list[Truth] = []
    if held is None or held.value is None or not held.sure:
        verdicts.append(YES if expected is None else NO)
    if held is not None and held.value is not None:
        for value in options(held.value):
            verdicts += (
                [_same(value, e, scene, condition.place) for e in options(expected)] if expected is not None else [NO]
            )
    return _joined(verdicts, (Substitution("var", ((name,),), condition.place),))


def _same(left: Value, right: Value, scene: Scene, place: Place) -> Truth:
    if isinstance(left, Const) and isinstance(right, Const):
        scene.variables.of_default(left.origins, right, place)
        scene.variables.of_default(right.origins, left, place)
        return _settled(left.value == right.value, left.origins | right.origins)
    same_path = is_same_path(left, right)
    if same_path is not None:
        return _settled(same_path, origins_of(left) | origins_of(right))
    if scene.variables.equal(left, right) is False:
        return NO
    for text, other in ((left, right), (right, left)):
        plain = plain_text(other)
        if isinstance(text, Text) and plain is not None:
            if not matches(text, plain) or (is_path(text) and not plain.startswith("/")):
                return NO
    return _not_known(left if not isinstance(left, Const) else right)
