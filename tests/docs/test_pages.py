# SPDX-License-Identifier: Apache-2.0
"""The pages hold together: each has its place in the site, each link leads somewhere, and nothing speaks of one machine."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any

import pytest
import yaml
from docsite.command_reference import command_reference, commands_of
from docsite.pages import DOCS, OUTSIDE, ROOT, anchors, links, pages, prose, slug
from docsite.repository_links import for_the_site, linked_files, place_in_site

from rosward.cli.command_line import command_line

PAGES = pages()
COMMENT = "<!-- SPDX-License-Identifier: Apache-2.0 -->\n"
LICENSED = {".css", ".cfg", ".js", ".mjs", ".md", ".py", ".pyi", ".sh", ".svg", ".toml", ".ts", ".xml", ".yaml", ".yml"}
MACHINE = re.compile(r"(?<![\w.$~/<-])/(?:home|work|root|Users)/(?!me\b)\w+")
"""A path of somebody's machine; `/home/me` is nobody's."""


def text_of(page: Path) -> str:
    return page.read_text(encoding="utf-8")


@cache
def anchors_of(page: Path) -> set[str]:
    return anchors(text_of(page))


@cache
def commands() -> set[str]:
    """The anchors that the reference of the command line has."""
    return {name.replace(" ", "-") for name in commands_of(command_line())}


@cache
def files_of_the_site() -> set[str]:
    return {place_in_site(p) for p in [*PAGES, *linked_files(), *(p for p in DOCS.rglob("*") if p.is_file())]}


def site() -> Any:
    """mkdocs.yml, without the tag that only MkDocs understands."""
    return yaml.safe_load(re.sub(r"!!python/\S+", "", text_of(ROOT / "mkdocs.yml")))


def places(nav: object) -> Iterator[str]:
    if isinstance(nav, str):
        yield nav
    else:
        for item in nav.values() if isinstance(nav, dict) else nav:  # type: ignore[attr-defined]
            yield from places(item)


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_a_page_begins_with_its_licence_and_has_one_title(page: Path) -> None:
    text = text_of(page)
    assert text.startswith(COMMENT)
    assert len(re.findall(r"^# ", prose(text), re.MULTILINE)) == 1


def test_the_navigation_has_each_page_once() -> None:
    listed = list(places(site()["nav"]))
    assert sorted(listed) == sorted({*(place_in_site(p) for p in PAGES if p.name != "README.md"), *OUTSIDE.values()})


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.relative_to(ROOT).as_posix())
def test_links_and_anchors_lead_somewhere(page: Path) -> None:
    for link in links(text_of(page)):
        if link.external:
            assert link.file.startswith(("https://", "mailto:")), link.file
            continue
        target = page.parent / link.file if link.file else page
        assert target.exists(), link.file
        if link.anchor:
            generated = page.name == "command-line.md" or target.name == "command-line.md"
            assert link.anchor in anchors_of(target) or (generated and link.anchor in commands()), (
                f"{link.file}#{link.anchor}"
            )


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.relative_to(ROOT).as_posix())
def test_links_lead_somewhere_in_the_site(page: Path) -> None:
    here = os.path.dirname(place_in_site(page))  # noqa: PTH120
    for link in links(for_the_site(text_of(page), page)):
        if link.file and not link.external:
            assert os.path.normpath(os.path.join(here, link.file)) in files_of_the_site(), link.file  # noqa: PTH118


def test_links_of_the_repository_are_made_for_the_site() -> None:
    page = "[a](../CONTRIBUTING.md) [b](findings.md#rw101) `[c](../x)` [d](../examples/) [e](https://x.org) [f](../LICENSE)"
    made = (
        "[a](contributing.md) [b](findings.md#rw101) `[c](../x)` [d](example.md) [e](https://x.org) [f](files/LICENSE)"
    )
    assert for_the_site(page, DOCS / "x.md") == made


@pytest.mark.parametrize(
    ("heading", "name"),
    [
        ("What is *told*?", "what-is-told"),
        ("What a change gives and takes: `diff`", "what-a-change-gives-and-takes-diff"),
        ("network.json", "networkjson"),
        ("A [link](x.md)", "a-link"),
        ("snake_case & more", "snake_case--more"),
    ],
)
def test_anchors_are_those_of_github(heading: str, name: str) -> None:
    assert slug(heading) == name
    assert anchors(f"## {heading}\n\n## {heading}\n\n```\n## code\n```\n") == {name, f"{name}-1"}


def test_the_reference_has_each_option_of_each_command() -> None:
    written = command_reference(command_line())
    for name, parser in commands_of(command_line()).items():
        section = written.partition(f"## rosward {name} {{")[2].partition("\n## ")[0]
        for option in (o for action in parser._actions for o in action.option_strings if action.dest != "help"):
            assert re.search(rf"^`.*(?<!-){re.escape(option)}[ `]", section, re.MULTILINE), (name, option)


def test_the_command_line_page_names_each_command() -> None:
    named = re.findall(r"^\| `rosward ([a-z -]+)` ", text_of(DOCS / "command-line.md"), re.MULTILINE)
    assert named == list(commands_of(command_line()))


def test_the_outputs_page_lists_each_schema() -> None:
    text = text_of(DOCS / "outputs.md")
    for schema in sorted((ROOT / "src/rosward/outputs/schemas").iterdir()):
        assert f"(../src/rosward/outputs/schemas/{schema.name})" in text, schema.name


def kept() -> Iterator[Path]:
    """The files of the repository, without those of tools and of runs."""
    for folder, folders, files in os.walk(ROOT):
        hidden = {f for f in folders if f.startswith(".") and f != ".ci"}
        folders[:] = sorted(
            set(folders) - hidden - {"__pycache__", "rosward-out", "site", "dist", "node_modules", "build"}
        )
        yield from (Path(folder) / name for name in files)


FOREIGN = r"tests/.*\.(?!py$)|tests/workspaces/|tests/live/(programs|standins)/|examples/.*(?<!\.md)$|.*/vendor/|docs/img/(?!mark)"
"""What has another licence, and programs and data that are analysed."""


def test_files_name_their_licence() -> None:
    unnamed = []
    for path in kept():
        name = path.relative_to(ROOT).as_posix()
        if path.suffix in LICENSED and not re.match(FOREIGN, name):
            head = path.read_text(encoding="utf-8", errors="replace")[:400]
            if head.strip() and "SPDX-License-Identifier: Apache-2.0" not in head:
                unnamed.append(name)
    assert not unnamed


def test_nothing_speaks_of_one_machine() -> None:
    found = []
    for path in kept():
        name = path.relative_to(ROOT).as_posix()
        if path.suffix in LICENSED and (name.startswith(("docs/", "tools/", "src/", "ci/")) or "/" not in name):
            found += [
                f"{name}: {m.group()}" for m in MACHINE.finditer(path.read_text(encoding="utf-8", errors="replace"))
            ]
    assert not found


def test_the_tables_of_modules_are_complete() -> None:
    """Where the page of the architecture has a table of the modules of a folder, it has all of them, and no others."""
    page = text_of(DOCS / "architecture.md")
    sections = re.findall(r"^### `([\w/]+/)`\n(.*?)(?=^##)", page, re.MULTILINE | re.DOTALL)
    assert len(sections) > 5
    for name, section in sections:
        folder = (ROOT if name.startswith("tools/") else ROOT / "src/rosward") / name
        told = {
            one for row in re.findall(r"^\| (`[^|]*) \|", section, re.MULTILINE) for one in re.findall(r"`(\w+)`", row)
        }
        there = {path.stem for path in folder.glob("*.py") if path.stem != "__init__"}
        assert told == there, name
