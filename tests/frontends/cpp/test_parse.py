# SPDX-License-Identifier: Apache-2.0
"""Promise: C++ as people write it is parsed whole; what is not understood is told by its line; no text takes for ever."""

from __future__ import annotations

import pytest

from frontends.cpp.units import prepared
from rosward.findings import Finding
from rosward.frontends.cpp.parse import CppParser, Parsed


def parsed(text: str) -> Parsed | Finding:
    return CppParser().parse(prepared(text))


@pytest.mark.parametrize(
    "text",
    [
        "class A : public rclcpp::Node { public: A() : Node(\"a\") { pub_ = create_publisher<M>(\"x\", 10); } };",
        "template<typename ... Ts> class Hub { Hub() { (add<Ts>(), ...); } };",
        "void f(const std::vector<int> & x = {});",
        "struct A { explicit A(const std::string & t = {}) : t_(t) {} };",
        "auto f = [this, x = std::move(y)](auto && ... args) mutable -> int { return g(args...); };",
        "void f() { if constexpr (std::is_same_v<T, M>) { a(); } else { b(); } }",
        "void f() { auto [a, b] = g(); for (auto & [k, v] : m) { h(k, v); } }",
        "void f() { goal_ = typename ActionT::Goal(); }",
        "void f() { this->template create_publisher<T>(\"x\", 1); }",
        "template<class U, typename std::enable_if<true>::type * = nullptr> struct A { template<class V, int * =\n nullptr> void f(); };",
        "template<class F> struct R<F, decltype(call(std::declval<F>(), 1), void())> {}; using A = decltype(a->b(c, d), e);",
        "void f() { held.~unexpected<E>(); p->~Tree<A<int>, B>(); x = ~a < b; }",
        "void f() { delete[] (v); delete [] (v[0]); delete (w); }",
        "void f() { if (a) v(i) = 0; else v(i, j + 1) = 0; m(i) =  0; } struct P { virtual void g(int a) = 0; virtual int\n h(X) = 0; };",
        "void f() { g(a, typename T::x{}, typename std::decay<U>::type(b)); o =\n typename decltype(c)::element_type::S{}; }",
        "void g(typename T::type a, typename std::vector<T>::const_iterator b = {}, typename T::type (*c)(int) = nullptr);",
        "inline constexpr char kSwitch[] = \"switch\"; namespace a::b { enum class E : int { X, Y }; }",
        "template<> struct Topic<sensor_msgs::msg::Imu> { static constexpr const char * name = \"imu\"; };",
        "using namespace std::chrono_literals; auto t = 100ms; auto s = \"x\"s;",
        "RCLCPP_COMPONENTS_REGISTER_NODE(a::B)",
        "#ifdef NDEBUG\nvoid f() {}\n#else\nvoid f() { g(); }\n#endif",
    ],
)  # fmt: skip
def test_ordinary_code(text: str) -> None:
    result = parsed(text)
    assert isinstance(result, Parsed)
    assert result.troubles == ()


def test_what_is_not_understood_is_told_and_what_stands_around_it_is_there() -> None:
    result = parsed("int a = 1;\nint b = @ $ 2;\nint c = 3;")
    assert isinstance(result, Parsed)
    assert {t.first for t in result.troubles} == {2}
    assert [(f.code, f.place.line) for f in result.findings][:1] == [("RW206", 2)]
    names = [n.text for n in result.tree.root_node.children if n.type == "declaration"]
    assert names[0] == b"int a = 1;"
    assert names[-1] == b"int c = 3;"


def test_the_place_of_a_node() -> None:
    result = parsed("#define N 5\n\n  int a = N;\n  int b = 5;")
    assert isinstance(result, Parsed)
    assert [str(result.place(n)) + f":{result.place(n).column}" for n in result.tree.root_node.children] == [
        "main.cpp:3:1",
        "main.cpp:4:3",
    ]


def test_a_file_is_parsed_once() -> None:
    file, parser = prepared("int a;"), CppParser()
    assert parser.parse(file) is parser.parse(file)


@pytest.mark.parametrize(
    "text",
    [
        "A<" * 60_000,
        "int x = " + "(" * 100_000,
        "{" * 100_000,
        "int x = " + "1+" * 50_000 + "1;",
        "\x01\x7f]}[" * 20_000,
    ],
)
def test_texts_that_would_not_end(text: str) -> None:
    result = parsed(text)
    assert isinstance(result, Parsed) or result.code == "RW201"


def test_too_large() -> None:
    result = parsed("int a;\n" * 300_000)
    assert isinstance(result, Finding)
    assert result.code == "RW003"
