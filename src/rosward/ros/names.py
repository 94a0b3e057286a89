# SPDX-License-Identifier: Apache-2.0
"""Which fully qualified name does a name in the source become?

    resolve("~/cmd", RemapKind.TOPIC, (), "arm", "/left")        -> ("/left/arm/cmd",)
    resolve("robot_*/cmd", RemapKind.TOPIC, (), "arm", "/left")  -> ("/left/robot_*/cmd",)

The rules are those of rcl (expand_topic_name.c, remap.c, node_resolve_name.c, node.c), the same from humble to
rolling. They are extended to names with *holes*: a `*`, not legal in a ROS name, stands for any text, also an empty
one and one with `/`. The law: however the holes are filled, what rcl makes of the filled name is matched by what
these functions make of the name with holes, and nothing is called invalid that some filling makes valid.
"""

from __future__ import annotations

import enum
import re
from collections.abc import Iterable, Sequence
from typing import Final

from rosward.holes import HOLE, Holed, with_stars
from rosward.records import NamedTuple
from rosward.ros.validation import (
    collapse,
    validate_enclave,
    validate_full,
    validate_name,
    validate_namespace,
    validate_node_name,
)

__all__ = [
    "HOLE",
    "InvalidName",
    "RemapKind",
    "RemapRule",
    "expand",
    "full_namespace",
    "fully_qualified",
    "is_for_node",
    "may_be_equal",
    "remap_node",
    "remap_topic",
    "resolve",
    "validate_enclave",
    "validate_full",
    "validate_name",
    "validate_namespace",
    "validate_node_name",
    "widen",
]

# Stand for a hole while two names in the same unknown namespace, or of the same unknown node, are compared.
_SAME_NAMESPACE: Final = "\ue000"
_SAME_NODE: Final = "\ue001"

_SUBSTITUTION: Final = re.compile(r"\{([^{}]*)\}")
# A hole within braces, after a lone opening brace, before a lone closing one: what they make is unknown as a whole.
_HOLE_IN_BRACES: Final = (re.compile(r"\{[^{}*]*\*[^{}]*\}"), re.compile(r"\{[^{}]*\*"), re.compile(r"\*[^{}]*\}"))


class InvalidName(ValueError):  # noqa: N818 (it is a state of a name, caught and reported, not a crash)
    """A name that rcl rejects however its holes are filled; the message says why."""


class RemapKind(enum.Enum):
    """What a remap rule renames (rcl/remap_impl.h); BOTH is a rule without `rostopic://` or `rosservice://`."""

    TOPIC = "topic"
    SERVICE = "service"
    BOTH = "both"
    NODE = "node"
    NAMESPACE = "namespace"


class RemapRule(NamedTuple):
    """One remap rule, `node:match:=replacement`. `match` is empty for NODE and NAMESPACE rules. `maybe`: it may not be given."""

    node: Holed | None
    kind: RemapKind
    match: Holed
    replacement: Holed
    maybe: bool = False


# Expansion


def full_namespace(namespace: Holed) -> Holed:
    """The namespace of a node as rcl completes it (node.c): `""` is `/`, `left/arm` is `/left/arm`, `*` is `/*`.

    `/*` may also be the root namespace.
    """
    namespace = collapse(namespace)
    if namespace.startswith("/"):
        return namespace
    return Holed("/" + (_after_leading_hole(namespace) if namespace.startswith(HOLE) else namespace))


def fully_qualified(namespace: Holed, name: Holed) -> Holed:
    """The full name of the node (or relative topic) `name` in the full namespace `namespace`."""
    if namespace in ("/", "/*", "/" + _SAME_NAMESPACE):
        return collapse(Holed(namespace + name))
    return Holed(f"{namespace}/{name}")


def expand(name: Holed, node_name: Holed, namespace: Holed) -> Holed:
    """The absolute name of `name` in the node `node_name` of the full namespace `namespace` (rcl expand_topic_name.c).

    Raises `InvalidName` where rcl returns an error. Like rcl it lets pass what only the full name shows to be wrong,
    such as `{ns}/x` in the root namespace, `//x`: see `validate_full`.
    """
    if namespace.startswith(HOLE):
        namespace = full_namespace(namespace)
    reason = validate_name(name) or validate_node_name(node_name) or validate_namespace(namespace)
    if reason is not None:
        raise InvalidName(reason)
    return _expand(name, collapse(node_name), collapse(namespace))


def _expand(name: Holed, node_name: Holed, namespace: Holed) -> Holed:
    name = collapse(name)
    if name.startswith("*~"):
        name = Holed(name[1:])
    if HOLE in name and ("{" in name or "}" in name):
        for pattern in _HOLE_IN_BRACES:
            name = collapse(Holed(pattern.sub(HOLE, name)))
    absolute = name.startswith(("/", HOLE))
    if name.startswith(HOLE):
        name = Holed("/" + _after_leading_hole(name))
    elif name.startswith("~"):
        absolute = True
        name = Holed(fully_qualified(namespace, node_name) + name[1:])

    def substitute(found: re.Match[str]) -> str:
        if found[1] == "node":
            return node_name
        if found[1] in ("ns", "namespace"):
            return namespace
        raise InvalidName(f"unknown substitution {with_stars(found[0])}")

    before = name
    name = Holed(_SUBSTITUTION.sub(substitute, name))
    if before.startswith("/*{"):
        name = Holed("/" + _after_leading_hole(Holed(name[1:])))  # what follows the leading hole may now begin with '/'
    if not absolute and not name.startswith("/"):
        name = fully_qualified(namespace, name)
    return collapse(name)


def _after_leading_hole(name: Holed) -> Holed:
    """`name`, which begins with a hole, without the `/` right after that: the hole may be empty."""
    return Holed(HOLE + name[2:]) if name.startswith("*/") else name


