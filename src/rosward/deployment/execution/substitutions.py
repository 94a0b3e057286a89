# SPDX-License-Identifier: Apache-2.0
"""What each substitution gives: one function for each kind."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.deployment.execution.perform_logic import LOGIC
from rosward.deployment.execution.perform_names import NAMES
from rosward.deployment.execution.perform_paths import PATHS
from rosward.domain.values import EMPTY, Value

if TYPE_CHECKING:
    from rosward.deployment.execution.scene import Performing, Scene
    from rosward.deployment.tree import Substitution


def _rewritten(scene: Scene, substitution: Substitution) -> Value:
    """RewrittenYaml of nav2_common: the path of a new file."""
    source, *rest = [scene.text(t) for t in substitution.arguments]
    root, convert = (*rest, EMPTY, EMPTY)[:2]
    tables = [
        tuple((scene.text(k), scene.text(v)) for k, v in table) for table in (*substitution.tables, (), (), ())[:3]
    ]
    return scene.generated.rewritten(source, tables, root, convert, substitution.place)


def _has_node_params(scene: Scene, substitution: Substitution) -> Value:
    """HasNodeParams of nav2_common: whether a parameter file has a key at its top."""
    source, key = (scene.text(t) for t in substitution.arguments[:2])
    return scene.generated.has_key(source, key, substitution.place)


def _replaced(scene: Scene, substitution: Substitution) -> Value:
    """ReplaceString of nav2_common: the path of a new file."""
    source = scene.text(substitution.arguments[0])
    table = substitution.tables[0] if substitution.tables else ()
    pairs = tuple((scene.text(k), scene.text(v)) for k, v in table)
    return scene.generated.replaced(source, pairs, substitution.place)


SUBSTITUTIONS: Final[dict[str, Performing]] = {
    **PATHS,
    **LOGIC,
    **NAMES,
    "rewritten-yaml": _rewritten,
    "replace-string": _replaced,
    "has-node-params": _has_node_params,
}
