# SPDX-License-Identifier: Apache-2.0
"""What was asked for, so that a result can be made again, and two results are compared knowing whether the same was asked?

    Asked(paths=(".",), launch=(LaunchAsked("bringup:robot.launch.py", (("sim", "true"),)),), options=(("tests", False), …))

Paths are relative to the root of the analysis, so that it is the same on every machine; what is elsewhere stands as it was given.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Final

from rosward.records import NamedTuple

__all__ = ["NOT_TOLD", "Asked", "LaunchAsked", "OptionValue", "asked_differently"]

OptionValue = bool | float | str | tuple[str, ...] | None
Pairs = tuple[tuple[str, str], ...]


class LaunchAsked(NamedTuple):
    """A launch file, as `PKG:FILE` or by its path, and the arguments for it alone."""

    file: str
    arguments: Pairs = ()


class Asked(NamedTuple):
    """The question. `arguments` and `environment` hold for every launch file; `models` is the version of the models, those of the user included."""

    paths: tuple[str, ...] = ()
    launch: tuple[LaunchAsked, ...] = ()
    all_launch: bool = False
    arguments: Pairs = ()
    nodes: tuple[str, ...] = ()
    parameter_files: tuple[str, ...] = ()
    environment: Pairs = ()
    options: tuple[tuple[str, OptionValue], ...] = ()
    models: str = ""


NOT_TOLD: Final = Asked()
"""Of networks that were put together by hand, and of files of version 1, which do not say it."""


def asked_differently(old: Asked, new: Asked) -> Iterator[str]:
    """What was asked otherwise, a line each; nothing where one side does not tell."""
    if NOT_TOLD in (old, new):
        return
    for name, before, after in _changed(_flat(old), _flat(new)):
        yield f"different options: {name} was {before}, is now {after}"


def _changed(old: dict[str, str], new: dict[str, str]) -> Iterator[tuple[str, str, str]]:
    for name in sorted({*old, *new}):
        before, after = old.get(name, "not set"), new.get(name, "not set")
        if before != after:
            yield name, before, after


def _flat(asked: Asked) -> dict[str, str]:
    flat = {
        "paths": _list(asked.paths),
        "launch files": _list(launch.file for launch in asked.launch) if not asked.all_launch else "all",
        "nodes": _list(asked.nodes),
        "parameter files": _list(asked.parameter_files),
        "models": asked.models,
        **{f"launch argument {name}": value for name, value in asked.arguments},
        **{f"environment variable {name}": value for name, value in asked.environment},
        **{f"option {name}": _option(value) for name, value in asked.options},
    }
    for launch in asked.launch:
        flat |= {f"launch argument {name} of {launch.file}": value for name, value in launch.arguments}
    return flat


def _option(value: OptionValue) -> str:
    if isinstance(value, bool):
        return "on" if value else "off"
    return _list(value) if isinstance(value, tuple) else "not set" if value is None else str(value)


def _list(names: Iterable[str]) -> str:
    return ", ".join(names) or "none"
