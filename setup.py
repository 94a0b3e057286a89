# SPDX-License-Identifier: Apache-2.0
"""For `colcon build` alone: hands to setuptools what stands in pyproject.toml, and adds what a workspace of ROS needs.

    pip install .          hatchling, by pyproject.toml; this file is not read
    colcon build           ament_python: setuptools, by this file

So there is one place to change, pyproject.toml, and colcon works with the setuptools of Ubuntu 22.04 (59, which knows nothing of
`[project]`) and 24.04 (68, which refuses a license as it is written today).
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

from setuptools import Distribution, setup

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

ROOT = Path(__file__).resolve().parent  # with --symlink-install colcon runs a link to this file
PROJECT: dict[str, Any] = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
NAME: str = PROJECT["name"]
MODULES = ROOT / "src" / NAME


class Described(Distribution):
    """A distribution that is described here, and not by what this release of setuptools makes of pyproject.toml."""

    def parse_config_files(self, filenames: Any = None, ignore_option_errors: bool = False) -> None:
        """Read the configuration files without pyproject.toml."""
        files = self.find_config_files() if filenames is None else filenames
        super().parse_config_files(files, ignore_option_errors)


def packages() -> list[str]:
    """Each folder with an `__init__.py`."""
    folders = sorted(init.parent.relative_to(MODULES.parent) for init in MODULES.rglob("__init__.py"))
    return [".".join(folder.parts) for folder in folders]


def data() -> list[str]:
    """Every other file: stubs, declared nodes, schemas, templates."""
    files = (path for path in MODULES.rglob("*") if path.is_file() and "__pycache__" not in path.parts)
    return sorted(f.relative_to(MODULES).as_posix() for f in files if not _is_module(f))


def _is_module(file: Path) -> bool:
    return file.suffix == ".py" and (file.parent / "__init__.py").is_file()


setup(
    distclass=Described,
    name=NAME,
    version=PROJECT["version"],
    description=PROJECT["description"],
    license=PROJECT["license"],
    python_requires=PROJECT["requires-python"],
    install_requires=PROJECT["dependencies"],
    package_dir={"": "src"},
    packages=packages(),
    package_data={NAME: data()},
    zip_safe=False,
    entry_points={
        "console_scripts": [f"{name} = {target}" for name, target in PROJECT["scripts"].items()],
        **{
            group: [f"{name} = {target}" for name, target in members.items()]
            for group, members in PROJECT["entry-points"].items()
        },
    },
    data_files=[
        ("share/ament_index/resource_index/packages", [f"resource/{NAME}"]),
        (f"share/{NAME}", ["package.xml", "resource/package.dsv"]),
        (
            f"share/{NAME}/environment",
            [f"resource/environment/{NAME}-argcomplete.bash", f"resource/environment/{NAME}-argcomplete.zsh"],
        ),
        (f"lib/{NAME}", [f"resource/lib/{NAME}"]),
    ],
)
