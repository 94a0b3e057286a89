# SPDX-License-Identifier: Apache-2.0
"""From the effects of one process to its nodes: names expanded and remapped, implicit entities added, doubts turned into findings."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Final

from rosward.domain.compound import Tuple
from rosward.domain.text import pattern
from rosward.domain.unknown import Cause, causes_of
from rosward.domain.values import Const, Value
from rosward.effects.log import EffectLog, EntityEffect, NodeEffect, ParameterEffect
from rosward.findings import Finding, Findings
from rosward.holes import HOLE, Holed
from rosward.location import Place
from rosward.naming import implicit
from rosward.naming.doubts import invalid_name, unknown_name, unknown_node, unknown_type
from rosward.naming.final_name import command_lines, final_name, remaps_of
from rosward.naming.flows import both, with_flows
from rosward.naming.implicit import Identity
from rosward.naming.options import NameOption, interface_types, name_options, together
from rosward.naming.resolved import ACTIONS, resolved
from rosward.records import NamedTuple, replace
from rosward.ros import names
from rosward.ros.distro import Distro
from rosward.ros.entities import Entity, EntityKind, Interface, Node, Parameter, Resolution, least_sure
from rosward.ros.implicit import service_event_topic

KINDS: Final = {
    "publisher": EntityKind.PUBLISHER,
    "subscription": EntityKind.SUBSCRIPTION,
    "service_server": EntityKind.SERVICE_SERVER,
    "service_client": EntityKind.SERVICE_CLIENT,
    "action_server": EntityKind.ACTION_SERVER,
    "action_client": EntityKind.ACTION_CLIENT,
}
_NO_VARIABLES: Final[Mapping[str, Value]] = {}


class Process(NamedTuple):
    """What is known of a process beside its effects: its package and executable, its label, and what every execution does.

    `launched_by` is the place in a launch file that starts it; `conditional`: some execution does not start it; `assumed`: nothing does.
    `shell` are the variables that it finds in its environment, unless it is given others.
    `interface` is what is known of its program, were it wholly known; `lacks`: why not, beside what its findings say.
    """

    package: str | None
    executable: str | None
    label: str
    done: frozenset[tuple[object, ...]]
    launched_by: Place | None = None
    conditional: bool = False
    assumed: bool = False
    shell: Mapping[str, Value] = _NO_VARIABLES
    interface: Interface = Interface.ANALYSED
    lacks: tuple[str, ...] = ()


_MAY_HAVE_MORE: Final = frozenset(
    {"RW106", "RW201", "RW202", "RW203", "RW204", "RW206", "RW207", "RW208", "RW212", "RW299", "RW314"}
)
"""What is found in a program that may have more than was found."""


def collect(log: EffectLog, process: Process, distro: Distro) -> tuple[list[Node], list[Finding]]:
    """The nodes of a process and the findings about their names."""
    findings = Findings()
    nodes: list[Node] = []
    identities: list[tuple[int, Identity]] = []
    for effect in log.nodes:
        for identity in _identities(log, effect, findings):
            identities.append((effect.address, identity))
            own = Findings()
            node = _node(log, effect, identity, process, distro, own)
            own.update(more := log.open.get(effect.address, Findings()))
            findings.update(f._replace(nodes=(node.fqn,)) for f in own)
            nodes.append(replace(node, lacks=_told(more)))
    lacks = _told(f for f in log.findings if f.code in _MAY_HAVE_MORE)
    if log.flows is not None:
        nodes = with_flows(nodes, identities, log.flows, distro)
    return [_with_interface(n, process, lacks) for n in _merged(nodes)], list(findings)


def _told(findings: Iterable[Finding]) -> tuple[str, ...]:
    return tuple(f"{f.code}: {f.message}" for f in findings)


def _with_interface(node: Node, process: Process, lacks: tuple[str, ...]) -> Node:
    """The node with how completely its interface is known: in part, where the program or a name of its own says that there may be more."""
    interface, given = process.interface, process.lacks
    if interface is Interface.UNKNOWN:
        return replace(node, interface=interface, lacks=given)
    nameless = sorted(
        {_nameless(e) for e in node.entities if e.resolution is Resolution.UNKNOWN and not e.system},
    )
    reasons = (*dict.fromkeys((*given, *node.lacks, *lacks)), *nameless)
    return replace(node, interface=Interface.PARTIAL if reasons else interface, lacks=reasons)


def _nameless(entity: Entity) -> str:
    """What the interface of a node lacks by an entity without a name."""
    if entity.reasons and all(reason.startswith(Cause.OTHER.value) for reason in entity.reasons):
        return f"RW108: a {entity.kind.value} is off by default"
    return f"RW101: the name of a {entity.kind.value} is unknown"


def _identities(log: EffectLog, effect: NodeEffect, findings: Findings) -> list[Identity]:
    if _refused(log, effect):
        return []
    name_value, space_value = final_name(log, effect)
    rules = remaps_of(log, effect)
    found: list[Identity] = []
    spaces = name_options(together(space_value))
    own = name_options(together(name_value), filled=True)
    for space in spaces:
        for option in own:
            wrong = names.validate_node_name(option.text) or names.validate_namespace(names.full_namespace(space.text))
            if wrong:
                findings.add(
                    invalid_name(
                        "node",
                        option.text if names.validate_node_name(option.text) else space.text,
                        wrong,
                        effect.place,
                    )
                )
                continue
            namespace = names.full_namespace(space.text)
            about = (names.fully_qualified(namespace, option.text),)
            resolution = least_sure(option.resolution, space.resolution)
            if not option.resolution.whole and not effect.assumed:
                findings.add(unknown_node(option, effect.place)._replace(nodes=about))
            if not space.resolution.whole:
                findings.add(unknown_node(space, effect.place, "namespace")._replace(nodes=about))
            reasons = tuple(str(r) for r in (*option.reasons, *space.reasons))
            depends = tuple(sorted({*option.depends_on, *space.depends_on}))
            causes = causes_of((*option.reasons, *space.reasons), effect.place)
            sole = len(spaces) * len(own) == 1
            found.append(Identity(option.text, namespace, rules, resolution, depends, reasons, causes, sole))
    return found


def _refused(log: EffectLog, effect: NodeEffect) -> bool:
    """Whether rcl refuses the arguments of the node: then there is none. Where they are given, that is told."""
    return any(line.errors for line in command_lines(log, effect))


def _node(
    log: EffectLog,
    effect: NodeEffect,
    identity: Identity,
    process: Process,
    distro: Distro,
    findings: Findings,
) -> Node:
    started = not process.conditional and not process.assumed
    certain = identity.sole and not effect.late and started and ("node", effect.address) in process.done
    entities: list[Entity] = []
    for entity in log.entities:
        if entity.address == effect.address:
            sure = certain and EffectLog.key(entity) in process.done
            path = log.paths.get(entity, ())
            entities += _entities(entity, identity, distro, findings, path, sure=sure)
    made, asked = implicit.of_client_library(log, effect, identity, distro)
    for each in made:
        if HOLE in each.name and HOLE not in identity.namespace + identity.name:
            option = NameOption(Holed(each.name), each.resolution, (), ())
            findings.add(unknown_name(each.kind.value, each, option, effect.place))
    entities = [replace(e, system=True) if (e.kind, e.name, e.type) in asked else e for e in entities]
    entities += [e if identity.sole else replace(e, conditional=True) for e in made]
    if not certain:
        entities = [replace(e, conditional=True) for e in entities]
    fqn = names.fully_qualified(identity.namespace, identity.name)
    return Node(
        namespace=identity.namespace,
        name=identity.name,
        resolution=identity.resolution,
        enclave=fqn,
        package=process.package,
        executable=process.executable,
        process=process.label,
        launched_by=process.launched_by,
        given_enclave=_given_enclave(log, effect, process),
        defined_at=effect.place,
        entities=tuple(entities),
        parameters=tuple(_parameters(log, effect.address)),
        reasons=identity.reasons,
        causes=identity.causes,
        conditional=not certain,
        assumed=process.assumed,
    )


def _given_enclave(log: EffectLog, effect: NodeEffect, process: Process) -> str | None:
    """The enclave that the start of the process names: ROS_SECURITY_ENCLAVE_OVERRIDE, else the last --enclave."""
    configuration = log.configuration
    own: Mapping[str, Value | None] = configuration.environment if configuration is not None else {}
    override = {**process.shell, **own}.get("ROS_SECURITY_ENCLAVE_OVERRIDE")
    said = override if override is not None else command_lines(log, effect)[1].enclave
    return None if said is None else pattern(said)


def _entities(
    effect: EntityEffect,
    identity: Identity,
    distro: Distro,
    findings: Findings,
    path: tuple[Place, ...],
    *,
    sure: bool,
) -> list[Entity]:
    """The entities that one effect makes: one for each name and type that it may have."""
    kind = KINDS[effect.kind]
    possible = name_options(effect.name, filled=True)
    types = interface_types(effect.type)
    result: list[Entity] = []
    for option in possible:
        full = resolved(kind, option, identity, distro, effect.place, findings)
        alone = len(possible) * len(types) * len(full) == 1
        for text, how in full:
            for type_ in types:
                entity = _entity(effect, kind, text, type_, how, identity, path, sure=sure and alone)
                if type_ is None:
                    findings.add(unknown_type(kind.value, text, effect.type, effect.place))
                if not entity.resolution.whole and not _from_node_only(how):
                    findings.add(unknown_name(kind.value, entity, how, effect.place))
                result.append(entity)
                if effect.introspection and type_ is not None:
                    for event in _events(kind, distro, text, type_):
                        result.append(
                            replace(event, system=True, conditional=entity.conditional, created_at=entity.created_at)
                        )
    return result


def _events(kind: EntityKind, distro: Distro, name: str, type_: str) -> list[Entity]:
    """What introspection publishes: of a service, or of the three services of an action."""
    if kind not in ACTIONS:
        events = [service_event_topic(distro, name, type_)]
    else:
        parts = (
            ("send_goal", f"{type_}_SendGoal"),
            ("get_result", f"{type_}_GetResult"),
            ("cancel_goal", "action_msgs/srv/CancelGoal"),
        )
        events = [service_event_topic(distro, f"{name}/_action/{part}", t, action=True) for part, t in parts]
    return [e for e in events if e is not None]


def _from_node_only(option: NameOption) -> bool:
    """The name itself is known: its hole stems from the node's own name or namespace, of which a finding speaks already."""
    return option.resolution.whole


