# SPDX-License-Identifier: Apache-2.0
"""Is the file of a declared interface well-formed, and what does it say?

    read_package(text, 'models/nodes/joy.yaml')  ->  Package('joy', executables={'joy_node': Program(…)}, …), ()
    …  with 'publisher:' for 'publishers:'       ->  None, (Finding RW324 "unknown key 'publisher'; expected one of: …",)

The notation is described in docs/declared-nodes.md.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Final

from rosward.deployment.declared.read_flows import read_flow
from rosward.deployment.declared.shapes import (
    DeclaredCondition,
    DeclaredParameter,
    EndpointGroup,
    EndpointTemplate,
    FlowTemplate,
    IncludedDeclaration,
    Loop,
    NodeShape,
    PackageDeclaration,
    Program,
    Scalar,
    Window,
)
from rosward.findings import Finding
from rosward.location import Place
from rosward.ros.distro import Distro
from rosward.ros.entities import Qos
from rosward.ros.implicit import ClientLibrary
from rosward.source.yaml_documents import YamlDocuments
from rosward.source.yaml_nodes import Item, Malformed

KINDS: Final = {
    "publishers": "publisher",
    "subscriptions": "subscription",
    "service_servers": "service_server",
    "service_clients": "service_client",
    "action_servers": "action_server",
    "action_clients": "action_client",
}
OPTIONS: Final = (
    "enable_rosout",
    "start_parameter_services",
    "start_parameter_event_publisher",
    "enable_logger_service",
    "lifecycle_services",
)

_FILE: Final = frozenset(
    ("nodl_version", "description", "package", "source", "client_library", "executables", "components", "interfaces")
)
_CONTENT: Final = frozenset(
    ("parameters", "include", "groups", "switch", "cases", "otherwise", "open", "flows", *KINDS)
)
_GROUP: Final = _CONTENT | {"when", "for_each", "since", "until", "description"}
_IDENTITY: Final = frozenset(
    ("node", "namespace", "lifecycle", "global_arguments", "options", "arguments", "client_library", "plugin")
)
_NODE: Final = _GROUP | _IDENTITY
_PROGRAM: Final = _NODE | {"nodes", "reader", "same_as"}
_ENDPOINT: Final = frozenset(("name", "type", "qos", "when", "since", "until", "description"))
_PARAMETER: Final = frozenset(("type", "default_value", "description", "read_only", "validation", "since", "until"))
_CONDITION: Final = frozenset(("param", "argument", "value", "is", "not", "in", "set", "installed"))
_LOOPS: Final = frozenset(("family", "words", "list", "below", "values"))
_MOST_INTERFACES: Final = 200
_VARIABLE: Final = re.compile(r"[a-z][a-z0-9_]*")
_TYPE: Final = re.compile(r"[A-Za-z][A-Za-z0-9_]*/(?:msg|srv|action)/[A-Z][A-Za-z0-9_]*")
_PART: Final = {"publishers": "msg", "subscriptions": "msg"}

_SENSOR_DATA: Final = Qos("best_effort", "volatile", "keep_last", 5)
_PROFILES: Final[Mapping[str, Qos]] = {
    "sensor_data": _SENSOR_DATA,
    "default": Qos("reliable", "volatile", "keep_last", 10),
    "parameters": Qos("reliable", "volatile", "keep_last", 1000),
    "services": Qos("reliable", "volatile", "keep_last", 10),
    "transient_local": Qos("reliable", "transient_local", "keep_last", 1),
    "system_default": Qos("system_default", "system_default", "system_default", None),
}
_POLICIES: Final = {
    "history": ("keep_last", "keep_all", "system_default"),
    "reliability": ("reliable", "best_effort", "system_default", "best_available"),
    "durability": ("volatile", "transient_local", "system_default", "best_available"),
}
_MORE_QOS: Final = frozenset(("deadline_ns", "lifespan_ns", "liveliness", "liveliness_lease_duration_ns"))


def read_package(
    text: str, file: str, package: str | None = None, documents: YamlDocuments | None = None
) -> tuple[PackageDeclaration | None, tuple[Finding, ...]]:
    """The package that a file declares, or why it cannot be read. `package`: the name that the file has to give."""
    try:
        item = (documents or YamlDocuments()).read(text, file)
        return _package(item, package), ()
    except Malformed as error:
        return None, (Finding("RW324", f"The declared interface cannot be read: {error.message}.", error.place),)


def _package(item: Item, wanted: str | None) -> PackageDeclaration:
    top = item.mapping(_FILE)
    if "nodl_version" not in top or top["nodl_version"].value != 2:
        raise Malformed("expected nodl_version: 2", item.place)
    for key in ("package", "source", "client_library"):
        if key not in top:
            raise Malformed(f"'{key}' is missing", item.place)
    name = top["package"].text()
    if wanted is not None and name != wanted:
        raise Malformed(f"the file of package {wanted} declares package {name}", top["package"].place)
    source = top["source"].text()
    library = _library(top["client_library"])
    interfaces = {k: _group(v) for k, v in _mapping(top, "interfaces").items()}
    programs = {
        kind: {k: _program(v, name, k, kind, source, library) for k, v in _mapping(top, kind).items()}
        for kind in ("executables", "components")
    }
    executables, components = _shared(top, "executables", programs), _shared(top, "components", programs)
    _check_includes(interfaces, name, item.place)
    return PackageDeclaration(name, executables, components, interfaces)


def _shared(top: Mapping[str, Item], kind: str, programs: Mapping[str, Mapping[str, Program]]) -> dict[str, Program]:
    """`same_as` another executable or component: the same nodes under another name."""
    found: dict[str, Program] = {}
    for name, program in programs[kind].items():
        shape = _mapping(top, kind)[name].mapping()
        if "same_as" not in shape:
            found[name] = program
            continue
        wanted = shape["same_as"].text()
        other = programs["executables"].get(wanted) or programs["components"].get(wanted)
        if other is None or (wanted == name and other is program) or set(shape) - {"same_as", "description"}:
            raise Malformed(f"same_as does not name another executable or component: {wanted}", shape["same_as"].place)
        found[name] = other._replace(name=name, kind=program.kind)
    return found


def _check_includes(interfaces: Mapping[str, EndpointGroup], package: str, place: Place) -> None:
    """No group of a file includes itself; what other files have is bounded when it is executed."""
    if len(interfaces) > _MOST_INTERFACES:
        raise Malformed(f"more than {_MOST_INTERFACES} interfaces", place)
    checked: set[str] = set()

    def visit(name: str, way: tuple[str, ...]) -> None:
        for include in _includes(interfaces[name]):
            short = include.name.removeprefix(f"{package}/")
            if "/" in short:
                continue
            if short not in interfaces:
                raise Malformed(f"there is no interface {short}", include.place)
            if short in (*way, name):
                raise Malformed(f"{short} includes itself", include.place)
            if short not in checked:
                visit(short, (*way, name))
        checked.add(name)

    for each in interfaces:
        if each not in checked:
            visit(each, ())


def _includes(group: EndpointGroup) -> tuple[IncludedDeclaration, ...]:
    inner = (*group.groups, *(g for _, g in group.cases), *((group.otherwise,) if group.otherwise else ()))
    return (*group.includes, *(i for g in inner for i in _includes(g)))


def _mapping(of: Mapping[str, Item], key: str) -> dict[str, Item]:
    return of[key].mapping() if key in of else {}


def _items(of: Mapping[str, Item], key: str) -> list[Item]:
    return of[key].items() if key in of else []


def _library(item: Item) -> ClientLibrary:
    try:
        return ClientLibrary(item.text())
    except ValueError:
        raise Malformed("client_library must be rclcpp or rclpy", item.place) from None


def _program(item: Item, package: str, name: str, kind: str, source: str, library: ClientLibrary) -> Program:
    shape = item.mapping(_PROGRAM)
    nodes: list[NodeShape] = []
    if "node" in shape:
        nodes.append(_node(Item({k: v for k, v in shape.items() if k in _NODE}, item.place), library))
    elif set(shape) & (_NODE - {"open", "description", "since", "until"}):
        raise Malformed("'node' is missing: the default name of the node", item.place)
    nodes += [_node(each, library) for each in _items(shape, "nodes")]
    open_ = None if "node" in shape else _text(shape, "open")
    reader = _text(shape, "reader")
    if not nodes and reader is None and open_ is None and "same_as" not in shape and "nodes" not in shape:
        raise Malformed("'nodes' is missing: write 'nodes: []' if it creates no node", item.place)
    return Program(package, name, kind.removesuffix("s"), source, tuple(nodes), reader, open_, item.place)


def _node(item: Item, library: ClientLibrary) -> NodeShape:
    shape = item.mapping(_NODE)
    if "node" not in shape:
        raise Malformed("'node' is missing: the default name of the node", item.place)
    options = _mapping(shape, "options")
    for key, option in options.items():
        if key not in OPTIONS:
            raise Malformed(f"unknown option '{key}'; expected one of: {', '.join(OPTIONS)}", option.place)
    return NodeShape(
        shape["node"].text(),
        _text(shape, "namespace"),
        shape["lifecycle"].flag() if "lifecycle" in shape else False,
        shape["global_arguments"].flag() if "global_arguments" in shape else True,
        tuple((k, v.flag()) for k, v in options.items()),
        tuple(i.text() for i in _items(shape, "arguments")),
        _library(shape["client_library"]) if "client_library" in shape else library,
        _group(Item({k: v for k, v in shape.items() if k in _GROUP}, item.place)),
        item.place,
        _text(shape, "plugin"),
    )


def _text(of: Mapping[str, Item], key: str) -> str | None:
    return of[key].text() if key in of else None


def _group(item: Item) -> EndpointGroup:
    shape = item.mapping(_GROUP)
    loops = tuple(_loop(each) for each in _one_or_many(shape, "for_each"))
    return _content(shape)._replace(when=_when(shape), window=_window(shape), loops=loops)


def _one_or_many(of: Mapping[str, Item], key: str) -> list[Item]:
    if key not in of:
        return []
    return of[key].items() if isinstance(of[key].value, list) else [of[key]]


def _content(shape: Mapping[str, Item]) -> EndpointGroup:
    cases = tuple((name, _group(each)) for name, each in _mapping(shape, "cases").items())
    if ("switch" in shape) != ("cases" in shape) or ("otherwise" in shape and "switch" not in shape):
        place = next(v.place for k, v in shape.items() if k in ("switch", "cases", "otherwise"))
        raise Malformed("'switch', 'cases' and 'otherwise' must be used together", place)
    return EndpointGroup(
        parameters=tuple(_parameter(n, i) for n, i in _mapping(shape, "parameters").items()),
        endpoints=tuple(_endpoint(each, key) for key in KINDS for each in _items(shape, key)),
        includes=tuple(_include(each) for each in _items(shape, "include")),
        groups=tuple(_group(each) for each in _items(shape, "groups")),
        switch=_text(shape, "switch"),
        cases=cases,
        otherwise=_group(shape["otherwise"]) if "otherwise" in shape else None,
        open=_text(shape, "open"),
        flows=tuple(_flow(each) for each in _items(shape, "flows")),
    )


def _flow(item: Item) -> FlowTemplate:
    flow, shape = read_flow(item), item.mapping()
    return flow._replace(when=_when(shape), window=_window(shape))


def _include(item: Item) -> IncludedDeclaration:
    if isinstance(item.value, str):
        return IncludedDeclaration(item.value, (), item.place)
    shape = item.mapping(frozenset(("interface", "with")))
    if "interface" not in shape:
        raise Malformed("'interface' is missing: the name of the included interface", item.place)
    variables = tuple((k, v.text()) for k, v in _mapping(shape, "with").items())
    return IncludedDeclaration(shape["interface"].text(), variables, item.place)


def _loop(item: Item) -> Loop:
    shape = item.mapping(_LOOPS | {"as"})
    sources = sorted(set(shape) & _LOOPS)
    if len(sources) != 1 or "as" not in shape or not _VARIABLE.fullmatch(shape["as"].text()):
        raise Malformed("expected 'as: VARIABLE' and one of family, words, list, below, values", item.place)
    source = sources[0]
    if source == "values":
        return Loop(shape["as"].text(), source, "", tuple(i.text() for i in shape[source].items()))
    of = shape[source].text()
    if source == "family" and of.count("{n}") != 1:
        raise Malformed("a family must have {n} in place of its number", shape[source].place)
    return Loop(shape["as"].text(), source, of)


def _window(shape: Mapping[str, Item]) -> Window:
    return Window(_distro(shape, "since"), _distro(shape, "until"))


def _distro(shape: Mapping[str, Item], key: str) -> Distro | None:
    known = {d.value: d for d in Distro}
    if key in shape and shape[key].text() not in known:
        raise Malformed(f"'{key}' must name a distribution: {', '.join(known)}", shape[key].place)
    return known[shape[key].text()] if key in shape else None


def _when(shape: Mapping[str, Item]) -> tuple[DeclaredCondition, ...]:
    return tuple(_condition(each) for each in _one_or_many(shape, "when"))


def _condition(item: Item) -> DeclaredCondition:
    shape = item.mapping(_CONDITION)
    if set(shape) == {"installed"}:
        return DeclaredCondition(shape["installed"].text(), "installed", ())
    subjects = [k for k in ("param", "argument", "value") if k in shape]
    tests = [k for k in ("is", "not", "in", "set") if k in shape]
    if len(subjects) != 1 or len(tests) != 1:
        raise Malformed("a condition needs one of param, argument, value and one of is, not, in, set", item.place)
    subject, test = shape[subjects[0]].text(), tests[0]
    template = subject if subjects[0] == "value" else f"${{{subjects[0]}:{subject}}}"
    values: tuple[Scalar, ...]
    if test == "in":
        values = tuple(i.scalar() for i in shape["in"].items())
    elif test == "set":
        if subjects[0] == "value":
            raise Malformed("'set' requires a param or an argument", item.place)
        values = (shape["set"].flag(),)
    else:
        values = (shape[test].scalar(),)
    return DeclaredCondition(template, test, values)


def _parameter(name: str, item: Item) -> DeclaredParameter:
    shape = item.mapping(_PARAMETER)
    default: Scalar | tuple[Scalar, ...] | None = None
    if "default_value" in shape:
        raw = shape["default_value"]
        default = tuple(i.scalar() for i in raw.value) if isinstance(raw.value, list) else raw.scalar()
    return DeclaredParameter(name, _text(shape, "type"), default, item.place, _window(shape))


def _endpoint(item: Item, key: str) -> EndpointTemplate:
    shape = item.mapping(_ENDPOINT)
    for needed in ("name", "type"):
        if needed not in shape:
            raise Malformed(f"'{needed}' is missing", item.place)
    name, type_ = shape["name"].text(), shape["type"].text()
    part = "msg" if key in ("publishers", "subscriptions") else "srv" if key.startswith("service") else "action"
    if "${" not in type_ and not _is_type(type_, part):
        raise Malformed(f"{type_} is not a type of this kind: expected package/{part}/Name", shape["type"].place)
    if not name or any(c.isspace() or c == "*" for c in name):
        raise Malformed("a name must not contain spaces or '*'", shape["name"].place)
    qos = _qos(shape["qos"]) if "qos" in shape else None
    if qos is None and part == "msg":
        raise Malformed("'qos' is missing", item.place)
    return EndpointTemplate(KINDS[key], name, type_, qos, _when(shape), _window(shape), item.place)


def _is_type(type_: str, part: str) -> bool:
    """Whether a type is one of this kind; topics also carry the events of services and the feedback of actions."""
    if not _TYPE.fullmatch(type_):
        return False
    return type_.split("/")[1] == part or (part == "msg" and type_.endswith(("_Event", "_FeedbackMessage")))


def _qos(item: Item) -> Qos:
    value = item.value
    if isinstance(value, int) and not isinstance(value, bool):
        return Qos("reliable", "volatile", "keep_last", value)
    if isinstance(value, str):
        if value in _PROFILES:
            return _PROFILES[value]
        raise Malformed(f"unknown profile '{value}'; expected one of: {', '.join(_PROFILES)}", item.place)
    shape = item.mapping(frozenset((*_POLICIES, "depth")) | _MORE_QOS)
    words: dict[str, str | None] = dict.fromkeys(_POLICIES)
    for policy, known in _POLICIES.items():
        if policy in shape:
            word = shape[policy].text().lower()
            if word not in known:
                raise Malformed(f"{policy} must be one of {', '.join(k.upper() for k in known)}", shape[policy].place)
            words[policy] = word
    depth = shape["depth"].value if "depth" in shape else None
    if depth is not None and (not isinstance(depth, int) or isinstance(depth, bool)):
        raise Malformed("depth must be a number", shape["depth"].place)
    return Qos(words["reliability"], words["durability"] or "volatile", words["history"] or "keep_last", depth)
