# SPDX-License-Identifier: Apache-2.0
"""Whether the packages are there that `rosward serve` needs, and what is said where they are not."""

from __future__ import annotations

import os

import pytest

from rosward.cli import main, serve

from .conftest import MISSING


def test_the_extra_is_installed() -> None:
    if MISSING:
        why = f"no {', '.join(MISSING)}"
        if "serve" in os.environ.get("ROSWARD_TESTS_REQUIRE", "").split():
            pytest.fail(f"serve is required here: {why}", pytrace=False)
        pytest.skip(why)


def test_without_it_the_command_says_what_to_install(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(serve, "_NEEDED", ("no_such_package_of_ours",))
    assert main(["serve"]) == 2
    assert capsys.readouterr().err == "rosward: serve needs additional packages: pip install 'rosward[serve]'\n"


@pytest.mark.parametrize("port", ["-1", "65536", "http", ""])
def test_a_port_is_a_number(port: str) -> None:
    with pytest.raises(SystemExit) as ended:
        main(["serve", "--port", port])
    assert ended.value.code == 2


@pytest.mark.skipif(bool(MISSING), reason="the extra is not there")
@pytest.mark.parametrize(
    ("paths", "why"),
    [
        (["no/such/folder"], "no such file or folder: no/such/folder"),
        (["/dev/null"], "there is no folder or file /dev/null"),
        ([".", ".."], "serve takes a single PATH"),
    ],
)
def test_a_path_that_cannot_be_opened(paths: list[str], why: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["serve", *paths]) == 2
    assert why in capsys.readouterr().err
