# SPDX-License-Identifier: Apache-2.0
"""The systems whose policies are enforced: read from sources, or made by hand where no source makes them.

systems("fleet", folder)     ->  a network of thirteen nodes
systems("programs", folder)  ->  one network for each program of `programs.md`
"""

from __future__ import annotations

import os
from pathlib import Path
from typing import Final

from casefile import Case, read_cases
from outputs.networks import entity, fleet, node, pub, sub, talker_and_listener

import rosward
from rosward import EntityKind, Network, Resolution
from rosward.network.connect import connect

__all__ = ["NAMES", "PROGRAMS", "network_of", "systems"]

_HERE: Final = Path(__file__).parent
_EXAMPLE: Final = _HERE.parent.parent / "examples" / "delivery_robot"
_ALL: Final = sorted((_HERE.parent / "cases").glob("*.md"))
_SAMPLE: Final = {
    "assumed", "characters", "distros", "entities", "late", "nodes", "parameters", "partial", "processes",
    "ros_arguments", "rules_and_holes", "unknown",
}  # fmt: skip
"""The documents whose programs make policies of every form. The others vary how a name comes about: `ROSWARD_ALL_CASES=1` takes them in."""
_DOCUMENTS: Final = {f.stem: f for f in _ALL if f.stem in _SAMPLE or "ROSWARD_ALL_CASES" in os.environ}
PROGRAMS: Final = tuple(read_cases(_HERE / "programs.md"))
NAMES: Final = ("example", "programs", "patterns", "fleet", "shared", "talker", *_DOCUMENTS)


def network_of(program: Case, folder: Path, distro: str = "jazzy") -> Network:
    """A little program, as rosward reads it."""
    for name, text in program.files.items():
        file = folder / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")
    return rosward.extract(folder, distro=distro).network


def systems(name: str, folder: Path) -> list[Network]:
    """The systems of a name; those that have nothing to do with each other are apart."""
    match name:
        case "example":
            return [rosward.extract(_EXAMPLE).network]
        case "patterns":
            return [_patterns()]
        case "fleet":
            return [fleet(robots=2)]
        case "shared":
            return [_shared()]
        case "talker":
            return [talker_and_listener()]
        case _:
            programs = PROGRAMS if name == "programs" else read_cases(_DOCUMENTS[name])
            return [
                network_of(program, folder / str(number), program.options.get("distro", "jazzy"))
                for number, program in enumerate(programs)
            ]


def _patterns() -> Network:
    """Names with holes, for each kind; a node with a hole in its own name; a node with nothing at all."""
    kind, hole = EntityKind, Resolution.PATTERN
    return connect(
        "jazzy",
        [
            node("/a", pub("/robot_*/cmd", resolution=hole), sub("/*/state", resolution=hole)),
            node("/b", pub("/robot_1/cmd"), pub("/robot_1/deep/cmd"), sub("/robot_/cmd"), sub("/robot/cmd")),
            node("/c", entity(kind.SERVICE_SERVER, "/doors/*", "std_srvs/srv/SetBool", resolution=hole)),
            node("/d", entity(kind.SERVICE_CLIENT, "/doors/lobby", "std_srvs/srv/SetBool")),
            node("/e", entity(kind.ACTION_CLIENT, "/*/dock", "test_msgs/action/Fibonacci", resolution=hole)),
            node("/f", entity(kind.ACTION_SERVER, "/robot_1/dock", "test_msgs/action/Fibonacci")),
            node("/robot_*/g", pub("/robot_*/g/x", resolution=hole)),
            node("/robot_1/g", sub("/robot_1/g/x"), sub("/robot_1/state")),
            node("/nothing", system=False),
        ],
    )


def _shared() -> Network:
    """Two nodes in one enclave, a third one elsewhere, and the same name in two processes."""
    return connect(
        "jazzy",
        [
            node("/camera", pub("/image"), enclave="/container"),
            node("/filter", sub("/image"), pub("/filtered"), enclave="/container"),
            node("/viewer", sub("/filtered"), enclave="/outside", process="one"),
            node("/viewer", sub("/image"), enclave="/outside", process="two"),
            node("/secret", pub("/secret"), enclave="/"),
        ],
    )
