# SPDX-License-Identifier: Apache-2.0
"""What is in the graph of a program whose interface nobody knows: a node, with what every node has, and a finding (RW314).

Node(package='acme', executable='driver', name='lidar')  ->  /lidar, of unknown interface
"""

from __future__ import annotations

from rosward.deployment.launched import Launched
from rosward.deployment.started import StartKind
from rosward.domain.series import Series
from rosward.domain.unknown import Cause, Reason
from rosward.domain.values import NONE, Const, Unknown, Value
from rosward.effects.log import EffectLog, NodeEffect
from rosward.findings import Finding

_ADDRESS = 1


def undeclared(launched: Launched) -> EffectLog:
    """The effects of such a program. Its name, where the launch file gives none, is not known either."""
    given = launched.configuration
    log = EffectLog(given)
    place = launched.started.place
    label = "/".join(filter(None, (launched.package, launched.executable))) or "of an unknown package"
    unnamed = Unknown((Reason(Cause.MODULE, label, place),), "str")
    component = launched.started.plugin is not None
    options: tuple[tuple[str, Value], ...] = (("client_library", Const("rclcpp")),)
    if launched.started.kind is StartKind.LIFECYCLE:
        options += (("lifecycle", Const(True)),)
    effect = NodeEffect(
        address=_ADDRESS,
        name=unnamed,
        namespace=NONE,
        options=options,
        words=Series(given.component or ()),
        global_words=Series(given.words if given.component is None else ()),
        cls=Unknown(()),
        place=place,
        late=False,
        assumed=True,
    )
    log.nodes[effect] = None
    what = "component" if component else "node"
    remedy = _remedy(launched)
    message = f"the interface of the {what} {label} is unknown: {launched.unknown}{remedy}"
    log.findings.add(Finding("RW314", message, place, (launched.cause,) if launched.cause else (), remedy=remedy))
    return log


def _remedy(launched: Launched) -> str:
    """What to type, where something can be declared at all."""
    if launched.package is None or launched.executable is None:
        return ""
    return f"; `rosward declare {launched.package}/{launched.executable}` creates a declaration for it"
