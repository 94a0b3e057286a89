# SPDX-License-Identifier: Apache-2.0
"""Ways in which C++ may hand on a value: `cpp_ways.txt` has one program for each, of which only what differs is written down.

Whatever else may be said of `r`, what arrives is in it, but where it is not. A program that could hand it on without being seen would be a hole.
"""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

import pytest
from sampling import sample

from .test_cpp import flows

PROGRAM = """\
#include <algorithm>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "geometry_msgs/msg/pose_stamped.hpp"
#include "rclcpp/rclcpp.hpp"
#include "sensor_msgs/msg/laser_scan.hpp"
#include "std_msgs/msg/float64.hpp"
#include "std_msgs/msg/float64_multi_array.hpp"
#include "std_msgs/msg/string.hpp"

using geometry_msgs::msg::PoseStamped;
using sensor_msgs::msg::LaserScan;
using std_msgs::msg::Float64;
using std_msgs::msg::Float64MultiArray;
using std_msgs::msg::String;

@before@

class App : public rclcpp::Node
{
public:
  App() : Node("app")
  {
    out_ = create_publisher<Float64>("out", 10);
    sub_ = create_subscription<@type@>("in", 10, std::bind(&App::on, this, std::placeholders::_1));
  }

private:
  void on(const @type@::SharedPtr msg)
  {
    double r = 0.0;
    @on@
    Float64 made;
    made.data = r;
    out_->publish(made);
  }
  @methods@
  @members@
  rclcpp::Publisher<Float64>::SharedPtr out_;
  rclcpp::Subscription<@type@>::SharedPtr sub_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<App>());
  return 0;
}
"""


class Way(NamedTuple):
    """One program: what differs, and whether the value is in the output ('data'), decides it ('control'), or is not in it ('clean')."""

    name: str
    program: str
    way: str


def read(text: str) -> Way:
    """One section of the file."""
    head, *lines = text.splitlines()
    given: dict[str, list[str]] = {}
    key = ""
    for each in lines:
        if each.startswith("    "):
            given[key].append(each.strip())
        elif each:
            key, _, rest = each.partition(":")
            given[key] = [rest.strip()] if rest else []
    program = PROGRAM
    for word, default in (("before", ""), ("type", "Float64"), ("on", ""), ("methods", ""), ("members", "")):
        program = program.replace(f"@{word}@", "\n".join(given.get(word, [default])))
    return Way(head.strip(), program, *given.get("way", ["data"]))


WAYS = [read(text) for text in (Path(__file__).parent / "cpp_ways.txt").read_text().split("\n## ")[1:]]


@pytest.mark.parametrize("way", sample(WAYS, 12), ids=lambda w: w.name)
def test_is_seen(way: Way, tmp_path: Path) -> None:
    path = tmp_path / "main.cpp"
    path.write_text(way.program)
    found = [sink for each in flows(path) for sink in each.sinks if str(sink.sink) == "topic:/out"]
    assert found
    for sink in found:
        sources = (*sink.data, *sink.control) if way.way == "control" else sink.data
        assert ("topic:/in" in set(map(str, sources))) == (way.way != "clean")
