# SPDX-License-Identifier: Apache-2.0
"""Which pages are there, which headings do they have, and where do their links lead?

    pages()                              docs/*.md, README.md, CHANGELOG.md, …
    anchors("## What is *told*?\\n")      {"what-is-told"}
    links("see [it](findings.md#rw101)") [Link("findings.md", "rw101", …)]

Anchors are made as GitHub makes them, and as the site is told to, so one link serves both.
"""

from __future__ import annotations

import re
from pathlib import Path
from typing import Final, NamedTuple

__all__ = ["DOCS", "OUTSIDE", "ROOT", "Link", "anchors", "links", "pages", "prose", "slug"]

ROOT: Final = Path(__file__).parent.parent.parent
DOCS: Final = ROOT / "docs"

OUTSIDE: Final = {
    "CHANGELOG.md": "changelog.md",
    "CONTRIBUTING.md": "contributing.md",
    "examples/README.md": "example.md",
    "bench/README.md": "benches.md",
}
"""Pages that stand outside of docs/, and what they are called in the site."""

_FENCE: Final = re.compile(r"^(`{3,}|~{3,})[^\n]*\n.*?^\1[ \t]*$", re.MULTILINE | re.DOTALL)
_INDENTED: Final = re.compile(r"(?:(?<=\n\n)|\A)(?:(?: {4}|\t)[^\n]*\n+)+")
_CODE: Final = re.compile(r"(`+)(?!`).+?(?<!`)\1(?!`)", re.DOTALL)
_COMMENT: Final = re.compile(r"<!--.*?-->", re.DOTALL)
_HEADING: Final = re.compile(r"^#{1,6} +(.+?)[ #]*$", re.MULTILINE)
_ID: Final = re.compile(r"<\w+ [^>]*\bid=\"([^\"]+)\"")
_LINK: Final = re.compile(r"(?<=\]\()<?([^()\s>]+)>?(?=(?: \"[^\"]*\")?\))")
_LINK_TEXT: Final = re.compile(r"!?\[([^\]]*)\]\([^)]*\)")


class Link(NamedTuple):
    """A link of a page: the file (empty for the page itself), the anchor, and where the target stands in the text."""

    file: str
    anchor: str
    start: int
    end: int

    @property
    def external(self) -> bool:
        """Whether it leads out of the repository."""
        return bool(re.match(r"[a-z]+:", self.file))


def pages() -> list[Path]:
    """All pages of the repository that people read."""
    return [ROOT / "README.md", *(ROOT / name for name in OUTSIDE), *sorted(DOCS.rglob("*.md"))]


def prose(text: str, *, inline: bool = True) -> str:
    """The text with code (`inline` too) and comments blanked out; everything stays at its place."""
    for pattern in (_FENCE, _INDENTED, _COMMENT, *([_CODE] if inline else [])):
        text = pattern.sub(lambda found: re.sub(r"[^\n]", " ", found.group()), text)
    return text


def slug(heading: str) -> str:
    """What a heading is called in links: `What is *told*?` is `what-is-told`."""
    plain = _LINK_TEXT.sub(r"\1", heading).replace("`", "")
    plain = re.sub(r"(?<!\w)[*_]+|[*_]+(?!\w)", "", plain).lower()
    return re.sub(r"[^\w\- ]", "", plain).strip().replace(" ", "-")


def anchors(text: str) -> set[str]:
    """All that a link can name behind `#` in a page."""
    found: dict[str, int] = {}
    for heading in _HEADING.findall(prose(text, inline=False)):
        name = slug(heading)
        found[name] = found.get(name, -1) + 1
    numbered = {f"{name}-{n}" for name, last in found.items() for n in range(1, last + 1)}
    return {*found, *numbered, *_ID.findall(text)}


def links(text: str) -> list[Link]:
    """The links of a page, in their order, those in code left out."""
    found = []
    for match in _LINK.finditer(prose(text)):
        file, _, anchor = match.group(1).partition("#")
        found.append(Link(file, anchor, *match.span(1)))
    return found
