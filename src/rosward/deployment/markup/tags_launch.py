# SPDX-License-Identifier: Apache-2.0
"""Which action is a tag of the package launch that has no actions inside?

<arg name="id" default="1"/>                      ->  Declare(name=…, default=…)
<append_env name="PATH" value="/opt" prepend="true"/>  ->  Environ(how='prepend', …)
<executable cmd="echo $(var id)"/>                ->  StartProcess(command=((Const('echo'),), (Substitution('var', …),)))
"""

from __future__ import annotations

import shlex
from collections.abc import Callable
from types import MappingProxyType
from typing import Final

from rosward.deployment.markup.element import Tag
from rosward.deployment.markup.substitutions import unescaped
from rosward.deployment.tree import (
    Condition,
    Declare,
    Environ,
    Group,
    Include,
    Inert,
    LaunchAction,
    ScopeChange,
    SetConfiguration,
    StartProcess,
    Substitution,
    Template,
)
from rosward.domain.values import Const, Value

Reader = Callable[[Tag], LaunchAction]

_TEXTS_OF_A_PROCESS: Final = ("cwd", "launch-prefix", "output", "respawn")
_NUMBERS_OF_A_PROCESS: Final = ("respawn_delay", "sigkill_timeout", "sigterm_timeout")


def command_words(element: Tag, text: str) -> tuple[Template, ...]:
    """The words of a command line; a substitution within a word is a part of it, whatever blanks its text will have.

    Text of blanks only ends a word, even if none was begun: an empty one then, as in launch.
    """
    words: list[Template] = []
    word: list[Value | Substitution] = []
    for piece in element.parsed(text):
        if not isinstance(piece, Const) or not isinstance(piece.value, str):
            word.append(piece)
            continue
        try:
            tokens = shlex.split(piece.value)
        except ValueError as error:
            element.refuse(f"{piece.value[:100]!r} is not a valid command line: {error}.")
            tokens = piece.value.split()
        if not tokens:
            words.append(tuple(word))
            word = []
            continue
        if piece.value[0].isspace() and word:
            words.append(tuple(word))
            word = []
        for number, token in enumerate(tokens):
            if number:
                words.append(tuple(word))
                word = []
            word.append(Const(token))
        if piece.value[-1].isspace():
            words.append(tuple(word))
            word = []
    return (*words, tuple(word)) if word else tuple(words)


def process_attributes(element: Tag) -> tuple[LaunchAction, ...]:
    """Read what any process can have; what it does on exit is returned."""
    element.ignore(*_TEXTS_OF_A_PROCESS)
    element.flag("shell")
    element.flag("emulate_tty")
    element.number("respawn_max_retries", int)
    for name in _NUMBERS_OF_A_PROCESS:
        element.seconds(name)
    on_exit = element.text("on_exit")
    if on_exit is None:
        return ()
    if on_exit != "shutdown":
        element.refuse(f"'on_exit' of <{element.tag}> is {on_exit!r}; launch supports only 'shutdown'.")
    return (Inert(place=element.place, kind="shutdown"),)


def _executable(element: Tag) -> LaunchAction:
    text = element.text("cmd")
    if text is None:
        element.required("cmd")
    element.ignore("name")
    return StartProcess(
        place=element.place,
        condition=element.condition(),
        command=() if text is None else command_words(element, text),
        shell=bool(element.flag("shell")),
        environment=element.pairs("env", "name", "value"),
        on_exit=process_attributes(element),
    )


def _arg(element: Tag) -> LaunchAction:
    choices = [(Const(each.name("value")),) for each in element.elements("choice")]
    description = element.text("description")
    return Declare(
        place=element.place,
        condition=element.condition(),
        name=(Const(element.name("name")),),
        default=element.template("default"),
        choices=tuple(choices) or None,
        description=() if description is None else (Const(unescaped(description)),),
    )


def _let(element: Tag) -> LaunchAction:
    name, value = element.required("name"), element.required("value")
    return SetConfiguration(place=element.place, condition=element.condition(), name=name, value=value)


def _unset(element: Tag) -> LaunchAction:
    return SetConfiguration(
        place=element.place, condition=element.condition(), name=element.required("name"), value=None
    )


def _reset(element: Tag) -> LaunchAction:
    kept = element.pairs("keep", "name", "value")
    return ScopeChange(
        place=element.place, condition=element.condition(), what="configurations", how="reset", configurations=kept
    )


def _reset_env(element: Tag) -> LaunchAction:
    return ScopeChange(place=element.place, condition=element.condition(), what="environment", how="reset")


def _include(element: Tag) -> LaunchAction:
    return Include(
        place=element.place,
        condition=element.condition(),
        path=element.required("file"),
        arguments=element.pairs("arg", "name", "value") + element.pairs("let", "name", "value"),
    )


def _set_env(element: Tag) -> LaunchAction:
    name, value = element.required("name"), element.required("value")
    return Environ(place=element.place, condition=element.condition(), how="set", name=name, value=value)


def _unset_env(element: Tag) -> LaunchAction:
    return Environ(place=element.place, condition=element.condition(), how="unset", name=element.required("name"))


def _append_env(element: Tag) -> LaunchAction:
    name, value = element.required("name"), element.required("value")
    separator = element.template("separator") or (Const(":"),)
    prepend, condition, place = element.switch("prepend"), element.condition(), element.place
    if not isinstance(prepend, tuple):
        how = "prepend" if prepend else "append"
        return Environ(place=place, condition=condition, how=how, name=name, value=value, separator=separator)
    test = (prepend,)
    ways = tuple(
        Environ(
            place=place, condition=Condition(kind, test, place), how=how, name=name, value=value, separator=separator
        )
        for kind, how in (("if", "prepend"), ("unless", "append"))
    )
    return Group(place=place, condition=condition, actions=ways, scoped=False)


def _inert(element: Tag) -> LaunchAction:
    return Inert(place=element.place, condition=element.condition(), kind=element.tag)


def _log(element: Tag) -> LaunchAction:
    element.required("message")
    element.ignore("level")
    return _inert(element)


def _log_at_level(element: Tag) -> LaunchAction:
    element.required("message")
    return _inert(element)


def _shutdown(element: Tag) -> LaunchAction:
    element.ignore("reason")
    return _inert(element)


READERS: Final = MappingProxyType[str, Reader](
    {
        "executable": _executable,
        "arg": _arg,
        "let": _let,
        "unset": _unset,
        "reset": _reset,
        "reset_env": _reset_env,
        "include": _include,
        "set_env": _set_env,
        "unset_env": _unset_env,
        "append_env": _append_env,
        "log": _log,
        "log_debug": _log_at_level,
        "log_info": _log_at_level,
        "log_warning": _log_at_level,
        "log_error": _log_at_level,
        "shutdown": _shutdown,
    }
)
