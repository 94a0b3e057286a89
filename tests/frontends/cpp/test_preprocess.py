# SPDX-License-Identifier: Apache-2.0
"""Promise: what the preprocessor leaves of a file is what a compiler would see of it, on the line where it stands, and it always ends."""

from __future__ import annotations

import time

import pytest
from hypothesis import given
from hypothesis import strategies as st
from sampling import sample

from frontends.cpp.units import lines, prepared, preprocessor, translate
from rosward.frontends.cpp.captures import with_plain_captures
from rosward.frontends.cpp.clean import cleaned
from rosward.frontends.cpp.literals import hidden, shown
from rosward.frontends.cpp.macros import EITHER
from rosward.frontends.cpp.suited import suited
from rosward.frontends.cpp.tokens import tokens

CODE = st.text(alphabet="ab1 \n\t\\\"'/*#(){};,.:<>R_=!&|$é", max_size=200)


@given(CODE)
def test_tokens_are_the_text(text: str) -> None:
    assert "".join(tokens(text)) == text


@given(CODE)
def test_cleaning_keeps_the_lines(text: str) -> None:
    assert cleaned(text).count("\n") == text.count("\n")


@given(CODE)
def test_any_text_is_prepared_line_by_line(text: str) -> None:
    assert prepared(text).text.count("\n") == text.count("\n")


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("a // b\nc", "a \nc"),
        ("a /* b\nc */ d", "a \n d"),
        ("a /* b", "a  "),
        ('"// no" /* yes */', '"// no"  '),
        ("a\\\nb\nc", "ab\n\nc"),
        ("// a \\\nb\nc", "\n\nc"),
        ('"a\\\nb" c\nd', '"ab" c\n\nd'),
        ("'\"' // x", "'\"' "),
        ("1'000 // x", "1'000 "),
        ('R"(a\n"b")" c', '"a\\n\\"b\\"" c\n'),
        ('R"x(a)" )x" c', '"a)\\" " c'),
        ('"open\nb', '"open"\nb'),
        ("don't\nb", "don't'\nb"),
    ],
)
def test_comments_splices_and_raw_strings(text: str, expected: str) -> None:
    assert [line.rstrip() for line in cleaned(text).split("\n")] == [line.rstrip() for line in expected.split("\n")]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ('#define T "/" R "/x"\n#define R "ant"\nf(T);', 'f("/" "ant" "/x");'),
        ("#define N 5\nint N1 = N;", "int N1 = 5;"),
        ("#define F(a, b) a + b\nF(1, (2, 3));", "1 + (2, 3);"),
        ("#define S(x) #x\nS(a b); S(\"q\\n\");", 'S; "a b"; "\\"q\\\\n\\"";'.removeprefix("S; ")),
        ("#define C(a, b) a ## b\nint C(x, 1), C(,y);", "int x1, y;"),
        ("#define C(a, b) a##b\n#define D(a, b) C(a, b)\n#define X y\nD(X, X) C(X, X)", "yy XX"),
        ("#define L(...) f(__VA_ARGS__)\nL(1, 2); L();", "f(1, 2); f();"),
        ("#define L(f, ...) p(f, ##__VA_ARGS__)\nL(1, 2);", "p(1,2);"),
        ("#define L(f, args...) p(f, args)\nL(1, 2, 3);", "p(1, 2, 3);"),
        ("#define L(f, ...) p(f __VA_OPT__(,) __VA_ARGS__)\nL(1); L(1, 2);", "p(1 ); p(1 , 2);"),
        ("#define f(x) f(x + 1)\nf(f(1));", "f(f(1 + 1) + 1);"),
        ("#define A B\n#define B A\nA", "A"),
        ("#define F(x) x\nF\nF (1)", "F\n1"),
        ("#define E()\nE() x", "x"),
        ("#define A 1\n#undef A\nA", "A"),
        ('#define N "a"\ng("N", N);', 'g("N", "a");'),
        ("#define F(a) a\nF(1,\n  2)\nx", "F\nx".replace("F", "1")),
    ],
)  # fmt: skip
def test_macros(text: str, expected: str) -> None:
    assert lines(prepared(text).text) == lines(expected)


