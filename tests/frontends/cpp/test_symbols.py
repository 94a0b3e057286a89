# SPDX-License-Identifier: Apache-2.0
"""Promise: the names of a program are those that its files declare together, each thing once."""

from __future__ import annotations

from collections.abc import Mapping

import pytest

from frontends.cpp.units import preprocessor
from rosward.frontends.cpp.program import SymbolStore
from rosward.frontends.cpp.symbol import CppSymbol
from rosward.frontends.cpp.symbols import CppSymbols
from rosward.ir.symbols import SymbolKind, TypePattern


def program(files: Mapping[str, str], *sources: str) -> CppSymbols:
    store = SymbolStore(preprocessor(files))
    return store.symbols([(path, ("include",), ()) for path in sources or ("main.cpp",)]).symbols


def one(text: str, name: str, *scope: str) -> CppSymbol:
    found = program({"main.cpp": text}).at(scope, name)
    assert len(found) == 1
    return found[0]


def shown(symbols: CppSymbols, name: str, *scope: str) -> list[str]:
    return [f"{s.kind.value} {s.place.file}:{s.place.line}{' {}' * s.defined}" for s in symbols.at(scope, name)]


LAMP = """\
#pragma once
namespace lamp {
struct Lamp {
  explicit Lamp(const std::string & name = "lamp");
  virtual void on(int level = 1, bool soft = false);
  void on(const Mode & mode) const;
  static int count();
  static int made;
  enum Mode { DIM, FULL };
  struct Bulb { int watts = 3; };
};
}
"""


def test_a_function_is_its_declaration_and_its_definition() -> None:
    symbols = program(
        {
            "include/lamp.hpp": LAMP,
            "main.cpp": '#include "lamp.hpp"\nusing namespace lamp;\nLamp::Lamp(const std::string & name) {}\n'
            "void Lamp::on(int level, bool) {}\nvoid lamp::Lamp::on(Mode const & mode) const {}\n"
            "int Lamp::count() { return made; }\nint Lamp::made = 0;",
        }
    )
    assert shown(symbols, "on", "lamp", "Lamp") == ["function main.cpp:4 {}", "function main.cpp:5 {}"]
    loud, by_mode = symbols.at(("lamp", "Lamp"), "on")
    assert [p.default for p in loud.parameters] == [True, True]
    assert [d.node.text for d in loud.defaults if d is not None] == [b"1", b"false"]
    assert (loud.virtual, by_mode.virtual) == (True, False)
    assert (loud.leading, symbols.at(("lamp", "Lamp"), "count")[0].leading) == (1, 0)
    assert shown(symbols, "made", "lamp", "Lamp") == ["variable main.cpp:7"]
    assert shown(symbols, "Lamp", "lamp", "Lamp") == ["function main.cpp:3 {}"]
    assert shown(symbols, "FULL", "lamp", "Lamp") == shown(symbols, "FULL", "lamp", "Lamp", "Mode")
    assert [m.name for m in symbols.at(("lamp",), "Lamp")[0].members] == [
        "Lamp", "on", "on", "count", "made", "Mode", "DIM", "FULL", "Bulb",
    ]  # fmt: skip
    assert symbols.variables == [*symbols.at(("lamp", "Lamp"), "made")]


@pytest.mark.parametrize(
    "before",
    ["using lamp::Lamp;", "using namespace lamp;", "using Lamp = lamp::Lamp;", "namespace l = lamp; using l::Lamp;"],
)
def test_a_definition_is_where_its_class_is(before: str) -> None:
    files = {"include/lamp.hpp": LAMP, "main.cpp": f'#include "lamp.hpp"\n{before}\nint Lamp::count() {{ return 1; }}'}
    assert shown(program(files), "count", "lamp", "Lamp") == ["function main.cpp:3 {}"]


def test_a_constant_of_a_source_is_its_own() -> None:
    symbols = program(
        {
            "include/k.hpp": "const int SHARED = 1; extern const int GLOBAL;",
            "a.cpp": '#include "k.hpp"\nconst int K = 1; const int GLOBAL = 2; namespace { int hidden; } static void f() {}',
            "b.cpp": '#include "k.hpp"\nconst int K = 2; static void f() {} int main() {}',
        },
        "a.cpp",
        "b.cpp",
    )
    assert [(s.unit, s.place.file) for s in symbols.at((), "K")] == [("a.cpp", "a.cpp"), ("b.cpp", "b.cpp")]
    assert [s.unit for s in symbols.at((), "f")] == ["a.cpp", "b.cpp"]
    assert [s.unit for name in ("SHARED", "GLOBAL") for s in symbols.at((), name)] == ["", ""]
    assert [s.unit for s in symbols.at(("",), "hidden")] == ["a.cpp"]
    assert symbols.main is not None
    assert symbols.main.place.file == "b.cpp"
    assert [v.name for v in symbols.variables] == ["SHARED", "K", "GLOBAL", "K", "hidden"]


def test_inline_namespaces_are_not_seen() -> None:
    symbols = program({"main.cpp": "namespace a { inline namespace v1 { int x; struct C { int y; }; } }"})
    assert shown(symbols, "x", "a") == shown(symbols, "x", "a", "v1") == ["variable main.cpp:1"]
    assert shown(symbols, "y", "a", "v1", "C") == ["variable main.cpp:1"]
    assert symbols.is_namespace(("a", "v1"))


