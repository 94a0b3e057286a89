# SPDX-License-Identifier: Apache-2.0
"""Calls and loops of C++ that are not followed again: whatever they do, the result is that of following them."""

from __future__ import annotations

import json
from pathlib import Path
from random import Random
from typing import Final

import pytest
from compiled import interpreted
from sampling import sample

import rosward
from rosward.domain.values import ModuleValue, Value
from rosward.engine.budget import Budget
from rosward.engine.calls import recalled
from rosward.engine.cpp import values
from rosward.engine.machine import Engine
from rosward.ir.symbols import Symbol
from rosward.outputs.documents.network_json import network_json

from .recalling import noted_recalls

_HEAD: Final = """
#include <cstdlib>
#include <functional>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"

const char * const TABLE[] = {"t0", "t1", "t2"};

class N;
struct Part {
  Part(N * n, const std::string & name, int number);
  void add(const std::string & more) { name_ += more; count_++; }
  std::string name_;
  int count_ = 0;
};

class N : public rclcpp::Node {
public:
  N() : Node("n") {
    tick_ = create_wall_timer(std::chrono::seconds(1), [this]() { tick(); });
    hear_ = create_subscription<std_msgs::msg::String>("in", 1, [this](const std_msgs::msg::String & m) { hear(m.data); });
    start();
  }
  std::string make(const std::string & name) {
    pubs_.push_back(create_publisher<std_msgs::msg::String>(name, 1));
    return name;
  }
  int any() { return std::rand(); }
  std::string a_ = "a";
  std::vector<std::string> b_{"x", "y"};
  int c_ = 0;
  std::map<std::string, std::string> d_{{"k", "v"}};
  std::vector<Part> parts_;
  std::vector<std::shared_ptr<Part>> shared_;
  std::vector<rclcpp::PublisherBase::SharedPtr> pubs_;
  rclcpp::TimerBase::SharedPtr tick_;
  rclcpp::SubscriptionBase::SharedPtr hear_;
"""
_TAIL: Final = """
};
Part::Part(N * n, const std::string & name, int number) : name_(name + std::to_string(number)) { n->make("part/" + name_); }
int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<N>());
}
"""
_VALUES: Final = (
    "a_", 'std::string("k")', "b_[0]", 'd_["k"]', "v", 'v + "z"', "std::to_string(c_)", "TABLE[c_ % 3]", "TABLE[1]",
    "make(v)", "f{n}(v)", "g{n}(a_)", "parts_.back().name_",
)  # fmt: skip
_STATEMENTS: Final = (
    "a_ = {value};",
    "c_ += 1;",
    "c_ = b_.size();",
    "b_.push_back({value});",
    "b_ = std::vector<std::string>(1, {value});",
    "d_[{value}] = {value};",
    "v = {value};",
    "make({value});",
    "static std::string kept = v; make(kept);",
    "parts_.push_back(Part(this, {value}, c_));",
    "shared_.push_back(std::make_shared<Part>(this, {value}, 1));",
    'for (auto & part : parts_) part.add("m");',
    "{{ std::string out = v; auto set = [&](const std::string & to) {{ out = to; }}; set({value}); make(out); }}",
    "if (any()) {{\n{inner}\n}}",
    "for (const auto & each : b_) {{ v = each;\n{inner}\n}}",
    "for (int i = 0; i < any(); i++) {{ c_ = i;\n{inner}\n}}",
    "while (any()) {{\n{inner}\n}}",
    "try {{\n{inner}\nif (any()) throw std::runtime_error({value});\n}} catch (const std::exception & e) {{ a_ = {value}; }}",
    "for (auto it = b_.begin(); it != b_.end();) {{ if (*it == v) it = b_.erase(it); else ++it;\n{inner}\n}}",
)
_PLAIN: Final = 13
"""So many statements, the first of them, have no others in them."""


def _block(random: Random, functions: int, depth: int) -> str:
    return "\n".join(_statement(random, functions, depth) for _ in range(random.randint(1, 3)))


def _statement(random: Random, functions: int, depth: int) -> str:
    chosen = random.choice(_STATEMENTS if depth else _STATEMENTS[:_PLAIN])
    known = [value for value in _VALUES if functions or "{n}" not in value]
    while "{value}" in chosen:
        value = random.choice(known).format(n=random.randrange(max(functions, 1)))
        chosen = chosen.replace("{value}", value, 1)
    inner = _block(random, functions, depth - 1) if "{inner}" in chosen else ""
    return chosen.replace("{inner}", inner).replace("{{", "{").replace("}}", "}")


def _program(seed: int) -> str:
    """A node whose callbacks call functions that read and write what it has; a function calls only those before it."""
    random = Random(seed)
    parts = [_HEAD]
    for number in range(3):
        parts.append(f"  std::string f{number}(std::string v) {{\n{_block(random, number, 2)}\n    return v;\n  }}")
        parts.append(f"  std::string & g{number}(std::string & v) {{\n{_block(random, number, 2)}\n    return v;\n  }}")
    for name in ("tick", "hear", "start"):
        parts.append(f'  void {name}(std::string v = "t") {{\n{_block(random, 3, 2)}\n  }}')
    return "\n".join(parts) + _TAIL


def _told(folder: Path, program: str, budget: Budget | None = None) -> str:
    (folder / "n.cpp").write_text(program, encoding="utf-8")
    return network_json(rosward.extract(folder, budget=budget).network)


