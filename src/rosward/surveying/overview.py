# SPDX-License-Identifier: Apache-2.0
"""What does `overview.html` show? Totals, findings by rule, and a table of repositories with state, cost and findings.

One file that loads nothing: its Content-Security-Policy allows its own style and nothing else, and it has no script.
"""

from __future__ import annotations

import base64
import hashlib
from collections import Counter
from importlib import resources
from typing import Final, final

from jinja2 import Environment, FunctionLoader, StrictUndefined
from markupsafe import Markup

from rosward._version import __version__
from rosward.outputs.whole_files import write_text
from rosward.records import NamedTuple
from rosward.rules import RULES
from rosward.safe import encodable, printable
from rosward.surveying.part import Part, Repository, Rows

__all__ = ["OVERVIEW", "Overview"]

OVERVIEW: Final = "overview.html"
_MOST: Final = 2_000
"""Rows of the table; those without a result are never left out before others."""
_STATES: Final = ("ok", "empty", "failed", "timeout")


class _Line(NamedTuple):
    """A row of the table."""

    good: bool
    name: str
    about: Repository
    nodes: int
    entities: int
    errors: int
    warnings: int
    cpu: float
    peak: int | None


class _Rule(NamedTuple):
    """How often a rule was reported, in how many repositories."""

    code: str
    title: str
    severity: str
    findings: int
    repositories: int


@final
class Overview:
    """The numbers while repositories are added."""

    def __init__(self) -> None:
        self._lines: list[_Line] = []
        self._states: Counter[str] = Counter()
        self._totals: Counter[str] = Counter()
        self._resolutions: Counter[str] = Counter()
        self._findings: Counter[str] = Counter()
        self._having: Counter[str] = Counter()

    def add(self, name: str, part: Part, rows: Rows) -> Repository:
        """Add a repository; returns what its row says."""
        about = Repository(*rows["repositories"][0])  # type: ignore[arg-type]  # the kinds of cells were checked
        codes = Counter(str(row[0]) for row in rows["findings"])
        severities = Counter(str(row[1]) for row in rows["findings"])
        own = [row for row in rows["entities"] if not row[6]]
        self._states[about.state] += 1
        self._resolutions.update(str(row[4]) for row in own)
        self._findings.update(codes)
        self._having.update(codes.keys())
        self._totals.update(
            files=about.files, lines=about.lines, nodes=len(rows["nodes"]), entities=len(own), findings=codes.total()
        )
        self._totals["complete"] += about.complete
        self._totals["cpu"] += round(part.cpu * 1_000)
        line = _Line(
            about.state in ("ok", "empty"),
            printable(name),
            about,
            len(rows["nodes"]),
            len(own),
            severities["error"],
            severities["warning"],
            part.cpu,
            part.peak,
        )
        self._lines.append(line)
        if len(self._lines) > 2 * _MOST:
            self._cut()
        return about

    def _cut(self) -> None:
        kept = sorted(self._lines, key=lambda line: line.good)[:_MOST]
        self._lines = sorted(kept, key=lambda line: line.name)

    def write(self, output: str, options: str) -> None:
        """Write the page. Raises OSError."""
        self._cut()
        environment = Environment(
            loader=FunctionLoader(_asset),
            autoescape=True,
            undefined=StrictUndefined,
            trim_blocks=True,
            lstrip_blocks=True,
            keep_trailing_newline=True,
        )
        style = _style()
        total = self._states.total()
        page = environment.get_template("overview.html.j2").render(
            style=Markup(style),
            sha256="sha256-" + base64.b64encode(hashlib.sha256(style.encode()).digest()).decode(),
            version=__version__,
            options=options,
            total=total,
            totals=self._totals,
            states=[(state, self._states[state]) for state in _STATES if self._states[state]],
            resolutions=sorted(self._resolutions.items(), key=lambda each: (-each[1], each[0])),
            rules=self._rules(),
            lines=self._lines,
            left_out=total - len(self._lines),
        )
        write_text(output, OVERVIEW, encodable(page))

    def _rules(self) -> list[_Rule]:
        found = [
            _Rule(code, RULES[code].title, RULES[code].severity.value, count, self._having[code])
            for code, count in self._findings.items()
            if code in RULES
        ]
        return sorted(found, key=lambda each: (-each.repositories, each.code))


def _style() -> str:
    colours = resources.files("rosward.outputs.report") / "assets" / "css" / "colours.css"
    return colours.read_text(encoding="utf-8") + _asset("overview.css")


def _asset(name: str) -> str:
    """The text of a file in `assets/`; the names are those that the template itself has."""
    return (resources.files("rosward.surveying") / "assets" / name).read_text(encoding="utf-8")
