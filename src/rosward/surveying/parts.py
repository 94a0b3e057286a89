# SPDX-License-Identifier: Apache-2.0
"""Where are the parts of a survey kept, so that one that was killed goes on?

OUTPUT/parts/3f/3fd1c0….part     one file for each repository, by the digest of its path; written whole or not at all
"""

from __future__ import annotations

import hashlib
import os
from pathlib import Path
from typing import Final, final

from rosward.outputs.whole_files import write_bytes
from rosward.surveying.part import LARGEST, Part, packed

__all__ = ["Parts"]

_FOLDER: Final = "parts"
_LONGEST_LINE: Final = 10_000


@final
class Parts:
    """The parts below an output folder. Reading gives None for what is not there or is no part; writing raises OSError."""

    def __init__(self, output: str) -> None:
        self._output = output

    def read(self, path: str) -> Part | None:
        """The part of the repository at a path."""
        try:
            with Path(self._output, self._name(path)).open("rb") as file:
                return packed(file.read(LARGEST + _LONGEST_LINE))
        except OSError:
            return None

    def write(self, path: str, stored: bytes) -> None:
        """Keep a part."""
        write_bytes(self._output, self._name(path), stored)

    def _name(self, path: str) -> str:
        digest = hashlib.sha256(os.fsencode(path)).hexdigest()[:40]
        return f"{_FOLDER}/{digest[:2]}/{digest}.part"