# Names that may be the same


def may_be_equal(one: Holed, other: Holed) -> bool:
    """Whether some filling of the holes of both makes the two names equal."""
    if HOLE not in one and HOLE not in other:
        return one == other
    # below[j]: whether one[i + 1:] and other[j:] may be equal; row: the same for one[i:]
    below = [other[j:].strip(HOLE) == "" for j in range(len(other) + 1)]
    for i in range(len(one) - 1, -1, -1):
        row = [False] * (len(other) + 1)
        row[-1] = one[i] == HOLE and below[-1]
        for j in range(len(other) - 1, -1, -1):
            if HOLE in (one[i], other[j]):
                row[j] = below[j] or row[j + 1]
            else:
                row[j] = one[i] == other[j] and below[j + 1]
        below = row
    return below[0]


def widen(names: Iterable[Holed]) -> Holed:
    """One name, with a hole if need be, that covers all of `names` (at least one): `/a/x` and `/b/x` are `/*/x`."""
    distinct = list(dict.fromkeys(names))
    if len(distinct) == 1:
        return distinct[0]
    before = _common_start(distinct)
    after = _common_start([name[len(before) :][::-1] for name in distinct])[::-1]
    return collapse(Holed(before + HOLE + after))


def _common_start(names: Sequence[str]) -> str:
    length = next((i for i, chars in enumerate(zip(*names, strict=False)) if len(set(chars)) > 1), min(map(len, names)))
    return names[0][:length]


# Remapping


def remap_node(name: Holed, namespace: Holed, rules: Sequence[RemapRule]) -> tuple[Holed, Holed]:
    """Name and full namespace of a node after `__node:=` and `__ns:=` (rcl node.c, remap.c).

    The node prefix of a `__ns` rule is compared with the name as already changed by `__node`. Where a hole leaves
    open whether a rule applies, the answer has a hole that covers both. It is not validated.
    """
    name = collapse(name)
    name = widen(_renamings(name, name, RemapKind.NODE, rules))
    namespace = full_namespace(namespace)
    return name, widen(map(full_namespace, _renamings(namespace, name, RemapKind.NAMESPACE, rules)))


def _renamings(old: Holed, node_name: Holed, kind: RemapKind, rules: Sequence[RemapRule]) -> list[Holed]:
    found: list[Holed] = []
    for rule in rules:
        applies = is_for_node(rule, node_name) if rule.kind is kind else False
        if applies is not False:
            found.append(collapse(rule.replacement))
        if applies:
            return found
    return [*found, old]


def resolve(
    name: Holed, kind: RemapKind, rules: Sequence[RemapRule], node_name: Holed, namespace: Holed
) -> tuple[Holed, ...]:
    """Every full name that `name` in a program can have (rcl node_resolve_name.c: expand, remap, validate).

    `node_name` and `namespace` are those after `remap_node`. There is one answer unless holes leave open whether a
    rule applies. Raises `InvalidName` if rcl rejects the name in every case.
    """
    found: list[Holed] = []
    reason: str | None = None
    for candidate in remap_topic(name, kind, rules, node_name, namespace):
        invalid = validate_full(candidate)
        if invalid is None:
            found.append(candidate)
        else:
            reason = reason or invalid
    if not found:
        raise InvalidName(reason or "not a valid name")
    return tuple(found)


def remap_topic(
    name: Holed, kind: RemapKind, rules: Sequence[RemapRule], node_name: Holed, namespace: Holed
) -> tuple[Holed, ...]:
    """Every full name that `name`, full or not, can have after `rules` (rcl remap.c), not yet validated.

    `kind` is TOPIC or SERVICE; node-local rules (the `cli_args` of a node) stand before those of the process. The
    first rule that fits wins, and its target is not looked up again. Both sides of a rule are expanded for this node,
    and its node prefix is compared with the node's final name.
    """
    full = expand(name, node_name, namespace)
    found: list[Holed] = []
    for rule in rules:
        if rule.kind is not kind and rule.kind is not RemapKind.BOTH:
            continue
        for_node = is_for_node(rule, node_name)
        if for_node is False:
            continue
        try:
            match = expand(rule.match, node_name, namespace)
        except InvalidName:
            continue  # as rcl does
        certain = for_node is True and _is_same(name, rule.match, node_name, namespace)
        if certain:
            return _distinct([*found, expand(rule.replacement, node_name, namespace)])
        if may_be_equal(full, match):
            try:
                found.append(expand(rule.replacement, node_name, namespace))
            except InvalidName:
                continue  # in that case there is no entity
    return _distinct([*found, full])


def is_for_node(rule: RemapRule, node_name: Holed) -> bool | None:
    """Whether `rule` is one for this node; None if that depends on how a hole is filled, or on whether the rule is given."""
    if rule.node is None:
        return None if rule.maybe else True
    if HOLE not in rule.node and HOLE not in node_name:
        return rule.node == node_name and (None if rule.maybe else True)
    return None if may_be_equal(rule.node, node_name) else False


def _is_same(one: Holed, other: Holed, node_name: Holed, namespace: Holed) -> bool:
    """Whether two names of one node are the same for certain: an unknown namespace or node name is the same in both."""
    if HOLE in one or HOLE in other:
        return False
    node_name = Holed(collapse(node_name).replace(HOLE, _SAME_NODE))
    namespace = Holed(full_namespace(namespace).replace(HOLE, _SAME_NAMESPACE))
    return _expand(one, node_name, namespace) == _expand(other, node_name, namespace)


def _distinct(names: Iterable[Holed]) -> tuple[Holed, ...]:
    return tuple(dict.fromkeys(names))
