# SPDX-License-Identifier: Apache-2.0
"""Promise: policy.xml and enclaves.txt go into `ros2 security` as they are, and what comes out is enforced.

`ROSWARD_SROS2` names the folder of the real sros2 (with `lxml` and `cryptography` at hand, 41 for the sros2 of 2024). Its own code makes the
keystore, the enclaves and the permissions of the launched fleet of `examples/`; openssl verifies each signature, and Cyclone DDS says what
each enclave may do.
"""

from __future__ import annotations

import os
import subprocess
import sys
from collections import Counter
from pathlib import Path
from typing import Final

import pytest

import rosward
from rosward import Network
from rosward.cli import main
from rosward.deployment.request import LaunchRequest, Request
from rosward.enclaves.grants import enclaves

from .cyclone import Cyclone
from .test_enforcement import everything, rightful

EXAMPLES: Final = Path(__file__).parent.parent.parent / "examples"
FLEET: Final = Request((LaunchRequest("fleet.launch.py", "delivery_bringup"),))
REAL: Final = Path(__file__).with_name("real_keystore.py")

pytestmark = pytest.mark.skipif("ROSWARD_SROS2" not in os.environ, reason="ROSWARD_SROS2 names no folder of sros2")


def network() -> Network:
    return rosward.extract(EXAMPLES, request=FLEET).network


def paths_in(enclaves_txt: Path) -> list[str]:
    """The lines that begin with a slash, as the documentation takes them."""
    return [line for line in enclaves_txt.read_text(encoding="utf-8").splitlines() if line.startswith("/")]


@pytest.fixture
def sros2_keystore(tmp_path: Path, domain: int) -> Path:
    """The keystore of the fleet, by the code of sros2 alone."""
    words = ["--launch", "delivery_bringup:fleet.launch.py", "-o", str(tmp_path / "out")]
    assert main(["extract", "-q", str(EXAMPLES), *words]) == 0
    found = paths_in(tmp_path / "out" / "enclaves.txt")
    command = [sys.executable, REAL, os.environ["ROSWARD_SROS2"], tmp_path / "keystore", tmp_path / "out/policy.xml"]
    environment = {**os.environ, "ROS_DOMAIN_ID": str(domain)}
    done = subprocess.run(
        [*map(str, command), *found], env=environment, capture_output=True, text=True, check=False, timeout=120
    )
    assert done.returncode == 0, done.stderr
    return tmp_path / "keystore"


def test_sros2_makes_a_keystore_of_it_that_dds_enforces(
    sros2_keystore: Path, domain: int, dds: Cyclone, tally: Counter[str]
) -> None:
    fleet = network()
    tried = everything([fleet])
    for enclave in enclaves(fleet):
        folder = sros2_keystore / "enclaves" / enclave.path[1:]
        authority = sros2_keystore / "public" / "permissions_ca.cert.pem"
        verify = ["openssl", "smime", "-verify", "-text", "-CAfile", authority, "-in", folder / "permissions.p7s"]
        signed = subprocess.run([*map(str, verify)], capture_output=True, check=True, timeout=300).stdout
        assert signed.replace(b"\r\n", b"\n").strip() == (folder / "permissions.xml").read_bytes().strip()
        with dds.participant(domain, folder) as participant:
            allowed = {endpoint for endpoint in tried if participant.may(endpoint)}
        assert allowed == rightful(enclave, tried), enclave.path
        tally["policies in a keystore of sros2 enforced"] += 1
        tally["endpoints allowed by it"] += len(allowed)
        tally["endpoints refused by it"] += len(tried) - len(allowed)
