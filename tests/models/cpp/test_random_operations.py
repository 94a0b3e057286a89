# SPDX-License-Identifier: Apache-2.0
"""What a compiler makes of random programs of strings and containers, rosward says exactly."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest
from casefile import Case, run_case
from sampling import sample

from models.cpp.random_operations import compiled, followed, program

_PUBLISHER = "pub /{} std_msgs/msg/String"


@pytest.mark.skipif(shutil.which("g++") is None, reason="there is no g++")
@pytest.mark.parametrize("seed", sample([1, 2], 2))
def test_as_a_compiler_has_it(seed: int, tmp_path: Path) -> None:
    body = program(seed)
    source, binary = tmp_path / "said.cpp", tmp_path / "said"
    source.write_text(compiled(body))
    subprocess.run(["g++", "-std=c++17", "-w", "-o", binary, source], check=True, timeout=120)
    said = subprocess.run([binary], check=True, capture_output=True, text=True, timeout=20).stdout.split()
    folder = tmp_path / "node"
    folder.mkdir()
    found = run_case(Case(Path("random.md"), "random", {"main.cpp": followed(body)}, [], {}), folder)
    assert sorted(line for line in found if line.startswith("pub")) == sorted(
        {_PUBLISHER.format(word) for word in said}
    )
