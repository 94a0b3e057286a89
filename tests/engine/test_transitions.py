# SPDX-License-Identifier: Apache-2.0
"""Nodes whose transitions are asked for by themselves and by others: what they make is made once, and a node within a node is no recursion."""

from __future__ import annotations

from pathlib import Path

import pytest

import rosward
from rosward.domain.values import Function, Value
from rosward.engine.budget import Budget
from rosward.engine.callbacks import schedule
from rosward.engine.calls import activation
from rosward.engine.calls.summarised import summarised
from rosward.engine.machine import Engine
from rosward.engine.running.schedule_book import Schedule

SOURCE = """
#include <chrono>
#include <memory>
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"
#include "std_msgs/msg/string.hpp"
using rclcpp_lifecycle::LifecycleNode;
using Return = rclcpp_lifecycle::node_interfaces::LifecycleNodeInterface::CallbackReturn;

class Map : public LifecycleNode
{
public:
  Map() : LifecycleNode("map") {}
  Return on_configure(const rclcpp_lifecycle::State &) override
  {
    tick_ = create_wall_timer(std::chrono::seconds(1), [this]() {count_++;});
    grid_ = create_publisher<std_msgs::msg::String>("grid", 10);
    return Return::SUCCESS;
  }
  int count_ = 0;
  rclcpp::TimerBase::SharedPtr tick_;
  rclcpp::PublisherBase::SharedPtr grid_;
};

class Planner : public LifecycleNode
{
public:
  Planner() : LifecycleNode("planner"), map_(std::make_shared<Map>())
  {
    start_ = create_wall_timer(std::chrono::seconds(0), [this]() {configure(); start_->cancel();});
  }
  Return on_configure(const rclcpp_lifecycle::State &) override
  {
    map_->configure();
    path_ = create_publisher<std_msgs::msg::String>("path", 10);
    return Return::SUCCESS;
  }
  std::shared_ptr<Map> map_;
  rclcpp::TimerBase::SharedPtr start_;
  rclcpp::PublisherBase::SharedPtr path_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<Planner>();
  rclcpp::spin(node->get_node_base_interface());
}
"""


def publishers(folder: Path, budget: Budget | None = None) -> set[str]:
    """What the program publishes of its own."""
    (folder / "main.cpp").write_text(SOURCE, encoding="utf-8")
    network = rosward.extract(folder, budget=budget).network
    names = {entity.name for node in network.nodes for entity in node.entities}
    return names & {"/grid", "/path"}


def test_a_transition_makes_the_same_whoever_asks_for_it(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The services of the map, and the planner, which is configured by its own service and by its timer: one timer of the map in all."""
    books: dict[int, Schedule] = {}
    add = schedule.add

    def noted(machine: Engine, callback: Value, *args: object) -> None:
        books[id(machine)] = machine.schedule_book
        add(machine, callback, *args)  # type: ignore[arg-type]  # what it is given is passed on

    monkeypatch.setattr(schedule, "add", noted)
    assert publishers(tmp_path) == {"/grid", "/path"}
    *_, book = books.values()  # the process may have been followed anew
    ticks = [
        entry for entry in book.entries.values() if entry.event == "timer" and "on_configure" in repr(entry.callback)
    ]
    assert len(ticks) == 1


def test_a_node_that_configures_another_one_is_no_recursion(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Both go through `configure` of the library; where precision is given up, it has no summary for the two."""
    asked: set[str] = set()

    def noted(machine: Engine, function: Function, registers: list[Value]) -> Value:
        asked.add(function.code.name)
        return summarised(machine, function, registers)

    monkeypatch.setattr(activation, "summarised", noted)
    assert publishers(tmp_path, Budget(coarse=0.0, entry_coarse=0, large=-1)) == {"/grid", "/path"}
    assert "configure" not in asked
