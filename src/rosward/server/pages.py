# SPDX-License-Identifier: Apache-2.0
"""How do the pages look? Templates and what stands beside them; text of others is always escaped.

Pages().start(…)    ->    HTML
ASSETS["page.css"]  ->    'text/css'
"""

from __future__ import annotations

import html
import json
import re
from importlib import resources
from typing import Final, final

from jinja2 import Environment, FunctionLoader, StrictUndefined
from markupsafe import Markup

from rosward._version import __version__
from rosward.ros.distro import DISTROS
from rosward.safe import printable
from rosward.server.examples import Example
from rosward.server.limits import Limits
from rosward.server.places import NOT_SOURCE, NOT_SOURCE_FOLDERS
from rosward.server.results import StoredResult
from rosward.server.settings import ENCLAVES, Settings
from rosward.server.shown import in_short

__all__ = ["ASSETS", "Pages", "asset"]

ASSETS: Final = {
    "page.css": "text/css",
    "colours.css": "text/css",
    "common.js": "text/javascript",
    "drop.js": "text/javascript",
    "options.js": "text/javascript",
    "start.js": "text/javascript",
    "result.js": "text/javascript",
    "icon.svg": "image/svg+xml",
}
_NOTHING: Final[dict[str, object]] = {
    "changed": 0,
    "enclaves": [],
    "files": [],
    "launch_files": [],
    "left_out": [],
    "left_out_count": 0,
}
_CODE: Final = re.compile(r"`([^`]+)`")
_EMPHASIS: Final = re.compile(r"\*([^*]+)\*")


def asset(name: str) -> bytes:
    """A file that the pages load: one of `ASSETS`. The colours are those of the report."""
    if name == "colours.css":
        return (resources.files("rosward.outputs.report") / "assets" / "css" / name).read_bytes()
    return (resources.files("rosward.server") / "assets" / name).read_bytes()


@final
class Pages:
    """The templates, read once."""

    def __init__(self, limits: Limits) -> None:
        self._environment = Environment(
            loader=FunctionLoader(_template),
            autoescape=True,
            finalize=_harmless,
            undefined=StrictUndefined,
            trim_blocks=True,
            lstrip_blocks=True,
        )
        self._environment.filters["prose"] = _prose
        self._limits = limits
        self._common = {"version": __version__, "distros": DISTROS, "enclaves": ENCLAVES, "defaults": Settings()}

    def start(self, examples: tuple[Example, ...], *, names_paths: bool) -> str:
        """The page on which something is chosen. `names_paths`: workspaces of this machine may be named."""
        rules = {
            "endings": sorted(NOT_SOURCE),
            "folders": sorted(NOT_SOURCE_FOLDERS),
            "file": self._limits.file,
            "upload": self._limits.upload,
            "files": self._limits.files,
        }
        return self._render("start.html.j2", examples=examples, names_paths=names_paths, rules=_in_script(rules))

    def result(self, result: StoredResult, example: Example | None, changes: str, *, watched: bool) -> str:
        """The page of one result, whatever its state."""
        summary = {**_NOTHING, **result.summary}
        facts = {**in_short(result, watched=watched), "settings_document": result.settings.document()}
        return self._render(
            "result.html.j2",
            result=result,
            summary=summary,
            example=example,
            changes=changes,
            watched=watched,
            facts=_in_script(facts),
            launch_files=_in_script(summary.get("launch_files", [])),
        )

    def missing(self) -> str:
        """What is said of a result that is not there."""
        return self._render("missing.html.j2")

    def _render(self, name: str, **values: object) -> str:
        return self._environment.get_template(name).render(**self._common, **values)


def _template(name: str) -> str:
    return (resources.files("rosward.server") / "templates" / name).read_text(encoding="utf-8")


def _harmless(value: object) -> object:
    """What is written for an expression: text without control characters and direction marks."""
    if isinstance(value, Markup):
        return value
    return "" if value is None else "\n".join(printable(line) for line in str(value).split("\n"))


def _prose(text: str) -> Markup:
    """Our own paragraphs: `code` and *emphasis*."""
    escaped = html.escape(text, quote=False)
    return Markup(_EMPHASIS.sub(r"<em>\1</em>", _CODE.sub(r"<code>\1</code>", escaped)))


def _in_script(document: object) -> Markup:
    """JSON that a `<script>` can hold: no tag and no comment can begin or end in it."""
    text = json.dumps(document)
    return Markup(text.replace("<", "\\u003c").replace(">", "\\u003e").replace("&", "\\u0026"))
