# SPDX-License-Identifier: Apache-2.0
"""Promise: C++ becomes well-formed operations, and nothing of it is silently left out. `lowering.md` shows what they look like.

`--update-cases` writes it anew.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Final

import pytest

from frontends.cpp.units import preprocessor
from rosward.frontends.cpp.lower.entry import EXPRESSIONS, STATEMENTS
from rosward.frontends.cpp.program import SymbolStore
from rosward.ir import cpp
from rosward.ir.check import check
from rosward.ir.op import Op, walk
from rosward.ir.program import Code
from rosward.ir.symbols import SymbolKind
from rosward.ir.text import code_text

FILE: Final = Path(__file__).with_name("lowering.md")
CASE: Final = re.compile(
    r"(^## (?P<name>[^\n]+)\n.*?^```cpp\n(?P<source>.*?)^```\n\n```ir\n)(?P<expected>.*?)^```$",
    re.DOTALL | re.MULTILINE,
)
CASES: Final = {match["name"]: match for match in CASE.finditer(FILE.read_text(encoding="utf-8"))}


def lowered(source: str, name: str = "f", *scope: str) -> list[Code]:
    """The bodies of the functions of that name."""
    symbols = SymbolStore(preprocessor({"main.cpp": source})).symbols([("main.cpp", (), ())]).symbols
    codes = [s.code for s in symbols.at(scope, name) if s.kind is SymbolKind.FUNCTION and s.code is not None]
    for code in codes:
        assert check(code) == []
    return codes


def operations(code: Code) -> Iterator[Op]:
    for op in walk(code.ops):
        yield op
        if isinstance(op, cpp.MakeLambda):
            yield from operations(op.code)


def unknown(statement: str) -> list[str]:
    """What is said to be unknown in a function with this statement."""
    (code,) = lowered(f"void f() {{ {statement} }}")
    return [f"{op.cause} {op.subject}" for op in operations(code) if isinstance(op, cpp.UnknownValue)]


@pytest.mark.parametrize("name", CASES)
def test_printed(name: str, request: pytest.FixtureRequest) -> None:
    case = CASES[name]
    classes = re.search(r"^struct (\w+) .*\1\(", case["source"], re.DOTALL | re.MULTILINE)
    codes = lowered(case["source"]) or lowered(
        case["source"], classes[1] if classes else "", classes[1] if classes else ""
    )
    found = "\n".join(code_text(code) for code in codes)
    if request.config.getoption("--update-cases", default=False):
        text = FILE.read_text(encoding="utf-8")
        FILE.write_text(text.replace(case[0], f"{case[1]}{found}```"), encoding="utf-8")
        return
    assert found == case["expected"]


@pytest.mark.parametrize(
    ("literal", "value"),
    [
        ("1'000u", 1000), ("0x1Ful", 31), ("0b101", 5), ("017", 15), ("0", 0), ("1.5f", 1.5), ("1e3", 1000.0), (".5", 0.5), ("2.", 2.0),
        ("'a'", "a"), (r"'\n'", "\n"), (r'"a\tb\x41\u00e9\\"', "a\tb\x41\u00e9\\"), ('"a" "b"', "ab"), ('R"(x\\n)"', "x\\n"),
        ('L"w"', "w"), ("true", True), ("nullptr", None),
    ],
)  # fmt: skip
def test_literals(literal: str, value: object) -> None:
    (code,) = lowered(f"auto f() {{ return {literal}; }}")
    (constant, _) = code.ops
    assert repr(getattr(constant, "value", ...)) == repr(value)


@pytest.mark.parametrize(
    ("statement", "expected"),
    [
        ("goto inside; {inside: g();}", ["language goto"]),
        ("int n = sizeof(int);", ["language sizeof"]),
        ("co_await g();", ["language coroutine", "language co_await", "language coroutine"]),
        ("decltype(g()) x = 1;", ["language decltype"]),
        ("asm(\"nop\");", ["language gnu_asm"]),
        ("a.*b; int x = @;", ["syntax int x = @;"]),
        ("g(1, @);", ["syntax , @"]),
        ("continue;", ["syntax continue;"]),
        ("break;", ["syntax break;"]),
        ("switch (1) { case 1: continue; }", ["syntax continue;"]),
        ("switch (1) { g(); case 1: break; }", []),
        ("for (int i = 0; i < 3; i++) ; for (;;) { break; } do { } while (g()); { } ;", []),
        ("Guard guard(mutex_); int h(int); extern int y; struct A; [[maybe_unused]] int z = 1; static_assert(true);", []),
        ("Guard one(std::mutex), two(A()), three{}, four = {}; (a.*m)(1); this->x; int A::* p = &A::x;", ["syntax this"]),
        ("if (int n = g(); n > 1) h(); else if (auto p = k()) p->x(); switch (int n = 1; n) { default: ; }", []),
        ("auto [a, b] = pair; auto && [c, d] = pair; for (auto [e, g] : m) { use(e, g); }", []),
        ("auto a = new T[3]; delete [] a; auto b = new (place) T{1}; T * c = new T; ::delete c;", []),
        ("using namespace std; enum { E1, E2 = 4, E3 }; enum class E : int { X }; typedef int I, * P; I i = E3; P q;", []),
        ("struct L { int x = 1; void go() { x = 2; } } l{3}; l.go(); union U { int a; } u;", []),
        ("f({.a = 1, .b = {2, 3}}); T t{.x = 1}; T{1}; std::vector<int>{1, 2}; (int)x; int(x); T(); typeid(int);", []),
        ("auto a = [=, this, &b] { return [=] { return c + b; }; }; auto d = [&e = g(), h = 1] { return e + h; };", []),
        ("x = y = 1; x += (a, b); int i = 0; i = i++ + ++i; i--; p->x++; ++p->x; v[i] = v[i + 1]; *p = *q; s >> i >> j;", []),
        ("not a; a and b or not c; !a && b || c; ~a; -a; +a; a ? b : c; (a ? b : c) = 1; a == b != (c < d);", []),
        ("a->B::g(); a.B<int>::g<3>(); ::g(); ::A::g<A>(); T::template h<int>(); p->template k<T>(1); o.template m(2);", []),
        ("thread_local int n = 1; static const A a{1}; constexpr int k = 3; const volatile unsigned long long u = 2ull;", []),
        ("throw; throw 1; throw E{}; try { g(); } catch (int) {} catch (E * e) { g(e); }", []),
        ("if constexpr (std::is_same_v<T, int>) { g(); } else { h(); } while (true) if (g()) break; else continue;", []),
        ("a = {1, 2}; return; g({}); g(T{}); v = {{1, 2}, {3}}; m[{1, 2}] = {}; std::string s = {'a', 'b'};", []),
        ("int (*fp)(int) = &g; std::function<void(int, T &)> h; int arr[2][3] = {}; char c[] = \"abc\"; fp(1); (*fp)(2);", []),
    ],
)  # fmt: skip
def test_what_is_understood_and_what_is_told(statement: str, expected: list[str]) -> None:
    assert unknown(statement) == expected


PARTS: Final = frozenset(
    {
        "abstract_array_declarator", "abstract_function_declarator", "abstract_parenthesized_declarator", "abstract_pointer_declarator",
        "abstract_reference_declarator", "alignas_qualifier", "argument_list", "array_declarator", "attribute", "attribute_specifier",
        "attributed_declarator", "base_class_clause", "bitfield_clause", "case_statement", "catch_clause", "character", "condition_clause",
        "constraint_conjunction", "constraint_disjunction", "compound_requirement", "default_method_clause", "delete_method_clause",
        "destructor_name", "else_clause", "enumerator", "enumerator_list", "escape_sequence", "explicit_function_specifier", "field_declaration",
        "field_declaration_list", "field_designator", "field_initializer", "field_initializer_list", "function_declarator",
        "gnu_asm_clobber_list", "gnu_asm_goto_list", "gnu_asm_input_operand", "gnu_asm_input_operand_list", "gnu_asm_output_operand",
        "gnu_asm_output_operand_list", "gnu_asm_qualifier", "init_declarator", "init_statement", "initializer_pair",
        "lambda_capture_initializer", "lambda_capture_specifier", "lambda_default_capture", "literal_suffix", "ms_based_modifier",
        "ms_call_modifier", "ms_declspec_modifier", "ms_pointer_modifier", "ms_restrict_modifier", "ms_signed_ptr_modifier",
        "ms_unaligned_ptr_modifier", "ms_unsigned_ptr_modifier", "nested_namespace_specifier", "new_declarator", "noexcept", "operator_cast",
        "optional_parameter_declaration", "optional_type_parameter_declaration", "parameter_declaration", "parameter_list",
        "parenthesized_declarator", "placeholder_type_specifier", "pointer_declarator", "pointer_type_declarator", "pure_virtual_clause",
        "raw_string_content", "raw_string_delimiter", "ref_qualifier", "reference_declarator", "requirement_seq", "requires_clause",
        "seh_except_clause", "seh_finally_clause", "simple_requirement", "statement_identifier", "storage_class_specifier", "string_content",
        "structured_binding_declarator", "subscript_argument_list", "subscript_designator", "subscript_range_designator",
        "template_argument_list", "template_method", "template_parameter_list", "template_template_parameter_declaration", "throw_specifier",
        "trailing_return_type", "translation_unit", "type_descriptor", "type_parameter_declaration", "type_qualifier", "type_requirement",
        "variadic_declarator", "variadic_parameter_declaration", "variadic_type_parameter_declaration", "virtual_specifier", "auto",
        "declaration_list",
    }
)  # fmt: skip
"""What stands within a statement or expression, and is read with it."""

OUTSIDE: Final = frozenset(
    {
        "concept_definition", "friend_declaration", "function_definition", "linkage_specification", "namespace_definition",
        "template_instantiation",
    }
)  # fmt: skip
"""What stands in no body."""

TOLD: Final = frozenset(
    {
        "extension_expression", "seh_leave_statement", "seh_try_statement", "system_lib_string",
    }
)  # fmt: skip
"""What is no C++ or in nobody's code: `UnknownValue`, as for each kind of node that a later grammar brings."""


