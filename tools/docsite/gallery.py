# SPDX-License-Identifier: Apache-2.0
"""What does rosward make of the systems in the gallery?

    ## Hello
    <!-- gallery: hello | rosward extract hello.py -->
    ```python title="hello.py"
    …
    ```

The command is carried out on the files that the section shows (and on `examples`); the site gets its outputs as `gallery/hello/…`, and in the
place of the comment their picture, with links.
"""

from __future__ import annotations

import contextlib
import os
import re
import shlex
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Final, NamedTuple

from docsite.console import File, steps_of, write_files
from docsite.pages import ROOT
from rosward.cli import main

__all__ = ["Exhibit", "exhibits_of", "outputs_of", "shown"]

_MARK: Final = re.compile(r"^<!-- gallery: (?P<name>[\w-]+) \| rosward (?P<command>[^\n]+) -->$", re.MULTILINE)
_FORMATS: Final = "json,policy,svg,html"
_KEPT: Final = ("report.html", "graph.svg", "policy.xml", "network.json")


class Exhibit(NamedTuple):
    """One system of the gallery: its name, the command, and the files that its section shows."""

    name: str
    command: str
    files: list[File]


def exhibits_of(page: str) -> Iterator[Exhibit]:
    """What the page exhibits."""
    for section in re.split(r"^(?=## )", page, flags=re.MULTILINE):
        for mark in _MARK.finditer(section):
            files = [step for step in steps_of(section) if isinstance(step, File)]
            yield Exhibit(mark["name"], mark["command"], files)


def outputs_of(exhibit: Exhibit) -> dict[str, str]:
    """The outputs of a system by their name in the site."""
    with tempfile.TemporaryDirectory() as place, _current(Path(place)):
        Path("examples").symlink_to(ROOT / "examples")
        write_files(exhibit.files, Path(place))
        status = main([*shlex.split(exhibit.command), "-q", "-o", "out", "--format", _FORMATS])
        if status > 1:
            raise ValueError(f"the gallery's command fails: rosward {exhibit.command}")
        return {f"gallery/{exhibit.name}/{name}": Path("out", name).read_text(encoding="utf-8") for name in _KEPT}


def shown(page: str) -> str:
    """The page with a picture and links in the place of each mark."""
    return _MARK.sub(
        lambda mark: (
            f"[![Computation graph](gallery/{mark['name']}/graph.svg){{ .exhibit }}](gallery/{mark['name']}/report.html)\n\n"
            f"[Open the report](gallery/{mark['name']}/report.html){{ .md-button .md-button--primary }} &nbsp; "
            f"[graph](gallery/{mark['name']}/graph.svg) · [policy](gallery/{mark['name']}/policy.xml) · "
            f"[network.json](gallery/{mark['name']}/network.json)"
        ),
        page,
    )


@contextlib.contextmanager
def _current(folder: Path) -> Iterator[None]:
    """Within it, the folder is the current one."""
    before = Path.cwd()
    os.chdir(folder)
    try:
        yield
    finally:
        os.chdir(before)