def _entity(
    effect: EntityEffect,
    kind: EntityKind,
    text: str,
    type_: str | None,
    option: NameOption,
    identity: Identity,
    path: tuple[Place, ...],
    *,
    sure: bool,
) -> Entity:
    resolution = option.resolution
    depends, reasons = option.depends_on, tuple(str(r) for r in option.reasons)
    causes = causes_of(option.reasons, effect.place)
    if not option.text.startswith("/"):
        if HOLE in text or resolution.whole:
            resolution = least_sure(resolution, identity.resolution)
        depends = tuple(sorted({*depends, *identity.depends_on}))
        causes = tuple(sorted({*causes, *identity.causes}))
        reasons = (*reasons, *identity.reasons)
    if resolution is Resolution.UNKNOWN and HOLE in text and text.strip("/*"):
        resolution = Resolution.PATTERN
    if HOLE not in text and not resolution.whole:
        resolution = Resolution.DEFAULT if depends else Resolution.EXACT
    callback = effect.callback
    return Entity(
        kind=kind,
        name=text,
        type=type_,
        resolution=resolution,
        conditional=not sure,
        callback=callback,
        qos=effect.qos,
        depends_on=depends,
        created_at=(effect.place,),
        reasons=reasons,
        causes=causes,
        via=effect.via,
        ros_prefix=effect.ros_prefix,
        path=path,
        system=implicit.is_of_container(kind, text, type_),
    )