def test_each_kind_of_node_has_its_place() -> None:
    """Each is lowered, or read as part of another one, or told."""
    import tree_sitter
    import tree_sitter_cpp

    grammar = tree_sitter.Language(tree_sitter_cpp.language())
    ids = range(grammar.node_kind_count)
    kinds = {
        grammar.node_kind_for_id(i) for i in ids if grammar.node_kind_is_named(i) and grammar.node_kind_is_visible(i)
    }
    kinds = {kind for kind in kinds if kind is not None and not kind.startswith("preproc_")}
    assert kinds - EXPRESSIONS.keys() - STATEMENTS.keys() - PARTS - OUTSIDE == TOLD
    assert kinds >= (PARTS | OUTSIDE | TOLD)


@pytest.mark.parametrize(
    "body",
    [
        "int x = " + "(" * 3_000 + "1" + ")" * 3_000 + ";",
        "{" * 3_000 + "}" * 3_000,
        "if (a) b(); else " * 500 + "c();",
        "x" + ".f()" * 3_000 + ";",
        "auto a = " + "[=] { return " * 300 + "1" + "; }" * 300 + ";",
        "x" + " = x" * 3_000 + ";",
        "x = " + "!" * 3_000 + "x;",
        "x = " + "a ? b : " * 3_000 + "c;",
        "f" + "<f" * 500 + ">" * 500 + "();",
        "x = " + "{" * 500 + "}" * 500 + ";",
        "for (;;++i) " * 100 + "continue;",
        "int " + "*" * 3_000 + "x;",
        "int x" + "[1]" * 3_000 + ";",
        "a" + "::a" * 3_000 + "();",
    ],
)
def test_nesting_without_end(body: str) -> None:
    """What is too deep is told."""
    assert all(len(list(operations(code))) < 100_000 for code in lowered(f"void f() {{ {body} }}"))


@pytest.mark.parametrize(
    "line",
    [
        "int x; g(x);",
        "std::string s; if (a) return;",
        "\n#ifdef NDEBUG\na();\n#endif\n",
        "[&] { x(); };",
        "switch (a) { case 1: break; }",
    ],
)
def test_much_code_takes_little(line: str) -> None:
    """Four times as much takes about four times as many operations."""
    sizes = [sum(1 for code in lowered(f"void f() {{ {line * n} }}") for _ in operations(code)) for n in (200, 800)]
    assert sizes[1] < 8 * sizes[0]


def test_long_code_is_linear() -> None:
    """Chains that lean to the left are as deep as their source is long, and are no nesting."""
    (code,) = lowered("auto f() { return a" + " + b" * 2_000 + " && c" * 2_000 + "; }")
    assert not [op for op in operations(code) if isinstance(op, cpp.UnknownValue)]
