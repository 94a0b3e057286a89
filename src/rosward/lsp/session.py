# SPDX-License-Identifier: Apache-2.0
"""What is analysed again after a change, and what is known already? The part of the work that runs in a worker, without its protocol.

    session = Session(settings)
    session.renew({}, None, tell)                         all: a view of the sources, then one of each launched system
    session.renew({"/ws/talker.py": b"…"}, {"/ws/talker.py"}, tell)      only what reads talker.py

A view is told as soon as it is there. A system is analysed again only if it looked at a file that has changed; what a process did is remembered
where all that it asked has the same answers (`engine/sources/remembered.py`).
"""

from __future__ import annotations

import gc
import os
from collections.abc import Callable, Collection, Hashable, Mapping
from functools import partial
from typing import Any, Final, NamedTuple, final

from rosward.analysis.deep_stack import with_deep_stack
from rosward.analysis.read import NothingToReadError, Progress, SourcesRead, read_sources
from rosward.deployment.request import LaunchRequest, Request, UnknownRequestError
from rosward.engine.sources.remembered import PROGRAM, Memory, remembering
from rosward.findings import Finding
from rosward.lsp.records import LAUNCH, SOURCES, View
from rosward.lsp.views import view_of
from rosward.pipeline import of_read
from rosward.ros.distro import DEFAULT_DISTRO, Distro
from rosward.source.overlay import overlaid
from rosward.source.text import place_name
from rosward.suppression.judge import SourceTexts, Wishes, review

__all__ = ["Session", "Settings"]

_CPP: Final = (".cpp", ".cc", ".cxx", ".c", ".h", ".hpp", ".hh", ".hxx", ".ipp")
_TEXTS: Final = (".py", ".xml", ".yaml", ".yml", *_CPP)
_STRUCTURE: Final = frozenset(
    {"package.xml", "setup.py", "setup.cfg", "pyproject.toml", "CMakeLists.txt", "COLCON_IGNORE", "rosward.toml"}
)
"""Files that say what there is: after a change of one, anything may be another."""


_COLLECTED: Final = 25
"""After so many analyses, what is of no use any more is given back."""


class Settings(NamedTuple):
    """How a workspace is analysed: as its rosward.toml says."""

    root: str
    distro: str = DEFAULT_DISTRO
    models: tuple[str, ...] = ()
    underlays: tuple[str, ...] = ()
    options: Mapping[str, Any] = {}
    """More arguments of `read_sources`, by name."""
    launches: tuple[LaunchRequest, ...] = ()
    """The systems; every launch file by itself where there is none."""
    wishes: Wishes = Wishes()
    assumed: bool = True


class _Known(NamedTuple):
    """What a view looked at, and which processes it used."""

    touched: frozenset[str]
    used: frozenset[Hashable]


