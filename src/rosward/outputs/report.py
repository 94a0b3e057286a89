# SPDX-License-Identifier: Apache-2.0
"""The report: one HTML file that needs nothing else, with the graph, the numbers, every node with its policy, and the
doubts.

It works offline and loads nothing: a Content-Security-Policy forbids all but its own style and its own script, which it
names by its hash. So a name out of the sources, however it is made, stays text. The page is a Jinja template
(`templates/report.html.j2`); here the network is only put into rows.
"""

from __future__ import annotations

import base64
import hashlib
from collections.abc import Iterable
from importlib import resources
from typing import Final, NamedTuple

from jinja2 import Environment, FunctionLoader, StrictUndefined
from markupsafe import Markup, escape

from rosward._version import __version__
from rosward.findings import Severity
from rosward.network.checks import UnknownNames
from rosward.network.enclaves import enclave_paths
from rosward.network.graph import Network
from rosward.outputs.counts import counts_of
from rosward.outputs.doubts import doubts
from rosward.outputs.policy import policies
from rosward.outputs.safe import printable
from rosward.outputs.svg import graph_svg
from rosward.ros.entities import Entity, EntityKind, Node, Resolution

__all__ = ["report_html"]

_TABLES: Final = (
    (EntityKind.PUBLISHER, "Publishers"),
    (EntityKind.SUBSCRIPTION, "Subscriptions"),
    (EntityKind.SERVICE_SERVER, "Service servers"),
    (EntityKind.SERVICE_CLIENT, "Service clients"),
    (EntityKind.ACTION_SERVER, "Action servers"),
    (EntityKind.ACTION_CLIENT, "Action clients"),
)


class _Row(NamedTuple):
    """One entity in a table."""

    kind: str
    entity: Entity
    places: str
    remarks: str


class _Page(NamedTuple):
    """One node with its tables and the policy of its enclave."""

    node: Node
    summary: str
    own: list[_Row]
    system: list[_Row]
    enclave: str
    policy: Markup


def report_html(network: Network, system: bool = False, unknown: UnknownNames = "deny") -> str:
    """The page as text. `system` shows in the graph what the client library makes; the tables always do."""
    paths = enclave_paths(network.nodes)
    policy_of = policies(network, unknown)
    script = _template("report.js")
    environment = Environment(
        loader=FunctionLoader(_template),
        autoescape=True,
        finalize=_shown,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )
    return environment.get_template("report.html.j2").render(
        version=__version__,
        network=network,
        counts=counts_of(network),
        resolutions=list(Resolution),
        severities=list(Severity),
        graph=Markup(graph_svg(network, system, links=True)),
        doubts=doubts(network.findings),
        pages=[_page(node, paths[node.enclave], policy_of) for node in network.nodes],
        style=Markup(_template("report.css")),
        script=Markup(script),
        script_hash=base64.b64encode(hashlib.sha256(script.encode()).digest()).decode(),
    )


def _template(name: str) -> str:
    return (resources.files("rosward.outputs") / "templates" / name).read_text(encoding="utf-8")


def _shown(value: object) -> object:
    """What Jinja writes for an expression: text without control characters and direction marks, nothing for None."""
    if isinstance(value, Markup):
        return value
    return "" if value is None else printable(str(value))


def _page(node: Node, enclave: str, policy_of: dict[str, str]) -> _Page:
    rows = [_row(title, entity) for kind, title in _TABLES for entity in node.of_kind(kind)]
    own = [row for row in rows if not row.entity.system]
    return _Page(
        node=node,
        summary=_in_words(own),
        own=own,
        system=[row for row in rows if row.entity.system],
        enclave=enclave,
        policy=escape(policy_of[enclave]),
    )


def _row(title: str, entity: Entity) -> _Row:
    remarks = [f"by {entity.via}"] if entity.via else []
    remarks += ["conditional"] if entity.conditional else []
    remarks += [] if entity.ros_prefix else ["outside the ROS name space"]
    remarks += [f"depends on {', '.join(entity.depends_on)}"] if entity.depends_on else []
    remarks += entity.reasons
    places = ", ".join(f"{place.file}:{place.line}" for place in entity.created_at)
    return _Row(title, entity, places, "; ".join(remarks))


def _in_words(rows: Iterable[_Row]) -> str:
    """`2 publishers, 1 service client`."""
    numbers: dict[str, int] = {}
    for row in rows:
        numbers[row.entity.kind.value] = numbers.get(row.entity.kind.value, 0) + 1
    return ", ".join(f"{number} {kind}{'s' if number > 1 else ''}" for kind, number in numbers.items())
