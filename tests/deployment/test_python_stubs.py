# SPDX-License-Identifier: Apache-2.0
"""The models of launch and its relatives can be loaded, each module by itself."""

from __future__ import annotations

import pytest

from deployment.python_tree import Files
from rosward.domain.values import External, ModuleValue, Unknown
from rosward.engine.library import Library
from rosward.engine.stub_files import STUBS
from rosward.models.tables import natives

FOLDERS = (
    "launch",
    "launch_ros",
    "launch_xml",
    "launch_yaml",
    "launch_testing",
    "launch_testing_ros",
    "launch_pytest",
    "nav2_common",
    "controller_manager",
    "launch_param_builder",
    "moveit_configs_utils",
    "ros_gz_bridge",
    "ros_gz_sim",
)
MODULES = sorted(
    ".".join(path.relative_to(STUBS).with_suffix("").parts).removesuffix(".__init__")
    for folder in FOLDERS
    for path in (STUBS / folder).rglob("*.pyi")
)


@pytest.fixture(scope="module")
def files(tmp_path_factory: pytest.TempPathFactory) -> Files:
    return Files(tmp_path_factory.mktemp("stubs"), "")


@pytest.mark.parametrize("name", [*MODULES, "xacro"])
def test_a_model_can_be_loaded(name: str, files: Files) -> None:
    """No name in it leads nowhere."""
    library = Library(files.tree, natives())
    found = library.find(name, 0, None)
    assert found is not None
    assert found.model
    module = library.load_model(found)
    assert isinstance(module, ModuleValue)
    attrs = library.at(module.address).attrs
    lost = [
        n
        for n, v in attrs.items()
        if isinstance(v, (Unknown, External)) and not n.startswith("__") and not _from_models(v)
    ]
    assert not lost


def _from_models(value: object) -> bool:
    """Functions for models, and names of the standard library that no model has."""
    return isinstance(value, External) and value.name.startswith(("_rosward", "typing."))