def test_an_expansion_stays_on_its_line() -> None:
    result = prepared("#define ADD(a, b) \\\n  a + b\nint x;\nint y = ADD(\n  1,\n  2);\nint z;")
    assert [line.strip() for line in result.text.split("\n")] == ["", "", "int x;", "int y = 1 + 2;", "", "", "int z;"]
    assert result.expanded == {4, 5, 6}


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("#define W 1\n#if defined(W) && W\na;\n#else\nb;\n#endif", "a;"),
        ("#ifdef GPS\na;\n#endif\n#if 0\nb;\n#endif\nc;", "c;"),
        ("#ifndef X\na;\n#elif 1\nb;\n#endif", "a;"),
        ("#if 0\n#if 1\na;\n#endif\n#elif (1 + 2 * 3 == 7) && !(4 >> 1 == 1)\nb;\n#else\nc;\n#endif", "b;"),
        ("#if __cplusplus >= 201703L\na;\n#endif\n#ifdef _WIN32\nb;\n#endif", "a;"),
        ("#if RCLCPP_VERSION_GTE(28, 0, 0)\na;\n#else\nb;\n#endif", "a;"),
        ("#if RCLCPP_VERSION_GTE(99, 0, 0)\na;\n#else\nb;\n#endif", "b;"),
        ('#if __has_include("there.hpp")\na;\n#endif\n#if __has_include(<string>)\nb;\n#endif', "a;\nb;"),
        ("#if 0xFF == 255 && 010 == 8 && 1'000 == 1000\na;\n#endif", "a;"),
        ("#if 1 ? 0 : 1\na;\n#else\nb;\n#endif", "b;"),
        ("#if 1\na;", "a;"),
        ("#else\n#endif\n#elif\na;", "a;"),
    ],
)  # fmt: skip
def test_conditions_that_are_known(text: str, expected: str) -> None:
    result = prepared(text, {"include/there.hpp": "#pragma once"})
    assert lines(result.text) == lines(expected)
    assert not result.choices


def test_a_condition_that_nobody_knows_is_kept_both_ways() -> None:
    text = "f();\n#if OPENCV_VERSION_MAJOR > 4\na();\n#elif 0\nb();\n#else\nc();\n#endif\ng();"
    result = prepared(text)
    assert lines(result.text) == ["f();", "a();", "c();", "g();"]
    assert [(c.branch, c.first, c.last, c.complete) for c in result.choices] == [(0, 3, 3, True), (2, 7, 7, True)]
    assert not result.findings


def test_a_macro_of_a_library_from_elsewhere_is_not_known() -> None:
    text = "#include <magic/magic.hpp>\n#ifdef MAGIC_FAST\na();\n#endif\n#ifdef OTHER\nb();\n#endif"
    result = prepared(text)
    assert lines(result.text) == ["a();"]
    assert [(c.branch, c.complete) for c in result.choices] == [(0, False)]


@pytest.mark.parametrize(
    ("before", "one", "other", "behind"),
    [
        ("enum class Side {LEFT,", "RIGHT,", "UP,", "DOWN};"),
        ("A::A(int i) : a_(1),", "b_(i),", "c_(i),", "d_(2) {}"),
        ("int x = 1,", "y = 2,", "z = 2,", "w = 3;"),
        ("f(", "a, b", "c", ");"),
        ("x =", "y +", "z -", "1;"),
        ("try {f();}", "catch (const A & e) {", "catch (const B & e) {", "g(); }"),
        ("class A : public", "B", "C", "{};"),
        ("auto f =", "[](const A & a) {", "[](const B & a) {", "return 1; };"),
        ("h(", "g(a", "g(b, c", "));"),
    ],
)
def test_a_condition_that_cuts_a_statement_is_told(before: str, one: str, other: str, behind: str) -> None:
    result = prepared(f"{before}\n#ifdef NDEBUG\n{one}\n#else\n{other}\n#endif\n{behind}")
    assert lines(result.text) == [before, one, behind]
    assert [(f.code, f.place.line) for f in result.findings] == [("RW206", 2)]


@pytest.mark.parametrize(
    ("before", "one", "other", "behind", "expected"),
    [
        ("int x =", "1", "2", ";", f"{EITHER}(1, 2)"),
        ("", "if (a || b) {", "if (a) {", "f(); }", f"if ({EITHER}(a || b, a)) {{"),
        ("A::A() : sub_{", "Given{*this},", "this,", '"image"} {}', f"{EITHER}(Given{{*this}}, this),"),
        ("f(1,", "a(1, 2)", "a(3, 4)", ");", f"{EITHER}(a(1, 2), a(3, 4))"),
        ("return", "g(a)", "h(a)", ";", f"{EITHER}(g(a), h(a))"),
        ("f(", "new A(1),", "new B(1),", "2);", f"{EITHER}(new A(1), new B(1)),"),
    ],
)
def test_both_branches_of_a_condition_within_a_statement(
    before: str, one: str, other: str, behind: str, expected: str
) -> None:
    result = prepared(f"{before}\n#ifdef NDEBUG\n{one}\n#else\n// other\n{other}\n#endif\n{behind}\nlast();")
    assert lines(result.text) == [line for line in (before, expected, behind, "last();") if line]
    assert result.text.split("\n")[8].strip() == "last();"
    assert not result.findings


