# SPDX-License-Identifier: Apache-2.0
"""The text of attributes and the substitutions in it, as launch's grammar has them."""

from __future__ import annotations

import pytest

from deployment.markup_tree import shown
from rosward.deployment.markup.substitutions import SubstitutionError, parse_substitution, unescaped
from rosward.location import Place

HERE = Place("f.xml", 1)

GOOD = {
    "": "",
    "plain 'text' (with) signs $5 $": "plain 'text' (with) signs $5 $",
    "$(var a)": "$(var <a>)",
    "a$(var b c)d": "a$(var <b> <c>)d",
    "$(find-pkg-share $(var p))/a.yaml": "$(find-pkg-share <$(var <p>)>)/a.yaml",
    "$(var a_$(var b)_c)": "$(var <a_$(var <b>)_c>)",
    # quotes: a quoted argument is one, and may hold blanks and the other quotes
    "$(eval '1 + 1')": "$(eval <1 + 1>)",
    "$(eval \"'$(var a)' == 'b c'\")": "$(eval <'$(var <a>)' == 'b c'>)",
    '$(eval \'"$(var a)" == "b"\')': '$(eval <"$(var <a>)" == "b">)',
    "$(eval 'a' 'math, os')": "$(eval <a> <math> <os>)",
    "$(env A '')": "$(env <A> <>)",
    "$(command 'xacro $(dirname)/a.xacro' warn)": "$(command <xacro $(dirname)/a.xacro> <warn>)",
    # escapes
    r"\$(var a)": "$(var a)",
    r"a\b\\c": r"ab\c",
    r"$(var a\)b)": "$(var <a)b>)",
    r"$(eval 'it\'s')": "$(eval <it's>)",
    # the names of launch
    "$(dirname)/$(filename)": "$(dirname)/$(filename)",
    "$(log_dir)$(launch_log_dir)": "$(launch-log-dir)$(launch-log-dir)",
    "$(exec-in-pkg a b)": "$(exec-in-pkg <a> <b>)",
    "$(find-exec a)$(find-pkg-prefix b)$(anon c)": "$(find-exec <a>)$(find-pkg-prefix <b>)$(anon <c>)",
    "$(if $(var a) b)": "$(if <$(var <a>)> <b> <>)",
    "$(not $(and a $(or b c)))": "$(not <$(and <a> <$(or <b> <c>)>)>)",
    "$(any a b c)$(all a)": "$(any <a> <b> <c>)$(all <a>)",
    "$(equals a b)$(not-equals a b)": "$(equals <a> <b>)$(not-equals <a> <b>)",
    "$(file-content a)$(param /use_sim_time)": "$(file-content <a>)$(param </use_sim_time>)",
    "$(string-join , a b)": "$(string-join <,> <a> <b>)",
    "$(for-var a b)$(index i)": "$(for-var <a> <b>)$(index <i>)",
    # not of launch: the names of ROS 1, and of anybody
    "$(find a)": "$(unknown <find>)",
    "$(optenv A b)": "$(unknown <optenv>)",
}

BAD = (
    "$(var a",
    "$()",
    "$( var a)",
    "$(var  a)",
    "$(var a )",
    "$(var a'b)",
    "$(var 'a'b)",
    "$(var 'a)",
    "$(eval 'it's')",
    "$(var (a))",
    "$(var)",
    "$(var a b c)",
    "$(dirname a)",
    "$(equals a)",
)


@pytest.mark.parametrize("text", GOOD)
def test_pieces(text: str) -> None:
    assert shown(parse_substitution(text, HERE)) == GOOD[text]


@pytest.mark.parametrize("text", BAD)
def test_what_launch_refuses(text: str) -> None:
    with pytest.raises(SubstitutionError):
        parse_substitution(text, HERE)


def test_nesting_has_an_end() -> None:
    with pytest.raises(SubstitutionError, match="nested too deeply"):
        parse_substitution("$(var " * 100_000 + ")" * 100_000, HERE)


def test_names_without_substitutions() -> None:
    assert unescaped(r"a\$b\\") == "a$b\\"
