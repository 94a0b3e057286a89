# SPDX-License-Identifier: Apache-2.0
"""The wheel with compiled modules, where ROSWARD_COMPILED=1 asks for it: beside each module of the list in pyproject.toml, what mypyc makes of it.

    ROSWARD_COMPILED=1 pip wheel --no-deps .

Without that the wheel is pure Python, and nothing is needed to build it. The sources are in both: they are what is read, told and hashed.
"""

from __future__ import annotations

import os
import shutil
import sys
import tempfile
from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface

ASKED = os.environ.get("ROSWARD_COMPILED", "") not in ("", "0")


class CompiledModules(BuildHookInterface):  # type: ignore[type-arg,misc]  # hatchling is there only while a wheel is built
    """Adds compiled modules to a wheel."""

    def dependencies(self) -> list[str]:
        """What is needed to compile."""
        return list(self.config["needs"]) if ASKED else []

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Compile, and say that the wheel is for one Python and one platform."""
        if not ASKED or version == "editable":
            return
        self._place = tempfile.mkdtemp()
        for made in _compiled(Path(self.root) / "src", self.config["modules"], Path(self._place)):
            build_data["force_include"][str(made)] = made.relative_to(Path(self._place) / "lib").as_posix()
        build_data["pure_python"] = False
        build_data["infer_tag"] = True

    def finalize(self, version: str, build_data: dict[str, Any], artifact_path: str) -> None:  # noqa: ARG002
        """Remove what was put into the wheel."""
        if ASKED and version != "editable":
            shutil.rmtree(self._place)


def _compiled(sources: Path, modules: list[str], place: Path) -> list[Path]:
    """The files of the compiled modules."""
    from mypyc.build import mypycify
    from setuptools import Distribution
    from setuptools.command.build_ext import build_ext

    config = place / "mypy.ini"
    config.write_text("[mypy]\nignore_missing_imports = True\nfollow_imports = silent\n", encoding="utf-8")
    before, arguments = Path.cwd(), sys.argv
    os.chdir(sources)  # errors tell of files as `rosward/domain/values.py`
    try:
        files = [f"--config-file={config}", f"--cache-dir={place / 'cache'}", *modules]
        extensions = mypycify(files, debug_level="0", opt_level="2", target_dir=str(place / "c"))
        command = build_ext(Distribution({"name": "rosward", "ext_modules": extensions}))
        command.build_lib, command.build_temp = str(place / "lib"), str(place / "o")
        command.ensure_finalized()
        command.run()
    finally:
        os.chdir(before)
        sys.argv = arguments
    return sorted(path for path in (place / "lib").rglob("*") if path.is_file())
