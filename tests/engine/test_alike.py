# SPDX-License-Identifier: Apache-2.0
"""Many callbacks that run one function with other arguments are followed as one where they compute much; nothing that a program creates is lost."""

from __future__ import annotations

import fnmatch
from pathlib import Path
from typing import Final

import pytest
from compiled import interpreted

import rosward
from rosward.engine.budget import Budget
from rosward.engine.callbacks import alike
from rosward.ros.entities import EntityKind

_PYTHON: Final = """
import threading
from functools import partial

import rclpy
from rclpy.node import Node
from std_msgs.msg import String
from std_srvs.srv import Trigger


class Part:
    def __init__(self, node, name):
        self.node, self.name = node, name

    def hear(self, message):
        self.node.last = self.name


class Names(Node):
    def __init__(self):
        super().__init__("names")
        self.last, self.kept, self.table = "first", [], {}
        self.create_service(Trigger, "make", self.make)
        for n in range(6):
            REGISTER

    def hear(self, name, message=None):
        HEAR

    def listen(self, name):
        self.create_subscription(String, "late" + name, partial(self.hear, "late" + name), 1)

    def make(self, request, response):
        MAKE
        return response


rclpy.init()
node = Names()
try:
    rclpy.spin(node)
except KeyError as error:
    node.create_publisher(String, error.args[0], 1)
"""
_BY_PARTIAL: Final = 'self.create_subscription(String, f"in{n}", partial(self.hear, f"n{n}"), 1)'
_LAST: Final = "self.create_publisher(String, self.last, 1)"
_OF_PYTHON: Final = {
    (_BY_PARTIAL, "self.last = name", _LAST): "first n0 n5",
    (_BY_PARTIAL, 'self.last = self.last + "/" + name', _LAST): "first first/n0 first/n0/n5 first/n5/n1",
    (_BY_PARTIAL, "self.kept.append(name)", "for each in self.kept: self.create_publisher(String, each, 1)"): "n0 n5",
    (_BY_PARTIAL, "self.table[name] = name", "for each in self.table: self.create_publisher(String, each, 1)"): "n0 n5",
    (_BY_PARTIAL, 'if name == "n5": self.last = "fifth"', _LAST): "first fifth",
    (_BY_PARTIAL, "raise KeyError(name)", "pass"): "n0 n5",
    (_BY_PARTIAL, "if message.data: self.last = name", _LAST): "first n0 n5",
    (_BY_PARTIAL, 'self.last = name\n        if not name.startswith("late"): self.listen(name)', _LAST): "n0 n5 laten0",
    (_BY_PARTIAL, "self.create_publisher(String, name, 1)", "pass"): "n0 n5",
    ('self.create_timer(1.0, lambda n=n: self.hear(f"n{n}"))', "self.last = name", _LAST): "first n0 n5",
    ('self.create_timer(1.0, partial(self.hear, name=f"n{n}"))', "self.last = name", _LAST): "first n0 n5",
    ('self.create_subscription(String, "in", Part(self, f"n{n}").hear, 1)', "pass", _LAST): "first n0 n5",
    ('threading.Thread(target=self.hear, args=(f"n{n}",)).start()', "self.last = name", _LAST): "first n0 n5",
    ('self.create_timer(1.0, partial(partial(self.hear), f"n{n}"))', "self.last = name", _LAST): "first n0 n5",
    (
        'self.create_timer(1.0, partial(self.hear if n < 3 else self.listen, f"n{n}"))',
        "self.last = name",
        _LAST,
    ): "n0 n2 laten3 laten5",
}
_CPP: Final = """
#include <functional>
#include <map>
#include <string>
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"
#include "std_srvs/srv/trigger.hpp"
using std::placeholders::_1;
using std::placeholders::_2;
using String = std_msgs::msg::String;

struct Settings { std::string name; int count = 0; };

class Names : public rclcpp::Node {
public:
  Names() : Node("names") {
    service_ = create_service<std_srvs::srv::Trigger>("make", std::bind(&Names::make, this, _1, _2));
    for (int n = 0; n < 6; n++) {
      auto name = "n" + std::to_string(n);
      std::function<void(String::ConstSharedPtr)> callback = CALLBACK;
      subscriptions_.push_back(create_subscription<String>("in" + std::to_string(n), 1, callback));
    }
  }
  void hear(String::ConstSharedPtr message, const std::string & name, const Settings & settings) { HEAR; }
  void make(std_srvs::srv::Trigger::Request::SharedPtr, std_srvs::srv::Trigger::Response::SharedPtr) { MAKE; }
  std::string last_ = "first";
  std::map<std::string, Settings> table_;
  std::vector<rclcpp::SubscriptionBase::SharedPtr> subscriptions_;
  std::vector<rclcpp::PublisherBase::SharedPtr> publishers_;
  rclcpp::ServiceBase::SharedPtr service_;
};

int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Names>());
}
"""
_BY_BIND: Final = "std::bind(&Names::hear, this, _1, name, Settings{name, n})"
_MAKE: Final = "publishers_.push_back(create_publisher<String>(last_, 1))"
_OF_CPP: Final = {
    (_BY_BIND, "last_ = name", _MAKE): "first n0 n5",
    (_BY_BIND, "last_ = settings.name + std::to_string(settings.count)", _MAKE): "first n00 n55",
    (_BY_BIND, 'if (name == "n5") last_ = message->data.empty() ? "a" : "b"', _MAKE): "first a b",
    (_BY_BIND, "table_[name] = settings", "for (auto & [k, v] : table_) { last_ = v.name; " + _MAKE + "; }"): "n0 n5",
    ("[this, name](String::ConstSharedPtr m) { hear(m, name, {}); }", "last_ = name", _MAKE): "first n0 n5",
    (_BY_BIND, "publishers_.push_back(create_publisher<String>(name, 1))", ""): "n0 n5",
}


def _check(program: Path, template: str, parts: dict[str, str], names: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Each topic is published, or a pattern that has it, where all callbacks that are alike are followed as one."""
    monkeypatch.setattr(alike, "_MANY", 3)
    for word, part in parts.items():
        template = template.replace(word, part)
    program.write_text(template, encoding="utf-8")
    network = rosward.extract(program.parent, budget=Budget(entry_coarse=0)).network
    entities = [e for node in network.nodes for e in node.entities if e.kind is EntityKind.PUBLISHER and not e.system]
    made = {str(e.name) for e in entities} - {"/*"}
    assert all(any(fnmatch.fnmatchcase(f"/{name}", each) for each in made) for name in names.split())


@pytest.mark.parametrize(("parts", "names"), _OF_PYTHON.items())
def test_python(parts: tuple[str, str, str], names: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    written = dict(zip(("REGISTER", "HEAR", "MAKE"), parts, strict=True))
    _check(tmp_path / "main.py", _PYTHON, written, names, monkeypatch)


@interpreted
@pytest.mark.parametrize(("parts", "names"), _OF_CPP.items())
def test_cpp(parts: tuple[str, str, str], names: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    written = dict(zip(("CALLBACK", "HEAR", "MAKE"), parts, strict=True))
    _check(tmp_path / "main.cpp", _CPP, written, names, monkeypatch)