def test_members_of_templates() -> None:
    symbols = program(
        {
            "main.cpp": "template<class T, int N> struct Box { void f(); template<class U> void g(U u); void h(); };\n"
            "template<class T, int N> void Box<T, N>::f() {}\n"
            "template<class T, int N> template<class U> void Box<T, N>::g(U u) {}\n"
            "template<> struct Box<int, 3> { int x; };\n"
            "template<> void Box<char, 1>::h() {}\n"
            "template<typename T, typename... Args> void make(Args &&... args);\n"
            "template<> void make<int>() {}"
        }
    )
    f, g = symbols.at(("Box",), "f")[0], symbols.at(("Box",), "g")[0]
    assert (f.defined, f.template, f.leading) == (True, None, 1)
    assert g.template is not None
    assert [(p.name, p.pack) for p in g.template] == [("U", False)]
    assert [c.inner for c in symbols.at((), "Box")] == [("Box",), ("Box<int,3>",)]
    special = symbols.at((), "Box")[1]
    assert special.specialises == (TypePattern(builtin="int"), TypePattern(builtin="3"))
    assert shown(symbols, "x", "Box<int,3>") == ["variable main.cpp:4"]
    assert shown(symbols, "h", "Box<char,1>") == ["function main.cpp:5 {}"]
    general, for_int = symbols.at((), "make")
    assert general.parameters[0].pack
    assert for_int.template == ()


def test_what_using_names() -> None:
    symbols = program(
        {
            "main.cpp": "using namespace std::chrono_literals; namespace a { using namespace ::b; } namespace fs = std::filesystem;\n"
            "using std::string; using ::c::d;"
        }
    )
    assert [s.target for s in symbols.used(())] == [("std", "chrono_literals")]
    assert [s.target for s in symbols.used(("a",))] == [("", "b")]
    assert [symbols.at((), n)[0].target for n in ("fs", "string", "d")] == [
        ("std", "filesystem"), ("std", "string"), ("", "c", "d"),
    ]  # fmt: skip


def test_words_and_marks() -> None:
    node = one(
        'class [[rosward::node_class]] Node { public: template<class M = int> [[rosward::creator("pub", "x")]] P<M> create(int q = 1);\n'
        "virtual void f() = 0; Node() = default; Node(const Node &) = delete; const int & r; static constexpr auto k = 1; };",
        "Node",
    )
    members = {m.name: m for m in node.members}
    assert node.marks == {"node_class": ()}
    assert members["create"].marks == {"creator": ("pub", "x")}
    assert members["f"].marks == {"abstract": ()}
    assert members["f"].virtual
    assert members["r"].reference
    assert members["r"].leading == 1
    assert (members["k"].static, members["k"].constant) == (True, True)
    assert shown(program({"main.cpp": "struct A { A() = default; A(const A &) = delete; };"}), "A", "A") == [
        "function main.cpp:1"
    ]


@pytest.mark.parametrize(
    ("parameter", "pattern"),
    [
        ("const std::vector<T *> & v", TypePattern(("std", "vector"), (TypePattern(("T",), pointers=1),), reference="&", const=True)),
        ("unsigned int const & b", TypePattern(builtin="unsigned int", reference="&", const=True)),
        ("typename T::X c", TypePattern(("T", "X"))),
        ("A<T>::type c", TypePattern(builtin="A<T>::type")),
        ("std::function<void(int)> f", TypePattern(("std", "function"),
         (TypePattern(builtin="function", arguments=(TypePattern(builtin="void"), TypePattern(builtin="int"))),))),
        ("char * argv[]", TypePattern(builtin="char", pointers=2)),
        ("int (&table)[3]", TypePattern(builtin="int", pointers=1, reference="&")),
        ("std::tuple<Ts...> && t", TypePattern(("std", "tuple"), (TypePattern(("Ts",), pack=True),), reference="&&")),
        ("auto x", TypePattern(builtin="auto")),
        ("struct A a", TypePattern(("A",))),
        ("decltype(y) x", TypePattern(builtin="decltype(y)")),
    ],
)  # fmt: skip
def test_types_as_they_are_written(parameter: str, pattern: TypePattern) -> None:
    assert one(f"void f({parameter}) {{}}", "f").parameters[0].type == pattern


def test_parameters_of_c() -> None:
    assert one("void f(void);", "f").parameters == ()
    last = one("int printf(const char * format, ...);", "printf").parameters[-1]
    assert (last.name, last.pack) == ("", True)


def test_what_only_the_preprocessor_knows_is_there_twice() -> None:
    found = program({"main.cpp": "#ifdef NDEBUG\nvoid f() {}\n#else\nvoid f() {}\n#endif"}).at((), "f")
    assert [s.sure for s in found] == [False, False]


def test_local_classes() -> None:
    f = one("namespace a { void f() { struct Local { int x; void g() {} }; } }", "f", "a")
    body = f.declared.node.child_by_field_name("body")
    assert body is not None
    local = f.written.local(body.named_children[0])
    assert local is not None
    assert (local.kind, local.inner) == (SymbolKind.CLASS, ("a", "f()", "Local"))
    assert [m.name for m in local.members] == ["x", "g"]
