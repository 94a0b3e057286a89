# SPDX-License-Identifier: Apache-2.0
"""How is a process of ours started and bounded that reads what somebody else wrote?

subprocess.Popen([*isolated("rosward.server.worker"), …])      loads nothing from the current folder, nor where PYTHONPATH says
bound(memory=4 * 2**30, seconds=600, file=2**28)               its first act, before it looks at anything
"""

from __future__ import annotations

import contextlib
import os
import sys
from pathlib import Path
from typing import Final

__all__ = ["bound", "isolated"]

_START: Final = "import sys; sys.path[:] = sys.argv[1:]; from {} import main; main()"


def isolated(module: str) -> list[str]:
    """The command that runs `main` of a module in a process with the modules of this one."""
    return [sys.executable, "-I", "-c", _START.format(module), *_search_path()]


def _search_path() -> list[str]:
    """Where the modules of this process come from, without the current folder; absolute."""
    own = str(Path(__file__).parent.parent)
    here = os.getcwd()  # noqa: PTH109
    return list(dict.fromkeys([*(p for p in sys.path if os.path.isabs(p) and p != here), own]))  # noqa: PTH117


def bound(memory: int, seconds: int, file: int, grace: int = 0) -> None:
    """Bound this process: bytes of address space, seconds of processor time, bytes of a file that it writes; no core is left.

    At the end of its time it gets SIGXCPU, and SIGKILL if that is survived for `grace` seconds. Windows knows no such bounds.
    """
    if sys.platform == "win32":
        return
    import resource

    bounds = (
        (resource.RLIMIT_AS, memory, 0),
        (resource.RLIMIT_CPU, seconds, grace),
        (resource.RLIMIT_FSIZE, file, 0),
        (resource.RLIMIT_CORE, 0, 0),
    )
    for kind, wanted, more in bounds:
        hard = resource.getrlimit(kind)[1]
        most = wanted + more if hard == resource.RLIM_INFINITY else min(wanted + more, hard)
        with contextlib.suppress(OSError, ValueError):
            resource.setrlimit(kind, (min(wanted, most), most))
