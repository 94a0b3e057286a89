# SPDX-License-Identifier: Apache-2.0
"""Which header does generate_parameter_library make of the description of parameters?

    robot:                                   namespace robot { struct Params { struct Pid { double rate = 0.1; } pid; };
      pid:                                   class ParamListener { … };
        rate: {type: double, …}                  node->declare_parameter(prefix + "pid.rate", 0.1, …), on this line

The header says what the generated one does, in the fewest words: what a listener gives is what the node has, asked anew each time. Each
declaration stands on the line of its description, so that places in it are places of the YAML file; all else is on the first line or behind.
"""

from __future__ import annotations

import json
import math
from types import MappingProxyType
from typing import Final

from rosward.source.parameter_yaml import MAP, Constant, DescribedParameter, ParameterLibrary, read_parameters

__all__ = ["parameter_header"]

_TYPES: Final = MappingProxyType({"bool": "bool", "double": "double", "int": "int64_t", "string": "std::string"})
_ARRAY: Final = "_array"
_LISTENER: Final = (
    "using StackParams = Params; class ParamListener { public:"  # those that need no heap: what is asked of them is in Params
    " template<typename NodeT> explicit ParamListener(const NodeT & node, const std::string & prefix = std::string())"
    " : node_(rosward::interface_of(node)), prefix_(prefix) { _begin(); }"
    " template<typename NodeT> ParamListener(const NodeT & node, const rclcpp::Logger & logger, const std::string & prefix = std::string())"
    " : node_(rosward::interface_of(node)), prefix_(prefix) { _begin(); }"
    " void _begin() { if (!prefix_.empty() && prefix_.back() != '.') { prefix_ += \".\"; } declare_params();"
    " node_->add_on_set_parameters_callback([this](const std::vector<rclcpp::Parameter> & changed) { return update(changed); }); }"
    " rcl_interfaces::msg::SetParametersResult update(const std::vector<rclcpp::Parameter> & parameters)"
    " { if (user_callback_) { user_callback_(get_params()); }"
    " return rosward::message<rcl_interfaces::msg::SetParametersResult>(); }"
    ' bool is_old(const Params & other) const { return rosward::unknown("parameter", "set when it runs", "bool"); }'
    " bool try_get_params(Params & out) const { out = get_params(); return true; }"
    " bool try_update_params(Params & out) const { out = get_params(); return true; }"
    " StackParams get_stack_params() { return get_params(); }"
    " template<typename CallbackT> void setUserCallback(const CallbackT & callback) { user_callback_ = callback; }"
    " void clearUserCallback() { user_callback_ = nullptr; }"
    " void refresh_dynamic_parameters() {}"
    " rosward::value node_; std::string prefix_; rosward::value user_callback_;"
)


def parameter_header(text: str, file: str) -> str:
    """The header that is generated of a description. Raises `Malformed`."""
    library = read_parameters(text, file)
    lines: dict[int, list[str]] = {}
    for parameter in library.parameters:
        lines.setdefault(max(2, parameter.line), []).append(_declaration(library, parameter))
    last = max(lines, default=1)
    before = f"namespace {library.name} {{ {_struct(library, '', 'Params')}; {_LISTENER} void declare_params() {{"
    body = (" ".join(lines.get(number, ())) for number in range(2, last + 1))
    return "\n".join([before, *body, f"}} {_get(library)} }}; }}", ""])


def _struct(library: ParameterLibrary, path: str, name: str) -> str:
    """The struct of a group, with those of the groups in it."""
    parts: list[str] = []
    for group, _ in library.groups:
        if _above(group) == path:
            inner, last = _struct(library, group, _struct_name(group)), _last(group)
            if last.startswith(MAP):
                parts.append(f"{inner}; std::map<std::string, {_struct_name(group)}> {last.removeprefix(MAP)}_map;")
            else:
                parts.append(f"{inner} {last};")
    for parameter in library.parameters:
        if _above(parameter.name) == path:
            first = "" if parameter.default is None else f" = {_constant(parameter.default, parameter.type)}"
            parts.append(f"{_type(parameter.type)} {parameter.parts[-1]}{first};")
    stamp = "" if path else " rclcpp::Time __stamp;"
    return f"struct {name} {{ {' '.join(parts)}{stamp} }}"