@pytest.mark.parametrize(
    ("before", "one", "behind", "expected"),
    [
        ("if (a", "|| b.c()", ") {f();}", f"|| {EITHER}(b.c(), false)"),
        ("x = a", "&& (b || c)", ";", f"&& {EITHER}((b || c), true)"),
        ("if (a) {f();", "} else if (b) {g();", "} else {h();}", f"}} else if ({EITHER}(b, false)) {{g();"),
    ],
)
def test_what_may_stand_in_a_statement_or_not(before: str, one: str, behind: str, expected: str) -> None:
    result = prepared(f"{before}\n#ifdef NDEBUG\n{one}\n#endif\n{behind}")
    assert lines(result.text) == [before, expected, behind]
    assert not result.findings


def test_a_macro_with_two_definitions_is_either() -> None:
    result = prepared('#ifdef NDEBUG\n#define T "a"\n#else\n#define T "b"\n#endif\nf(T);')
    assert lines(result.text) == [f'f({EITHER}("a", "b"));']


def test_an_unsure_definition_of_the_command_line() -> None:
    result = prepared("#ifdef GPU\na();\n#endif\n", definitions=[("GPU", "1", False)])
    assert [c.complete for c in result.choices] == [False]


def test_definitions_of_the_command_line() -> None:
    assert lines(prepared('f(SIDE "_side");', definitions=[("SIDE", '"left"', True)]).text) == ['f("left" "_side");']


HEADERS = {
    "include/demo/a.hpp": '#ifndef A_\n#define A_\n#include "b.hpp"\nint a = B;\n#endif',
    "include/demo/b.hpp": "#pragma once\n#define B 1\nint b;",
    "include/demo/table.inc": "ROW(one)\nROW(two)",
    "include/demo/circle.hpp": '#include "circle.hpp"\nint c;',
}


def test_included_files_come_once_and_first() -> None:
    unit = translate('#include "demo/a.hpp"\n#include <demo/b.hpp>\n#include <vector>\nint m = B;', HEADERS)
    assert [(f.path, lines(f.text)) for f in unit.files] == [
        ("include/demo/b.hpp", ["int b;"]),
        ("include/demo/a.hpp", ["int a = 1;"]),
        ("main.cpp", ["int m = 1;"]),
    ]
    assert unit.files[-1].external == ("vector",)


def test_what_is_included_within_brackets_stands_there() -> None:
    result = prepared('#define ROW(x) #x,\nconst char * names[] = {\n#include "demo/table.inc"\n};\nint last;', HEADERS)
    assert lines(result.text) == ["const char * names[] = {", '"one", "two",', "};", "int last;"]
    assert result.text.split("\n")[4] == "int last;"


def test_files_that_include_each_other() -> None:
    unit = translate('#include "demo/circle.hpp"', HEADERS)
    assert [f.path for f in unit.files] == ["include/demo/circle.hpp", "main.cpp"]


def test_a_header_is_prepared_once_for_all_units_that_see_the_same() -> None:
    include = '#include "demo/a.hpp"'
    files = {"one.cpp": f"#define UNSEEN 1\n{include}", "two.cpp": include, "three.cpp": f"#define a z\n{include}"}
    shared = preprocessor(HEADERS | files)
    first, second, third = (shared.translate(f"{name}.cpp", ("include",), ()).files for name in ("one", "two", "three"))
    assert first[1] is second[1]
    assert first[0] is third[0]
    assert lines(third[1].text) == ["int z = 1;"]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("class DEMO_PUBLIC Driver : public Base {};", "class Driver : public Base {};"),
        ("  DEMO_PUBLIC\n  explicit Driver(int x);", "explicit Driver(int x);"),
        ("RCLCPP_PUBLIC void f();", "void f();"),
        ("class DEMO final {};", "class DEMO final {};"),
        ("UINT32 x;", "UINT32 x;"),
        ("if (x == DEMO_PUBLIC) {}", "if (x == DEMO_PUBLIC) {}"),
        ('const auto s = "%" PRId64;', 'const auto s = "%" "ld";'),
        ("x = typename T::Goal();", "x = T::Goal();"),
        ("auto a = new Cell * [5];", "auto a = new Cell [5];"),
        ("public slots:", "public :"),
        ("template class Tree<int>;", ""),
        ('  RCLCPP_INFO(l, "%zu) %s", a);', 'RCLCPP_INFO(l, "%zu) %s", a);'),
    ],
)
def test_what_hides_a_declaration_is_blanked(text: str, expected: str) -> None:
    result = prepared(text)
    assert lines(result.text) == lines(expected)
    assert not result.findings


