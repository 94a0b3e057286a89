# SPDX-License-Identifier: Apache-2.0
"""The full names that a name may have in a node: expanded, and remapped by the rules of its process."""

from __future__ import annotations

from typing import Final

from rosward.findings import Findings
from rosward.holes import Holed
from rosward.location import Place
from rosward.naming.doubts import invalid_name
from rosward.naming.final_name import remapped_by
from rosward.naming.implicit import Identity
from rosward.naming.options import NameOption, name_options
from rosward.ros import names
from rosward.ros.distro import Distro
from rosward.ros.entities import EntityKind, Resolution, least_sure

SERVICES: Final = (EntityKind.SERVICE_SERVER, EntityKind.SERVICE_CLIENT)
ACTIONS: Final = (EntityKind.ACTION_SERVER, EntityKind.ACTION_CLIENT)


def resolved(
    kind: EntityKind,
    option: NameOption,
    identity: Identity,
    distro: Distro,
    place: Place,
    findings: Findings,
) -> list[tuple[Holed, NameOption]]:
    """The full names that a name may have, each with how it was found: behind a remap rule, as that rule's target was."""
    remap = names.RemapKind.SERVICE if kind in SERVICES else names.RemapKind.TOPIC
    rules = identity.rules
    if kind in ACTIONS and not distro.facts.actions_are_remapped:
        rules = ()
    if option.resolution is Resolution.UNKNOWN:
        rules = ()  # any rule may be for it: that makes none of their targets its name
    own, space = identity.name, identity.namespace
    try:
        found = names.resolve(option.text, remap, tuple(r.rule for r in rules), own, space)
    except names.InvalidName as error:
        findings.add(invalid_name(kind.value, option.text, str(error), place, option.depends_on))
        return []
    result: list[tuple[Holed, NameOption]] = []
    for text in found:
        target = remapped_by(text, option.text, remap, rules, own, space) if rules else None
        result.append((text, option if target is None else _behind_rule(option, name_options(target)[0])))
    return result


def _behind_rule(name: NameOption, target: NameOption) -> NameOption:
    """How a name was found that a remap rule gives: as the rule's target was, and, since the rule fits this name only, as that was."""
    depends = tuple(sorted({*name.depends_on, *target.depends_on}))
    known = name.resolution.whole and target.resolution.whole
    resolution = least_sure(name.resolution, target.resolution) if known else target.resolution
    return target._replace(depends_on=depends, resolution=resolution)