_LITTLE: Final = Budget(steps=30_000, entry_steps=30_000, callback_steps=60_000, entry_coarse=150, loop_steps=150)
"""With it, precision is given up soon."""


_PATIENT: Final = Budget(entry_idle=30_000, loop_idle=120_000)
"""With it, nothing is followed in haste."""


def _topics(said: str) -> set[str]:
    return {topic["name"] for topic in json.loads(said)["topics"]}


@pytest.mark.parametrize("budget", [Budget(), _LITTLE], ids=["usual", "little"])
@pytest.mark.parametrize("seed", sample(range(16), 16))
def test_the_result_is_that_of_following_all(
    seed: int, budget: Budget, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """What is recalled takes no steps: where following all comes to a limit, recalling may find more."""
    found = _told(tmp_path, _program(seed), budget)
    monkeypatch.setattr(recalled, "place_of", lambda *_: None)
    followed = _told(tmp_path, _program(seed), budget)
    assert found == followed or ("RW201" in followed and _topics(found) >= _topics(followed))


_BOARDS: Final = """
#include <memory>
#include <string>
#include <vector>
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"

const int WEIGHTS[] = {1, 2, 3, 5, 8, 13, 21, 34};

class Motor {
public:
  Motor(rclcpp::Node::SharedPtr node, int board, int port, int number) : node_(node) {
    const std::string base = "board" + std::to_string(board) + ".port" + std::to_string(port);
    if (!node_->get_parameter(base + ".motor" + std::to_string(number) + ".name", name_)) name_ = "none";
    weight_ = WEIGHTS[number % 8] + WEIGHTS[port % 8];
    pub_ = node_->create_publisher<std_msgs::msg::String>(name_ + "/state", 1);
  }
  rclcpp::Node::SharedPtr node_;
  std::string name_;
  int weight_ = 0;
  rclcpp::Publisher<std_msgs::msg::String>::SharedPtr pub_;
};
class Port {
public:
  Port(rclcpp::Node::SharedPtr node, int board, int number) : node_(node) {
    int motors = 0;
    node_->get_parameter("motors", motors);
    for (int i = 1; i <= motors; i++) motors_.push_back(new Motor(node_, board, number, i));
  }
  rclcpp::Node::SharedPtr node_;
  std::vector<Motor *> motors_;
};
class Board {
public:
  Board(rclcpp::Node::SharedPtr node, int number) : node_(node) {
    int ports = 0;
    node_->get_parameter("ports", ports);
    for (int i = 1; i <= ports; i++) ports_.push_back(new Port(node_, number, i));
  }
  rclcpp::Node::SharedPtr node_;
  std::vector<Port *> ports_;
};
class Robot {
public:
  explicit Robot(rclcpp::Node::SharedPtr node) : node_(node) {
    timer_ = node_->create_wall_timer(std::chrono::seconds(1), [this]() { build(); });
  }
  void build() {
    boards_.clear();
    int boards = 0;
    node_->get_parameter("boards", boards);
    for (int i = 1; i <= boards; i++) boards_.push_back(std::make_shared<Board>(node_, i));
  }
  rclcpp::Node::SharedPtr node_;
  std::vector<std::shared_ptr<Board>> boards_;
  rclcpp::TimerBase::SharedPtr timer_;
};

int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>(
    "robot", rclcpp::NodeOptions().automatically_declare_parameters_from_overrides(true));
  Robot robot(node);
  rclcpp::spin(node);
}
"""


@interpreted
def test_what_is_made_in_loops_within_loops_is_not_made_again(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Each call has variables of its own, whose addresses the functions within get."""
    recalls = noted_recalls(monkeypatch)
    found = _told(tmp_path, _BOARDS, _PATIENT)
    assert {"/none/state", "/*state"} <= _topics(found)
    assert any(call.fresh and call.effort.steps > 100 for call in recalls)
    monkeypatch.setattr(recalled, "place_of", lambda *_: None)
    assert found == _told(tmp_path, _BOARDS, _PATIENT)


_TABLES: Final = """
#include <cstdlib>
#include <string>
#include <vector>
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"

const char * const NAMES[] = {"left", "right"};
const int LEVELS[] = {3, 5, 7};

static std::string pick(int number)
{
  if (std::rand()) return NAMES[0];
  return NAMES[number % 2] + std::to_string(LEVELS[number]);
}

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("n");
  std::vector<rclcpp::PublisherBase::SharedPtr> pubs;
  for (int i = 0; i < 3; i++) {
    if (std::rand()) continue;
    pubs.push_back(node->create_publisher<std_msgs::msg::String>(pick(i), 1));
  }
  rclcpp::spin(node);
}
"""


@interpreted
def test_a_constant_is_computed_once_on_all_ways(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    computed: list[str] = []
    first_value = values.first_value

    def noting(machine: Engine, symbol: Symbol, env: ModuleValue) -> Value:
        computed.append(symbol.name)
        return first_value(machine, symbol, env)

    monkeypatch.setattr(values, "first_value", noting)
    found = _told(tmp_path, _TABLES)
    assert {"/left", "/left3", "/right5", "/left7"} <= _topics(found)
    assert (computed.count("NAMES"), computed.count("LEVELS")) == (1, 1)
