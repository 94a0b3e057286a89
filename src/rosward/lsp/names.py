# SPDX-License-Identifier: Apache-2.0
"""Which name or key stands under a cursor, and what is it a name of? For places that no mark tells of: remappings, parameter files, policies.

<remap from="chatter" to="/news"/>            Named("/news" and what it may mean, kind "")
/talker: {ros__parameters: {rate: 5}}         Key(("/talker", "ros__parameters", "rate"))
<topics publish="ALLOW"><topic>chatter</topic>    of a profile in the namespace /: "/chatter"
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from fnmatch import fnmatchcase
from typing import Final, NamedTuple

from rosward.holes import Holed
from rosward.lsp.extents import LONGEST_LINE, Extent, Literal, literals
from rosward.lsp.records import Seen
from rosward.ros.names import InvalidName, expand, full_namespace

__all__ = [
    "Key",
    "expanded",
    "is_for",
    "keys",
    "literal_at",
    "namespace_of",
    "parameter_of",
    "policy_name",
    "relative_to",
]

_KEY: Final = re.compile(r"^(\s*)(?:-\s+)?(\"[^\"]+\"|'[^']+'|[^\s#'\"\[{&*!|>%@`-][^:#]*?|/\*\*[^:]*?)\s*:(?=\s|$)")
_POLICY_NAME: Final = re.compile(r"<(topic|service|action)>\s*([^<\s]+)\s*</")
_PROFILE: Final = re.compile(r"<profile\b([^>]*)>")
_ATTRIBUTE: Final = re.compile(r"(\w+)\s*=\s*[\"']([^\"']*)[\"']")
_BACK: Final = 400
_PARAMETERS: Final = "ros__parameters"


class Key(NamedTuple):
    """A key of a YAML file: where it stands, and those above it, itself last."""

    extent: Extent
    path: tuple[str, ...]


def literal_at(lines: Sequence[str], file: str, line: int, column: int) -> Literal | None:
    """The literal in which a position is."""
    if not 0 <= line < len(lines):
        return None
    whole = Extent(line, 0, line, len(lines[line]))
    return next((each for each in literals(lines, file, whole) if each.column <= column <= each.end), None)


def namespace_of(node: Seen) -> tuple[Holed, Holed]:
    """The namespace of a node and its name."""
    namespace, _, name = node.fqn.rpartition("/")
    return full_namespace(Holed(namespace or "/")), Holed(name)


def expanded(text: str, node: Seen) -> str | None:
    """The full name that a text becomes in a node, before remapping; None where it cannot be one."""
    namespace, name = namespace_of(node)
    if not text or "*" in text:
        return None
    try:
        return str(expand(Holed(text), name, namespace))
    except (InvalidName, ValueError):
        return None


def relative_to(like: str, name: str, node: Seen) -> str:
    """A full name written in the manner of another text (`chatter`, `~/cmd`, `/a/b`), where that can be."""
    namespace, own = namespace_of(node)
    base = "" if namespace == "/" else str(namespace)
    if like.startswith("~") and name.startswith(f"{base}/{own}/"):
        return f"~/{name[len(base) + len(own) + 2 :]}"
    if not like.startswith(("/", "~")) and name.startswith(f"{base}/"):
        return name[len(base) + 1 :]
    return name


def keys(lines: Sequence[str]) -> list[Key]:
    """The keys of a YAML file in block style; what is written in braces is left out."""
    above: list[tuple[int, str]] = []
    found: list[Key] = []
    for number, text in enumerate(lines):
        match = _KEY.match(text) if len(text) <= LONGEST_LINE else None
        if match is None:
            continue
        indent = len(match[1]) + (2 if text[len(match[1]) :].startswith("- ") else 0)
        name = match[2].strip("\"'")
        while above and above[-1][0] >= indent:
            above.pop()
        above.append((indent, name))
        found.append(Key(Extent(number, match.start(2), number, match.end(2)), tuple(n for _, n in above)))
    return found


def parameter_of(key: Key) -> tuple[str, str] | None:
    """The nodes (a pattern) and the parameter that a key of a parameter file is about."""
    if _PARAMETERS not in key.path or key.path[-1] == _PARAMETERS:
        return None
    at = key.path.index(_PARAMETERS)
    nodes = "/".join(part.strip("/") for part in key.path[:at] if part.strip("/"))
    return f"/{nodes}", ".".join(key.path[at + 1 :])


def is_for(pattern: str, node: Seen) -> bool:
    """Whether a key of a parameter file (as `parameter_of` gives it) means a node."""
    name = f"/{node.fqn.rpartition('/')[2]}"
    return pattern in ("/**", node.fqn, name) or fnmatchcase(node.fqn, pattern.replace("**", "*"))


def policy_name(lines: Sequence[str], line: int, column: int) -> tuple[str, str, Extent] | None:
    """The kind and the full name that a policy speaks of at a position, and where that stands."""
    text = lines[line] if 0 <= line < len(lines) and len(lines[line]) <= LONGEST_LINE else ""
    for match in _POLICY_NAME.finditer(text):
        if match.start(2) <= column <= match.end(2):
            name = match[2]
            if not name.startswith(("/", "~")):
                namespace = _namespace_above(lines, line)
                name = f"{namespace.rstrip('/')}/{name}"
            return match[1], name, Extent(line, match.start(2), line, match.end(2))
    return None


def _namespace_above(lines: Sequence[str], line: int) -> str:
    for number in range(line, max(-1, line - _BACK), -1):
        match = _PROFILE.search(lines[number][:LONGEST_LINE])
        if match is not None:
            return dict(_ATTRIBUTE.findall(match[1])).get("ns", "/") or "/"
    return "/"
