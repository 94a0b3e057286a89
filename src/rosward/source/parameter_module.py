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
from itertools import groupby
from types import MappingProxyType
from typing import Final

from rosward.location import Place
from rosward.records import NamedTuple
from rosward.source.parameter_yaml import MAP, Check, Constant, DescribedParameter, ParameterLibrary, read_parameters
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
        for param in parameters:
            if not self._rosward_accepts(param):
                return SetParametersResult(successful=False)
        self.params_ = self.get_params()
        self.params_.stamp_ = self.clock_.now()
        if self.user_callback:
            self.user_callback(self.get_params())
        return SetParametersResult(successful=True)
"""


_ENTRIES: Final = """\
def __getattr__(self, name):
    if name not in self._rosward_entries:
        raise AttributeError(name)
    return self._rosward_entries[name]
def add_entry(self, name):
    if name not in self._rosward_entries:
        self._rosward_entries[name] = {made}
    return self._rosward_entries[name]
def get_entry(self, name):
    return getattr(self, name)
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
        "import rclpy\nimport rclpy.logging\nimport rclpy.parameter\nimport generate_parameter_library_py._generated as _rosward_generated\n"
        "from rcl_interfaces.msg import ParameterDescriptor, SetParametersResult\nfrom rclpy.clock import Clock\n"
        "from rclpy.time import Time",
    )
    if validation:
        out.add(0, f"import {validation} as custom_validators")
    own = next((p for p in library.parameters if any(check.own for check in p.checks)), None)
    if own is not None and not validation:
        raise Malformed("a custom validation needs the module that contains it", Place(file, own.line))
    out.add(0, f"class {library.name}:")
    _params(library, out)
    out.add(1, _LISTENER.format(name=library.name))
    fixed = [p for p in library.parameters if MAP not in p.name]
    mapped = [_mapped(p, fixed, file) for p in library.parameters if MAP in p.name]
    _declare(fixed, mapped, out)
    _get(library, mapped, out)
    _accepts(library, out)
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


def _params(library: ParameterLibrary, out: _Text) -> None:
    """The class of what a listener gives, and that of each group; all is given when one is made, so that nothing is there before its value."""
    for path, line in {"": library.line, **dict(library.groups)}.items():
        fields = [p for p in library.parameters if _above(p.name) == path]
        inner = [group for group, _ in library.groups if _above(group) == path]
        names = [f"given_{p.parts[-1]}={_constant(p.default)}" for p in fields]
        names += [f"given_{_last(group)}=None" for group in inner if MAP not in _last(group)]
        out.add(1, f"class {_class(path)}:", line)
        out.add(2, f"def __init__({', '.join(['self', *names])}):", line)
        out.add(3, "pass" if path else "self.stamp_ = Time()", line)
        for parameter in fields:
            out.add(3, f"self.{parameter.parts[-1]} = given_{parameter.parts[-1]}", parameter.line)
        for group in inner:
            name, made = _last(group), f"{library.name}.{_class(group)}()"
            if MAP not in name:
                out.add(3, f"self.{name} = {made} if given_{name} is None else given_{name}", line)
        entries = [group for group in inner if MAP in _last(group)]
        if entries:  # of several, Python keeps the last
            out.add(3, "self._rosward_entries = {}", line)
            out.add(2, _ENTRIES.format(made=f"{library.name}.{_class(entries[-1])}()"), line)


def _last(path: str) -> str:
    return path.rpartition(".")[2]


def _above(path: str) -> str:
    return path.rpartition(".")[0]


def _class(path: str) -> str:
    """The name of the class for a group."""
    return "Params" if not path else f"Params_{_flat(path)}"


class _Mapped(NamedTuple):
    """A parameter of which there is one for each entry: the group that has the entries, the groups that one is made of
    for each, the lists of their names, and its path in an entry."""

    parameter: DescribedParameter
    group: str
    maps: tuple[str, ...]
    keys: tuple[str, ...]
    field: str


def _mapped(parameter: DescribedParameter, fixed: list[DescribedParameter], file: str) -> _Mapped:
    maps = [index for index, part in enumerate(parameter.parts) if MAP in part]
    if maps != list(range(maps[0], maps[-1] + 1)) or not all(parameter.parts[i].startswith(MAP) for i in maps):
        raise Malformed(
            f"the groups around {parameter.name} are in an order from which no module can be generated",
            _at(parameter, file),
        )
    group = parameter.parts[: maps[0]]
    lists = {p.name for p in fixed if p.type == "string_array"}
    keys = []
    for index in maps:
        key = parameter.parts[index].removeprefix(MAP)
        found = [".".join([*group[:depth], key]) for depth in range(len(group), -1, -1)]
        name = next((each for each in found if each in lists), None)
        if name is None:
            raise Malformed(f"no list of texts {key} lists the entries", _at(parameter, file))
        keys.append(name)
    paths = tuple(".".join(parameter.parts[: index + 1]) for index in maps)
    return _Mapped(parameter, ".".join(group), paths, tuple(keys), ".".join(parameter.parts[maps[-1] + 1 :]))


def _at(parameter: DescribedParameter, file: str) -> Place:
    return Place(file, parameter.line)


