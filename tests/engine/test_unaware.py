# SPDX-License-Identifier: Apache-2.0
"""Functions in C++ that know nothing of ROS, and take many steps, are not followed to the end; nothing that a program creates is lost by that."""

from __future__ import annotations

import fnmatch
import json
from pathlib import Path
from typing import Final

import pytest
from compiled import interpreted
from sampling import sample

import rosward
from rosward.engine.budget import Budget
from rosward.engine.cpp import linked
from rosward.outputs.documents.network_json import network_json

_TOOLS: Final = """
#pragma once
#include <functional>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>
namespace tools {
const std::string PREFIX = "p";
struct Pair { std::string first; std::string second; };
struct Inner { std::string name = "inner"; std::function<void()> act; };
struct Base { virtual ~Base() {} virtual std::string name() const { return "base"; } };
class Box {
public:
  Box() {}
  void set(const std::string & name) { name_ = name; }
  void fill(int count) { for (int i = 0; i < count; i++) names_.push_back("n" + std::to_string(i)); }
  std::string & ref() { return name_; }
  Inner & inner() { return inner_; }
  Inner * pointer() { return &inner_; }
  std::shared_ptr<Inner> shared() { return shared_; }
  Box & chain() { name_ += "c"; return *this; }
  void call() { if (inner_.act) inner_.act(); }
  std::string get() const { return name_; }
  std::map<std::string, std::string> table_;
  std::vector<std::string> names_;
  std::string name_ = "box";
  Inner inner_;
  std::shared_ptr<Inner> shared_ = std::make_shared<Inner>();
};
inline std::string join(const std::string & a, const std::string & b) { return a + "/" + b; }
inline void assign(std::string & to, const std::string & from) { to = from; }
inline void assign_by(std::string * to, const std::string & from) { *to = from; }
inline void rename(Pair & pair) { pair.first = pair.second; }
inline void rename_in(std::vector<Pair> & pairs) { for (auto & each : pairs) each.first = each.second; }
inline void each(const std::vector<std::string> & names, const std::function<void(const std::string &)> & act) { for (auto & n : names) act(n); }
template<typename T> void visit(T & visited, const std::string & name) { visited.accept(name); }
template<typename T> std::string make_name() { return T::label(); }
inline std::string name_of(const Base & base) { return base.name(); }
inline std::unique_ptr<Pair> made(const std::string & name) { auto p = std::make_unique<Pair>(); p->first = name; return p; }
inline Pair pair(const std::string & name) { return {name, name}; }
inline std::vector<std::string> list(const std::string & name) { return {name + "0", name + "1"}; }
inline bool lacks(const std::string & name) { if (name.empty()) throw std::runtime_error("empty"); return false; }
inline const std::string & same(const std::string & name) { return name; }
inline void put(std::map<std::string, std::string> & table, const std::string & key) { table[key] = key + "v"; }
inline void swap(std::string & a, std::string & b) { std::string c = a; a = b; b = c; }
inline std::string count(int n) { return n > 0 ? count(n - 1) + "x" : PREFIX; }
template<typename T> std::string written(const T & value) { std::string to = "w"; to_text(to, value); return to; }
template<typename T> std::string written_all(const std::vector<T> & values) { return written(values.at(0)); }
}
"""
_SHAPES: Final = """
#pragma once
namespace shapes {
struct Square { int side = 1; };
enum class Colour { RED, BLUE };
}
"""
_MAIN: Final = """
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"
#include "shapes.hpp"
#include "tools.hpp"
rclcpp::Node::SharedPtr node;
std::vector<rclcpp::PublisherBase::SharedPtr> kept;
void make(const std::string & name) { kept.push_back(node->create_publisher<std_msgs::msg::String>(name, 1)); }
struct Maker {
  std::string before = "m";
  void accept(const std::string & name) { make(before + name); }
  static std::string label() { make("label"); return "l"; }
};
struct Derived : tools::Base { std::string name() const override { make("derived"); return "d"; } };
namespace shapes {
void to_text(std::string & to, const Square & square) { make("square"); to = "s" + std::to_string(square.side); }
void to_text(std::string &, Colour) { make("colour"); }
}
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  node = std::make_shared<rclcpp::Node>("n");
  for (int turn = 0; turn < 2; turn++) {
    ROW
  }
  rclcpp::spin(node);
}
"""
_ROWS: Final = {
    'make(tools::join("a", "b"));': ["a/b"],
    'std::string s = "a"; tools::assign(s, "z"); make(s);': ["z"],
    'std::string s = "a"; tools::assign_by(&s, "z"); make(s);': ["z"],
    'tools::Pair p{"a", "b"}; tools::rename(p); make(p.first);': ["b"],
    'std::vector<tools::Pair> p{{"a", "b"}}; tools::rename_in(p); make(p[0].first);': ["b"],
    'tools::each({"a", "b"}, [](const std::string & n) { make(n); });': ["a", "b"],
    'Maker m; tools::visit(m, "v");': ["mv"],
    "make(tools::make_name<Maker>());": ["label", "l"],
    "Derived d; make(tools::name_of(d));": ["derived", "d"],
    'make(tools::made("q")->first);': ["q"],
    'make(tools::pair("q").second);': ["q"],
    'for (auto & n : tools::list("q")) make(n);': ["q0", "q1"],
    'try { tools::lacks(""); make("there"); } catch (const std::exception &) { make("caught"); }': ["caught"],
    'make(tools::same("s"));': ["s"],
    'std::map<std::string, std::string> t; tools::put(t, "k"); make(t["k"]);': ["kv"],
    'std::map<std::string, std::string> t; tools::put(t, "k"); for (auto & [k, v] : t) make(k);': ["k"],
    'std::string a = "a", b = "b"; tools::swap(a, b); make(a + "_" + b);': ["b_a"],
    "make(tools::count(3));": ["pxxx"],
    'tools::Box b; b.set("s"); make(b.get());': ["s"],
    'tools::Box b; b.fill(2); for (auto & n : b.names_) make(n);': ["n0", "n1"],
    'tools::Box b; b.ref() = "r"; make(b.get());': ["r"],
    'tools::Box b; b.inner().name = "i"; make(b.inner_.name);': ["i"],
    'tools::Box b; b.pointer()->name = "i"; make(b.inner().name);': ["i"],
    'tools::Box b; b.shared()->name = "i"; make(b.shared_->name);': ["i"],
    'tools::Box b; b.inner().act = []() { make("acted"); }; b.call();': ["acted"],
    'tools::Box b; b.inner_.act = []() { make("acted"); }; b.call();': ["acted"],
    'tools::Box b; b.chain().chain(); make(b.name_);': ["boxcc"],
    'tools::Box b; auto f = [&b]() { b.set("f"); }; f(); make(b.name_);': ["f"],
    'tools::Box b; auto f = std::bind(&tools::Box::set, &b, "bound"); f(); make(b.get());': ["bound"],
    'auto b = std::make_shared<tools::Box>(); auto c = b; c->set("two"); make(b->get());': ["two"],
    'std::vector<tools::Box> b(2); b[1].set("second"); make(b[1].get()); make(b[0].get());': ["second", "box"],
    'std::vector<std::string> v{"a"}; tools::assign(v[0], "e"); make(v[0]);': ["e"],
    "shapes::Square s; make(tools::written(s));": ["square", "s1"],
    "make(tools::written_all(std::vector<shapes::Square>(1)));": ["square", "s1"],
    "make(tools::written(shapes::Colour::BLUE));": ["colour", "w"],
    'static tools::Box b; b.set("kept"); make(b.get());': ["kept"],
}  # fmt: skip


class _All(set[str]):
    def __contains__(self, key: object) -> bool:
        return True


class _AllLarge(linked.Unaware):
    """As if each function had taken many steps before."""

    def __init__(self) -> None:
        super().__init__()
        self.large = _All()


@interpreted
@pytest.mark.parametrize("row", sample(_ROWS, 4))
def test_nothing_is_lost(row: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Each name is there, or a pattern that has it."""
    (tmp_path / "tools.hpp").write_text(_TOOLS, encoding="utf-8")
    (tmp_path / "shapes.hpp").write_text(_SHAPES, encoding="utf-8")
    (tmp_path / "main.cpp").write_text(_MAIN.replace("ROW", row), encoding="utf-8")
    followed = json.loads(network_json(rosward.extract(tmp_path, budget=Budget(unaware=10**9)).network))
    monkeypatch.setattr(linked, "Unaware", _AllLarge)
    told = json.loads(network_json(rosward.extract(tmp_path, budget=Budget(unaware=0)).network))
    known = [each["name"] for node in told["nodes"] for each in node["publishers"]]
    for name in _ROWS[row]:
        assert f"/{name}" in {topic["name"] for topic in followed["topics"]}
        assert any(fnmatch.fnmatchcase(f"/{name}", pattern) for pattern in known)
