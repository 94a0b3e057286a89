# SPDX-License-Identifier: Apache-2.0
"""Promise: a file counts as knowing nothing of ROS only where nothing in it can come to ROS, or keep something between two calls."""

from __future__ import annotations

import pytest

from .test_symbols import program

_MAIN = '#include "rclcpp/rclcpp.hpp"\n#include "tools.hpp"\n#include "ros.hpp"\nint main() { go(); rclcpp::spin(make()); }\n'
_ROS = "#pragma once\n#include <rclcpp/rclcpp.hpp>\nint announce(int);\nrclcpp::Node::SharedPtr make();\nclass Station {};\nextern int counter;\n"


def _is_unaware(tools: str, **others: str) -> bool:
    files = {f"{name}.hpp" if name != "extra" else "extra.cpp": text for name, text in others.items()}
    sources = ["main.cpp", "extra.cpp"] if "extra" in others else ["main.cpp"]
    symbols = program({"main.cpp": _MAIN, "ros.hpp": _ROS, "tools.hpp": tools, **files}, *sources)
    assert "main.cpp" not in symbols.unaware
    assert "ros.hpp" not in symbols.unaware
    return "tools.hpp" in symbols.unaware


@pytest.mark.parametrize(
    "tools",
    [
        "#include <string>\n#include <vector>\ninline int go() { return 1; }",
        "#include <math.h>\n#include <Eigen/Dense>\n#include <geometry_msgs/msg/pose.hpp>\ninline int go() { return 1; }",
        "const int N = 3; constexpr double PI = 3.14; inline int go() { static const int kept = 2; return kept; }",
        "class Box { public: static int count(); static constexpr int N = 2; int field = 1; }; static int help(int a) { return a; }",
        'extern "C" { int c_function(int); }\nstruct Point { double x; double y; };',
        "template<typename T> T twice(T value) { return value + value; }",
        "enum class Mode { A, B }; typedef int Number; using Name = int;",
        'static const char * const NAME = "a"; const std::vector<std::string> NAMES = {"a"}; static constexpr const char * B = "b";',
    ],
)
def test_it_knows_nothing(tools: str) -> None:
    assert _is_unaware(tools)


@pytest.mark.parametrize(
    "tools",
    [
        '#include "rclcpp/rclcpp.hpp"\ninline int go() { return 1; }',
        '#include "ros.hpp"\ninline int go() { return 1; }',
        "#include <vendor/unknown.hpp>\ninline int go() { return 1; }",
        '#include "missing.hpp"\ninline int go() { return 1; }',
        "void use(rclcpp::Node * node);",
        "template<typename N> auto help(N & node) { return node.create_publisher(); }",
        "template<typename P> void send(P & to) { to.publish(1); }",
        "inline int go() { return announce(1); }",
        "struct Holder { Station * station; };",
        "inline int go() { return counter++; }",
        "int kept = 0;",
        "static int kept;",
        "inline int next() { static int kept = 0; return kept++; }",
        "inline int & next() { static std::vector<int> kept(5); return kept[0]; }",
        "inline int next() { thread_local int kept; return kept; }",
        "class Box { static inline int count = 0; };",
        "class Box { static int count; };",
        "template<typename T> class Box { static T count; };",
        "extern int elsewhere;",
        "namespace a { namespace b { std::string name; } }",
        "inline auto & next() { static std::map<const char *, int> kept; return kept; }",
        "inline auto & next() { static const auto kept = std::make_unique<int>(1); return *kept; }",
        "struct Box { int kept = 1; }; inline Box & next() { static Box * const box = new Box(); return *box; }",
        "struct Box { mutable int kept = 1; }; const Box box;",
        "const std::shared_ptr<int> kept = std::make_shared<int>(1);",
        'static const char * kept = "a";',
    ],
)
def test_it_may_know_something(tools: str) -> None:
    assert not _is_unaware(tools)


def test_what_is_defined_elsewhere_counts() -> None:
    logger = "class Logger { public: void log(int value); };"
    assert _is_unaware(logger)
    assert not _is_unaware(logger, extra='#include "tools.hpp"\n#include "rclcpp/rclcpp.hpp"\nvoid Logger::log(int) {}')
    assert not _is_unaware("void say(int);", extra='#include "tools.hpp"\n#include "ros.hpp"\nvoid say(int) {}')


def test_operators_count() -> None:
    pair = "struct Pair { int a; }; template<typename T> bool same(T a, T b) { return a == b; }"
    assert _is_unaware(
        pair, extra='#include "ros.hpp"\nstruct Other {};\nbool operator==(Other a, Other b) { return true; }'
    )
    assert not _is_unaware(
        pair, extra='#include "tools.hpp"\n#include "ros.hpp"\nbool operator==(Pair a, Pair b) { return announce(1); }'
    )


def test_what_includes_it_counts() -> None:
    assert not _is_unaware('#include "inner.hpp"\ninline int go() { return 1; }', inner='#include "ros.hpp"')
    assert not _is_unaware('#include "inner.hpp"\ninline int go() { return 1; }', inner="int kept;")
    assert _is_unaware(
        '#include "inner.hpp"\ninline int go() { return inner(); }', inner="inline int inner() { return 2; }"
    )


def test_what_only_arguments_lead_to_counts_where_these_are_handed() -> None:
    json = "namespace json { template<typename T> void put(T value) { to_json(value); } }"
    user = '#include "ros.hpp"\nnamespace robot { struct Mission {}; void to_json(Mission) { announce(1); } }'
    assert _unaware_of(json, user) == frozenset({("robot",)})
    assert _unaware_of(json + "\nnamespace robot { struct Part {}; }", user) is None
    assert _unaware_of("using robot::to_json;\n" + json, user) is None
    assert _unaware_of(json, user + "\nvoid to_json(int) {}") is None
    assert _unaware_of(json, user + "\nnamespace json { void to_json(int) {} }") is None
    assert _unaware_of(json, user.replace("namespace", "inline namespace", 1)) is None
    assert _unaware_of(json, user, "using namespace robot;") is None
    assert _unaware_of(json, user, "using namespace std::chrono_literals;") == frozenset({("robot",)})
    assert _unaware_of(json, user, "using robot::to_json;") is None
    assert _unaware_of('#include "inner.hpp"\ninline int go() { return 1; }', user, inner=json) == frozenset(
        {("robot",)}
    )


def _unaware_of(tools: str, extra: str, shown: str = "", inner: str = "") -> frozenset[tuple[str, ...]] | None:
    """The namespaces of which nothing may be handed to tools.hpp; None where it may know something of ROS."""
    files = {
        "main.cpp": _MAIN,
        "ros.hpp": _ROS + shown,
        "tools.hpp": tools,
        "inner.hpp": inner,
        "extra.cpp": '#include "tools.hpp"\n' + extra,
    }
    return program(files, "main.cpp", "extra.cpp").unaware.get("tools.hpp")