def _parameters(log: EffectLog, address: int) -> list[Parameter]:
    found: dict[str, Parameter] = {}
    for effect in log.parameters:
        if effect.address == address:
            for option in name_options(effect.name):
                found.setdefault(option.text, _parameter(option.text, effect))
    return [found[name] for name in sorted(found)]


def _parameter(name: str, effect: ParameterEffect) -> Parameter:
    default, value = plain(effect.default), plain(effect.value)
    return Parameter(name, _type_name(value if value is not None else default), default, value, effect.place)


def plain(value: Value) -> object:
    """The Python value of a constant, or of a list of constants; None where it is not known."""
    if isinstance(value, Const):
        return value.value if not isinstance(value.value, (bytes, complex)) else None
    if isinstance(value, Tuple):
        items = [plain(v) for v in value.items]
        return None if None in items else items
    return None


def _type_name(value: object) -> str | None:
    """The word of rcl for the type of a parameter's value. As for rclpy, a list without elements is one of bytes."""
    if isinstance(value, list):
        kinds = {_type_name(item) for item in value}
        return f"{kinds.pop()}_array" if len(kinds) == 1 and None not in kinds else None if kinds else "byte_array"
    for kind, word in ((bool, "bool"), (int, "integer"), (float, "double"), (str, "string")):
        if isinstance(value, kind):
            return word
    return None


def _merged(nodes: list[Node]) -> list[Node]:
    """Nodes of one full name that one place creates (in several contexts) are one node."""
    result: dict[tuple[str, object], Node] = {}
    for node in nodes:
        key = (node.fqn, node.defined_at)
        known = result.get(key)
        if known is None:
            result[key] = node
        else:
            merged = replace(
                known,
                entities=(*known.entities, *node.entities),
                parameters=_union(known.parameters, node.parameters),
                conditional=known.conditional and node.conditional,
                lacks=tuple(dict.fromkeys((*known.lacks, *node.lacks))),
                flows=both(known.flows, node.flows),
            )
            result[key] = merged
    return list(result.values())


def _union(left: tuple[Parameter, ...], right: tuple[Parameter, ...]) -> tuple[Parameter, ...]:
    found = {p.name: p for p in (*right, *left)}
    return tuple(found[n] for n in sorted(found))
