# SPDX-License-Identifier: Apache-2.0
"""Whether the packages are there that `rosward survey` needs, and what is said if they are not."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from rosward.cli import main

from .conftest import MISSING


def test_the_extras_are_installed() -> None:
    if MISSING:
        why = f"no {', '.join(MISSING)}"
        if "survey" in os.environ.get("ROSWARD_TESTS_REQUIRE", "").split():
            pytest.fail(f"survey is required here: {why}", pytrace=False)
        pytest.skip(why)


@pytest.mark.parametrize(
    ("package", "options", "told"),
    [
        ("pyarrow", [], "survey needs additional packages: pip install 'rosward[survey]'"),
        ("distributed", ["--scheduler", "tcp://127.0.0.1:1"], "--scheduler needs additional packages"),
    ],
)
def test_what_is_said_without_them(
    package: str,
    options: list[str],
    told: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    for module in ("run", "cluster"):
        monkeypatch.setattr(f"rosward.surveying.{module}.find_spec", lambda name: None if name == package else object())
    assert main(["survey", str(tmp_path), *options]) == 2
    assert told in capsys.readouterr().err
