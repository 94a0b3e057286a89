# SPDX-License-Identifier: Apache-2.0
"""How are enclaves chosen? The words of `--enclaves`, which the command line and the server offer; light to import."""

from __future__ import annotations

import enum

__all__ = ["EnclaveMode"]


class EnclaveMode(enum.Enum):
    """How enclaves are chosen where the start of a process names none."""

    NODE = "node"
    """Each node one of its own, as if each ran in a process of its own."""

    PROCESS = "process"
    """The nodes of a process share one."""

    LAUNCH = "launch"
    """As rcl does it: `/`."""
