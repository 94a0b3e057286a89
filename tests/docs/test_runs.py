# SPDX-License-Identifier: Apache-2.0
"""What the pages show as a run is what the commands print; `tools/docsite/console.py` says how a page marks one.

python -m pytest tests/docs/test_runs.py --update-pages     writes what is printed into the pages; read it with care
"""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest
from docsite.command_reference import commands_of
from docsite.console import ELIDED, Run, agrees, perform, rewritten, runs_of, steps_of
from docsite.pages import pages
from sampling import sample

from rosward.cli.command_line import command_line

pytestmark = pytest.mark.usefixtures("remembered")

PAGES = [page for page in pages() if runs_of(page.read_text(encoding="utf-8"))]
SHOWN_OTHERWISE = {"lsp", "serve", "watch"}
"""Commands that do not end by themselves."""


@pytest.fixture
def folder(tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """An empty folder, the current one. All pages have the same, so that what they ask of the examples is the same."""
    made = tmp_path_factory.getbasetemp() / "page"
    made.mkdir()
    monkeypatch.chdir(made)
    yield made
    shutil.rmtree(made)


@pytest.mark.parametrize("page", sample(PAGES, 8), ids=lambda page: page.name)
def test_a_page_shows_what_is_printed(
    page: Path, folder: Path, monkeypatch: pytest.MonkeyPatch, request: pytest.FixtureRequest
) -> None:
    monkeypatch.setenv("COLUMNS", "100")
    text = page.read_text(encoding="utf-8")
    results = list(perform(text, folder))
    if request.config.getoption("--update-pages"):
        assert page.read_text(encoding="utf-8") == text, "the page was changed meanwhile"
        page.write_text(rewritten(text, results), encoding="utf-8")
        return
    for run, printed in results:
        assert agrees(run.shown, printed), f"$ {run.command}\n" + "\n".join(printed)


def test_each_command_is_shown_by_a_run() -> None:
    shown = [run.command for page in PAGES for run in runs_of(page.read_text(encoding="utf-8"))]
    for command in set(commands_of(command_line())) - SHOWN_OTHERWISE:
        assert any(each.startswith(f"rosward {command}") for each in shown), command


PAGE = """
```python title="src/talker.py"
print(1)
```

<!-- runs -->
```console
$ rosward extract \\
    src
one
…
$ echo $?
0
```

```console
$ rosward not marked
```

````markdown
<!-- runs -->
```console
$ rosward in a quotation
```
````
"""


def test_the_steps_of_a_page() -> None:
    file, extract, status = steps_of(PAGE)
    assert file == ("src/talker.py", "print(1)\n")
    assert isinstance(extract, Run)
    assert isinstance(status, Run)
    assert (extract.command, extract.shown) == ("rosward extract src", ["one", "…"])
    assert (status.command, status.shown) == ("echo $?", ["0"])


def test_a_page_is_rewritten_where_it_differs() -> None:
    extract, status = runs_of(PAGE)
    assert rewritten(PAGE, [(extract, ["one", "two"]), (status, ["1"])]) == PAGE.replace("\n0\n", "\n1\n")
    assert rewritten(PAGE, [(extract, ["two", "three"]), (status, ["0"])]) == PAGE.replace("one\n…", "two\n…")
    assert rewritten(PAGE, [(extract, ["two"]), (status, ["0"])]) == PAGE.replace("one\n…", "two\n…")


@pytest.mark.parametrize(
    ("shown", "printed", "same"),
    [
        ("a b", "a b", True),
        ("a b", "a b c", False),
        ("a …", "a b c", True),
        ("… c", "a b c", True),
        ("a … c", "a c", True),
        ("a … c", "a b", False),
        ("… b …", "a b c", True),
        ("a … b … a", "a c b a", True),
        ("a … b … a", "a b", False),
        ("… b c … d", "b x b c d", True),
        ("… b c … d", "b x c d", False),
        ("a … a", "a", False),
    ],
)
def test_lines_that_are_left_out(shown: str, printed: str, same: bool) -> None:
    assert agrees(shown.split(), printed.split()) is same
    assert ELIDED == "…"
