# SPDX-License-Identifier: Apache-2.0
"""Writes `source/data/definitions.json`: names and types of the fields of common interfaces, their defaults, and constants.

    python tools/interface_definitions.py CHECKOUT...

Each CHECKOUT is a git repository with .msg, .srv and .action files (ros2/common_interfaces, ros2/rcl_interfaces, …), in a folder of its name. They
are read on the branches of all supported distros, or where there are none as they are checked out. What is not the same in all of them is marked:
`?` before a field that some do not have, `*` for a type or a value that differs. Comments are left out: what remains are facts, not text.
"""

from __future__ import annotations

import json
import re
import subprocess
import sys
from collections import defaultdict
from pathlib import Path
from typing import Final

from rosward.ros.distro import DISTROS

BRANCHES: Final = (*DISTROS, "main")
"""Where the interfaces of the distros stand; `main` counts where there is no `rolling`."""
DATA: Final = Path(__file__).parent.parent / "src" / "rosward" / "source" / "data"
_FILE: Final = re.compile(r"(?:(?:.*/)?([\w-]+)/)?(msg|srv|action)/(\w+)\.\2")
_LINE: Final = re.compile(r"(\S+(?:\s*<=\s*\d+)?)\s+(\w+)\s*(.*)")

Line = tuple[str, str, str]
"""Type, name, and what stands behind: a default, or `=` and a value."""


def git(folder: Path, *words: str) -> str:
    """What git prints."""
    done = subprocess.run(
        ["git", "-C", str(folder), *words], capture_output=True, check=True, text=True, errors="replace"
    )
    return done.stdout


def branches(folder: Path) -> list[str]:
    """The branches to read."""
    there = set(git(folder, "branch", "--all", "--format=%(refname:short)").split())
    found: list[str] = [b for b in BRANCHES if b in there and not (b == "main" and "rolling" in there)]
    return found or ["HEAD"]


def parts(text: str) -> list[dict[str, Line]]:
    """The lines of each part of an interface, by name."""
    found: list[dict[str, Line]] = [{}]
    for line in text.splitlines():
        bare = line.partition("#")[0].strip()
        match = _LINE.fullmatch(bare)
        if bare == "---":
            found.append({})
        elif match is not None:
            found[-1][match[2]] = (match[1].replace(" ", ""), match[2], match[3].strip())
    return found


def united(versions: list[list[dict[str, Line]]]) -> str:
    """One text for the interface in several distros."""
    return "\n---\n".join(_united([v[n] for v in versions if n < len(v)]) for n in range(max(map(len, versions))))


def _united(versions: list[dict[str, Line]]) -> str:
    lines: list[str] = []
    for name in dict.fromkeys(n for v in reversed(versions) for n in v):
        found = {v[name] for v in versions if name in v}
        type_, _, rest = found.pop()
        if found:  # they differ
            type_, rest = "*", "=" if rest.startswith("=") else ""
        maybe = "?" if not rest.startswith("=") and not all(name in v for v in versions) else ""
        if rest.startswith("="):
            lines.append(f"{type_} {name}={rest[1:].strip()}")
        else:
            lines.append(f"{maybe}{type_} {name} {rest}".strip())
    return "\n".join(lines)


def main() -> int:
    """Read all checkouts and write the file."""
    versions: dict[tuple[str, str, str], list[list[dict[str, Line]]]] = defaultdict(list)
    known = json.loads((DATA / "interfaces.json").read_text(encoding="utf-8"))
    for folder in map(Path, sys.argv[1:]):
        for branch in branches(folder):
            for path in git(folder, "ls-tree", "-r", "--name-only", branch).splitlines():
                match = _FILE.fullmatch(path)
                package = "" if match is None else match[1] or folder.name
                if match is not None and package in known:
                    text = git(folder, "show", f"{branch}:{path}")
                    versions[package, match[2], match[3]].append(parts(text))
    found: dict[str, dict[str, dict[str, str]]] = {}
    for (package, kind, name), several in sorted(versions.items()):
        found.setdefault(package, {}).setdefault(kind, {})[name] = united(several)
    lines = (
        f"  {json.dumps(p)}: {json.dumps(kinds, ensure_ascii=False, separators=(',', ':'))}"
        for p, kinds in found.items()
    )
    (DATA / "definitions.json").write_text("{\n" + ",\n".join(lines) + "\n}\n", encoding="utf-8")
    sys.stdout.write(f"{len(versions)} interfaces of {len(found)} packages\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
