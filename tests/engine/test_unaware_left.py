# SPDX-License-Identifier: Apache-2.0
"""What a function may do that is not followed: make objects lead to each other, throw, return what is derived. What comes of that is not lost."""

from __future__ import annotations

import fnmatch
import json
from pathlib import Path

import pytest
from compiled import interpreted

import rosward
from rosward.engine.budget import Budget
from rosward.engine.cpp import linked
from rosward.outputs.documents.network_json import network_json

from .test_unaware import _AllLarge

_INCLUDES = "#pragma once\n" + "".join(
    f"#include <{name}>\n"
    for name in ("any", "functional", "map", "memory", "sstream", "stdexcept", "string", "vector")
)
_MAIN = """
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"
#include "tools.hpp"
rclcpp::Node::SharedPtr node;
std::vector<rclcpp::PublisherBase::SharedPtr> kept;
std::vector<rclcpp::SubscriptionBase::SharedPtr> heard;
void make(const std::string & name) { kept.push_back(node->create_publisher<std_msgs::msg::String>(name, 1)); }
void mark() { heard.push_back(node->create_subscription<std_msgs::msg::String>("x", 1, [](std_msgs::msg::String::SharedPtr) {})); }
BEFORE
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  node = std::make_shared<rclcpp::Node>("n");
  ROW
  rclcpp::spin(node);
}
"""
_LINK = "struct N { N * next = nullptr; std::any v; std::string s; std::function<void()> f; };\ninline void link(N & a, N & b) { a.next = &b; }"
_ACT = "struct Act { Act() { mark(); } static std::string label() { mark(); return {}; } };"
_GO = "struct Go { void go() { mark(); } };"
_PAIR = "struct Pair { std::string a; };\n"
_NAMES = {
    "a pointer kept, by which something is written later": (
        "struct H { std::string * p = nullptr; void bind(std::string & s) { p = &s; } };",
        'std::string s = "a"; H h; h.bind(s); s = "b"; *h.p = "z"; make(s);',
    ),
    "the same of an object": (_LINK, 'N a, b; link(a, b); b.s = "b"; a.next->s = "z"; make(b.s);'),
    "a reference to a field": (
        'struct B { std::string n = "a"; std::string & ref() { return n; } };',
        'B b; auto & r = b.ref(); b.n = "b"; r = "z"; make(b.n);',
    ),
    "a reference to an element": (
        "inline std::string & at(std::map<std::string, std::string> & m, const std::string & k) { return m[k]; }",
        'std::map<std::string, std::string> m; auto & r = at(m, "k"); m["k"] = "b"; r = "z"; make(m["k"]);',
    ),
    "an object of the result that leads to what it was handed": (
        'struct B { std::string n = "a"; };\nstruct V { B & b; };\ninline V view(B & b) { return V{b}; }',
        'B s; V v = view(s); s.n = "b"; v.b.n = "z"; make(s.n);',
    ),
    "an exception of a class of its own": (
        "struct Error : std::runtime_error { using std::runtime_error::runtime_error; };\n"
        "inline void check(const std::string & a) { throw Error(a); }",
        'try { check("z"); } catch (const std::logic_error &) { } catch (const Error & e) { make(e.what()); }',
    ),
    "an object of a derived class": (
        'struct Shape { virtual ~Shape() {} };\nstruct Square : Shape { std::string n = "z"; };\n'
        "inline std::unique_ptr<Shape> build(int c) { return std::make_unique<Square>(); }",
        "auto s = build(1); if (auto q = dynamic_cast<Square *>(s.get())) make(q->n);",
    ),
    "a singleton behind a constant pointer": (
        'struct R { std::string v = "a"; };\ninline R & only() { static R * const r = new R(); return *r; }\n'
        "inline void set(const std::string & v) { only().v = v; }",
        'only().v = "b"; set("z"); make(only().v);',
    ),
}  # fmt: skip
_MARKS = {
    "a function put in later, called by another way": (_LINK, "", "N a, b; link(a, b); b.f = [] { mark(); }; a.next->f();"),
    "an object put in later": (_LINK, _GO, "N a, b; link(a, b); b.v = std::make_shared<Go>(); std::any_cast<std::shared_ptr<Go>>(a.next->v)->go();"),
    "a function put into a result": (
        "struct E { std::function<void()> f; };\nstruct Bus { std::vector<std::unique_ptr<E>> es;\n"
        "E * add() { es.push_back(std::make_unique<E>()); return es.back().get(); } void run() { for (auto & e : es) e->f(); } };",
        "", "Bus b; b.add()->f = [] { mark(); }; b.run();",
    ),
    "an argument of the template around": (
        "template<class T> struct Outer { struct Inner { std::string run() { return T::label(); } }; Inner inner; };",
        "struct Label { static std::string label() { mark(); return {}; } };", "Outer<Label> o; o.inner.run();",
    ),
    "an argument of a container's type": ("inline void grow(auto & v) { v.emplace_back(); }", _ACT, "std::vector<Act> v; grow(v);"),
    "an argument of a class's template": (
        "template<class T> struct Pool { using V = std::vector<T>; V v; };\ntemplate<class P> void grow(P & p) { p.v.emplace_back(); }",
        _ACT, "Pool<Act> d; grow(d);",
    ),
    "an operator of its objects": (
        _PAIR + "template<class T> bool same(const T & a, const T & b) { return a == b; }",
        "bool operator==(const Pair & a, const Pair & b) { mark(); return a.a == b.a; }", 'same(Pair{"q"}, Pair{"r"});',
    ),
    "one that is called in the same way": (
        _PAIR + "template<class T> std::string str(const T & t) { std::ostringstream s; s << t; return s.str(); }",
        "std::ostream & operator<<(std::ostream & o, const Pair & p) { mark(); return o << p.a; }", 'str(Pair{"q"});',
    ),
    "a singleton that holds functions": (
        "struct R { std::function<void()> f; static R & only() { static R * const r = new R(); return *r; } };\n"
        "inline void fire() { R::only().f(); }",
        "", "R::only().f = [] { mark(); }; fire();",
    ),
    "a switch that is set by a reference": (
        "struct B { bool on = false; bool & ref() { return on; } };", "",
        "B b; auto & r = b.ref(); b.on = false; r = true; if (b.on) mark();",
    ),
}  # fmt: skip


def _told(tools: str, before: str, row: str, folder: Path, monkeypatch: pytest.MonkeyPatch) -> list[str]:
    (folder / "tools.hpp").write_text(_INCLUDES + tools, encoding="utf-8")
    (folder / "main.cpp").write_text(_MAIN.replace("BEFORE", before).replace("ROW", row), encoding="utf-8")
    monkeypatch.setattr(linked, "Unaware", _AllLarge)
    told = json.loads(network_json(rosward.extract(folder, budget=Budget(unaware=0)).network))
    return [each["name"] for node in told["nodes"] for each in (*node["publishers"], *node["subscriptions"])]


@interpreted
@pytest.mark.parametrize("what", _NAMES)
def test_a_name_may_be_what_was_written(what: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    tools, row = _NAMES[what]
    assert any(fnmatch.fnmatchcase("/z", name) for name in _told(tools, "", row, tmp_path, monkeypatch))


@interpreted
@pytest.mark.parametrize("what", _MARKS)
def test_what_is_called_is_found(what: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    assert "/x" in _told(*_MARKS[what], tmp_path, monkeypatch)
