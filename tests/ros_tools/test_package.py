# SPDX-License-Identifier: Apache-2.0
"""`pyproject.toml` says what rosward is; what colcon and rosdep read says the same, and whoever builds it ships every file.

setup.py is run with a stand-in for setuptools that only keeps what it is told. What a real `colcon build` makes of it is told in
docs/ros2-cli.md.
"""

from __future__ import annotations

import importlib
import os
import re
import runpy
import sys
import types
from importlib.metadata import PackageNotFoundError, PackagePath, distribution
from pathlib import Path
from typing import Any, Final

import pytest
from catkin_pkg.package import parse_package

from rosward import __version__

ROOT: Final = Path(__file__).parent.parent.parent
SOURCES: Final = ROOT / "src" / "rosward"
PROJECT: Final[dict[str, Any]] = importlib.import_module("tomllib" if sys.version_info >= (3, 11) else "tomli").loads(
    (ROOT / "pyproject.toml").read_text(encoding="utf-8")
)["project"]

ROSDEP: Final = {
    "catkin_pkg": "python3-catkin-pkg-modules",
    "jinja2": "python3-jinja2",
    "pyyaml": "python3-yaml",
    "rich": "python3-rich",
    "graphviz-pure": "graphviz",  # draws where graphviz-pure is not
}
"""The key of rosdep for each dependency."""
WITHOUT_KEY: Final = {"tomli", "tree-sitter", "tree-sitter-cpp"}


@pytest.fixture(scope="module")
def told() -> dict[str, Any]:
    """What setup.py tells setuptools."""
    kept: dict[str, Any] = {}
    with pytest.MonkeyPatch.context() as patch:
        stand_in = types.ModuleType("setuptools")
        vars(stand_in).update(Distribution=object, setup=kept.update)
        patch.setitem(sys.modules, "setuptools", stand_in)
        runpy.run_path(str(ROOT / "setup.py"))
    return kept


def files() -> set[str]:
    """Every file of the package."""
    found = (path for path in SOURCES.rglob("*") if path.is_file() and "__pycache__" not in path.parts)
    return {path.relative_to(SOURCES).as_posix() for path in found}


def name_of(requirement: str) -> str:
    return re.split(r"[ <>=!;\[]", requirement, maxsplit=1)[0]


def test_the_version_is_one() -> None:
    assert PROJECT["version"] == __version__ == parse_package(ROOT / "package.xml").version


def test_package_xml_says_what_pyproject_says() -> None:
    package = parse_package(ROOT / "package.xml")
    assert package.name == PROJECT["name"]
    assert package.description == PROJECT["description"]
    assert package.licenses == [PROJECT["license"]]
    assert package.get_build_type() == "ament_python"


def test_rosdep_installs_what_pip_would() -> None:
    needed = {name_of(requirement) for requirement in PROJECT["dependencies"]} - WITHOUT_KEY
    package = parse_package(ROOT / "package.xml")
    assert {depend.name for depend in package.exec_depends} == {ROSDEP[name] for name in needed}


def test_colcon_is_told_what_pyproject_says(told: dict[str, Any]) -> None:
    assert (told["name"], told["version"], told["license"]) == (PROJECT["name"], PROJECT["version"], PROJECT["license"])
    assert told["install_requires"] == PROJECT["dependencies"]
    assert told["python_requires"] == PROJECT["requires-python"]
    assert told["entry_points"]["console_scripts"] == ["rosward = rosward.cli:program"]
    assert told["entry_points"]["sros2.verb"] == ["extract_policy = rosward.ros2_security:ExtractPolicyVerb"]


def test_colcon_ships_every_file(told: dict[str, Any]) -> None:
    """Stubs, declared nodes, schemas, templates: without them rosward would start and know nothing."""
    modules = {
        file.relative_to(SOURCES).as_posix()
        for package in told["packages"]
        for file in (ROOT / "src" / package.replace(".", "/")).glob("*.py")
    }
    assert modules | set(told["package_data"]["rosward"]) == files()


def test_what_ament_needs_is_there(told: dict[str, Any]) -> None:
    installed = {
        f"{folder}/{Path(file).name}": ROOT / file for folder, members in told["data_files"] for file in members
    }
    assert "share/ament_index/resource_index/packages/rosward" in installed
    assert "share/rosward/package.xml" in installed
    assert os.access(installed["lib/rosward/rosward"], os.X_OK), "`ros2 run` starts only what is executable"
    assert all(file.is_file() for file in installed.values())


def test_pip_ships_every_file() -> None:
    """Where the tests run against an installed rosward, as in CI: the folders of stubs and templates hold no modules, and are in the wheel."""
    try:
        listed: list[PackagePath] = distribution("rosward").files or []
    except PackageNotFoundError:
        pytest.skip("not installed")
    shipped = {path.relative_to("rosward").as_posix() for path in listed if path.parts[0] == "rosward"}
    if not shipped:
        pytest.skip("installed as editable: the files are those of the sources")
    assert {path for path in shipped if "__pycache__" not in path} == files()
