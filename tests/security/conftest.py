# SPDX-License-Identifier: Apache-2.0
"""Where the DDS comes from, a domain for each test, and how much was tried in all.

What a machine lacks skips the tests that need it, with a reason. `ROSWARD_TESTS_REQUIRE="dds rclpy"` turns that into a
failure: so `.ci/run` calls them. `ROSWARD_LIVE_PYTHON` is a Python that has rclpy, where it is not the one of the tests.
"""

from __future__ import annotations

import functools
import itertools
import os
import random
import socket
import subprocess
import sys
from collections import Counter
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Final, NoReturn

import pytest

from rosward import Network

from .cyclone import Cyclone, UnavailableError
from .keystore import Keystore, has_openssl
from .systems import systems

TALLY: Final = pytest.StashKey["Counter[str]"]()
_DOMAINS: Final = range(1, 100)  # beyond, the ports of DDS meet those that the system gives to anyone


def lacking(what: str, why: str) -> NoReturn:
    """Skip, or fail where this has to be there."""
    required = os.environ.get("ROSWARD_TESTS_REQUIRE", "").split()
    if what in required:
        pytest.fail(f"{what} is required here: {why}", pytrace=False)
    pytest.skip(why)


@pytest.fixture(scope="session")
def dds() -> Cyclone:
    if not has_openssl():
        lacking("dds", "no openssl command")
    try:
        return Cyclone()
    except UnavailableError as error:
        missing = str(error)
    lacking("dds", f"no Cyclone DDS with security: {missing}")


@pytest.fixture(scope="session")
def live_python() -> str:
    """A Python with the real rclpy."""
    python = os.environ.get("ROSWARD_LIVE_PYTHON", sys.executable)
    found = subprocess.run([python, "-c", "import rclpy, test_msgs"], capture_output=True, check=False, timeout=60)
    if found.returncode:
        lacking("rclpy", f"no rclpy in {python}")
    return python


@pytest.fixture(scope="session")
def domains() -> Iterator[int]:
    """Domain ids that nobody uses, from somewhere in their range, since other tests may run on the machine."""
    start = random.randrange(len(_DOMAINS))
    return filter(_is_free, itertools.cycle([*_DOMAINS[start:], *_DOMAINS[:start]]))


def _is_free(domain: int) -> bool:
    """Whether the port of the first participant of a domain (RTPS 9.6.1.1) can be had."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as one:
        try:
            one.bind(("", 7400 + 250 * domain + 10))
        except OSError:
            return False
    return True


@pytest.fixture
def domain(domains: Iterator[int]) -> int:
    """A domain id for one test."""
    return next(domains)


@pytest.fixture
def keystore(tmp_path: Path, domain: int, dds: Cyclone) -> Keystore:
    del dds  # it says whether there is an openssl
    return Keystore(tmp_path / "keystore", domain)


@pytest.fixture(scope="session")
def read(tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], list[Network]]:
    """The systems of a name, read once."""
    return functools.cache(lambda name: systems(name, tmp_path_factory.mktemp("sources")))


@pytest.fixture
def tally(pytestconfig: pytest.Config) -> Counter[str]:
    """What the terminal tells at the end."""
    return pytestconfig.stash.setdefault(TALLY, Counter())


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter, config: pytest.Config) -> None:
    counted = config.stash.get(TALLY, Counter())
    if counted:
        terminalreporter.write_line(", ".join(f"{number} {what}" for what, number in counted.items()))
