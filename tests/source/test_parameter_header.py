# SPDX-License-Identifier: Apache-2.0
"""The header that generate_parameter_library makes of a description."""

from __future__ import annotations

import pytest

from rosward.source.parameter_header import parameter_header
from rosward.source.yaml_nodes import Malformed

DESCRIPTION = """\
robot:
  topic: {type: string, default_value: "a b"}
  names: {type: string_array, default_value: [x, y]}
  joints:
    __map_names:
      gain: {type: double, default_value: 2}
  limits:
    top: {type: double, default_value: .inf, read_only: true}
    count: {type: int}
"""


def test_each_declaration_stands_on_the_line_of_its_description() -> None:
    lines = parameter_header(DESCRIPTION, "robot.yaml").splitlines()
    assert 'prefix_ + "topic"' in lines[1]
    assert 'std::string("a b")' in lines[1]
    assert 'std::vector<std::string>{"x", "y"}' in lines[2]
    assert lines[3] == lines[4] == lines[6] == ""
    assert 'prefix_ + "limits" + ".top"' in lines[7]
    assert "std::numeric_limits<double>::infinity()" in lines[7]
    assert "descriptor.read_only = true" in lines[7]
    assert "rclcpp::ParameterType::PARAMETER_INTEGER" in lines[8]


def test_entries_are_declared_for_each_name_in_a_list() -> None:
    line = parameter_header(DESCRIPTION, "robot.yaml").splitlines()[5]
    assert 'for (const auto & key_0 : node_->get_parameter(prefix_ + "names").as_string_array())' in line
    assert 'prefix_ + "joints" + "." + key_0 + ".gain"' in line
    assert "double(2.0)" in line


def test_structs_are_nested_as_the_groups_are() -> None:
    first = parameter_header(DESCRIPTION, "robot.yaml").splitlines()[0]
    assert (
        "struct Joints { struct MapNames { double gain = 2.0; }; std::map<std::string, MapNames> names_map; } joints;"
        in first
    )
    assert "struct Limits { double top = std::numeric_limits<double>::infinity(); int64_t count; } limits;" in first
    assert first.startswith("namespace robot { struct Params {")


def test_what_is_no_description_is_refused() -> None:
    with pytest.raises(Malformed):
        parameter_header("a: {b: {type: double}}\nc: {}\n", "robot.yaml")
