# SPDX-License-Identifier: Apache-2.0
"""From the arguments of an analysis to the record of what was asked: paths relative to its root, launch arguments by name, the models by digest."""

from __future__ import annotations

import hashlib
import os
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Final

from rosward.deployment.request import NodeRequest, Request
from rosward.findings import Finding
from rosward.network.asked import Asked, LaunchAsked, OptionValue
from rosward.source import disk, limits
from rosward.source.exclude import Exclusion
from rosward.source.kept import kept
from rosward.source.text import place_name, read_bytes, readable_path

__all__ = ["asked_of"]

_OWN: Final = Path(__file__).parent.parent / "models"
_FOLDERS: Final = ("nodes", "stubs", "marks")
_SUFFIXES: Final = (".pyi", ".yaml")
_MOST_FILES: Final = 10_000
_DIGITS: Final = 16

_OWN_VERSION: Final[list[str]] = []
"""The digest of rosward's own models, once it was asked for: they do not change."""


def asked_of(
    request: Request,
    root: Path,
    paths: Iterable[str | os.PathLike[str]],
    models: Sequence[str | os.PathLike[str]],
    underlays: Iterable[str | os.PathLike[str]],
    exclude: Iterable[str | Exclusion],
    environment: Mapping[str, str],
    **options: OptionValue,
) -> Asked:
    """The question of an analysis whose files lie below `root`; `options` are the others, by their names."""
    given: dict[str, OptionValue] = {
        **options,
        "exclude": tuple(_pattern(each, root) for each in exclude),
        "models": tuple(_place(each, root) for each in models),
        "underlays": tuple(_place(each, root) for each in underlays),
    }
    return Asked(
        paths=tuple(sorted(_place(path, root) for path in paths)) or (_place(".", root),),
        launch=tuple(
            LaunchAsked(
                str(each) if each.package else _place(each.file, root, there=disk.exists(each.file)),
                tuple(sorted(each.arguments)),
            )
            for each in request.launches
        ),
        all_launch=request.all_launch,
        arguments=tuple(sorted(request.arguments)),
        nodes=tuple(_node(each) for each in request.nodes),
        parameter_files=tuple(_place(each, root) for each in request.params),
        environment=tuple(sorted(environment.items())),
        options=tuple(sorted(given.items())),
        models=_version(models),
    )


def _place(path: str | os.PathLike[str], root: Path, *, there: bool = True) -> str:
    """A path as the record has it: what is given as an absolute one, and lies elsewhere, or is not there, as it is given."""
    text = os.fspath(path)
    absolute = os.path.abspath(text)  # noqa: PTH100
    inside = absolute == str(root) or absolute.startswith(f"{str(root).rstrip(os.sep)}{os.sep}")
    return place_name(absolute, root) if there and (inside or not os.path.isabs(text)) else readable_path(text)  # noqa: PTH117


def _pattern(each: str | Exclusion, root: Path) -> str:
    return each if isinstance(each, str) else f"{_place(each.base, root)}: {each.pattern}"


def _node(node: NodeRequest) -> str:
    return f"{node.package}/{node.executable}{f':{node.name}' if node.name else ''}"


def _version(folders: Iterable[str | os.PathLike[str]]) -> str:
    """What tells one state of the models from another: rosward's own, then those of the user, by what is in their files."""
    return "+".join([_own_version(), *(_digest([Path(folder)]) for folder in folders)])


def _own_version() -> str:
    if not _OWN_VERSION:
        known = kept("digest", lambda: _digest_of_own().encode())
        _OWN_VERSION.append(_digest_of_own() if known is None else known.decode())
    return _OWN_VERSION[0]


def _digest_of_own() -> str:
    return _digest([_OWN / each for each in _FOLDERS])


def _digest(folders: Iterable[Path]) -> str:
    found = hashlib.sha256()
    for folder in folders:
        for name in _files(folder):
            content = read_bytes(folder / name, name, limits.MODELS_FILE)
            told = b"" if isinstance(content, Finding) else content
            found.update(f"{name}\0{len(told)}\0".encode("utf-8", "surrogateescape") + told)
    return found.hexdigest()[:_DIGITS]


def _files(folder: Path) -> list[str]:
    """The descriptions in a folder, of which rosward reads these alone; of a folder that is no such, not the whole tree."""
    found: list[str] = []
    for above, inner, names in disk.walk(folder):
        inner.sort()
        inside = os.path.relpath(above, folder)
        found += (os.path.normpath(os.path.join(inside, n)) for n in sorted(names) if n.endswith(_SUFFIXES))  # noqa: PTH118
        if len(found) > _MOST_FILES:
            break
    return [name.replace(os.sep, "/") for name in found[:_MOST_FILES]]
