# SPDX-License-Identifier: Apache-2.0
"""Which module does generate_parameter_library make of the description of parameters?

    robot: {topic: {type: string, default_value: scan}}
    ->  class robot:
            class Params: …
            class ParamListener: …          node.declare_parameter(prefix + "topic", "scan", …)

The module says what the generated one does, in the fewest words: what a listener holds is what the node has, asked anew each time. Each of its lines
knows the line of the description that it comes from.
"""

from __future__ import annotations

import math
from types import MappingProxyType
from typing import Final, NamedTuple

from rosward.source.location import Place
from rosward.source.parameter_yaml import MAP, Check, Constant, Described, Library, read_parameters
from rosward.source.yaml_nodes import Malformed

_WRONG: Final = MappingProxyType(
    {
        "lt": "not value < {0}",
        "gt": "not value > {0}",
        "lt_eq": "not value <= {0}",
        "gt_eq": "not value >= {0}",
        "not_empty": "len(value) == 0",
        "one_of": "value not in {0}",
        "unique": "len(set(value)) != len(value)",
        "subset_of": "not all(each in {0} for each in value)",
        "fixed_size": "len(value) != {0}",
        "size_gt": "not len(value) > {0}",
        "size_lt": "not len(value) < {0}",
        "element_bounds": "any(each > {1} or each < {0} for each in value)",
        "lower_element_bounds": "any(each < {0} for each in value)",
        "upper_element_bounds": "any(each > {0} for each in value)",
        "bounds": "value > {1} or value < {0}",
    }
)
"""By rule, which values are wrong."""

_LISTENER: Final = """\
class ParamListener:
    def __init__(self, node, prefix=""):
        self.prefix_ = prefix
        self.node_ = node
        self.logger_ = rclpy.logging.get_logger({name!r} + "." + prefix)
        self.by_hand_ = None
        self.params_ = {name}.Params()
        self.declare_params()
        self.node_.add_on_set_parameters_callback(self.update)
        self.user_callback = None
        self.clock_ = Clock()
    def is_old(self, other_param):
        return self.params_.stamp_ != other_param.stamp_
    def set_user_callback(self, callback):
        self.user_callback = callback
    def clear_user_callback(self):
        self.user_callback = None
    def unpack_parameter_dict(self, namespace, parameter_dict):
        parameters = []
        for name, value in parameter_dict.items():
            if isinstance(value, dict):
                parameters.extend(self.unpack_parameter_dict(namespace + name + ".", value))
            else:
                parameters.append(rclpy.parameter.Parameter(namespace + name, value=value))
        return parameters
    def set_params_from_dict(self, param_dict):
        self.by_hand_ = param_dict
        self.update(self.unpack_parameter_dict("", param_dict))
    def update_internal_params(self, updated_params):
        self.params_ = updated_params
    def update(self, parameters):
        self.params_ = self.get_params()
        self.params_.stamp_ = self.clock_.now()
        if self.user_callback:
            self.user_callback(self.get_params())
        return SetParametersResult(successful=True)
"""


class ParameterModule(NamedTuple):
    """The text of a module, and for each of its lines the line of the description."""

    text: str
    lines: tuple[int, ...]


def parameter_module(text: str, file: str, validation: str = "") -> ParameterModule:
    """The module that is generated of a description; `validation` is the module of its own validators. Raises `Malformed`."""
    library = read_parameters(text, file)
    out = _Text(library.line)
    out.add(
        0,
        "import rclpy\nimport rclpy.logging\nimport rclpy.parameter\nimport generate_parameter_library_py.python_validators\n"
        "from rcl_interfaces.msg import ParameterDescriptor, SetParametersResult\nfrom rclpy.clock import Clock\n"
        "from rclpy.exceptions import InvalidParameterValueException\nfrom rclpy.time import Time",
    )
    if validation:
        out.add(0, f"import {validation} as custom_validators")
    own = next((p for p in library.parameters if any(check.own for check in p.checks)), None)
    if own is not None and not validation:
        raise Malformed("a validation of its own needs a module that it is in", Place(file, own.line))
    out.add(0, f"class {library.name}:")
    _params(library, out)
    out.add(1, _LISTENER.format(name=library.name))
    fixed = [p for p in library.parameters if MAP not in p.name]
    mapped = [_mapped(p, fixed, file) for p in library.parameters if MAP in p.name]
    _declare(fixed, out)
    _declare_mapped(mapped, out)
    _get(library, fixed, mapped, out)
    return ParameterModule("\n".join(out.text) + "\n", tuple(out.lines))


