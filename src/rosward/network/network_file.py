# SPDX-License-Identifier: Apache-2.0
"""Which nodes does an earlier `network.json` say that there are?

    {"schema_version": 2, "nodes": [{"fqn": "/talker", …, "publishers": [{"name": "/chatter", …}]}], "diagnostics": […]}
      ->  the nodes as `rosward.extract` gave them, and the findings

Files of version 1 are read, too: they do not say what was asked, and of interfaces what findings say.
Why a name is not known is not in the file, only where; and a node is one of some runs only where all that it has itself is. That it is
assumed, its process says.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Final

from rosward.findings import Finding
from rosward.location import Place
from rosward.network.asked import NOT_TOLD, Asked, LaunchAsked
from rosward.records import NamedTuple
from rosward.ros.entities import ENTITY_LISTS, Entity, Interface, Node, Qos, Resolution, is_assumed_label
from rosward.rules import RULES
from rosward.source.json_fields import Fields, UnreadableError, json_document

__all__ = ["NetworkRead", "qos_of", "read_network"]

_MOST: Final = 200_000
_VERSIONS: Final = (1, 2)
_RESOLUTIONS: Final = {r.value: r for r in Resolution}
_INTERFACES: Final = {i.value: i for i in Interface}


class NetworkRead(NamedTuple):
    """What is in a file. `distro` is that of the extraction, `asked` the rest of the question."""

    distro: str
    nodes: tuple[Node, ...]
    findings: tuple[Finding, ...]
    asked: Asked = NOT_TOLD


def read_network(path: str) -> NetworkRead:
    """What a file says. Raises UnreadableError."""
    document = json_document(path)
    try:
        top = Fields(document, "the document")
        version = top.version(*_VERSIONS)
        distro = top.text("distro")
        nodes = tuple(_node(fields, version) for fields in top.objects("nodes", _MOST))
        findings = tuple(f for fields in top.objects("diagnostics", _MOST) for f in _findings(fields))
        return NetworkRead(
            distro=distro,
            nodes=nodes if version > 1 else tuple(_as_found(node, findings) for node in nodes),
            findings=findings,
            asked=_asked(top.inner("asked")) if version > 1 else NOT_TOLD,
        )
    except UnreadableError as error:
        raise UnreadableError(f"{path}: not a rosward network.json: {error}") from error


def _asked(fields: Fields) -> Asked:
    options = fields.inner("options")
    return Asked(
        paths=tuple(fields.texts("paths", _MOST)),
        launch=tuple(
            LaunchAsked(each.text("file"), tuple(each.texts_by_name("arguments", _MOST).items()))
            for each in fields.objects("launch", _MOST)
        ),
        all_launch=fields.flag("all_launch", False),
        arguments=tuple(fields.texts_by_name("arguments", _MOST).items()),
        nodes=tuple(fields.texts("nodes", _MOST)),
        parameter_files=tuple(fields.texts("parameter_files", _MOST)),
        environment=tuple(fields.texts_by_name("environment", _MOST).items()),
        options=tuple((name, options.option(name, _MOST)) for name in options.names()),
        models=fields.text("models"),
    )


def _as_found(node: Node, findings: tuple[Finding, ...]) -> Node:
    """A node of version 1 with what its findings say of its interface. One that a launch file makes, and no source, is declared."""
    at = {(p.file, p.line) for p in (node.defined_at, node.launched_by) if p is not None}
    lacks = tuple(f.message for f in findings if f.code == "RW314" and (f.place.file, f.place.line) in at)
    if lacks:
        partial = all("not wholly known" in message for message in lacks)
        return replace(node, interface=Interface.PARTIAL if partial else Interface.UNKNOWN, lacks=lacks)
    return replace(node, interface=Interface.DECLARED) if node.defined_at == node.launched_by else node


def _node(fields: Fields, version: int) -> Node:
    defined = fields.inner("defined_at")
    entities = tuple(_entities(fields))
    own = [e for e in entities if not e.system]
    launched = fields.inner("launched_by") if "launched_by" in fields else None
    executable, process = fields.text_or_none("executable"), fields.text("process")
    label = fields.text("label") if version > 1 else fields.text("fqn")
    assumed = executable is None and is_assumed_label(process)
    return Node(
        namespace=fields.text("namespace"),
        name=fields.text("name"),
        resolution=fields.one_of("resolution", _RESOLUTIONS),
        enclave=fields.text("enclave"),
        package=fields.text_or_none("package"),
        executable=executable,
        process=process,
        launched_by=None if launched is None else _place(launched),
        defined_at=_place(defined),
        entities=entities,
        # a node of which the file does not say it itself
        conditional=assumed or (bool(own) and all(e.conditional for e in own)),
        assumed=assumed,
        interface=fields.one_of("interface", _INTERFACES) if version > 1 else Interface.ANALYSED,
        lacks=tuple(fields.texts("lacks", _MOST)) if version > 1 else (),
        label=None if label == fields.text("fqn") else label,
    )


def _entities(fields: Fields) -> Iterator[Entity]:
    for key, kind in ENTITY_LISTS.items():
        for entity in fields.objects(key, _MOST):
            yield Entity(
                kind=kind,
                name=entity.text("name"),
                type=entity.text_or_none("type"),
                system=entity.flag("system", False),
                resolution=entity.one_of("resolution", _RESOLUTIONS),
                conditional=entity.flag("conditional", False),
                qos=qos_of(entity.inner("qos")) if "qos" in entity else None,
                depends_on=tuple(entity.texts("depends_on", _MOST)),
                created_at=tuple(_place(place) for place in entity.objects("created_at", _MOST)),
            )


def _findings(fields: Fields) -> tuple[Finding, ...]:
    """The finding; none where a later version has a code that this one does not."""
    code = fields.text("code")
    place = Place(fields.text("file"), fields.number("line"), fields.number("column"))
    causes, nodes = (tuple(fields.texts(key, _MOST)) if key in fields else () for key in ("causes", "nodes"))
    return (Finding(code, fields.long_text("message"), place, causes, nodes),) if code in RULES else ()


def _place(fields: Fields) -> Place:
    return Place(fields.text("file"), fields.number("line"))


def qos_of(fields: Fields) -> Qos:
    """What an object says of a QoS profile."""
    return Qos(
        fields.text_or_none("reliability"),
        fields.text_or_none("durability"),
        fields.text_or_none("history"),
        fields.integer_or_none("depth"),
    )
