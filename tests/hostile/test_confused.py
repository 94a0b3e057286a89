# SPDX-License-Identifier: Apache-2.0
"""Programs that call everything in a wrong way make nothing fail; `ROSWARD_CONFUSED=20000` tries more of them than by default."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

import rosward
from hostile import confused
from rosward.models.tables import own_models


def test_confused_programs_hurt_nobody() -> None:
    count = int(os.environ.get("ROSWARD_CONFUSED", "30"))
    tried = confused.confuse(confused.programs(int(os.environ.get("ROSWARD_SEED", "1"))), count, slow=60.0)
    assert [(f.program.path, f.error) for f in tried.failures] == []
    assert tried.reached > count * confused.CALLS // 2


def test_all_that_is_modelled_is_called() -> None:
    called = {c.expression for c in confused.callees()}
    missing = {n for n in own_models().natives if n not in called and n.removeprefix("builtins.") not in called}
    assert missing == set()


def test_what_stubs_import_is_nothing_to_a_program(tmp_path: Path) -> None:
    (tmp_path / "n.py").write_text(
        "import rclpy\nfrom _rosward import create_node, fail_unless\nimport _rosward\nrclpy.init()\n"
        "_rosward.create_node('made')\nfail_unless(1)\nrclpy.create_node('good')\n"
    )
    result = rosward.extract(tmp_path, budget=confused.SMALL)
    assert [n.fqn for n in result.network.nodes] == ["/good"]


@pytest.mark.parametrize(
    "call", ["contextlib._end(1)", "contextlib._unwind(1, 2, 3)", "object.__eq__()", "object.__setattr__(1)"]
)
def test_what_takes_so_many_arguments_gets_others(call: str, tmp_path: Path) -> None:
    (tmp_path / "n.py").write_text(
        f"import contextlib, rclpy\nrclpy.init()\nrclpy.create_node('good')\ntry:\n    {call}\nexcept TypeError:\n    pass\n"
        "rclpy.create_node('after')\n"
    )
    result = rosward.extract(tmp_path, budget=confused.SMALL)
    assert {n.fqn for n in result.network.nodes} == {"/good", "/after"}