def test_macros_that_nobody_defined_are_told() -> None:
    result = prepared("int a;\nDECLARE_THINGS(a,\n  b)\nint b;")
    assert lines(result.text) == ["int a;", "int b;"]
    assert [(f.code, f.place.line) for f in result.findings] == [("RW206", 2)]


def test_registrations() -> None:
    result = prepared(
        "int a;\nRCLCPP_COMPONENTS_REGISTER_NODE(demo::Driver)\nPLUGINLIB_EXPORT_CLASS(\n  demo::A, demo::B)\nint b;"
    )
    assert [(r.macro, r.arguments, r.line) for r in result.registrations] == [
        ("RCLCPP_COMPONENTS_REGISTER_NODE", ("demo::Driver",), 2),
        ("PLUGINLIB_EXPORT_CLASS", ("demo::A", "demo::B"), 3),
    ]
    assert result.text.split("\n")[4] == "int b;"


def _bomb(levels: int) -> str:
    return "#define A0 x x x x x x x x x x\n" + "".join(
        f"#define A{i + 1} " + f"A{i} " * 10 + "\n" for i in range(levels)
    )


@pytest.mark.parametrize(
    "text",
    sample([
        _bomb(30) + "A30\n" * 50,
        "#define F(x) x x\n" + "F(" * 300 + ")" * 300,
        "#define F(x) F(x F)\nF(F)(F)",
        "#define A A\n" * 20_000,
        "".join(f"#define C{i} C{i + 1}\n" for i in range(5_000)) + "C0",
        "#if " + "(" * 10_000,
        "#if " + "!" * 10_000 + "1\n",
        "#if NDEBUG\n" * 5_000,
        "#ifdef NDEBUG\n#define X a\n#endif\n" * 5_000 + "X",
        '#include "main.cpp"\n' * 10_000,
        '#define S "main.cpp"\n#include S\n#include T\n#include\n#define\n#define (\n#undef\n#if\n#endif\n#',
        'R"(' * 20_000,
        '"\\"' * 50_000,
        "/*" * 50_000,
        "'" * 50_001,
        "AAAA(\n" * 30_000,
        "#define Q(x) #x\nQ(Q(Q(" + "\"" * 1_001 + ")))",
        "#define P(a, b) a ## b\nP(,)P(P,P)(1,2)P(\",\")",
        "RCLCPP_COMPONENTS_REGISTER_NODE(\n" * 5_000,
        "new a" + "*" * 50_000,
    ], 3),
)  # fmt: skip
def test_texts_that_would_not_end(text: str) -> None:
    result = prepared(text)
    assert result.text.count("\n") == text.count("\n")
    assert len(result.text) < 20_000_000


def test_a_bomb_is_told() -> None:
    assert {f.code for f in prepared(_bomb(30) + "A30").findings} == {"RW201"}


def test_a_macro_of_several_definitions_is_one_cause() -> None:
    """Each place is told, and all of them belong together, whichever file they are in."""
    there = "#include <magic/magic.hpp>\n#ifdef MAGIC_FAST\n"
    one = (
        there
        + "#define BUTTON(a) f(a)\n#else\n#define BUTTON(a) g(a)\n#endif\nint b = BUTTON(1);\nint c = BUTTON(2);\n"
    )
    other = one.replace("BUTTON", "OTHER")
    causes = [[f.causes for f in prepared(text).findings if f.code == "RW206"] for text in (one, other)]
    assert causes == [[("macro BUTTON",)] * 2, [("macro OTHER",)] * 2]


def test_literals_that_nobody_closes_end_with_their_line() -> None:
    escaped = '"' + '\\"' * 3
    assert cleaned(f"f({escaped}\n\"a\"); 'b\\'\n") == f"f({escaped}\"\n\"a\"); 'b\\''\n"
    assert cleaned('"a\\\\"; "b\\') == '"a\\\\"; "b"'


@pytest.mark.parametrize("piece", ['\\"', "[a{", "= [a{b},", "[& & "])
def test_what_stands_open_everywhere_is_read_in_little_time(piece: str) -> None:
    text = cleaned('"' * piece.startswith("\\") + piece * 100_000)
    before = time.process_time()
    changed, contents = hidden(text)
    assert len(shown(with_plain_captures(changed), contents)) == len(text)
    assert time.process_time() - before < 5


@pytest.mark.parametrize(
    "text",
    [
        "struct A { unsigned " + f"a:1=1{' ' * 40}," * 40 + "!",
        "struct A { unsigned " + " " * 20_000,
        "; a b : 1, " * 2_000,
        "a::" * 10_000,
    ],
    ids=["aligned", "spaces", "widths", "scopes"],
)
def test_bit_fields_that_never_end_are_read_in_little_time(text: str) -> None:
    before = time.process_time()
    assert len(suited(text)) == len(text)
    assert time.process_time() - before < 2