class _Text:
    """Lines of Python in the course of being written."""

    def __init__(self, line: int) -> None:
        self.text: list[str] = []
        self.lines: list[int] = []
        self._line = line

    def add(self, depth: int, text: str, line: int = 0) -> None:
        """Lines, indented so many times; `line` is where they come from, else from the whole."""
        for each in text.splitlines():
            self.text.append("    " * depth + each)
            self.lines.append(line or self._line)


def _params(library: Library, out: _Text) -> None:
    """The class of what a listener gives, and that of each group; one of which there are several is made by name."""
    places = {"": library.line, **dict(library.groups)}
    for path, line in places.items():
        out.add(1, f"class {_class(path)}:", line)
        out.add(2, "def __init__(self):", line)
        if not path:
            out.add(3, "self.stamp_ = Time()", line)
        out.add(3, "pass", line)
        for parameter in library.parameters:
            if _above(parameter.name) == path:
                out.add(3, f"self.{parameter.parts[-1]} = {_constant(parameter.default)}", parameter.line)
        entries = ""
        for inner, place in library.groups:
            if _above(inner) == path:
                name = inner.rpartition(".")[2]
                if MAP in name:
                    entries = inner  # of several, Python keeps the last
                else:
                    out.add(3, f"self.{name} = {library.name}.{_class(inner)}()", place)
        if entries:
            out.add(
                2,
                "def add_entry(self, name):\n    if not hasattr(self, name):\n"
                f"        setattr(self, name, {library.name}.{_class(entries)}())\n    return getattr(self, name)\n"
                "def get_entry(self, name):\n    return getattr(self, name)",
                places[entries],
            )


def _above(path: str) -> str:
    return path.rpartition(".")[0]


def _class(path: str) -> str:
    """The name of the class for a group; no two have one, since no name of a group has a dot."""
    return "Params" if not path else "Params_" + path.replace("_", "_1").replace(".", "_0")


class _Mapped(NamedTuple):
    """A parameter of which there is one for each entry: the group that has the entries, the lists of their names, and its path in an entry."""

    parameter: Described
    group: str
    keys: tuple[str, ...]
    field: str


def _mapped(parameter: Described, fixed: list[Described], file: str) -> _Mapped:
    maps = [index for index, part in enumerate(parameter.parts) if MAP in part]
    if maps != list(range(maps[0], maps[-1] + 1)) or not all(parameter.parts[i].startswith(MAP) for i in maps):
        raise Malformed(
            f"the groups around {parameter.name} are in an order that no module can be made of", _at(parameter, file)
        )
    group = parameter.parts[: maps[0]]
    lists = {p.name for p in fixed if p.type == "string_array"}
    keys = []
    for index in maps:
        key = parameter.parts[index].removeprefix(MAP)
        found = [".".join([*group[:depth], key]) for depth in range(len(group), -1, -1)]
        name = next((each for each in found if each in lists), None)
        if name is None:
            raise Malformed(f"no list of texts {key} says which entries there are", _at(parameter, file))
        keys.append(name)
    return _Mapped(parameter, ".".join(group), tuple(keys), ".".join(parameter.parts[maps[-1] + 1 :]))


def _at(parameter: Described, file: str) -> Place:
    return Place(file, parameter.line)