def _above(path: str) -> str:
    return path.rpartition(".")[0]


def _last(path: str) -> str:
    return path.rpartition(".")[2]


def _struct_name(path: str) -> str:
    """`Gains` for the group `gains`; `MapJoints` for the entries of `__map_joints`."""
    last = _last(path)
    words = last.removeprefix(MAP).split("_")
    return ("Map" if last.startswith(MAP) else "") + "".join(word[:1].upper() + word[1:] for word in words)


def _type(word: str) -> str:
    if word.endswith(_ARRAY):
        return f"std::vector<{_TYPES.get(word.removesuffix(_ARRAY), 'rosward::value')}>"
    return _TYPES.get(word, "rosward::value")


def _constant(value: Constant, type_: str) -> str:
    """The C++ that stands for a default."""
    if isinstance(value, list):
        inner = type_.removesuffix(_ARRAY)
        return f"{_type(type_)}{{{', '.join(_constant(each, inner) for each in value)}}}"
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (int, float)) and type_ == "double":
        if math.isfinite(value):
            return repr(float(value))
        word = "quiet_NaN" if math.isnan(value) else "infinity"
        return f"{'-' if value < 0 else ''}std::numeric_limits<double>::{word}()"
    return json.dumps(value, ensure_ascii=False) if isinstance(value, str) else repr(value)


class _Entry:
    """How a parameter is reached: its field in `params`, its name, and the loops around it, one for each group with entries."""

    def __init__(self, library: ParameterLibrary, parameter: DescribedParameter) -> None:
        self.field = "params"
        self.name = "prefix_"
        self.loops: list[str] = []
        lists = {p.name for p in library.parameters if p.type == "string_array"}
        separator = ""
        for depth, part in enumerate(parameter.parts):
            if part.startswith(MAP):
                short, key = part.removeprefix(MAP), f"key_{len(self.loops)}"
                above = [p for p in parameter.parts[:depth] if not p.startswith(MAP)]
                found = (".".join([*above[:count], short]) for count in range(len(above), -1, -1))
                listed = next((each for each in found if each in lists), short)
                self.loops.append(
                    f'for (const auto & {key} : node_->get_parameter(prefix_ + "{listed}").as_string_array())'
                )
                self.field += f".{short}_map[{key}]"
                self.name += f"{separator} + {key}" if not separator else f' + "." + {key}'
            else:
                self.field += f".{part}"
                self.name += f' + "{separator}{part}"'
            separator = "."

    def each(self, statement: str) -> str:
        """The statement, for each of its entries."""
        return f"{' '.join(self.loops)} {{ {statement} }}"


def _declaration(library: ParameterLibrary, parameter: DescribedParameter) -> str:
    entry = _Entry(library, parameter)
    word = parameter.type.replace("int", "integer").upper()
    given = (
        f"rclcpp::ParameterType::PARAMETER_{word}"
        if parameter.default is None
        else f"{_type(parameter.type)}({_constant(parameter.default, parameter.type)})"
    )
    return entry.each(
        f"const std::string name = {entry.name}; if (!node_->has_parameter(name)) {{"
        " rcl_interfaces::msg::ParameterDescriptor descriptor;"
        f" descriptor.read_only = {'true' if parameter.read_only else 'false'};"
        f" node_->declare_parameter(name, {given}, descriptor); }}"
    )


def _get(library: ParameterLibrary) -> str:
    """`get_params`: what the node has now."""
    reads = []
    for parameter in library.parameters:
        entry = _Entry(library, parameter)
        reads.append(entry.each(f"rosward::get_parameter(node_, {entry.name}, {entry.field});"))
    return f"Params get_params() const {{ Params params; {' '.join(reads)} return params; }}"
