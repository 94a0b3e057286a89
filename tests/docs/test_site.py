# SPDX-License-Identifier: Apache-2.0
"""The site is built without a warning, loads nothing from elsewhere, and holds what is generated."""

from __future__ import annotations

import importlib.util
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest
from docsite.pages import DOCS, OUTSIDE, ROOT

pytestmark = pytest.mark.slow

LOADED = re.compile(r"""(?:\bsrc|<link\b[^>]*\bhref)=["'](https?:|//)[^"']*|@import|url\(["']?(?:https?:|//)""")


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    if importlib.util.find_spec("material") is None:
        if "docs" in os.environ.get("ROSWARD_TESTS_REQUIRE", "").split():
            pytest.fail("docs is required here: no mkdocs-material", pytrace=False)
        pytest.skip("mkdocs-material is not installed")
    folder = tmp_path_factory.mktemp("site")
    command = [sys.executable, "-m", "mkdocs", "build", "--strict", "--quiet", "--site-dir", str(folder)]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False, timeout=300)
    assert done.returncode == 0, done.stdout + done.stderr
    return folder


def test_each_page_is_there(site: Path) -> None:
    names = {*OUTSIDE.values(), *(page.relative_to(DOCS).as_posix() for page in DOCS.rglob("*.md"))}
    assert all((site / name).with_suffix(".html").is_file() for name in names)


def test_nothing_is_loaded_from_elsewhere(site: Path) -> None:
    for page in [*site.glob("*.html"), *(site / "css").glob("*.css")]:
        assert not LOADED.search(page.read_text(encoding="utf-8")), page.name
    assert "mermaid" not in (site / "index.html").read_text(encoding="utf-8")


def test_marks_were_replaced(site: Path) -> None:
    pages = {page.stem: page.read_text(encoding="utf-8") for page in site.glob("*.html")}
    assert not [name for name, text in pages.items() if re.search(r"<!-- (generated|gallery):", text)]
    assert "<code>--enclaves {node,process,launch" in pages["command-line"]
    assert 'id="diagnostic"' in pages["outputs"]


@pytest.mark.parametrize("name", ["robot", "fleet", "unknown-names", "unknown-node"])
def test_the_gallery_has_reports(site: Path, name: str) -> None:
    assert f'href="gallery/{name}/report.html"' in (site / "gallery.html").read_text(encoding="utf-8")
    assert (site / "gallery" / name / "report.html").stat().st_size > 100_000
    assert (site / "gallery" / name / "graph.svg").read_text(encoding="utf-8").startswith("<svg")
