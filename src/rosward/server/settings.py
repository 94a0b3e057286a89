# SPDX-License-Identifier: Apache-2.0
"""What does the page ask of an analysis?

    {"distro": "humble", "launch": ["bringup/launch/robot.launch.py"], "arguments": {"sim": "true"}}
      ->  Settings(distro='humble', launch=('bringup/launch/robot.launch.py',), arguments=(('sim', 'true'),))

The same record is sent to the process that analyses, and kept with its result. What is not of this form is refused.
"""

from __future__ import annotations

import re
from typing import Final

from rosward.network.checks import UnknownNames
from rosward.network.enclave_mode import EnclaveMode
from rosward.records import NamedTuple
from rosward.ros.distro import DEFAULT_DISTRO, DISTROS
from rosward.server.places import UploadRefusedError
from rosward.source.surroundings import SurroundingsError, checked_variable, surroundings

__all__ = ["ENCLAVES", "Settings", "read_settings"]

ENCLAVES: Final = tuple(mode.value for mode in EnclaveMode)
_MOST_LAUNCHES: Final = 50
_MOST_ARGUMENTS: Final = 200
_LONGEST: Final = 2_000
_OUTSIDE: Final = re.compile(r"^/|\\|(^|/)\.\.(/|$)")


class Settings(NamedTuple):
    """The options. `launch` are launch files as they are named in the sources; without one, every executable is started."""

    distro: str = DEFAULT_DISTRO
    unknown: UnknownNames = "deny"
    enclaves: str | None = None
    tests: bool = False
    launch: tuple[str, ...] = ()
    all_launch: bool = False
    arguments: tuple[tuple[str, str], ...] = ()
    env: tuple[tuple[str, str], ...] = ()
    flows: bool = False

    def document(self) -> dict[str, object]:
        """As `read_settings` reads it."""
        return {
            **self._asdict(),
            "launch": list(self.launch),
            "arguments": dict(self.arguments),
            "env": dict(self.env),
        }

    def words(self) -> str:
        """For people: what is not as it is without options."""
        parts = [self.distro]
        parts += ["every launch file"] if self.all_launch else list(self.launch)
        parts += [f"{name}:={value}" for name, value in self.arguments]
        parts += [f"{name}={value}" for name, value in self.env]
        parts += ["wildcards for unknown names"] if self.unknown == "wildcard" else []
        parts += [f"one enclave per {self.enclaves}"] if self.enclaves in {"node", "process"} else []
        parts += ["enclaves of the launch files"] if self.enclaves == "launch" else []
        parts += ["with tests"] if self.tests else []
        parts += ["with flows"] if self.flows else []
        return ", ".join(parts)


def read_settings(document: object) -> Settings:
    """The settings that a decoded JSON document holds. Raises UploadRefusedError."""
    if not isinstance(document, dict) or set(document) - set(Settings._fields):
        raise UploadRefusedError("invalid settings")
    distro, unknown, enclaves = (
        document.get("distro", DEFAULT_DISTRO),
        document.get("unknown", "deny"),
        document.get("enclaves"),
    )
    if distro not in DISTROS:
        raise UploadRefusedError(f"the distro must be one of {', '.join(DISTROS)}")
    if unknown not in ("deny", "wildcard"):
        raise UploadRefusedError("unknown must be deny or wildcard")
    if enclaves is not None and enclaves not in ENCLAVES:
        raise UploadRefusedError(f"enclaves must be one of {', '.join(ENCLAVES)}")
    tests, all_launch, flows = (document.get(name, False) for name in ("tests", "all_launch", "flows"))
    if not isinstance(tests, bool) or not isinstance(all_launch, bool) or not isinstance(flows, bool):
        raise UploadRefusedError("tests, all_launch and flows must be true or false")
    launch, arguments = _launch(document.get("launch", [])), _pairs(document.get("arguments", {}), "arguments")
    if arguments and not (launch or all_launch):
        raise UploadRefusedError("launch arguments need a launch file")
    return Settings(
        str(distro),
        "wildcard" if unknown == "wildcard" else "deny",
        enclaves,
        tests,
        launch,
        all_launch,
        arguments,
        _environment(document.get("env", {}), str(distro)),
        flows,
    )


def _launch(value: object) -> tuple[str, ...]:
    if not isinstance(value, list) or len(value) > _MOST_LAUNCHES or not all(isinstance(v, str) for v in value):
        raise UploadRefusedError("launch must be a list of launch files of the sources")
    if any(not v or len(v) > _LONGEST or not v.isprintable() or _OUTSIDE.search(v) for v in value):
        raise UploadRefusedError("a launch file must be given by its path relative to the sources")
    return tuple(dict.fromkeys(value))


def _environment(value: object, distro: str) -> tuple[tuple[str, str], ...]:
    pairs = _pairs(value, "environment variables")
    try:
        surroundings(distro, dict(checked_variable(*pair) for pair in pairs))
    except SurroundingsError as error:
        raise UploadRefusedError(str(error)) from error
    return pairs


def _pairs(value: object, what: str) -> tuple[tuple[str, str], ...]:
    if not isinstance(value, dict) or len(value) > _MOST_ARGUMENTS:
        raise UploadRefusedError(f"{what} must be names and values")
    pairs = [(name, text) for name, text in value.items() if isinstance(name, str) and isinstance(text, str)]
    if len(pairs) < len(value) or any(not n or max(len(n), len(t)) > _LONGEST for n, t in pairs):
        raise UploadRefusedError(f"{what} must be names and values")
    return tuple(pairs)
