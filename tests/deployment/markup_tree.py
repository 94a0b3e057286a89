# SPDX-License-Identifier: Apache-2.0
"""A tree of actions as text to compare with: one line an action, its place first, what has its default left out.

<launch><node pkg="demo" exec="talker_$(var id)"/></launch>  ->  1: StartNode package=demo executable=talker_$(var id)
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import MISSING, fields
from textwrap import dedent, wrap

from rosward.deployment.markup.xml import read_xml
from rosward.deployment.markup.yaml_file import read_yaml
from rosward.deployment.tree import (
    Component,
    Condition,
    LaunchAction,
    Literal,
    NodeKind,
    ParameterFile,
    ParameterTable,
    Several,
    Substitution,
    Typed,
)
from rosward.domain.compound import Tuple
from rosward.domain.values import Const


def xml(text: str) -> str:
    """What an XML launch file says, and what is wrong with it."""
    description, findings = read_xml(dedent(text).strip(), "f.xml")
    return told(description.actions, [f"{f.code} {f.place.line}: {f.message}" for f in findings])


def yaml(text: str) -> str:
    """What a YAML launch file says, and what is wrong with it."""
    description, findings = read_yaml(dedent(text).strip(), "f.yaml")
    return told(description.actions, [f"{f.code} {f.place.line}: {f.message}" for f in findings])


def told(actions: tuple[LaunchAction, ...], findings: list[str]) -> str:
    """All lines."""
    return "\n".join([*(line for each in actions for line in lines(each, "")), *findings])


def expected(text: str) -> str:
    """Expected lines as they are written in a test."""
    return dedent(text).strip()


def lines(action: LaunchAction | Component, indent: str) -> Iterator[str]:
    """One action, and below it those inside."""
    words = [f"{indent}{action.place.line}: {type(action).__name__}"]
    below: list[LaunchAction | Component] = []
    given: list[str] = []
    inner = indent + "    "
    for field in fields(action):
        value = getattr(action, field.name)
        default = None if field.default is MISSING else field.default
        if field.name == "place" or value in (default, ()):
            continue
        if isinstance(value, tuple) and isinstance(value[0], (LaunchAction, Component)):
            below += value
        elif isinstance(value, tuple) and isinstance(value[0], (ParameterTable, ParameterFile)):
            given += [f"{inner}{word}" for each in value for word in parameters(each)]
        else:
            words.append(f"{field.name}={shown(value)}")
    wrapped = wrap(
        " ".join(words)[len(indent) :],
        130,
        initial_indent=indent,
        subsequent_indent=inner * 2,
        break_long_words=False,
        break_on_hyphens=False,
    )
    yield from (*wrapped, *given)
    for each in below:
        yield from lines(each, inner)


def parameters(source: ParameterTable | ParameterFile) -> list[str]:
    """One line for each parameter."""
    if isinstance(source, ParameterFile):
        return [shown(source)]
    return [f"{source.place.line}: {shown(name)} = {shown(data)}" for name, data in source.entries]


def shown(value: object) -> str:
    """A field."""
    match value:
        case Condition(kind, arguments):
            return f"{kind}[{' '.join(map(shown, arguments))}]"
        case ParameterTable(entries, place):
            return f"{place.line}:{{{', '.join(f'{shown(name)}: {shown(data)}' for name, data in entries)}}}"
        case ParameterFile(path, place, substitutions):
            return f"{place.line}:file[{shown(path)}]{' with substitutions' if substitutions else ''}"
        case Literal(data):
            return constant(data)
        case Typed(text, kind):
            return f"typed[{shown(text)}]" + (f" as {kind}" if kind else "")
        case Several(items):
            return f"several[{', '.join(map(shown, items))}]"
        case Substitution(kind, arguments):
            return f"$({' '.join([kind, *(f'<{shown(each)}>' for each in arguments)])})"
        case Const(value=text) if isinstance(text, str):
            return text
        case tuple() if all(isinstance(each, (Const, Substitution)) for each in value):
            return "".join(map(shown, value))
        case tuple():
            return f"[{', '.join(map(shown, value))}]"
        case _:
            return str(value.value) if isinstance(value, NodeKind) else repr(value)


def constant(value: object) -> str:
    """A value of Python."""
    if isinstance(value, Tuple):
        return f"[{', '.join(map(constant, value.items))}]"
    return repr(value.value) if isinstance(value, Const) else repr(value)