def _declare(fixed: list[Described], out: _Text) -> None:
    out.add(2, "def declare_params(self):")
    for parameter in fixed:
        out.add(3, f"name = self.prefix_ + {parameter.name!r}", parameter.line)
        _declared(parameter, 3, out)
    for parameter in fixed:
        if parameter.checks:
            out.add(3, f"name = self.prefix_ + {parameter.name!r}", parameter.line)
            _checked(parameter, 3, out)
    out.add(3, "self.refresh_dynamic_parameters()\nself.update_internal_params(self.get_params())")


def _declare_mapped(mapped: list[_Mapped], out: _Text) -> None:
    out.add(2, "def refresh_dynamic_parameters(self):\n    updated_params = self.get_params()")
    for each in mapped:
        depth = _loops(each, out)
        _declared(each.parameter, depth, out)
        _checked(each.parameter, depth, out)


def _get(library: Library, fixed: list[Described], mapped: list[_Mapped], out: _Text) -> None:
    out.add(
        2,
        "def get_params(self):\n    if self.by_hand_ is not None:\n"
        "        return generate_parameter_library_py.python_validators.params(self.by_hand_)\n"
        f"    updated_params = {library.name}.Params()\n    updated_params.stamp_ = self.params_.stamp_",
    )
    for parameter in fixed:
        read = f"self.node_.get_parameter(self.prefix_ + {parameter.name!r}).value"
        out.add(3, f"updated_params.{parameter.name} = {read}", parameter.line)
    for each in mapped:
        depth = _loops(each, out)
        line = each.parameter.line
        out.add(depth, "if self.node_.has_parameter(name):", line)
        entry = "updated_params" + (f".{each.group}" if each.group else "")
        entry += "".join(f".add_entry(key_{number})" for number in range(len(each.keys)))
        out.add(depth + 1, f"{entry}.{each.field} = self.node_.get_parameter(name).value", line)
    out.add(3, "return updated_params")


def _loops(each: _Mapped, out: _Text) -> int:
    """Go through all entries, with the name of the parameter; how deep the text stands now."""
    line = each.parameter.line
    for number, key in enumerate(each.keys):
        out.add(3 + number, f"for key_{number} in updated_params.{key}:", line)
    depth = 3 + len(each.keys)
    keys = ' + "." + '.join(f"key_{number}" for number in range(len(each.keys)))
    group = f"{each.group}." if each.group else ""
    out.add(depth, f"name = self.prefix_ + {group!r} + {keys} + {'.' + each.field!r}", line)
    return depth


def _declared(parameter: Described, depth: int, out: _Text) -> None:
    word = parameter.type.replace("int", "integer").upper()
    value = f"rclpy.Parameter.Type.{word}" if parameter.default is None else _constant(parameter.default)
    out.add(depth, "if not self.node_.has_parameter(name):", parameter.line)
    descriptor = f"ParameterDescriptor(read_only={parameter.read_only})"
    out.add(depth + 1, f"self.node_.declare_parameter(name, {value}, {descriptor})", parameter.line)


def _checked(parameter: Described, depth: int, out: _Text) -> None:
    """Raise where a value is wrong."""
    if parameter.checks:
        out.add(depth, "param = self.node_.get_parameter(name)\nvalue = param.value", parameter.line)
    for condition in map(_wrong, parameter.checks):
        out.add(depth, f"if {condition}:", parameter.line)
        out.add(depth + 1, f"raise InvalidParameterValueException(name, value, {'not valid'!r})", parameter.line)


def _wrong(check: Check) -> str:
    arguments = [_constant(each) for each in check.arguments]
    if check.own:
        return f"custom_validators.{check.name}({', '.join(['param', *arguments])})"
    return _WRONG[check.name].format(*arguments)


def _constant(value: Constant | None) -> str:
    """The Python that stands for a constant."""
    if isinstance(value, list):
        return f"[{', '.join(map(_constant, value))}]"
    if isinstance(value, float) and not math.isfinite(value):
        return f"float({str(value)!r})"
    return repr(value)
