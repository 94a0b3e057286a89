# SPDX-License-Identifier: Apache-2.0
"""Objects of `launch.substitutions` and `launch.conditions`, as templates and conditions of the tree.

['talker_', LaunchConfiguration('id')]      (Const('talker_'), Substitution('var', ((Const('id'),),)))
IfCondition(LaunchConfiguration('gui'))     Condition('if', ((Substitution('var', …),),))
"""

from __future__ import annotations

from typing import Final, final

from rosward.deployment.python.objects import Objects
from rosward.deployment.tree import Condition, Substitution, Template
from rosward.domain.choice import join, options
from rosward.domain.compound import External, Native, Tuple
from rosward.domain.values import NONE, Const, Ref, Text, Unknown, Value
from rosward.location import Place
from rosward.records import NamedTuple

_SUBSTITUTION: Final = "launch.substitution.Substitution"
_CONDITION: Final = "launch.condition.Condition"
_STR: Final = Native("builtins.str")
_DEEPEST: Final = 40
_MOST: Final = 2_000


class _Form(NamedTuple):
    """How a class is written in the tree: the kind, and which of its fields are the arguments; those with `?` may be left out,
    those with `*` are lists of arguments."""

    kind: str
    fields: tuple[str, ...] = ()


FORMS: Final = {
    "launch.substitutions.LaunchConfiguration": _Form("var", ("name", "default?")),
    "launch.substitutions.EnvironmentVariable": _Form("env", ("name", "default?")),
    "launch.substitutions.FindExecutable": _Form("find-exec", ("name",)),
    "launch.substitutions.AnonName": _Form("anon", ("name",)),
    "launch.substitutions.LocalSubstitution": _Form("local", ("expression",)),
    "launch.substitutions.ThisLaunchFile": _Form("filename"),
    "launch.substitutions.ThisLaunchFileDir": _Form("dirname"),
    "launch.substitutions.LaunchLogDir": _Form("launch-log-dir"),
    "launch.substitutions.PythonExpression": _Form("eval", ("expression", "modules*")),
    "launch.substitutions.Command": _Form("command", ("command", "on_stderr?")),
    "launch.substitutions.FileContent": _Form("file-content", ("path",)),
    "launch.substitutions.PathJoinSubstitution": _Form("path-join", ("parts*",)),
    "launch.substitutions.PathSubstitution": _Form("path-join", ("parts*",)),
    "launch.substitutions.StringJoinSubstitution": _Form("string-join", ("delimiter", "parts*")),
    "launch.substitutions.NotSubstitution": _Form("not", ("value",)),
    "launch.substitutions.AndSubstitution": _Form("and", ("left", "right")),
    "launch.substitutions.OrSubstitution": _Form("or", ("left", "right")),
    "launch.substitutions.AnySubstitution": _Form("any", ("parts*",)),
    "launch.substitutions.AllSubstitution": _Form("all", ("parts*",)),
    "launch.substitutions.EqualsSubstitution": _Form("equals", ("left", "right")),
    "launch.substitutions.NotEqualsSubstitution": _Form("not-equals", ("left", "right")),
    "launch.substitutions.IfElseSubstitution": _Form("if", ("test", "then", "otherwise")),
    "launch.substitutions.ForEachVar": _Form("for-var", ("name", "default?")),
    "launch.substitutions.ForLoopIndex": _Form("index", ("name", "default?")),
    "launch_ros.substitutions.FindPackageShare": _Form("find-pkg-share", ("package",)),
    "launch_ros.substitutions.FindPackagePrefix": _Form("find-pkg-prefix", ("package",)),
    "launch_ros.substitutions.FindPackage": _Form("find-pkg-prefix", ("package",)),
    "launch_ros.substitutions.ExecutableInPackage": _Form("exec-in-pkg", ("executable", "package")),
    "launch_ros.substitutions.Parameter": _Form("param", ("name", "default?")),
    "launch_ros.parameter_descriptions.ParameterFile": _Form("parameter-file", ("path", "allow_substs")),
    "nav2_common.launch.RewrittenYaml": _Form("rewritten-yaml", ("path", "root_key", "convert_types")),
    "nav2_common.launch.ReplaceString": _Form("replace-string", ("path",)),
    "nav2_common.launch.HasNodeParams": _Form("has-node-params", ("path", "node")),
    "nav2_common.launch.LaunchConfigAsBool": _Form("as-bool", ("name@",)),
}
_TABLES: Final = {
    "nav2_common.launch.RewrittenYaml": ("rewrites", "key_rewrites", "value_rewrites"),
    "nav2_common.launch.ReplaceString": ("replacements",),
}
_CONDITIONAL: Final = {"nav2_common.launch.ReplaceString": ("test", "path")}
"""Substitutions with a condition of their own: its field, and what stands for them where it does not hold."""
_TAKE_NUMBERS: Final = frozenset({"var", "equals", "not-equals", "parameter-file", "rewritten-yaml"})
CONDITIONS: Final = {
    "launch.conditions.IfCondition": _Form("if", ("predicate",)),
    "launch.conditions.UnlessCondition": _Form("unless", ("predicate",)),
    "launch.conditions.LaunchConfigurationEquals": _Form("equals", ("name", "value?")),
    "launch.conditions.LaunchConfigurationNotEquals": _Form("not-equals", ("name", "value?")),
}


