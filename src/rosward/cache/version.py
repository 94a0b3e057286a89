# SPDX-License-Identifier: Apache-2.0
"""Which rosward is this, and on what does it run? A result of another one says nothing of what this one would find."""

from __future__ import annotations

import os
import sys

from rosward.source.kept import program_key

TYPE_CHECKING = False  # not from typing: this decides what else is loaded
if TYPE_CHECKING:
    from collections.abc import Iterator
    from typing import Final

__all__ = ["version_key"]

_LIBRARIES: Final = frozenset(
    {"catkin_pkg", "pyyaml", "tomli", "tree_sitter", "tree_sitter_cpp", "jinja2", "graphviz_pure", "rich"}
)
"""The projects on which results depend, or what is written of them, as the installer lists them: name and version."""


def version_key() -> str:
    """What tells this program, its libraries and its Python from others."""
    return "\0".join((program_key(), sys.platform, *_libraries()))


def _libraries() -> Iterator[str]:
    for folder in dict.fromkeys(sys.path):
        if os.path.basename(folder) in {"site-packages", "dist-packages"}:  # noqa: PTH119
            yield from sorted(name for name in _names(folder) if _is_listed(name))


def _is_listed(name: str) -> bool:
    """Whether an entry is the list of files of such a project: `PyYAML-6.0.dist-info`, `tree.sitter-0.25-py3.11.egg-info`."""
    return name.endswith("-info") and name.lower().partition("-")[0].replace(".", "_") in _LIBRARIES


def _names(folder: str) -> list[str]:
    try:
        return os.listdir(folder)  # noqa: PTH208
    except OSError:
        return []
