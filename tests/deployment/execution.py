# SPDX-License-Identifier: Apache-2.0
"""Launch files as text or as records, and what they start as lines of text.

<launch><node pkg="demo" exec="talker" name="t"/></launch>    ->    demo/talker --ros-args -r __node:=t

A file is named as in the workspace: demo/launch/a.launch.xml lies in the share folder of the package demo. Behind a line stand its event
(@timer), and [maybe] where some execution does not start it. The content of a parameter file is written in braces.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

from rosward.deployment.execution.execution import Execution
from rosward.deployment.performer import Performer
from rosward.deployment.started import Started, StartKind
from rosward.deployment.tree import Description, LaunchAction, Substitution, Template
from rosward.domain.choice import options
from rosward.domain.compound import Partial, Tuple
from rosward.domain.text import parts_of, pattern
from rosward.domain.unknown import Cause, Reason
from rosward.domain.values import Const, Hole, Text, Unknown, Value
from rosward.findings import Finding
from rosward.location import Place
from rosward.ros.distro import Distro

HERE = Place("demo/launch/main.launch.py", 1)
UNKNOWN = Unknown((Reason(Cause.CALL, "gethostname()", HERE),), "str")

Function = Callable[[Performer, Mapping[str, Value]], Sequence[LaunchAction]]


def text(value: str) -> Template:
    return (Const(value),)


def var(name: str, *default: str) -> Template:
    return (Substitution("var", (text(name), *map(text, default)), HERE),)


def share(package: str, rest: str) -> Value:
    """A path in the share folder of a package."""
    return Text((Hole((Reason(Cause.SHARE, package, HERE),)), rest))


class Files:
    """Files by name; the first folder is the package, unless the file lies at the top."""

    def __init__(self, texts: Mapping[str, str]) -> None:
        self.texts = texts

    def find(self, path: Value) -> str | None:
        parts = parts_of(path)
        if len(parts) != 2 or not isinstance(parts[0], Hole) or not isinstance(parts[1], str):
            return None
        if len(parts[0].reasons) != 1:
            return None
        (reason,) = parts[0].reasons
        file = f"{reason.subject}{parts[1]}".lstrip("/")
        return file if reason.cause in (Cause.SHARE, Cause.SOURCES) and file in self.texts else None

    def text(self, file: str) -> str | None:
        return self.texts.get(file)

    def has_package(self, package: str) -> bool:
        return any(file.startswith(f"{package}/") for file in self.texts)

    def show(self, path: Value) -> str:
        parts = [p if isinstance(p, str) else self._hole(p) for p in parts_of(path)]
        return "".join(parts)

    def _hole(self, hole: Hole) -> str:
        shares = [r.subject for r in hole.reasons if r.cause is Cause.SHARE]
        return f"$(find-pkg-share {shares[0]})" if shares else "*"


class Code:
    """Python launch files: what they say is given as records, functions by name."""

    def __init__(self, files: Mapping[str, Sequence[LaunchAction]], functions: Mapping[str, Function]) -> None:
        self.files = files
        self.functions = functions
        self.findings: list[Finding] = []

    def read(self, file: str, performer: Performer) -> Description:  # noqa: ARG002
        return Description(tuple(self.files.get(file, ())), file)

    def actions(
        self,
        function: Value,
        args: Sequence[Value],  # noqa: ARG002
        kwargs: Mapping[str, Value],
        performer: Performer,
        *,
        context: bool,  # noqa: ARG002
    ) -> tuple[LaunchAction, ...]:
        if isinstance(function, Partial):
            function = function.function
        assert isinstance(function, Const)
        return tuple(self.functions[str(function.value)](performer, kwargs))

    def appended(self, function: Value, performer: Performer) -> Mapping[Value, tuple[LaunchAction, ...]]:  # noqa: ARG002
        return {}

    def perform(self, substitution: Value, performer: Performer) -> Value:  # noqa: ARG002
        return substitution

    def test(self, condition: Value, performer: Performer) -> Value:  # noqa: ARG002
        return condition

    def evaluate(self, expression: Value, modules: Sequence[str], performer: Performer) -> Value:  # noqa: ARG002
        return Const(f"<{pattern(expression)}>")


class Run:
    """One execution: `lines` of what it starts, `codes` of its findings."""

    def __init__(
        self,
        main: str | Sequence[LaunchAction],
        files: Mapping[str, str] | None = None,
        functions: Mapping[str, Function] | None = None,
        python: Mapping[str, Sequence[LaunchAction]] | None = None,
        distro: Distro = Distro.JAZZY,
        limit: int = 20_000,
        **arguments: str,
    ) -> None:
        texts = {**(files or {}), **dict.fromkeys(python or {}, "")}
        programs = dict(python or {})
        if isinstance(main, str):
            name = "demo/launch/main.launch.xml"
            texts[name] = main if main.lstrip().startswith("<launch") else f"<launch>{main}</launch>"
        else:
            name = "demo/launch/main.launch.py"
            texts[name], programs[name] = "", main
        given = {n: Const(v) for n, v in arguments.items()}
        execution = Execution(Files(texts), Code(programs, functions or {}), distro, given, limit)
        self.started = execution.run(name, share("demo", name.removeprefix("demo")))
        self.findings = execution.findings
        self.unread = execution.unread

    @property
    def lines(self) -> list[str]:
        return [line(each) for each in self.started]

    @property
    def codes(self) -> list[str]:
        return [f.code for f in self.findings]

    @property
    def messages(self) -> str:
        return "\n".join(f.message for f in self.findings)


def line(each: Started) -> str:
    """One started node or process as text."""
    program = each.plugin if each.kind is StartKind.COMPONENT else each.executable
    words = [shown(each.package), shown(program)] if each.package is not None else [shown(program)]
    head = "/".join(words)
    if each.kind is StartKind.COMPONENT:
        head += f" in {shown(each.container)}"
    files = each.configuration.files
    rest = [
        _content(files.get(w)) if w.startswith("/tmp/launch_params") else w
        for w in map(shown, each.configuration.words)
    ]
    event = [f"@{each.event}"] if each.event else []
    return " ".join([head, *rest, *event, *(["[maybe]"] if each.conditional else [])])


def _content(rows: Sequence[object] | None) -> str:
    if rows is None:
        return "{?}"
    return "{" + ", ".join(f"{r.node} {r.name}={plain(r.value)}" for r in rows) + "}"  # type: ignore[attr-defined]


def shown(value: Value | None) -> str:
    """A text as its pattern, alternatives side by side."""
    return "|".join(pattern(o) for o in options(value)) if value is not None else "-"


def plain(value: Value) -> str:
    """A value of any type."""
    if isinstance(value, Const):
        return repr(value.value)
    if isinstance(value, Tuple):
        return "[" + ", ".join(plain(i) for i in value.items) + "]"
    if isinstance(value, Text):
        return repr(pattern(value))
    return "|".join(plain(o) for o in options(value)) if len(options(value)) > 1 else "?"
