# SPDX-License-Identifier: Apache-2.0
"""Promise: what the language says is what is computed: each program in `language/` creates the publishers that it has when it is compiled and run.

The programs name their publishers after what they compute: `num("a", n)` makes `/a_3`.
"""

from __future__ import annotations

from pathlib import Path
from typing import Final

import pytest

import rosward

from .compiled import Ran, fits_beside_others, needs_compiler, run_many, run_source

pytestmark = [needs_compiler, pytest.mark.slow]

FOLDER: Final = Path(__file__).with_name("language")
PROGRAMS: Final = sorted(FOLDER.glob("*.cpp"))
HEAD: Final = """\
#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"

static std::shared_ptr<rclcpp::Node> node;

static void show(const std::string & s)
{
  node->create_publisher<std_msgs::msg::String>(s, 1);
}

static void num(const std::string & s, int n)
{
  show(s + "_" + (n < 0 ? "m" + std::to_string(-n) : std::to_string(n)));
}

"""
MAIN: Final = """
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  node = std::make_shared<rclcpp::Node>("n");
  run();
  rclcpp::shutdown();
  return 0;
}
"""


def publishers(source: Path) -> set[str]:
    """What is said of a program."""
    network = rosward.extract(source).network
    return {e.name for n in network.nodes for e in n.entities if e.kind.value == "publisher" and not e.system}


def text_of(program: Path) -> str:
    return HEAD + program.read_text(encoding="utf-8") + MAIN


@pytest.fixture(scope="module")
def together(tmp_path_factory: pytest.TempPathFactory) -> dict[Path, Ran]:
    """What the programs do that can be compiled as one."""
    programs = [program for program in PROGRAMS if fits_beside_others(text_of(program))]
    assert len(programs) > len(PROGRAMS) // 2
    return dict(zip(programs, run_many(map(text_of, programs), tmp_path_factory.mktemp("programs")), strict=True))


@pytest.mark.parametrize("program", PROGRAMS, ids=lambda program: program.stem)
def test_the_language(program: Path, together: dict[Path, Ran], tmp_path: Path) -> None:
    text = text_of(program)
    ran = together[program] if program in together else run_source(text, tmp_path)
    assert ran.status == 0, ran.output
    source = tmp_path / "said" / "main.cpp"
    source.parent.mkdir()
    source.write_text(text, encoding="utf-8")
    assert publishers(source) == {fact[2] for fact in ran.facts}