def _declare(fixed: list[DescribedParameter], mapped: list[_Mapped], out: _Text) -> None:
    out.add(2, "def declare_params(self):")
    for write in (_declared, _checked):
        for parameter in fixed:
            if parameter.checks or write is _declared:
                out.add(3, f"name = {_name('', [], parameter.name)}", parameter.line)
                write(parameter, 3, out)
    out.add(3, "self.refresh_dynamic_parameters()\nself.update_internal_params(self.get_params())")
    out.add(2, "def refresh_dynamic_parameters(self):\n    pass")
    _read_lists(mapped, out)
    for (group, lists), several in groupby(mapped, key=lambda each: (each.group, each.keys)):
        entries = list(several)
        for number, key in enumerate(lists):
            out.add(3 + number, _loop(key, number), entries[0].parameter.line)
        depth = 3 + len(lists)
        keys = [f"key_{number}" for number in range(len(lists))]
        for each in entries:
            out.add(depth, f"name = {_name(group, keys, each.field)}", each.parameter.line)
            _declared(each.parameter, depth, out)
            _checked(each.parameter, depth, out)


def _read_lists(mapped: list[_Mapped], out: _Text) -> None:
    """The lists that say which entries there are."""
    for key, line in {key: each.parameter.line for each in mapped for key in each.keys}.items():
        out.add(3, f"{_variable(key)} = _rosward_generated.value(self.node_, self.prefix_ + {key!r})", line)


def _get(library: ParameterLibrary, mapped: list[_Mapped], out: _Text) -> None:
    """`get_params`: objects for all groups, from the innermost, of what the node has now."""
    lists = {path: key for each in mapped for path, key in zip(each.maps, each.keys, strict=True)}
    out.add(
        2,
        "def get_params(self):\n    if self.by_hand_ is not None:\n        return _rosward_generated.set_by_hand(self.by_hand_)",
    )
    _read_lists(mapped, out)
    _build(library, "", lists, ("", []), out)
    out.add(3, "params_.stamp_ = self.params_.stamp_\nreturn params_")


def _build(
    library: ParameterLibrary, path: str, lists: dict[str, str], entry: tuple[str, list[str]], out: _Text
) -> None:
    """The object of a group; `entry` are the group with entries that it is in, and the variables with their names."""
    group, keys = entry
    depth = 3 + len(keys)
    given = []
    inner = [each for each in library.groups if _above(each[0]) == path]
    for below, _ in inner:
        if MAP not in _last(below):
            _build(library, below, lists, entry, out)
            given.append(f"given_{_last(below)}={_variable(below)}")
    for parameter in library.parameters:
        if _above(parameter.name) == path:
            field = parameter.name
            if keys:
                field = ".".join(parameter.parts[(group.count(".") + 1 if group else 0) + len(keys) :])
            name = _name(group, keys, field)
            value = f"_rosward_generated.value(self.node_, {name})"
            if keys:
                value += f" if self.node_.has_parameter({name}) else {_constant(parameter.default)}"
            variable = _variable(parameter.name)
            out.add(depth, f"{variable} = {value}", parameter.line)
            given.append(f"given_{parameter.parts[-1]}={variable}")
    line = dict(library.groups).get(path, library.line)
    out.add(depth, f"{_variable(path)} = {library.name}.{_class(path)}({', '.join(given)})", line)
    for below, place in inner:
        if below in lists:
            key = f"key_{len(keys)}"
            out.add(depth, _loop(lists[below], len(keys)), place)
            _build(library, below, lists, (group if keys else path, [*keys, key]), out)
            out.add(depth + 1, f"{_variable(path)}._rosward_entries[{key}] = {_variable(below)}", place)


def _variable(path: str) -> str:
    return f"params_{_flat(path)}"


def _flat(path: str) -> str:
    """A path as a part of a name; no two have one."""
    return path.replace("_", "_1").replace(".", "_0")


def _name(group: str, keys: list[str], field: str) -> str:
    """The Python that gives the name of a parameter: of one in an entry by variables."""
    if not keys:
        return f"self.prefix_ + {field!r}"
    parts = ["self.prefix_", *([repr(f"{group}.")] if group else []), ' + "." + '.join(keys), repr(f".{field}")]
    return " + ".join(parts)


def _loop(key: str, number: int) -> str:
    return f"for key_{number} in {_variable(key)}:"


def _declared(parameter: DescribedParameter, depth: int, out: _Text) -> None:
    word = parameter.type.replace("int", "integer").upper()
    value = f"rclpy.Parameter.Type.{word}" if parameter.default is None else _constant(parameter.default)
    out.add(depth, "if not self.node_.has_parameter(name):", parameter.line)
    descriptor = f"ParameterDescriptor(read_only={parameter.read_only})"
    out.add(depth + 1, f"self.node_.declare_parameter(name, {value}, {descriptor})", parameter.line)


def _checked(parameter: DescribedParameter, depth: int, out: _Text) -> None:
    """Raise where a value is wrong."""
    if any(check.own for check in parameter.checks):
        out.add(depth, "param = self.node_.get_parameter(name)", parameter.line)
    if parameter.checks:
        out.add(depth, "value = _rosward_generated.value(self.node_, name)", parameter.line)
    for check in parameter.checks:
        out.add(depth, f"_rosward_generated.check(not ({_wrong(check)}), name, {check.name!r})", parameter.line)


def _accepts(library: ParameterLibrary, out: _Text) -> None:
    """What functions of the package say of a new value: all are asked that may be, since they may do anything."""
    out.add(2, "def _rosward_accepts(self, param):")
    for parameter in library.parameters:
        start = parameter.name.partition(MAP)[0]
        for check in parameter.checks:
            if check.own:
                mine = f"param.name.startswith(self.prefix_ + {start!r})"
                out.add(3, f"if {mine} and {_wrong(check)}:\n    return False", parameter.line)
    out.add(3, "return True")


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