@final
class Session:
    """One workspace, analysed again and again."""

    def __init__(self, settings: Settings, wanted: Collection[str] = (SOURCES, LAUNCH)) -> None:
        self.memory = Memory()
        self._settings = settings
        self._wanted = frozenset(wanted)
        self._known: dict[str, _Known] = {}
        self._first = True
        self._renewed = 0
        self._shown: tuple[frozenset[str], frozenset[str]] = (frozenset(), frozenset())
        """The files with a text of an editor: before, and now."""

    def renew(
        self,
        texts: Mapping[str, bytes],
        changed: Collection[str] | None,
        tell: Callable[[View], None],
        progress: Progress,
    ) -> tuple[str, ...]:
        """Tell each view that may be another after files (whole paths) have changed; all of them for None.

        Returns the names of all views that there are. `progress` may raise to end the work: what is known by then stays known.
        """
        self._shown = self._shown[1], frozenset(texts)
        with overlaid(texts), remembering(self.memory):
            names = with_deep_stack(lambda: self._renew(changed, tell, progress))
        self._renewed += 1
        if self._renewed % _COLLECTED == 0:  # an analysis makes circles, and turns the collector off
            gc.collect()
        return names

    def _renew(
        self, changed: Collection[str] | None, tell: Callable[[View], None], progress: Progress
    ) -> tuple[str, ...]:
        self.memory.sources_changed()
        settings = self._settings
        try:
            read = read_sources(
                [settings.root],
                Distro(settings.distro),
                settings.models,
                settings.underlays,
                progress=progress,
                **settings.options,
            )
        except NothingToReadError:
            self._known.clear()
            return ()
        requests = self._requests(read)
        self._known = {name: known for name, known in self._known.items() if name in requests}
        names = self._names(changed, read)
        for name in sorted(requests, key=lambda name: (name != "", name not in (names or ()), name)):
            if not self._is_known(name, names):
                self._view(name, requests[name], read, tell, progress)
        self._forget()
        return tuple(requests)

    def _view(
        self,
        name: str,
        request: Request,
        read: SourcesRead,
        tell: Callable[[View], None],
        progress: Progress,
    ) -> None:
        self._known.pop(name, None)
        self.memory.begin()
        try:
            result = of_read(read, request, progress, assumed=self._settings.assumed)
            found: tuple[Finding, ...] = result.findings
            sources = SourceTexts(result.root, result.files)
            shown = review(found, sources, self._settings.wishes, unused=not request.deploys).findings
            view = view_of(name, result, shown, partial(_share, read))
        except UnknownRequestError as error:
            view = View(name, LAUNCH, (), (), (), ())
            progress(f"{name}: {error}", 0, 0)
        # a launch file whose execution failed has touched itself
        touched = self.memory.touched | set(view.files) | ({name} if name else set())
        self._known[name] = _Known(frozenset(touched), frozenset(self.memory.used))
        tell(view)

    def _requests(self, read: SourcesRead) -> dict[str, Request]:
        """What is started, by the name of the view; '' are the sources themselves."""
        found: dict[str, Request] = {"": Request()} if SOURCES in self._wanted else {}
        if LAUNCH in self._wanted:
            launches = self._settings.launches or tuple(
                LaunchRequest(file.relative) for file in read.workspace.launch_files
            )
            for launch in launches:
                given = ",".join(f"{name}:={value}" for name, value in launch.arguments)
                found[f"{launch},{given}" if given else str(launch)] = Request((launch,))
        return found

    def _names(self, changed: Collection[str] | None, read: SourcesRead) -> frozenset[str] | None:
        """The files that changed, as places name them; None where anything may be another."""
        first, self._first = self._first, False
        if changed is None or first:
            return None
        names: set[str] = set()
        touched = frozenset[str]().union(*(known.touched for known in self._known.values()))
        for path in changed:
            name = place_name(os.path.abspath(path), read.workspace.root)  # noqa: PTH100
            if name.rpartition("/")[2] in _STRUCTURE or not name.endswith(_TEXTS):
                return None
            typed = all(path in shown for shown in self._shown) and not name.endswith(".xml")
            if not (typed or name.endswith(_CPP) or _meets(name, touched)):
                return None  # it may be new, and somebody looked for it and did not find it
            names.add(name)
        return frozenset(names)

    def _is_known(self, name: str, changed: frozenset[str] | None) -> bool:
        known = self._known.get(name)
        if known is None or changed is None or (name == "" and changed):
            return False
        return not any(
            PROGRAM in known.touched if file.endswith(_CPP) else _meets(file, known.touched) for file in changed
        )

    def _forget(self) -> None:
        self.memory.keep_only({key for known in self._known.values() for key in known.used})


def _share(read: SourcesRead, package: str, relative: str) -> str:
    found = read.sources.files.share(package, relative)
    return "" if found is None else place_name(found.path, read.workspace.root)


def _meets(file: str, touched: Collection[str]) -> bool:
    return file in touched or f"*/{file.rpartition('/')[2]}" in touched
