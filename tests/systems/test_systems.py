# SPDX-License-Identifier: Apache-2.0
"""Every workspace of `tests/systems` gives exactly what stands beside it, and outputs that fit each other."""

from __future__ import annotations

import json
import re
import xml.etree.ElementTree as ET
from importlib import resources
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from casefile import rewrite

from .systemfile import OUTPUT, SystemCase, read_systems, run_system

CASES = [case for file in sorted(Path(__file__).parent.glob("*.md")) for case in read_systems(file)]
SCHEMA = json.loads((resources.files("rosward.outputs") / "schemas" / "network.schema.json").read_text())
_EXACT = re.compile(r"/|(/[A-Za-z_]\w*)+")
VALIDATOR = jsonschema.Draft202012Validator(SCHEMA)


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.name)
def test_system(
    case: SystemCase, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, request: pytest.FixtureRequest
) -> None:
    """What is written below a command is what comes out of it, no more and no less."""
    monkeypatch.chdir(tmp_path)
    outcome = run_system(case, tmp_path)
    if outcome.network is not None:
        VALIDATOR.validate(outcome.network)
        check_places(outcome.network, tmp_path)
        check_enclaves(outcome.network, tmp_path / OUTPUT)
    if request.config.getoption("--update-cases") and outcome.lines != case.expected:
        rewrite(case.file, {case.title: outcome.lines})
        return
    assert outcome.lines == case.expected


def check_places(network: dict[str, Any], root: Path) -> None:
    """Each place is a line of a file that was read."""
    for node in network["nodes"]:
        for place in (node["launched_by"], *(e for p in node["publishers"] for e in p["created_at"])):
            if place is not None and (root / place["file"]).is_file():
                lines = (root / place["file"]).read_text(encoding="utf-8").splitlines()
                assert 1 <= place["line"] <= len(lines), place


def check_enclaves(network: dict[str, Any], folder: Path) -> None:
    """The policy and enclaves.txt have the enclaves of the network, and a profile for each node in the one that it runs in."""
    if not network["nodes"]:
        return
    wanted: dict[str, set[str]] = {}
    for node in network["nodes"]:
        wanted.setdefault(node["enclave"], set()).add(node["fqn"])
    found = {
        enclave.get("path", ""): {f"{p.get('ns', '').rstrip('/')}/{p.get('node')}" for p in enclave.iter("profile")}
        for enclave in ET.parse(folder / "policy.xml").iter("enclave")
    }
    starts = (folder / "enclaves.txt").read_text(encoding="utf-8")
    assert set(re.findall(r"^/\S*$", starts, re.MULTILINE)) == set(found)
    if all(_EXACT.fullmatch(name) for name in (*wanted, *(fqn for fqns in wanted.values() for fqn in fqns))):
        assert found == wanted


def test_titles_are_unique() -> None:
    """A title names one case."""
    names = [case.name for case in CASES]
    assert len(names) == len(set(names))
