# SPDX-License-Identifier: Apache-2.0
"""How does a sketch stand in the file of its package, which a person edits then?

    executables:
      lidar_node:
        open: as it ran (robot.json), which another run may differ from   # delete this line when the declaration is complete
        node: lidar
        publishers:
          - {name: scan, type: sensor_msgs/msg/LaserScan, qos: 10}  # /scan

What is in the file already stays as it is, comments included.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from typing import Final

from rosward.declaring.sketch import SeenEndpoint, Sketch
from rosward.ros.entities import ENTITY_LISTS, Qos

__all__ = ["declaration", "with_declaration"]

_PLAIN: Final = re.compile(r"[A-Za-z_~/][\w~/]*", re.ASCII)
_RESERVED: Final = frozenset({"true", "false", "yes", "no", "on", "off", "null", "y", "n", "~"})
_EXAMPLES: Final = (
    "publishers:",
    "  - {name: scan, type: sensor_msgs/msg/LaserScan, qos: sensor_data}",
    "subscriptions:",
    "  - {name: cmd_vel, type: geometry_msgs/msg/Twist, qos: 10}",
    "service_servers:",
    "  - {name: '~/reset', type: std_srvs/srv/Trigger}",
    "flows:  # what each output is made of; without it, each may hold every input",
    "  - {to: scan, data: [device], control: [cmd_vel]}",
)
_DELETE: Final = "  # delete this line when the declaration is complete"


def declaration(package: str, program: str, sketch: Sketch) -> str:
    """A new file with this one program."""
    head = [
        "# Created by `rosward declare`. Format: docs/declared-nodes.md of rosward.",
        "nodl_version: 2",
        f"package: {_text(package)}",
        "source: to do  # repository, version, commit",
        f"client_library: {sketch.client_library}",
    ]
    return "\n".join([*head, f"{_section(program)}:", *_block(program, sketch, "  ")]) + "\n"


def with_declaration(text: str, program: str, sketch: Sketch) -> str:
    """The text of a file of the package, with this program first in its section."""
    lines = text.splitlines()
    head = next((n for n, line in enumerate(lines) if re.fullmatch(rf"{_section(program)}:\s*(#.*)?", line)), None)
    if head is None:
        return "\n".join([*lines, f"{_section(program)}:", *_block(program, sketch, "  ")]) + "\n"
    below = next((line for line in lines[head + 1 :] if line.strip() and not line.lstrip().startswith("#")), "")
    indent = re.match(r" *", below)
    block = _block(program, sketch, (indent[0] if indent else "") or "  ")
    return "\n".join([*lines[: head + 1], *block, *lines[head + 1 :]]) + "\n"


def _section(program: str) -> str:
    return "components" if "::" in program else "executables"


def _block(program: str, sketch: Sketch, indent: str) -> list[str]:
    return [f"{indent}{_text(program)}:", *(f"{indent * 2}{line}" for line in _body(program, sketch))]


def _body(program: str, sketch: Sketch) -> Iterator[str]:
    yield from (f"# {_comment(text)}" for text in sketch.told)
    yield f"open: {json.dumps(sketch.open or 'not yet filled in')}{_DELETE}"
    guess = "" if sketch.node else "  # the node name in its code"
    yield f"node: {_text(sketch.node or re.sub(r'[^A-Za-z0-9_]', '_', program.rpartition('::')[2]))}{guess}"
    if sketch.lifecycle:
        yield "lifecycle: true"
    if sketch.parameters:
        yield "parameters:"
        yield from (f"  {_text(name)}: {{{f'type: {type_}' if type_ else ''}}}" for name, type_ in sketch.parameters)
    for key in ENTITY_LISTS:
        rows = [seen for seen in sketch.entities if seen.kind == key]
        if rows:
            yield f"{key}:"
            yield from (_row(seen) for seen in rows)
    if not sketch.entities:
        yield from (f"# {line}" for line in _EXAMPLES)


def _row(seen: SeenEndpoint) -> str:
    topic = seen.kind in ("publishers", "subscriptions")
    qos = f", qos: {_qos(seen.qos)}" if topic else ""
    at = f"  # {_comment(seen.at)}" if seen.at and seen.at != seen.name else ""
    unknown = "  # QoS not observed" if topic and seen.qos is None and not at else ""
    return f"  - {{name: {_text(seen.name)}, type: {seen.type}{qos}}}{at}{unknown}"


_POLICIES: Final = frozenset(
    [
        "reliable",
        "best_effort",
        "volatile",
        "transient_local",
        "keep_last",
        "keep_all",
        "system_default",
        "best_available",
    ]
)


def _qos(qos: Qos | None) -> str:
    if qos is None:
        return "default"
    if qos == Qos("best_effort", "volatile", "keep_last", 5):
        return "sensor_data"
    if qos == Qos("reliable", "volatile", "keep_last", qos.depth) and qos.depth is not None:
        return str(qos.depth)
    policies = {"reliability": qos.reliability, "durability": qos.durability, "history": qos.history}
    parts = [f"{name}: {word.upper()}" for name, word in policies.items() if word in _POLICIES]
    if qos.depth is not None:
        parts.append(f"depth: {qos.depth}")
    return f"{{{', '.join(parts)}}}"


def _text(text: str) -> str:
    """A text as YAML has it; quoted where it could be read as something else."""
    return text if _PLAIN.fullmatch(text) and text.lower() not in _RESERVED and "~" not in text else json.dumps(text)


def _comment(text: str) -> str:
    return "".join(c if c.isprintable() else " " for c in text)[:200]
