# SPDX-License-Identifier: Apache-2.0
"""The enclaves of a suggestion as a file that `--enclaves FILE.toml` reads and people correct.

    [[enclave]]
    path = "/robot1/camera_and_lidar"
    nodes = ["/robot1/camera", "/robot1/lidar"]

A process is named by its nodes, which stay what they are when launch files change; by its label where their names are in other processes, too.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from typing import Final

from rosward.enclaves.suggestion import JointEnclave, Suggestion
from rosward.safe import toml_string

__all__ = ["enclaves_toml"]

_HEAD: Final = "# The enclave of each process, for `--enclaves`. Written by `rosward enclaves suggest`."


def enclaves_toml(suggestion: Suggestion) -> str:
    """The text of the file."""
    counted = Counter(node for e in suggestion.enclaves for p in e.processes for node in p.nodes)
    return "\n".join([_HEAD, *(line for e in suggestion.enclaves for line in _enclave(e, counted)), ""])


def _enclave(enclave: JointEnclave, counted: Counter[str]) -> Iterator[str]:
    unique = [p for p in enclave.processes if all(counted[node] == 1 for node in p.nodes)]
    others = [p.process for p in enclave.processes if p not in unique]
    yield ""
    yield "[[enclave]]"
    yield f"path = {toml_string(enclave.path)}"
    for key, names in (("nodes", [node for p in unique for node in p.nodes]), ("processes", others)):
        if names:
            yield f"{key} = [{', '.join(map(toml_string, sorted(names)))}]"
