# SPDX-License-Identifier: Apache-2.0
"""What is started, in plain words: abstract values become text and the place that they come from.

Const('left', from launch argument side)    Shown('left', 'argument side')
Text('/robot_', hole)                       Shown('/robot_*', 'environment variable: ROBOT (x.launch.py:4)')
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from rosward.domain.choice import options, reasons_of
from rosward.domain.compound import Tuple
from rosward.domain.text import origins_of, parts_of
from rosward.domain.unknown import Cause, Reason
from rosward.domain.values import Const, Value
from rosward.network.launch_tree import GivenParameter, LaunchEntry, Shown

if TYPE_CHECKING:
    from rosward.deployment.launched import Launched
    from rosward.deployment.started import Started

_FOLDERS = {Cause.SHARE: "find-pkg-share", Cause.PREFIX: "find-pkg-prefix"}


def shown(value: Value) -> Shown:
    """A value as a person reads it."""
    several = options(value)
    if len(several) > 1:
        each = [shown(o) for o in several]
        return Shown(" | ".join(e.text for e in each), "; ".join(dict.fromkeys(e.source for e in each if e.source)))
    return Shown(_text(value), _source(value))


def _text(value: Value) -> str:
    if isinstance(value, Tuple):
        return f"[{', '.join(_text(v) for v in value.items)}]"
    if isinstance(value, Const) and not isinstance(value.value, str):
        return str(value.value).lower() if isinstance(value.value, bool) else str(value.value)
    return "".join(p if isinstance(p, str) else _folder(p.reasons) for p in parts_of(value))


def _folder(reasons: tuple[Reason, ...]) -> str:
    for reason in reasons:
        word = _FOLDERS.get(reason.cause)
        if word is not None:
            return f"$({word} {reason.subject})"
    return "*"


def _source(value: Value) -> str:
    origins = [
        f"{o.kind.removeprefix('launch ')} {o.name}{'' if o.given else ' (default)'}" for o in sorted(origins_of(value))
    ]
    reasons = [str(r) for r in reasons_of(value) if r.cause not in _FOLDERS]
    return "; ".join((*origins, *reasons))


def entry(started: Started, launched: Launched | None) -> LaunchEntry:
    """The plain form of what is started; `launched` is the program behind it, where one was looked for."""
    configuration = started.configuration
    return LaunchEntry(
        kind=started.kind.value,
        package=_maybe(started.package),
        executable=_maybe(started.executable),
        plugin=_maybe(started.plugin),
        container=_maybe(started.container),
        name=_maybe(started.name),
        namespace=_maybe(started.namespace),
        remaps=tuple((shown(a), shown(b)) for a, b in started.remaps),
        parameters=tuple(GivenParameter(s.kind, s.name, shown(s.value), s.scope, s.place) for s in started.settings),
        words=tuple(shown(w) for w in (started.command or configuration.words)),
        environment=tuple((n, shown(v)) for n, v in sorted(configuration.environment.items()) if v is not None),
        place=started.place,
        trail=started.trail,
        program=_program(launched),
        conditional=started.conditional,
        why=started.why,
        event=started.event,
    )


def _maybe(value: Value | None) -> Shown | None:
    return None if value is None else shown(value)


def _program(launched: Launched | None) -> str:
    if launched is None:
        return ""
    if launched.entry is not None:
        return launched.entry.file
    if launched.program is not None:
        return f"declared: {launched.program.source}"
    return f"unknown: {launched.unknown}"
