# SPDX-License-Identifier: Apache-2.0
"""Where does a link of the repository lead in the site?

    docs/trust.md:  [how](../bench/README.md)          benches.md
    README.md:      [changes](CHANGELOG.md)            changelog.md
    docs/models.md: [schema](../src/…/x.schema.json)   files/src/…/x.schema.json, a copy

Links are written for the repository, where people read them first. The site holds a page for each page of the repository, and a copy of
each other file that one links to.
"""

from __future__ import annotations

import os
import posixpath
from pathlib import Path
from typing import Final

from docsite.pages import DOCS, OUTSIDE, ROOT, links, pages

__all__ = ["for_the_site", "linked_files", "place_in_site"]

_COPIES: Final = "files"
_HOME: Final = {"README.md": "index.md"}


def place_in_site(path: Path) -> str:
    """Where a file of the repository stands in the site."""
    if path.is_relative_to(DOCS):
        return path.relative_to(DOCS).as_posix()
    name = path.relative_to(ROOT).as_posix()
    return OUTSIDE.get(name) or _HOME.get(name) or f"{_COPIES}/{name}"


def linked_files() -> list[Path]:
    """The files, other than pages and what docs/ holds, that a page of the site links to."""
    found: set[Path] = set()
    for page in pages():
        for link in links(page.read_text(encoding="utf-8")):
            path = _target(page, link.file)
            if (
                link.file
                and not link.external
                and path.is_file()
                and path not in pages()
                and not path.is_relative_to(DOCS)
            ):
                found.add(path)
    return sorted(found)


def for_the_site(text: str, page: Path) -> str:
    """A page of the repository with its links as the site needs them."""
    here = posixpath.dirname(place_in_site(page))
    for link in reversed(links(text)):
        if link.file and not link.external:
            place = posixpath.relpath(place_in_site(_target(page, link.file)), here or ".")
            text = text[: link.start] + place + (f"#{link.anchor}" if link.anchor else "") + text[link.end :]
    return text


def _target(page: Path, file: str) -> Path:
    """What a link names; a folder is its README.md."""
    path = Path(os.path.normpath(page.parent / file))
    return path / "README.md" if path.is_dir() else path