@final
class Texts:
    """Reads what launch takes as text."""

    def __init__(self, objects: Objects) -> None:
        self.objects = objects
        self._depth = 0
        self._pieces = 0

    def is_substitution(self, value: Value) -> bool:
        """Whether a value is a substitution object."""
        return self.objects.is_a(value, _SUBSTITUTION)

    def template(self, value: Value | None, place: Place) -> Template:
        """The text that a str, a path, a substitution or a list of them stands for; `place` is that of what it is given to."""
        if self._depth == 0:
            self._pieces = 0
        self._pieces += 1
        if self._depth > _DEEPEST or self._pieces > _MOST:
            return (self.objects.unknown("string with too many parts", place),)
        self._depth += 1
        try:
            return self._template(value, place)
        finally:
            self._depth -= 1

    def _template(self, value: Value | None, place: Place) -> Template:
        if value is None or value == NONE:
            return ()
        if self.objects.is_text(value):
            return (value,)
        found = options(value)
        if len(found) > 1:
            return (Substitution("python", (), place, value),)
        if isinstance(value, (Unknown, External)):
            return (value if isinstance(value, Unknown) else self.objects.unknown(value.name, place),)
        if isinstance(value, Const):
            self.objects.tell("RW320", f"launch requires a str or a substitution here, not {value.value!r}", place)
            return (Const(str(value.value), value.origins),)
        if self.objects.kind(value) in FORMS or self.is_substitution(value):
            return self._substitution(value, place)
        if self.objects.is_sequence(value):
            return self._several(value, place)
        return (self._as_str(value, place),)

    def optional(self, value: Value | None, place: Place) -> Template | None:
        """The text, None where there is none."""
        return None if value is None or value == NONE else self.template(value, place)

    def pairs(self, value: Value | None, place: Place) -> tuple[tuple[Template, Template], ...]:
        """A dict, or a list of pairs, of texts. What may not be there has a value that may be any."""
        return tuple((k, v if sure else self._perhaps(v, place)) for k, v, sure in self._pairs(value, place))

    def rules(self, value: Value | None, place: Place) -> tuple[tuple[Template, Template], ...]:
        """The remap rules of a node. One that may not be there may keep its name, unless a later one is for that name, too."""
        pairs = self._pairs(value, place)
        found: list[tuple[Template, Template]] = []
        for index, (source, target, sure) in enumerate(pairs):
            last = all(source != later for later, _, _ in pairs[index + 1 :])
            found.append((source, target if sure else self._perhaps(target, place, source if last else ())))
        return tuple(found)

    def _perhaps(self, text: Template, place: Place, other: Template = ()) -> Template:
        """A text in place of which another one may hold; any, where that is not known."""
        unknown = self.objects.unknown("what may not be there", place)
        known = [t[0] if len(t) == 1 and not isinstance(t[0], Substitution) else unknown for t in (text, other)]
        return (join(*known),)

    def _pairs(self, value: Value | None, place: Place) -> list[tuple[Template, Template, bool]]:
        """Pairs of texts, each with whether it is surely there."""
        if value is None or value == NONE:
            return []
        if self.objects.is_dict(value):
            assert isinstance(value, Ref)
            obj = self.objects.machine.obj(value)
            entries = [
                (self.template(k, place), self.template(v, place), k not in obj.maybe) for k, v in obj.entries.items()
            ]
            if obj.rest is not None:
                unknown = self.objects.unknown("entries of a dict", place)
                entries.append(((unknown,), self.template(obj.rest, place), False))
            return entries
        found: list[tuple[Template, Template, bool]] = []
        for element in self.objects.elements(value):
            several = options(element.value)
            sure = element.sure and len(several) == 1
            for option in several:
                pair = self.objects.elements(option) if self.objects.is_sequence(option) else []
                if len(pair) == 2:
                    key, text = (self.template(p.value, place) for p in pair)
                    found.append((key, text, sure))
                elif isinstance(option, Unknown):
                    found.append(((option,), (option,), sure))
                else:
                    self.objects.tell("RW320", "launch requires pairs of strings here", place)
        return found

    def words(self, value: Value | None, place: Place) -> tuple[Template, ...]:
        """A list of texts. A str is taken as the list of its characters, as launch does."""
        if value is None or value == NONE:
            return ()
        if self.objects.is_text(value):
            known, rest = self.objects.machine.iterate(value)
            return tuple((v,) for v in (*known, *(() if rest is None else (rest,))))
        words = ((self.template(e.value, place), e.sure) for e in self.objects.elements(value))
        return tuple(word if sure else self._perhaps(word, place) for word, sure in words)

    def condition(self, value: Value | None, place: Place) -> Condition | None:
        """A condition of an action; None where there is none."""
        if value is None or value == NONE:
            return None
        if not isinstance(value, Ref):
            return Condition("python", (), place, value)
        made = self.objects.place(value)
        here = made if made.file else place
        form = CONDITIONS.get(self.objects.kind(value))
        if form is None or self.objects.overrides(value, "evaluate"):
            predicate = self.objects.field(value, "predicate")
            bare = self.objects.kind(value) == _CONDITION and not self.objects.overrides(value, "evaluate")
            return Condition("python", (), here, predicate if bare and predicate is not None else value)
        return Condition(form.kind, self._arguments(value, form, here), here)

    def _substitution(self, value: Value, place: Place) -> Template:
        assert isinstance(value, Ref)
        made = self.objects.place(value)
        here = made if made.file else place
        kind = self.objects.kind(value)
        if self.objects.overrides(value, "perform"):
            return (Substitution("python", (), here, value),)
        if kind == "launch.substitutions.TextSubstitution":
            return self.template(self.objects.field(value, "text"), here)
        form = FORMS.get(kind)
        if form is None:
            return (self.objects.unknown(kind, here),)
        tables = tuple(self.pairs(self.objects.field(value, name), here) for name in _TABLES.get(kind, ()))
        found: Template = (Substitution(form.kind, self._arguments(value, form, here), here, None, tables),)
        field, otherwise = _CONDITIONAL.get(kind, ("", ""))
        test = self.objects.field(value, field) if field else None
        if test is None or test == NONE:
            return found
        holds: Template = (Substitution("holds", (), here, test),)
        return (Substitution("if", (holds, found, self.template(self.objects.field(value, otherwise), here)), here),)

    def _arguments(self, ref: Ref, form: _Form, place: Place) -> tuple[Template, ...]:
        found: list[Template] = []
        for name in form.fields:
            value = self.objects.field(ref, name.rstrip("?*@"))
            if name.endswith("*"):
                found += self._arguments_of(value, place)
            elif name.endswith("@"):
                found.append((Substitution("var", (self.template(value, place),), place),))
            elif value is not None or not name.endswith("?"):
                found.append(self._argument(value, place, form.kind))
        return tuple(found)

    def _argument(self, value: Value | None, place: Place, kind: str) -> Template:
        """One argument: switches, what is compared and the defaults of configurations may be numbers."""
        if kind in _TAKE_NUMBERS and isinstance(value, Const) and isinstance(value.value, (bool, int, float)):
            return (Const(str(value.value), value.origins),)
        return self.template(value, place)

    def _arguments_of(self, value: Value | None, place: Place) -> list[Template]:
        """A list of texts; a single text or substitution is a list of one."""
        if value is None:
            return []
        if self.objects.is_sequence(value):
            elements = self.objects.elements(value)
            if all(e.sure for e in elements):
                return [self.template(e.value, place) for e in elements]
            return [(self.objects.unknown("list of unknown length", place),)]
        return [self.template(value, place)]

    def _several(self, value: Value, place: Place) -> Template:
        """The concatenation of a list."""
        if isinstance(value, Tuple) or self.objects.is_sequence(value):
            found: list[Value | Substitution] = []
            for element in self.objects.elements(value):
                text = self.template(element.value, place)
                found += text if element.sure else self._perhaps(text, place)
            return tuple(found) or (Const(""),)
        return (self.objects.unknown("list", place),)

    def _as_str(self, value: Value, place: Place) -> Value:
        """A path object: its text."""
        text = self.objects.machine.call(_STR, (value,))
        if isinstance(text, (Const, Text, Unknown)) or self.objects.is_text(text):
            return text
        return self.objects.unknown("text", place)
