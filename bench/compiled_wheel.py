# SPDX-License-Identifier: Apache-2.0
"""Build the pure and the compiled wheel, compare what is in them, and run tests against the compiled one.

python bench/compiled_wheel.py                    in a temporary environment; needs a C compiler and the package index
python bench/compiled_wheel.py tests/flow -n 2    other arguments of pytest
"""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
import venv
import zipfile
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Final

_ROOT: Final = Path(__file__).parent.parent
_TESTS: Final = ("tests/domain", "tests/engine", "tests/flow", "tests/models", "tests/test_cases.py", "-n", "auto")


def built(python: Path, place: Path, environment: Mapping[str, str]) -> Path:
    """A wheel of this checkout."""
    words = [str(python), "-m", "pip", "wheel", "--quiet", "--no-deps", "--wheel-dir", str(place), str(_ROOT)]
    subprocess.run(words, env={**os.environ, **environment}, check=True)
    return next(place.glob("*.whl"))


def _names(wheel: Path) -> set[str]:
    """The files in a wheel; what tells of the wheel itself and what is compiled apart."""
    with zipfile.ZipFile(wheel) as file:
        return {name for name in file.namelist() if ".dist-info/" not in name and not name.endswith((".so", ".pyd"))}


def main(arguments: Sequence[str]) -> int:
    """Build, compare, install, test."""
    with tempfile.TemporaryDirectory() as folder:
        place = Path(folder)
        venv.create(place / "venv", with_pip=True)
        python = place / "venv" / "bin" / "python"
        pure = built(python, place / "pure", {"ROSWARD_COMPILED": ""})
        compiled = built(python, place / "compiled", {"ROSWARD_COMPILED": "1"})
        if _names(pure) != _names(compiled):
            print("only in one wheel:", *sorted(_names(pure) ^ _names(compiled)), sep="\n  ")
            return 1
        subprocess.run([str(python), "-m", "pip", "install", "--quiet", f"{compiled}[test]"], check=True)
        where = "import rosward.domain.values as v; assert not v.__file__.endswith('.py'), v.__file__"
        subprocess.run([str(python), "-c", where], check=True, cwd=place)
        words = [str(python), "-m", "pytest", "-p", "no:cacheprovider", *(arguments or _TESTS)]
        return subprocess.run(words, cwd=_ROOT, check=False).returncode


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
