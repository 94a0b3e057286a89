# SPDX-License-Identifier: Apache-2.0
"""Expressions for a word that hang on a node: its parameters, its names, what is kept in its attributes.

parameter(draft, scope, 1)    ->  self.declare_parameter("param1", "left").value
"""

from __future__ import annotations

from typing import Final

from .draft import Draft, Scope, Way
from .values import word


def parameter(draft: Draft, scope: Scope, depth: int) -> str:
    name, node = draft.fresh("param"), scope.node
    value = word(draft, scope, depth)
    kind = draft.chooser.number(0, 6)
    if kind == 0:
        return f"{node}.declare_parameter({name!r}, {value}).value"
    if kind == 1:
        scope.add(f"{node}.declare_parameters('group', [({name!r}, {value})])")
        return f"{node}.get_parameter('group.{name}').value"
    if kind == 2:
        draft.need("from rclpy.parameter import Parameter")
        scope.add(
            f"{node}.declare_parameter({name!r}, 'declared')\n"
            f"{node}.set_parameters([Parameter({name!r}, value={value})])"
        )
        return f"{node}.get_parameter({name!r}).value"
    if kind == 3:
        draft.need("from rclpy.parameter import Parameter")
        return f"{node}.get_parameter_or({name!r}, Parameter({name!r}, Parameter.Type.STRING, {value})).value"
    if kind == 4:
        scope.add(f"{node}.declare_parameter({name!r}, [{value}, 'second'])")
        return f"{node}.get_parameter({name!r}).value[0]"
    if kind == 5:
        scope.add(f"{node}.declare_parameter({name!r}, {draft.chooser.number(1, 9)})")
        return f"('v' + str({node}.get_parameter({name!r}).get_parameter_value().integer_value))"
    scope.add(f"{node}.declare_parameter({name!r}, {value})")
    return f"{node}.get_parameter({name!r}).get_parameter_value().string_value"


def own_name(draft: Draft, scope: Scope, _depth: int) -> str:
    node = scope.node
    return draft.chooser.pick(
        [
            f"{node}.get_name()",
            f"('x' + {node}.get_fully_qualified_name())",
            f"{node}.get_namespace().replace('/', 'x')",
            f"('x' + {node}.resolve_topic_name('rel'))",
            f"type({node}).__name__",
        ]
    )


def attribute(draft: Draft, scope: Scope, depth: int) -> str:
    name, node = draft.fresh("attr"), scope.node
    value = word(draft, scope, depth)
    kind = draft.chooser.number(0, 4)
    if kind == 0:
        scope.add(f"setattr({node}, {name!r}, {value})")
        return f"{node}.{name}"
    if kind == 1:
        scope.add(f"{node}.{name} = {value}")
        return f"getattr({node}, {name!r})"
    if kind == 2:
        return f"getattr({node}, {name!r}, {value})"
    if kind == 3:
        scope.add(f"{node}.{name} = {value}")
        return f"({node}.{name} if hasattr({node}, {name!r}) else 'no')"
    scope.add(f"{node}.{name} = {value}\n{node}.{name} += '_more'")
    return f"{node}.{name}"


NODE_WAYS: Final[tuple[Way, ...]] = (parameter, parameter, own_name, attribute, attribute)
