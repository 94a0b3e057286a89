# SPDX-License-Identifier: Apache-2.0
"""What is made of a description of parameters says what it says, in its lines; what no module can be made of is refused where it stands."""

from __future__ import annotations

import ast

import pytest

from rosward.frontends.python.module import lower_module
from rosward.source import limits
from rosward.source.parameter_module import parameter_module
from rosward.source.parameter_yaml import Check, DescribedParameter, read_parameters
from rosward.source.yaml_nodes import Malformed

ONE = "r:\n  a: {type: string, default_value: %s}\n"


def test_a_description_is_read_with_its_lines() -> None:
    """Groups, types, defaults, flags and rules, each with the line of its name."""
    library = read_parameters(
        "robot:\n  pid:\n    rate:\n      type: double\n      default_value: 1\n      read_only: true\n"
        "      validation: {bounds<>: [0.0, 2.0], 'custom_validators::odd': null}\n  none: {type: none}\n  note: passed over\n"
        "  id: {type: string_fixed_8}\n  on: {type: bool_array, default_value: [true, false]}\n",
        "a.yaml",
    )
    assert library.name == "robot"
    assert library.groups == (("pid", 2),)
    assert library.parameters == (
        DescribedParameter(
            "pid.rate", "double", 1.0, True, (Check("bounds", (0.0, 2.0)), Check("odd", (), own=True)), 3
        ),
        DescribedParameter("id", "string", None, False, (Check("size_lt", (9,)),), 10),
        DescribedParameter("on", "bool_array", [True, False], False, (), 11),
    )


@pytest.mark.parametrize(
    ("text", "line", "why"),
    [
        ("", 0, "the file is empty"),
        ("[]", 1, "expected a mapping"),
        ("a: {b: {type: int}}\nc: {d: {type: int}}", 1, "exactly one name at the top"),
        ("r: {}", 1, "this is empty"),
        ("r: {type: string}", 1, "expected a group of parameters"),
        ("r:\n  a: {}", 2, "this is empty"),
        ("r:\n  a: {default_value: 1}", 2, "parameter a has no type"),
        ("r:\n  a: {type: text}", 2, "an unknown type: text"),
        ("r:\n  a: {type: bool_array_fixed_3}", 2, "an unknown type"),
        ("r:\n  a: {type: string_array_array}", 2, "an unknown type"),
        ("r:\n  a: {type: [int]}", 2, "expected a string"),
        ("r:\n  a: {type: int, kind: x}", 2, "unknown key 'kind'"),
        ("r:\n  a: {type: int, default_value: 1.5}", 2, "expected a value of type int"),
        ("r:\n  a: {type: int, default_value: true}", 2, "expected a value of type int"),
        ("r:\n  a: {type: double, default_value: 1e-5}", 2, "expected a value of type double"),
        ("r:\n  a: {type: int_array, default_value: 1}", 2, "expected a list"),
        ("r:\n  a: {type: string_array, default_value: [a, null]}", 2, "expected a"),
        (f"r:\n  a: {{type: int, default_value: 0x{'f' * 5000}}}", 2, "too large for a parameter"),
        ("r:\n  a b: {type: int}", 2, "'a b' cannot be a name in the generated module"),
        ("r:\n  class: {type: int}", 2, "'class' cannot be a name in the generated module"),
        ("r:\n  __a: {type: int}", 2, "'__a' cannot be a name in the generated module"),
        ("r\n\n: {a: {type: int}}", 3, "not valid YAML"),
        ("'r: pass #':\n  a: {type: int}", 1, "cannot be a name in the generated module"),
        ("r:\n  a:\n    type: int\n    validation: {odd<>: [1]}", 4, "no validation 'odd' with 1 arguments"),
        ("r:\n  a:\n    type: int\n    validation: {bounds<>: [1]}", 4, "no validation 'bounds' with 1 arguments"),
        ("r:\n  a:\n    type: int\n    validation:\n", 4, "expected a mapping"),
        (
            "r:\n  a:\n    type: int\n    validation: {'custom_validators::f(': []}",
            4,
            "'f(' cannot be a name in the generated module",
        ),
        ("r:\n  a:\n    type: int\n    validation: {'custom_validators::f': []}", 2, "needs the module"),
        ("r:\n  __map_a: {type: int}", 2, "named like a group of entries"),
        ("r:\n  __map_keys:\n    a: {type: int}", 3, "no list of texts keys"),
        ("r:\n  keys: {type: int}\n  __map_keys:\n    a: {type: int}", 4, "no list of texts keys"),
        (
            "r:\n  k: {type: string_array}\n  __map_k:\n    g:\n      __map_k:\n        a: {type: int}",
            6,
            "in an order from which no module can be generated",
        ),
        (ONE % "'a\"b'", 2, "line breaks or quotation marks"),
        (ONE % '"a\\nb"', 2, "line breaks or quotation marks"),
        (ONE % "'a\\'", 2, "no Python can be generated from this string"),
        (ONE % "!!python/object/apply:os.system [id]", 2, "a number, a string, true or false"),
        ("r: &r\n  a: *r", 2, "aliases are not supported"),
        ("a: &a [x]\nb: &b [*a, *a]\nc: [*b, *b]", 2, "aliases are not supported"),
        ("r: " + "{a: " * 200 + "1" + "}" * 200, 1, "nested too deep"),
        ("r:\n" + "".join(f"  p{n}: {{type: int}}\n" for n in range(2_000)), 1_503, "the file is too large"),
        ("r: " + "x" * limits.PARAMETERS_FILE, 0, "too large"),
        ("r:\n  a: {type: int}\n  a: {type: int}", 3, "occurs twice here"),
    ],
    ids=lambda value: value[:40] if isinstance(value, str) else None,
)
def test_what_no_module_can_be_made_of_is_refused_where_it_stands(text: str, line: int, why: str) -> None:
    """No error but `Malformed`, with what is wrong and its line."""
    with pytest.raises(Malformed) as raised:
        parameter_module(text, "a.yaml")
    assert why in raised.value.message
    assert (raised.value.place.file, raised.value.place.line) == ("a.yaml", line)


@pytest.mark.parametrize(
    "text",
    [
        "r:\n  self: {type: string}\n  params_: {type: int}\n  given_self: {type: int}\n",
        "r:\n  a_b: {c: {type: int}}\n  a: {b_c: {type: int}, b: {c: {type: int}}}\n  a__b: {type: int}\n",
        "r:\n  k: {type: string_array}\n  g:\n    __map_k:\n      __map_k:\n        h: {a: {type: double, default_value: .nan}}\n",
        "generated:\n  value:\n    type: double\n    default_value: -.inf\n    validation: {gt: 1, one_of<>: [[1.0, .inf]]}\n",
        ONE % "'{0} {name} \\\\ %s'",
        ONE % "'\\u00e9 \\x41'",
    ],
)
def test_each_line_of_a_module_has_a_line_of_its_description(text: str) -> None:
    """What is made is Python, of as many lines as have an origin, all of them lines of the description; and the engine's frontend takes it."""
    made = parameter_module(text, "a.yaml", "own.rules")
    ast.parse(made.text)
    assert len(made.lines) == len(made.text.splitlines())
    assert set(made.lines) <= set(range(1, text.count("\n") + 1))
    assert lower_module(made.text, "a.yaml", made.lines).file == "a.yaml"
