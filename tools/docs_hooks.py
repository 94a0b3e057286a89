# SPDX-License-Identifier: Apache-2.0
"""What the site has beyond the pages of docs/: MkDocs calls these functions while it builds.

    mkdocs build --strict

Pages that stand elsewhere in the repository, references that are generated from the code, the gallery, and links that fit them.
"""

from __future__ import annotations

import json
import re
from importlib import resources
from pathlib import Path
from typing import Final

from docsite.command_reference import command_reference
from docsite.gallery import exhibits_of, outputs_of, shown
from docsite.pages import DOCS, OUTSIDE, ROOT
from docsite.repository_links import for_the_site, linked_files, place_in_site
from docsite.schema_reference import schema_reference
from mkdocs.config.defaults import MkDocsConfig
from mkdocs.structure.files import File, Files
from mkdocs.structure.pages import Page

from rosward.cli.command_line import command_line

_GENERATED: Final = re.compile(r"^<!-- generated: ([\w.-]+) -->$", re.MULTILINE)
_GALLERY: Final = DOCS / "gallery.md"
_WIDE: Final = {"index.md": ["navigation", "toc"], "comparison.md": ["toc"]}
"""Pages that need the room of the columns beside them."""


def on_files(files: Files, *, config: MkDocsConfig) -> Files:
    """Add the pages from elsewhere, copies of linked files, and what is in the gallery."""
    for name in OUTSIDE:
        files.append(File.generated(config, place_in_site(ROOT / name), abs_src_path=str(ROOT / name)))
    for path in linked_files():
        files.append(File.generated(config, place_in_site(path), abs_src_path=str(path)))
    for exhibit in exhibits_of(_GALLERY.read_text(encoding="utf-8")):
        for place, text in outputs_of(exhibit).items():
            files.append(File.generated(config, place, content=text))
    return files


def on_page_markdown(markdown: str, *, page: Page, config: MkDocsConfig, files: Files) -> str:  # noqa: ARG001
    """Links for the site, generated parts in the place of their marks, the gallery's pictures."""
    source = _source(page.file.src_uri)
    page.meta["hide"] = _WIDE.get(page.file.src_uri, [])
    text = _GENERATED.sub(lambda mark: _generated(mark[1]), for_the_site(markdown, source))
    return shown(text) if source == _GALLERY else text


def _source(place: str) -> Path:
    """The file of the repository behind a page of the site."""
    return next((ROOT / name for name, there in OUTSIDE.items() if there == place), DOCS / place)


def _generated(name: str) -> str:
    if name == "command-line":
        return command_reference(command_line())
    schemas = resources.files("rosward.outputs") / "schemas"
    return schema_reference(json.loads((schemas / name).read_text(encoding="utf-8")))
