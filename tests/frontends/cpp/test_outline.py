# SPDX-License-Identifier: Apache-2.0
"""Promise: what a file declares is found under its full name, wherever it is written."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import pytest

from frontends.cpp.units import prepared
from rosward.frontends.cpp.outline import Declared, members, outline
from rosward.frontends.cpp.parse import CppParser, Parsed
from rosward.ir.symbols import SymbolKind


def declared(text: str) -> list[str]:
    result = CppParser().parse(prepared(text))
    assert isinstance(result, Parsed)
    assert result.troubles == ()
    return list(_shown(result, outline(result).declared))


def _shown(parsed: Parsed, found: Iterable[Declared]) -> Iterator[str]:
    for d in found:
        name = "::".join([*d.scope, *(part.name for part in d.before), d.label])
        yield f"{d.kind.value} {name}{'<>' * len(d.templates)}{' {}' * d.defined}{' ?' * len(d.choices)}"
        if d.kind is SymbolKind.CLASS:
            yield from _shown(parsed, members(parsed, d))


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("namespace a { namespace b { int x; } } namespace a::c { int y = 1, * z; }", ["variable a::b::x", "variable a::c::y", "variable a::c::z"]),
        ("namespace { int hidden; } inline namespace v1 { int x; } namespace a::inline b { int y; }",
         ["variable ::hidden", "variable x", "variable a::y"]),
        ("class A : public B { public: A(); ~A(); explicit A(int x) : x_(x) {} int x_ = 1; static constexpr const char * k = \"\"; };",
         ["class A {}", "function A::A", "function A::~A", "function A::A {}", "variable A::x_", "variable A::k"]),
        ("class A; struct B { struct C { int d; } c; enum { E1, E2 }; };",
         ["class A", "class B {}", "class B::C {}", "variable B::C::d", "variable B::c", "enumerator B::E1", "enumerator B::E2"]),
        ("enum class Mode : int { A, B = 2 }; enum Old { C };", ["enum Mode {}", "enum Old {}", "enumerator C"]),
        ("namespace lamp { Lamp::Lamp(int x) : Node(\"a\") {} void Lamp::Inner::f() const {} }",
         ["function lamp::Lamp::Lamp {}", "function lamp::Lamp::Inner::f {}"]),
        ("std::vector<pumps::Pump> pumps::make_pumps(int count) { return {}; }", ["function pumps::make_pumps {}"]),
        ("int main(int argc, char ** argv) { class Local {}; int x; }", ["function main {}"]),
        ("template<typename T> struct Topic; template<> struct Topic< Imu > { static constexpr int n = 1; };",
         ["class Topic<>", "class Topic<Imu><> {}", "variable Topic<Imu>::n"]),
        ("template<class T> void Hub<T>::add(T & x) {}", ["function Hub::add<> {}"]),
        ("template<typename T> T const & f(const T &); template<typename T> using P = std::shared_ptr<T>;", ["function f<>", "alias P<>"]),
        ("using A = int; typedef int B; using std::string; using namespace std::chrono; namespace fs = std::filesystem; using Base::Base;",
         ["alias A", "alias B", "using string", "using namespace std::chrono", "namespace alias fs", "using Base"]),
        ("bool operator == (const A & a, const A & b); struct A { A & operator+=(int); operator bool() const; void operator()() {} };",
         ["function operator==", "class A {}", "function A::operator+=", "function A::operator bool", "function A::operator() {}"]),
        ("struct A { operator const B *() const; }; A::operator const B *() const { return b; }",
         ["class A {}", "function A::operator const B*", "function A::operator const B* {}"]),
        ("int (*handler)(int); std::function<void(int)> g; int table[3] = {1, 2, 3}; extern \"C\" { void c_function(int); }",
         ["variable handler", "variable g", "variable table", "function c_function"]),
        ("auto f(int x) -> std::string; int & g(); const char * const * h(int);", ["function f", "function g", "function h"]),
        ("#ifdef NDEBUG\nvoid f() {}\n#else\nvoid f() { g(); }\n#endif", ["function f {} ?", "function f {} ?"]),
        ("struct A { virtual void f() = 0; void g() = delete; A() = default; friend void h(A &); };",
         ["class A {}", "function A::f", "function A::g", "function A::A"]),
        ("namespace n { struct A { friend bool operator<(const A &, const A &) { return true; } }; }",
         ["class n::A {}", "function n::operator< {}"]),
        ("typedef struct { int x; } Point; struct { int y; } p; struct Q { union { int a; float b; }; };",
         ["class Point {}", "variable Point::x", "class <unnamed 33> {}", "variable <unnamed 33>::y", "variable p",
          "class Q {}", "variable Q::a", "variable Q::b"]),
    ],
)  # fmt: skip
def test_names(text: str, expected: list[str]) -> None:
    assert declared(text) == expected


def test_scopes_that_would_not_end() -> None:
    result = CppParser().parse(prepared("namespace a {" * 3_000 + "}" * 3_000))
    assert isinstance(result, Parsed)
    assert outline(result).declared == []
